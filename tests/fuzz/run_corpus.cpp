// Gives every file of the folders named to a fuzz target: what was found once is not found again.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/fuzz/target.h"

int main(int count, char** folders) {
  constexpr double longest = 5.0;  // s
  int files = 0;
  for (int i = 1; i < count; ++i) {
    for (const auto& entry : std::filesystem::directory_iterator(folders[i])) {
      std::ifstream file(entry.path(), std::ios::binary);
      const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
      const auto start = std::chrono::steady_clock::now();
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
      if (taken.count() > longest) {
        std::fprintf(stderr, "%s takes %g s\n", entry.path().c_str(), taken.count());
        return 1;
      }
      ++files;
    }
  }
  std::printf("%d inputs\n", files);
  return files > 0 ? 0 : 1;
}
