// SPDX-License-Identifier: MIT
// fuzz_bundle_replay: mutations of valid bundles and KTX2 files; see replay().
#include "bundle_example.h"
#include "bundle_surgery.h"
#include "mutation.h"

#include <algorithm>

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
    mutateBytes(file, files, random);
  return file;
}

} // namespace

int main(int argumentCount, char** arguments) {
  const std::vector<Bytes> files = seeds();
  return replay({arguments, std::size_t(argumentCount)}, files,
                [&](Random& random) { return mutated(files, random); });
}
