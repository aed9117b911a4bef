#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <random>
#include <vector>

#include "fuzz/readers.h"
#include "relievo/files.h"

namespace {

using relievo::Bytes;

constexpr int mutations = 300;  // of every seed

/// Some bytes changed, taken out, doubled or cut off.
Bytes mutated(Bytes bytes, std::mt19937& random) {
  for (auto i = 1 + random() % 6; i > 0 && !bytes.empty(); --i) {
    const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(random() % bytes.size());
    const auto end =
        at + static_cast<std::ptrdiff_t>(
                 random() % std::min<size_t>(32, static_cast<size_t>(bytes.end() - at)));
    switch (random() % 5) {
      case 0:
        *at = static_cast<uint8_t>(random());
        break;
      case 1:
        *at = static_cast<uint8_t>(*at ^ (1U << random() % 8));
        break;
      case 2:
        bytes.erase(at, end);
        break;
      case 3: {
        const Bytes piece(at, end);
        bytes.insert(at, piece.begin(), piece.end());
        break;
      }
      default:
        if (random() % 8 == 0) bytes.erase(at, bytes.end());
    }
  }
  return bytes;
}

}  // namespace

/// usage: fuzz_smoke READER FOLDER: reads every seed in the folder and mutations of it, the same in
/// every run. Ends with 0, or by the crash that it looks for.
int main(int argc, char** argv) {
  const relievo::fuzz::Reader read = argc == 3 ? relievo::fuzz::reader_of(argv[1]) : nullptr;
  if (read == nullptr) return 2;
  std::mt19937 random(20261123);
  int runs = 0;
  std::vector<std::filesystem::path> seeds;
  for (const auto& entry : std::filesystem::directory_iterator(argv[2])) seeds.push_back(entry);
  std::sort(seeds.begin(), seeds.end());
  for (const std::filesystem::path& path : seeds) {
    const auto seed = relievo::read_file(path);
    if (!seed) return 6;
    read(*seed);
    for (int i = 0; i < mutations; ++i, ++runs) read(mutated(*seed, random));
  }
  std::printf("%d mutations of %zu seeds\n", runs, seeds.size());
  return seeds.empty() ? 1 : 0;
}
