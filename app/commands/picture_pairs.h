/// Which pictures are to be compared with which.
#pragma once

#include <string>
#include <vector>

namespace wuerfel {

/// Two files that should show the same. In folders one of them may be missing.
struct PicturePair {
  std::string name;      ///< of the file, or its path inside the folders
  std::string expected;  ///< path
  std::string actual;    ///< path
  bool expected_there = true;
  bool actual_there = true;
};

/// One pair of two files; of two folders all .png files in them and in their subfolders, by name.
/// Hidden files are left out. Throws UsageError where one is missing or only one of them is a
/// folder; an EXPECTED that is yet to be made may be missing where `may_be_new`.
std::vector<PicturePair> picture_pairs(const std::string& expected,
                                       const std::string& actual,
                                       bool may_be_new);

}  // namespace wuerfel
