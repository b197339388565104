#include "render/shared_library.h"

#include <string>

#include <gtest/gtest.h>

#include "render/error.h"

namespace wuerfel::internal {
namespace {

std::string complaint_about(const std::string& file, const std::string& function) {
  try {
    void (*address)() = nullptr;
    SharedLibrary(file, "pictures need OSMesa", "libosmesa6").find(function, address);
  } catch (const LibraryError& error) {
    return error.what();
  }
  return "";
}

TEST(SharedLibrary, ThatIsMissingIsAnErrorThatSaysWhatToInstall) {
  const std::string complaint = complaint_about("libnosuch.so.8", "any");
  EXPECT_NE(complaint.find("pictures need OSMesa, which could not be loaded"), std::string::npos);
  EXPECT_NE(complaint.find("libnosuch.so.8"), std::string::npos);
  EXPECT_NE(complaint.find("libosmesa6"), std::string::npos);
}

TEST(SharedLibrary, WithoutAFunctionIsAnErrorThatNamesIt) {
  EXPECT_EQ(complaint_about("libc.so.6", "nosuch"), "libc.so.6 has no nosuch");
}

TEST(SharedLibrary, GivesFunctionsThatCanBeCalled) {
  int (*absolute)(int) = nullptr;
  SharedLibrary("libc.so.6", "this test needs C", "libc6").find("abs", absolute);
  EXPECT_EQ(absolute(-7), 7);
}

}  // namespace
}  // namespace wuerfel::internal
