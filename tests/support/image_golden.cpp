#include "tests/support/image_golden.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include <fmt/format.h>

#include "render/files/png.h"
#include "render/raster/compare.h"

namespace wuerfel::test {
namespace {

constexpr const char* update_variable = "WUERFEL_UPDATE_GOLDEN";
const std::filesystem::path golden_folder(GOLDEN_FOLDER);
const std::filesystem::path output_folder(GOLDEN_OUTPUT);

/// name -> hash of its pixels; "renderer" -> what drew them.
std::map<std::string, std::string> read_manifest() {
  std::map<std::string, std::string> manifest;
  std::ifstream file(golden_folder / "manifest.txt");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) manifest[line.substr(0, colon)] = line.substr(colon + 2);
  }
  return manifest;
}

void store(const std::string& name, const Image& actual, const std::string& renderer) {
  const std::string path = (golden_folder / (name + ".png")).string();
  std::string change = "new";
  if (std::filesystem::exists(path))
    change = describe(compare_images(read_png(path).image, actual));
  std::cout << "golden " << name << ": " << change << '\n';
  write_png(path, actual);
  std::map<std::string, std::string> manifest = read_manifest();
  manifest["renderer"] = renderer;
  manifest[name] = fmt::format("{:016x}", pixel_hash(actual));
  std::ofstream file(golden_folder / "manifest.txt");
  for (const auto& [key, value] : manifest)
    file << key << ": " << value << '\n';
}

}  // namespace

void update_golden(const std::string& renderer) { setenv(update_variable, renderer.c_str(), 1); }

::testing::AssertionResult matches_golden(const std::string& name, const Image& actual) {
  if (const char* renderer = std::getenv(update_variable); renderer != nullptr) {
    store(name, actual, renderer);
    return ::testing::AssertionSuccess();
  }
  const std::string path = (golden_folder / (name + ".png")).string();
  if (!std::filesystem::exists(path)) {
    return ::testing::AssertionFailure()
           << path << " is missing; look at the picture and store it with "
           << "golden_test --update-golden";
  }
  const Image expected = read_png(path).image;
  // The picture in the tree is the one that the manifest speaks of.
  const std::string stored = fmt::format("{:016x}", pixel_hash(expected));
  if (read_manifest()[name] != stored) {
    return ::testing::AssertionFailure() << path << " has the hash " << stored
                                         << ", the manifest says '" << read_manifest()[name] << "'";
  }
  const Comparison comparison = compare_images(expected, actual);
  if (comparison.verdict != CompareVerdict::different)
    return ::testing::AssertionSuccess() << describe(comparison);
  Font font;
  write_png((output_folder / (name + ".actual.png")).string(), actual);
  write_png((output_folder / (name + ".compare.png")).string(),
            side_by_side(expected, actual, {}, font));
  return ::testing::AssertionFailure() << name << " is " << describe(comparison) << "; see "
                                       << (output_folder / (name + ".compare.png")).string();
}

}  // namespace wuerfel::test
