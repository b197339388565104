// Every phrase is there in both languages, with the same names in braces.
#include "app/words/language.h"

#include <set>

#include <gtest/gtest.h>

namespace wuerfel::test {
namespace {

std::set<std::string> braces(const std::string& text) {
  std::set<std::string> names;
  for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1))
    names.insert(text.substr(at, text.find('}', at) - at + 1));
  return names;
}

TEST(Language, EveryPhraseIsThereInBoth) {
  for (int k = 0; k <= static_cast<int>(Phrase::nothing_found); ++k) {
    const auto phrase = static_cast<Phrase>(k);
    const std::string en = say_in(Language::en, phrase);
    const std::string de = say_in(Language::de, phrase);
    EXPECT_FALSE(en.empty()) << k;
    EXPECT_FALSE(de.empty()) << k;
    EXPECT_EQ(braces(en), braces(de)) << en;
  }
}

TEST(Language, NumbersHaveThreeDigitsAndTheUnitThatFits) {
  EXPECT_EQ(length_in(Language::en, 0.05), "50 mm");
  EXPECT_EQ(length_in(Language::en, 0.0005), "0.5 mm");
  EXPECT_EQ(length_in(Language::de, 0.0005), "0,5 mm");
  EXPECT_EQ(length_in(Language::en, 1.25), "1.25 m");
  EXPECT_EQ(length_in(Language::en, 5e-7), "0.5 µm");
  EXPECT_EQ(force_in(Language::en, 0.0188), "18.8 mN");
  EXPECT_EQ(force_in(Language::en, 0.8918), "0.892 N");
  EXPECT_EQ(force_in(Language::de, 12345.0), "12,3 kN");
  EXPECT_EQ(power_in(Language::en, 1.4217), "1.42 W");
  EXPECT_EQ(percent_in(Language::en, 0.426), "43 %");
  EXPECT_EQ(angle_in(Language::de, 0.19739555984988075), "11,3°");
}

TEST(Language, AdviceIsRoundedSoThatItHolds) {
  EXPECT_EQ(length_in(Language::en, 0.0500000001, Rounding::up), "50 mm");
  EXPECT_EQ(length_in(Language::en, 0.05001, Rounding::up), "50.1 mm");
  EXPECT_EQ(force_in(Language::en, 0.89111, Rounding::up), "0.892 N");
}

TEST(Language, ListsEndWithAnd) {
  EXPECT_EQ(list_in(Language::en, {"a"}), "a");
  EXPECT_EQ(list_in(Language::en, {"a", "b"}), "a and b");
  EXPECT_EQ(list_in(Language::de, {"a", "b", "c"}), "a, b und c");
}

}  // namespace
}  // namespace wuerfel::test
