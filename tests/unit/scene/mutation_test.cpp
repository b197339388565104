// Damaged scenes: whatever is read is either a sound scene or a SceneError, nothing else.
#include <array>
#include <string>

#include <gtest/gtest.h>

#include "core/scene/counter_random.h"
#include "core/scene/overlap.h"
#include "tests/unit/scene/scene_texts.h"

namespace wuerfel::test {
namespace {

constexpr int mutations_per_scene = 400;

/// Numbers that are a function of the seed: a failing case can be run again.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : seed_(seed) {}
  /// 0 .. below - 1.
  std::size_t throw_below(std::size_t below) {
    return static_cast<std::size_t>(random_unit(seed_, counter_++) * static_cast<double>(below));
  }

 private:
  std::uint64_t seed_;
  std::uint64_t counter_ = 0;
};

/// Things that are wrong in most places.
const std::array<std::string, 26> splinters{"[",
                                            "]",
                                            "{",
                                            "}",
                                            "\"",
                                            "'",
                                            "=",
                                            "\n",
                                            ".",
                                            ",",
                                            "#",
                                            "-",
                                            "nan",
                                            "inf",
                                            "1e999",
                                            "-1e308",
                                            "1e-320",
                                            "99999999999999999999",
                                            "0",
                                            "true",
                                            "[[cube]]\n",
                                            "on = \"floor\"\n",
                                            std::string(1, '\0'),
                                            "\xff",
                                            "\xc3\xa4",
                                            "\"\"\""};

void mutate(std::string& text, Dice& dice) {
  const std::size_t at = dice.throw_below(text.size() + 1);
  const std::size_t length = dice.throw_below(12);
  switch (dice.throw_below(5)) {
    case 0:
      text.insert(at, splinters[dice.throw_below(splinters.size())]);
      break;
    case 1:
      text.erase(at, length);
      break;
    case 2:
      text.insert(at, text.substr(dice.throw_below(text.size() + 1), 4 * length));
      break;
    case 3:
      if (at < text.size()) text[at] = static_cast<char>(dice.throw_below(256));
      break;
    default: {
      const std::size_t digit = text.find_first_of("0123456789", at);
      if (digit != std::string::npos)
        text.replace(digit, 1, splinters[dice.throw_below(splinters.size())]);
    }
  }
}

/// How many texts were sound, how many refused.
struct Tally {
  int sound = 0;
  int refused = 0;
};

/// Reads `text`. Any exception but SceneError ends the test.
void read(const std::string& text, Tally& tally) {
  SCOPED_TRACE(text);
  try {
    const Scene scene = parse_scene(text, "damaged");
    ++tally.sound;
    EXPECT_FALSE(find_overlap(scene).has_value());
    EXPECT_EQ(parse_scene(normalised_scene(scene), "-"), scene);
  } catch (const SceneError& error) {
    ++tally.refused;
    EXPECT_TRUE(std::string(error.what()).starts_with("damaged:")) << error.what();
  }
}

void read_damaged(const std::string& text, std::uint64_t seed, Tally& tally) {
  Dice dice(seed);
  for (int i = 0; i < mutations_per_scene; ++i) {
    std::string damaged = text;
    for (std::size_t k = 0; k <= dice.throw_below(3); ++k) {
      mutate(damaged, dice);
    }
    read(damaged, tally);
  }
}

class DamagedScene : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] std::string toml() const { return shipped_scene_text(GetParam()); }
  [[nodiscard]] std::string json() const { return normalised_scene(parse_scene(toml(), "whole")); }
};

TEST_P(DamagedScene, IsASceneOrASceneError) {
  Tally tally;
  read_damaged(toml(), 1, tally);
  read_damaged(json(), 2, tally);
  EXPECT_GT(tally.sound, mutations_per_scene / 20) << "comments and titles may change";
  EXPECT_GT(tally.refused, mutations_per_scene / 2);
}

TEST_P(DamagedScene, CutOffAnywhereIsASceneOrASceneError) {
  const std::string text = toml();
  Tally tally;
  for (std::size_t length = 0; length < text.size(); length += 7) {
    read(text.substr(0, length), tally);
  }
  EXPECT_GT(tally.refused, 0);
  const std::string line = json();
  tally = {};
  for (std::size_t length = 0; length < line.size(); length += 31) {
    read(line.substr(0, length), tally);
  }
  EXPECT_EQ(tally.sound, 0);
}

INSTANTIATE_TEST_SUITE_P(Assets,
                         DamagedScene,
                         ::testing::ValuesIn(shipped_scene_names()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace wuerfel::test
