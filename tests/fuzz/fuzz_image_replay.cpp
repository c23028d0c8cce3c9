// SPDX-License-Identifier: MIT
// fuzz_image_replay CASES SEED: runs mutations of valid files of every kind through the fuzzer's
// entry point; deterministic.
// fuzz_image_replay corpus FOLDER: writes the unmutated files as a corpus for libFuzzer.
#include "image_samples.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

using lichen::samples::Bytes;

namespace {

using Random = std::mt19937_64; // the standard defines its sequence, but not those of distributions

std::size_t below(Random& random, std::size_t limit) { return std::size_t(random() % limit); }

std::ptrdiff_t position(Random& random, const Bytes& bytes) {
  return std::ptrdiff_t(below(random, bytes.size()));
}

/// Edge values of the integer types in which formats store sizes.
constexpr std::array<std::uint32_t, 10> kEdges = {
    0, 1, 0x7f, 0xff, 0x7fff, 0xffff, 0x4000, 0x7fffffff, 0x80000000, 0xffffffff};

void overwriteWord(Bytes& file, Random& random) {
  const std::uint32_t value = kEdges[below(random, kEdges.size())];
  const bool bigEndian = random() % 2 == 0;
  const std::size_t size = std::size_t(1) << below(random, 3);
  const std::size_t at = below(random, file.size());
  for (std::size_t i = 0; i < size && at + i < file.size(); ++i)
    file[at + i] = std::byte(value >> (8 * (bigEndian ? size - 1 - i : i)));
}

void mutateOnce(Bytes& file, const std::vector<Bytes>& files, Random& random) {
  if (file.empty())
    return;
  const std::ptrdiff_t at = position(random, file);
  const auto length = std::ptrdiff_t(below(random, std::min<std::size_t>(file.size(), 64)));
  switch (random() % 6) {
  case 0:
    file[std::size_t(at)] ^= std::byte(1u << (random() % 8));
    break;
  case 1:
    overwriteWord(file, random);
    break;
  case 2:
    file.resize(std::size_t(at));
    break;
  case 3: { // the start of this file and the end of another
    const Bytes& other = files[below(random, files.size())];
    const std::ptrdiff_t from = std::min(at, std::ptrdiff_t(other.size()));
    file.erase(file.begin() + at, file.end());
    file.insert(file.end(), other.begin() + from, other.end());
    break;
  }
  case 4:
    file.erase(file.begin() + at, std::min(file.begin() + at + length, file.end()));
    break;
  default: { // repeats a block
    const Bytes block(file.begin() + at, std::min(file.begin() + at + length, file.end()));
    file.insert(file.begin() + at, block.begin(), block.end());
    break;
  }
  }
}

Bytes mutated(const std::vector<Bytes>& files, Random& random) {
  constexpr std::size_t kMostMutations = 4;
  Bytes file = files[below(random, files.size())];
  const std::size_t count = 1 + below(random, kMostMutations);
  for (std::size_t i = 0; i < count; ++i)
    mutateOnce(file, files, random);
  if (random() % 4 != 0) // otherwise few mutations of a PNG get past its checksums
    lichen::samples::correctPngChecksums(file);
  return file;
}

int writeCorpus(const std::vector<Bytes>& files, const std::string& folder) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::ofstream stream(folder + "/" + std::to_string(i), std::ios::binary);
    stream.write(reinterpret_cast<const char*>(files[i].data()), std::streamsize(files[i].size()));
    if (!stream)
      return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

} // namespace

int main(int argumentCount, char** arguments) {
  if (argumentCount != 3) {
    std::fprintf(stderr, "usage: fuzz_image_replay CASES SEED | corpus FOLDER\n");
    return 2;
  }
  const std::vector<Bytes> files = lichen::samples::everySupportedKind();
  if (std::strcmp(arguments[1], "corpus") == 0)
    return writeCorpus(files, arguments[2]);
  const unsigned long long cases = std::strtoull(arguments[1], nullptr, 10);
  const unsigned long long seed = std::strtoull(arguments[2], nullptr, 10);
  for (unsigned long long i = 0; i < cases; ++i) {
    Random random(seed * cases + i);
    const Bytes file = mutated(files, random);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
  }
  std::printf("%llu mutated files, none mishandled\n", cases);
  return EXIT_SUCCESS;
}
