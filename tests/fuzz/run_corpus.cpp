// Gives every file of the folders named to a fuzz target: what was found once is not found again.
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/fuzz/target.h"

int main(int count, char** folders) {
  constexpr double longest = 5.0;  // s of the processor: other work on the machine does not count
  int files = 0;
  for (int i = 1; i < count; ++i) {
    for (const auto& entry : std::filesystem::directory_iterator(folders[i])) {
      std::ifstream file(entry.path(), std::ios::binary);
      const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
      const std::clock_t start = std::clock();
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      if (taken > longest) {
        std::fprintf(stderr, "%s takes %g s\n", entry.path().c_str(), taken);
        return 1;
      }
      ++files;
    }
  }
  std::printf("%d inputs\n", files);
  return files > 0 ? 0 : 1;
}
