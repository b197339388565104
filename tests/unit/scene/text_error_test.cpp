// Texts that are no TOML, no JSON or no text, with the exact message.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/scene/scene_texts.h"

namespace wuerfel::test {
namespace {

TEST(TextError, SyntaxErrorsHaveLineAndColumn) {
  EXPECT_EQ(toml_error("version = 1\nversion = 1\n"),
            "s.toml:2:11: not valid TOML: Error while parsing key-value pair: cannot redefine "
            "existing integer 'version'");
  EXPECT_EQ(toml_error("title = \"äöü\" x\n").substr(0, 28), "s.toml:1:15: not valid TOML:");
  EXPECT_EQ(json_error("{\"version\": 1,\n \"cube\": [}"),
            "s.json:2:11: not valid JSON: syntax error while parsing value - unexpected '}'; "
            "expected '[', '{', or a literal");
  EXPECT_EQ(
      json_error("[1,2"),
      "s.json:1:5: not valid JSON: syntax error while parsing array - unexpected end of input; "
      "expected ']'");
  EXPECT_EQ(json_error(R"({"cube": [{"position": [0, 1]}]} x)").substr(0, 28),
            "s.json:1:34: not valid JSON:");
}

TEST(TextError, JsonKeysAreGivenOnce) {
  EXPECT_EQ(json_error(R"({"cube": [{"position": [0, 1], "mass": 1, "mass": 2}]})"),
            "s.json: cube[1].mass: given twice");
}

TEST(TextError, EmptyTextsAreRefused) {
  for (const char* text : {"", " \n\t\r\n", "\xef\xbb\xbf\n"}) {
    EXPECT_EQ(toml_error(text), "s.toml:1:1: empty; a scene needs at least one [[cube]]");
  }
  EXPECT_EQ(json_error(""), "s.json:1:1: empty; a scene needs at least one [[cube]]");
}

TEST(TextError, WhatIsNotUtf8TextIsRefused) {
  EXPECT_EQ(toml_error("# caf\xe9\n"), "s.toml:1:6: not UTF-8 text; save it in that encoding");
  EXPECT_EQ(toml_error("\n# ä \xc0\xaf\n"), "s.toml:2:5: not UTF-8 text; save it in that encoding")
      << "overlong form";
  EXPECT_EQ(toml_error("# \xed\xa0\x80\n"), "s.toml:1:3: not UTF-8 text; save it in that encoding")
      << "surrogate";
  EXPECT_EQ(toml_error("# \xf4\x90\x80\x80\n"),
            "s.toml:1:3: not UTF-8 text; save it in that encoding")
      << "beyond U+10FFFF";
  EXPECT_EQ(toml_error("# \xe2\x82"), "s.toml:1:3: not UTF-8 text; save it in that encoding")
      << "cut off";
  EXPECT_EQ(json_error("{\"title\": \"\xff\"}"),
            "s.json:1:12: not UTF-8 text; save it in that encoding");
  EXPECT_EQ(toml_error(std::string("# a\0b\n", 6)), "s.toml:1:4: not a text: it holds a zero byte");
}

TEST(TextError, DeepNestingIsRefusedBeforeAnyoneRecurses) {
  const std::string brackets(100'000, '[');
  EXPECT_EQ(toml_error("x = " + brackets), "s.toml:1:21: nested too deeply: more than 16 levels");
  EXPECT_EQ(json_error("{\"x\": " + brackets),
            "s.json:1:22: nested too deeply: more than 16 levels");
  std::string dots;
  for (int i = 0; i < 100'000; ++i) {
    dots += "a.";
  }
  EXPECT_EQ(toml_error(dots + "a = 1\n"), "s.toml:1:34: nested too deeply: more than 16 levels");
  EXPECT_EQ(toml_error("[" + dots + "a]\n"), "s.toml:1:35: nested too deeply: more than 16 levels");
}

TEST(TextError, BracketsAndDotsWithinStringsAndCommentsDoNotNest) {
  const std::string many = "[[[[[[[[[[[[[[[[[[[[......................";
  EXPECT_EQ(toml_error("title = \"" + many + "\\\"" + many + "\" # " + many + "\n" + cube_text),
            "no error");
  EXPECT_EQ(toml_error("title = '" + many + "' # '\n" + cube_text), "no error");
  EXPECT_EQ(toml_error("title = \"\"\"" + many + "\"" + many + "\"\"\"\n" + cube_text), "no error");
  EXPECT_EQ(toml_error("title = '''" + many + "'" + many + "'''\n" + cube_text), "no error");
  EXPECT_EQ(json_error("{\"title\": \"" + many + "\\\"'\", \"cube\": [{\"position\": [0, 1]}]}"),
            "no error");
}

TEST(TextError, AbsurdlyLongTextsAreRefused) {
  EXPECT_EQ(toml_error(std::string((std::size_t{128} << 20U) + 1, '#')),
            "s.toml:1:1: too long: 134217729 bytes, at most 134217728 are read");
}

}  // namespace
}  // namespace wuerfel::test
