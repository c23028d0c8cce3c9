// SPDX-License-Identifier: MIT
// fuzz_bundle_replay CASES SEED: runs mutations of valid bundles and KTX2 files through the
// fuzzer's entry point; deterministic.
// fuzz_bundle_replay corpus FOLDER: writes the unmutated files as a corpus for libFuzzer.
#include "bundle_example.h"
#include "bundle_surgery.h"
#include "gltf_mutation.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

using namespace lichen;
using namespace lichen::fuzz;

namespace {

constexpr std::size_t kGlbSeeds = 10;

/// Two noises with separate tables; the first has a future revision.
Bytes laterRevision() {
  BundleFile file = example::smallest();
  Bundle& bundle = file.bundle;
  Noise second = bundle.noises[0];
  second.name = "second";
  second.maps[0].as<TilingMap>().gaussian = 2;
  second.maps[0].as<TilingMap>().inverseTable = 3;
  bundle.noises.push_back(second);
  const std::vector<Table> ownTables = bundle.tables;
  bundle.tables.insert(bundle.tables.end(), ownTables.begin(), ownTables.end());
  MaterialNoise use;
  use.noise = 1;
  bundle.materials.emplace_back(use);
  file.previews.emplace_back();
  example::GlbParts parts(encodeGlb(file).value());
  parts.extension()["noises"][0]["revision"] = revisionOf(Method::tiling) + 1;
  return parts.join();
}

/// Small files, so that mutations hit structure instead of texels. The GLBs come first.
std::vector<Bytes> seeds() {
  BundleFile withScene = example::smallest();
  withScene.previews[0].baseColor = example::tinyPng();
  withScene.shape = PreviewShape::plane;
  return {encodeGlb(example::smallest()).value(),
          encodeGlb(withScene).value(),
          laterRevision(),
          encodeGlb(example::smallestTexton()).value(),
          encodeGlb(example::smallestCosines()).value(),
          encodeGlb(example::smallestKernels()).value(),
          encodeGlb(example::smallestQuilting()).value(),
          encodeGlb(example::layered()).value(),
          encodeGlb(example::smallestStructure()).value(),
          encodeGlb(example::textonMix()).value(),
          cookBundle(example::smallest().bundle),
          cookBundle(example::smallestStructure().bundle),
          cookBundle(example::textonMix().bundle),
          cookBundle(example::smallestQuilting().bundle),
          cookBundle(example::layered().bundle),
          encodeKtx2(example::patternTable("", TexelFormat::rg16Sfloat, 4, 2, 0, 3)),
          encodeKtx2(example::patternTable("", TexelFormat::rgba8Unorm, 4, 4, 4, 2))};
}

Bytes mutated(const std::vector<Bytes>& files, Random& random) {
  const std::size_t index = below(random, files.size());
  Bytes file = files[index];
  if (index < kGlbSeeds && random() % 2 == 0) {
    example::GlbParts parts(file);
    mutateJson(parts.json["extensions"], random);
    if (random() % 2 == 0)
      mutateJson(parts.json, random);
    constexpr std::size_t kTableBytes = 600; // the tables are at the start of the buffer
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
