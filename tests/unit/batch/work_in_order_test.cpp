#include "core/work_in_order.h"

#include <atomic>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "core/check_many.h"
#include "core/scene/scene_parser.h"

namespace wuerfel::test {
namespace {

class WorkInOrder : public testing::TestWithParam<int> {
 protected:
  // Numbers below `count`; the lower ones take longer.
  std::vector<int> squares(int count) {
    std::vector<int> delivered;
    int i = 0;
    work_in_order(
        {GetParam()}, [&] { return i < count ? std::optional(i++) : std::nullopt; },
        [count](int n) {
          std::this_thread::sleep_for(std::chrono::microseconds(10 * (count - n)));
          return n * n;
        },
        [&](int square) { delivered.push_back(square); });
    return delivered;
  }
};

TEST_P(WorkInOrder, DeliversInTheOrderOfTheItems) {
  const std::vector<int> delivered = squares(300);
  ASSERT_EQ(delivered.size(), 300U);
  for (int n = 0; n < 300; ++n)
    EXPECT_EQ(delivered[n], n * n);
}

TEST_P(WorkInOrder, GivesNothingForNothing) { EXPECT_TRUE(squares(0).empty()); }

TEST_P(WorkInOrder, DeliversAllBeforeTheItemThatFails) {
  std::vector<int> delivered;
  int i = 0;
  const auto fail_at_20 = [](int n) {
    if (n == 20) throw std::runtime_error("twenty");
    return n;
  };
  const auto fails = [&] {
    work_in_order(
        {GetParam()}, [&] { return std::optional(i++); }, fail_at_20,
        [&](int n) { delivered.push_back(n); });
  };
  EXPECT_THROW(fails(), std::runtime_error);
  ASSERT_EQ(delivered.size(), 20U);
  EXPECT_EQ(delivered.back(), 19);
}

TEST_P(WorkInOrder, StopsWhereDeliveringOrFetchingFails) {
  int i = 0;
  const auto same = [](int n) { return n; };
  const auto delivers = [&] {
    work_in_order(
        {GetParam()}, [&] { return std::optional(i++); }, same,
        [](int n) {
          if (n == 5) throw std::logic_error("five");
        });
  };
  EXPECT_THROW(delivers(), std::logic_error);
  int delivered = 0;
  i = 0;
  const auto fetches = [&] {
    work_in_order(
        {GetParam()},
        [&] {
          if (i == 7) throw std::logic_error("seven");
          return std::optional(i++);
        },
        same, [&](int) { ++delivered; });
  };
  EXPECT_THROW(fetches(), std::logic_error);
  EXPECT_EQ(delivered, 7);
}

TEST_P(WorkInOrder, EndsWhenThePulseThrows) {
  std::atomic<int> worked = 0;
  int beats = 0;
  const Workforce impatient{GetParam(), [&] {
                              if (++beats == 3) throw std::runtime_error("enough");
                            }};
  const auto beat = [&] {
    work_in_order(
        impatient, [] { return std::optional(1); },
        [&](int) {
          std::this_thread::sleep_for(std::chrono::milliseconds(5));
          return ++worked;
        },
        [](int) {});
  };
  EXPECT_THROW(beat(), std::runtime_error);
}

TEST_P(WorkInOrder, ChecksManyScenesAsOneByOne) {
  std::vector<Scene> scenes;
  scenes.reserve(40);
  for (int i = 0; i < 40; ++i) {
    scenes.push_back(parse_scene(R"({"plane":[{}],"tower":[{"count":6,"base":[0,0]}]})", "t",
                                 {"tower.1.lean=" + std::to_string(0.01 * i)}));
  }
  scenes[7].cubes[1].position = scenes[7].cubes[0].position;  // overlap
  const auto attempts = check_many(scenes, {}, {GetParam()});
  ASSERT_EQ(attempts.size(), scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (i == 7) {
      EXPECT_THROW(std::rethrow_exception(attempts[i].failure), SceneError);
      continue;
    }
    const Check alone = check(scenes[i], {});
    EXPECT_EQ(attempts[i].answer.verdict, alone.verdict);
    EXPECT_EQ(attempts[i].answer.objective, alone.objective);
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, WorkInOrder, testing::Values(1, 2, 5));

}  // namespace
}  // namespace wuerfel::test
