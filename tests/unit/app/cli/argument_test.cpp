#include "app/cli/argument.h"

#include <string>

#include <gtest/gtest.h>

#include "app/cli/exit_code.h"

namespace wuerfel::test {
namespace {

template <class Parse>
std::string complaint_of(const Parse& parse) {
  try {
    parse();
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(ParseWhole, TellsTheRangeWhateverIsWrong) {
  EXPECT_EQ(parse_whole("--cases", "1e3", 1, 1000), 1000);
  EXPECT_EQ(parse_whole("--ghosts", "0", 0, 100), 0);
  for (const std::string text : {"abc", "", "3.5", "-3", "0", "1001", "1e99", "nan", "inf", "7 "}) {
    EXPECT_EQ(complaint_of([&] { parse_whole("--cases", text, 1, 1000); }),
              "--cases: '" + text + "' is no whole number of 1 to 1000");
  }
}

TEST(ParseBytes, KnowsItsUnitsAndMissesThem) {
  EXPECT_EQ(parse_bytes("--max-memory", "500M"), 5e8);
  EXPECT_EQ(parse_bytes("--max-memory", "1.5T"), 1.5e12);
  EXPECT_EQ(parse_bytes("--max-memory", "4000000000"), 4e9);
  EXPECT_EQ(complaint_of([] { parse_bytes("--max-memory", "500"); }),
            "--max-memory: '500' are bytes, too few for any run; did you mean 500M?");
  for (const std::string text : {"", "M", "-1", "0", "4GB", "nan", "infM"}) {
    EXPECT_EQ(complaint_of([&] { parse_bytes("--max-memory", text); }),
              "--max-memory: '" + text + "' is no size, as 500M or 4G");
  }
}

}  // namespace
}  // namespace wuerfel::test
