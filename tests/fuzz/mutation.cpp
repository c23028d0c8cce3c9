// SPDX-License-Identifier: MIT
#include "mutation.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace lichen::fuzz {
namespace {

/// Maximum processor time for one small file. The loader of scenes may take two seconds; sanitizers
/// take about ten times as long.
constexpr double kMostSeconds = 20.0;

/// Edge values of the integer types in which formats store sizes.
constexpr std::array<std::uint32_t, 13> kEdges = {
    0, 1, 3, 0x7f, 0xff, 0x7fff, 0xffff, 0x4000, 0x7fffffff, 0x80000000, 0xfffffffc, 0xffffffff, 2};

void overwriteWord(Bytes& file, std::size_t at, Random& random) {
  const std::uint32_t value = kEdges[below(random, kEdges.size())];
  const bool bigEndian = random() % 2 == 0;
  const std::size_t size = std::size_t(1) << below(random, 3);
  for (std::size_t i = 0; i < size && at + i < file.size(); ++i)
    file[at + i] = std::byte(value >> (8 * (bigEndian ? size - 1 - i : i)));
}

/// Runs a file through the fuzzer; false if that takes too long.
bool run(const Bytes& file) {
  const std::clock_t start = std::clock();
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
  return double(std::clock() - start) / CLOCKS_PER_SEC < kMostSeconds;
}

int writeCorpus(const std::vector<Bytes>& files, const std::string& folder) {
  int index = 0;
  for (const Bytes& file : files) {
    std::ofstream stream(folder + "/" + std::to_string(index++), std::ios::binary);
    stream.write(reinterpret_cast<const char*>(file.data()), std::streamsize(file.size()));
    if (!stream)
      return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

/// Plausible values, valid or not, of members of glTF or of the extension.
const nlohmann::json& replacement(Random& random) {
  static const nlohmann::json values = nlohmann::json::parse(
      R"([null, true, 0, 1, 2, 3, 4, -1, 0.5, -0.25, 1e300, 3e38, 5121, 5125, 5126, 4294967296,
          18446744073709551615, "", "uv", "surface", "texton", "SCALAR", "VEC3", "MAT4", [], {}, ")" +
      std::string(100, 'x') + "\"]");
  return values[below(random, values.size())];
}

/// Descends to a random value of the document.
nlohmann::json& anyValue(nlohmann::json& root, Random& random) {
  constexpr std::size_t kStopsOneIn = 8;
  nlohmann::json* value = &root;
  while (value->is_structured() && !value->empty() && below(random, kStopsOneIn) != 0) {
    auto child = value->begin();
    std::advance(child, std::ptrdiff_t(below(random, value->size())));
    value = &*child;
  }
  return *value;
}

} // namespace

std::size_t below(Random& random, std::size_t limit) { return std::size_t(random() % limit); }

void mutateBytes(Bytes& file, const std::vector<Bytes>& files, Random& random) {
  if (file.empty())
    return;
  const std::size_t index = below(random, file.size());
  const auto at = file.begin() + std::ptrdiff_t(index);
  const auto length = std::ptrdiff_t(below(random, std::min<std::size_t>(file.size() - index, 64)));
  switch (random() % 6) {
  case 0:
    *at ^= std::byte(1u << (random() % 8));
    break;
  case 1:
    overwriteWord(file, index, random);
    break;
  case 2:
    file.erase(at, file.end());
    break;
  case 3: {
    const Bytes& other = files[below(random, files.size())];
    file.erase(at, file.end());
    file.insert(file.end(), other.begin() + std::ptrdiff_t(std::min(index, other.size())),
                other.end());
    break;
  }
  case 4:
    file.erase(at, at + length);
    break;
  default: {
    const Bytes block(at, at + length);
    file.insert(at, block.begin(), block.end());
    break;
  }
  }
}

void mutateJson(nlohmann::json& root, Random& random) {
  nlohmann::json& value = anyValue(root, random);
  switch (random() % 5) {
  case 0:
    if (value.is_array() && !value.empty())
      value.push_back(nlohmann::json(value.front()));
    break;
  case 1:
    if (value.is_structured() && !value.empty())
      value.erase(std::next(value.begin(), std::ptrdiff_t(below(random, value.size()))));
    break;
  case 2:
    value = nlohmann::json(anyValue(root, random));
    break;
  default:
    value = replacement(random);
    break;
  }
}

int replay(std::span<char* const> arguments, const std::vector<Bytes>& seeds,
           const std::function<Bytes(Random&)>& mutated) {
  if (arguments.size() < 3 || arguments.size() > 4) {
    std::fprintf(stderr, "usage: %s CASES SEED [FOLDER] | corpus FOLDER\n", arguments[0]);
    return 2;
  }
  if (std::string(arguments[1]) == "corpus")
    return writeCorpus(seeds, arguments[2]);
  std::size_t once = 0;
  if (arguments.size() == 4)
    for (const auto& entry : std::filesystem::directory_iterator(arguments[3])) {
      std::ifstream stream(entry.path(), std::ios::binary);
      const std::string text{std::istreambuf_iterator<char>(stream), {}};
      const auto bytes = std::as_bytes(std::span(text));
      if (!run({bytes.begin(), bytes.end()})) {
        std::fprintf(stderr, "%s: more than %.0f s\n", entry.path().c_str(), kMostSeconds);
        return EXIT_FAILURE;
      }
      ++once;
    }
  const unsigned long long cases = std::strtoull(arguments[1], nullptr, 10);
  const unsigned long long seed = std::strtoull(arguments[2], nullptr, 10);
  for (unsigned long long i = 0; i < cases; ++i) {
    Random random(seed * cases + i);
    run(mutated(random));
  }
  std::printf("%zu regression files, %llu mutated files, none mishandled\n", once, cases);
  return EXIT_SUCCESS;
}

} // namespace lichen::fuzz
