// SPDX-License-Identifier: MIT
// fuzz_bundle_replay CASES SEED: mutations of valid bundles and KTX2 files, the same for the same
// numbers, through the fuzzer's entry point.
// fuzz_bundle_replay corpus FOLDER: writes the unmutated files, for libFuzzer to start from.
#include "bundle_example.h"
#include "bundle_surgery.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

using namespace lichen;

namespace {

using Bytes = std::vector<std::byte>;
using Random = std::mt19937_64; // the standard fixes its sequence, not that of distributions

std::size_t below(Random& random, std::size_t limit) { return std::size_t(random() % limit); }

constexpr std::size_t kGlbSeeds = 5;

/// Two noises with tables of their own, the first of a revision to come.
Bytes laterRevision() {
  BundleFile file = example::smallest();
  Bundle& bundle = file.bundle;
  Noise second = bundle.noises[0];
  second.name = "second";
  second.maps[0].image = 2;
  second.maps[0].inverseTable = 3;
  bundle.noises.push_back(second);
  const std::vector<Table> ownTables = bundle.tables;
  bundle.tables.insert(bundle.tables.end(), ownTables.begin(), ownTables.end());
  MaterialNoise use;
  use.noise = 1;
  bundle.materials.emplace_back(use);
  file.previews.emplace_back();
  example::GlbParts parts(encodeGlb(file).value());
  parts.extension()["noises"][0]["revision"] = kNoiseRevision + 1;
  return parts.join();
}

/// Small files: mutations then hit what is read, not texels. The GLBs come first.
std::vector<Bytes> seeds() {
  BundleFile withScene = example::smallest();
  withScene.previews[0].baseColor = example::tinyPng();
  withScene.shape = PreviewShape::plane;
  return {encodeGlb(example::smallest()).value(),
          encodeGlb(withScene).value(),
          laterRevision(),
          encodeGlb(example::smallestTexton()).value(),
          encodeGlb(example::textonMix()).value(),
          encodeKtx2(example::patternTable("", TexelFormat::rg16Sfloat, 4, 2, 0, 3)),
          encodeKtx2(example::patternTable("", TexelFormat::rgba8Srgb, 2, 2, 2, 1))};
}

constexpr std::array<std::uint32_t, 10> kEdges = {
    0, 1, 3, 0xff, 0xffff, 0x4000, 0x7fffffff, 0x80000000, 0xfffffffc, 0xffffffff};

void mutateBytes(Bytes& file, Random& random) {
  if (file.size() < 8)
    return;
  const std::size_t at = below(random, file.size() - 4);
  const auto place = file.begin() + std::ptrdiff_t(at);
  switch (random() % 4) {
  case 0:
    *place ^= std::byte(1u << (random() % 8));
    break;
  case 1:
    std::memcpy(&*place, &kEdges[below(random, kEdges.size())], 4);
    break;
  case 2:
    file.resize(at);
    break;
  default:
    file.erase(place, place + std::ptrdiff_t(below(random, 4)));
    break;
  }
}

/// Walks down to some value of the document.
nlohmann::json& anyValue(nlohmann::json& root, Random& random) {
  nlohmann::json* value = &root;
  while (value->is_structured() && !value->empty() && random() % 8 != 0) {
    auto child = value->begin();
    std::advance(child, std::ptrdiff_t(below(random, value->size())));
    value = &*child;
  }
  return *value;
}

void mutateJson(nlohmann::json& root, Random& random) {
  const std::array<nlohmann::json, 17> replacements = {nullptr,
                                                       true,
                                                       0,
                                                       1,
                                                       2,
                                                       3,
                                                       -1,
                                                       0.5,
                                                       1e300,
                                                       4294967296u,
                                                       18446744073709551615u,
                                                       "",
                                                       "uv",
                                                       "texton",
                                                       nlohmann::json::array(),
                                                       nlohmann::json::object(),
                                                       std::string(100, 'x')};
  nlohmann::json& value = anyValue(root, random);
  switch (random() % 3) {
  case 0:
    if (value.is_array() && !value.empty())
      value.push_back(nlohmann::json(value.front()));
    break;
  case 1:
    if (value.is_structured() && !value.empty())
      value.erase(value.begin());
    break;
  default:
    value = replacements[below(random, replacements.size())];
    break;
  }
}

Bytes mutated(const std::vector<Bytes>& files, Random& random) {
  const std::size_t index = below(random, files.size());
  Bytes file = files[index];
  if (index < kGlbSeeds && random() % 2 == 0) {
    example::GlbParts parts(file);
    mutateJson(parts.json["extensions"], random);
    if (random() % 2 == 0)
      mutateJson(parts.json, random);
    constexpr std::size_t kTableBytes = 600; // the tables lie at the buffer's beginning
    if (random() % 2 == 0)
      parts.binary[below(random, std::min(kTableBytes, parts.binary.size()))] ^=
          std::byte(1u << (random() % 8));
    return parts.join();
  }
  constexpr std::size_t kMostMutations = 3;
  const std::size_t count = 1 + below(random, kMostMutations);
  for (std::size_t i = 0; i < count; ++i)
    mutateBytes(file, random);
  return file;
}

int writeCorpus(const std::string& folder) {
  int index = 0;
  for (const Bytes& file : seeds()) {
    std::ofstream stream(folder + "/bundle-" + std::to_string(index++), std::ios::binary);
    stream.write(reinterpret_cast<const char*>(file.data()), std::streamsize(file.size()));
    if (!stream)
      return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

} // namespace

int main(int argumentCount, char** arguments) {
  if (argumentCount != 3) {
    std::fprintf(stderr, "usage: fuzz_bundle_replay CASES SEED | corpus FOLDER\n");
    return 2;
  }
  if (std::strcmp(arguments[1], "corpus") == 0)
    return writeCorpus(arguments[2]);
  const std::vector<Bytes> files = seeds();
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
