// Damaged scenes: whatever is read is either a sound scene or a SceneError, nothing else.
#include <array>
#include <string>

#include <gtest/gtest.h>

#include "core/scene/counter_random.h"
#include "core/scene/overlap.h"
#include "tests/unit/scene/scene_texts.h"

namespace wuerfel {
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

class DamagedScene : public ::testing::TestWithParam<std::string> {
 protected:
  static void read(const std::string& text, const std::string& name) {
    try {
      const Scene scene = parse_scene(text, name);
      ++sound_;
      EXPECT_FALSE(find_overlap(scene).has_value()) << text;
      EXPECT_EQ(parse_scene(normalised_scene(scene), "-"), scene) << text;
    } catch (const SceneError& error) {
      ++refused_;
      EXPECT_TRUE(std::string(error.what()).starts_with(name)) << error.what();
    }
  }

  static void damage(const std::string& text, const std::string& name, std::uint64_t seed) {
    Dice dice(seed);
    for (int i = 0; i < mutations_per_scene; ++i) {
      std::string damaged = text;
      for (std::size_t k = 0; k <= dice.throw_below(3); ++k) {
        mutate(damaged, dice);
      }
      SCOPED_TRACE("mutation " + std::to_string(i));
      ASSERT_NO_THROW(read(damaged, name)) << damaged;
    }
  }

  static inline int sound_ = 0;
  static inline int refused_ = 0;
};

TEST_P(DamagedScene, IsASceneOrASceneError) {
  const std::string text = shipped_scene_text(GetParam());
  sound_ = 0;
  refused_ = 0;
  damage(text, "damaged", 1);
  damage(normalised_scene(parse_scene(text, "whole")), "damaged", 2);
  EXPECT_GT(sound_, mutations_per_scene / 20) << "comments and titles may change";
  EXPECT_GT(refused_, mutations_per_scene / 2);
}

TEST_P(DamagedScene, CutOffAnywhereIsASceneOrASceneError) {
  const std::string text = shipped_scene_text(GetParam());
  const std::string json = normalised_scene(parse_scene(text, "whole"));
  for (std::size_t length = 0; length < text.size(); length += 7) {
    ASSERT_NO_THROW(read(text.substr(0, length), "cut")) << length;
  }
  for (std::size_t length = 0; length < json.size(); length += 31) {
    EXPECT_THROW(parse_scene(json.substr(0, length), "cut.json"), SceneError) << length;
  }
}

INSTANTIATE_TEST_SUITE_P(Assets,
                         DamagedScene,
                         ::testing::ValuesIn(shipped_scene_names()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace wuerfel
