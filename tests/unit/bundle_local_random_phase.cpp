// SPDX-License-Identifier: MIT
// Local random-phase noises in a file: every fault that the checker must report by its code and the
// reader must reject, and what the shader's constants hold of them.
#include "bundle_example.h"
#include "bundle_faults.h"

#include <lichen/bfloat16_pair.h>
#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>
#include <lichen/structure_texel.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace lichen;
using example::GlbParts;
using nlohmann::json;

namespace {

const std::vector<std::byte>& soundFile() {
  static const std::vector<std::byte> file = encodeGlb(example::smallestCosines()).value();
  return file;
}

const std::vector<std::byte>& structuredFile() {
  static const std::vector<std::byte> file = encodeGlb(example::smallestStructure()).value();
  return file;
}

json& sharedOf(GlbParts& parts) { return parts.extension()["noises"][0]["localRandomPhase"]; }

} // namespace

TEST_CASE("the example file of cosines has no faults, and is read as it was written") {
  CHECK(checkBundle(GlbParts(soundFile()).join()).empty());
  const Bundle bundle = parseBundle(soundFile(), "cosines").value();
  REQUIRE(bundle.noises.size() == 1);
  CHECK(bundle.noises[0] == example::smallestCosines().bundle.noises[0]);
}

TEST_CASE("a float holds two numbers of 8 significant bits, and is never subnormal") {
  std::mt19937 generator(4u);
  std::uniform_real_distribution<float> exponent(-30.0f, 14.0f);
  std::bernoulli_distribution isNegative, isZero(0.1);
  const auto number = [&] {
    const float value = isZero(generator) ? 0.0f : std::exp2(exponent(generator));
    return isNegative(generator) ? -value : value;
  };
  for (int k = 0; k < 10000; ++k) {
    const std::array<float, 2> wanted{number(), number()};
    const float pair = bfloat16Pair(wanted[0], wanted[1]);
    CHECK((pair == 0.0f || std::isnormal(pair)));
    const std::array<float, 2> found = fromBfloat16Pair(pair);
    for (std::size_t i = 0; i < 2; ++i)
      CHECK(std::abs(found[i] - wanted[i]) <= std::ldexp(std::abs(wanted[i]), -8) + 1.2e-38f);
  }
}

TEST_CASE("a float holds three integers of a structure, and is never subnormal") {
  std::mt19937 generator(5u);
  std::uniform_int_distribution<int> integer(-kMostStructureInteger - 1, kMostStructureInteger);
  for (int k = 0; k < 10000; ++k) {
    const std::array<int, 3> wanted{integer(generator), integer(generator), integer(generator)};
    const float texel = structureTexel(wanted);
    CHECK(std::isnormal(texel));
    CHECK(fromStructureTexel(texel) == wanted);
  }
}

TEST_CASE("the example file of a structure has no faults, and is read as it was written") {
  CHECK(checkBundle(GlbParts(structuredFile()).join()).empty());
  const Bundle bundle = parseBundle(structuredFile(), "structure").value();
  REQUIRE(bundle.noises.size() == 1);
  CHECK(bundle.noises[0] == example::smallestStructure().bundle.noises[0]);
}

TEST_CASE("every fault of a structure is found") {
  const auto structureOf = [](GlbParts& parts) -> json& { return sharedOf(parts)["structure"]; };
  const auto ownOf = [](GlbParts& parts) -> json& { return parts.map(0, 0)["structure"]; };
  example::checkFaults(
      structuredFile(),
      {
          {"a number", "type", [&](GlbParts& p) { structureOf(p) = 64; }},
          {"in a solid", "material-mapping", [](GlbParts& p) { p.use(0)["mapping"] = "solid"; }},
          {"no sides", "required", [&](GlbParts& p) { structureOf(p).erase("texels"); }},
          {"one side", "count", [&](GlbParts& p) { structureOf(p)["texels"] = {64}; }},
          {"small sides", "range", [&](GlbParts& p) { structureOf(p)["texels"][0] = 32; }},
          {"huge sides", "range", [&](GlbParts& p) { structureOf(p)["texels"][1] = 16384; }},
          {"sides that are no powers of two", "structure-texels",
           [&](GlbParts& p) { structureOf(p)["texels"][1] = 96; }},
          {"no offsets", "range", [&](GlbParts& p) { structureOf(p)["offsets"] = 0; }},
          {"two offsets", "range", [&](GlbParts& p) { structureOf(p)["offsets"] = 2; }},
          {"65 offsets", "range", [&](GlbParts& p) { structureOf(p)["offsets"] = 65; }},
          {"a list in the cosines", "map-cosines",
           [&](GlbParts& p) { structureOf(p).erase("offsets"); }},
          {"another height", "map-cosines",
           [&](GlbParts& p) { structureOf(p)["texels"][1] = 128; }},
          {"a turbulence of two tiles", "range",
           [&](GlbParts& p) { structureOf(p)["turbulence"] = 2.0; }},
          {"no structure of the map", "required",
           [&](GlbParts& p) { p.map(0, 0).erase("structure"); }},
          {"no amplitudes", "required", [&](GlbParts& p) { ownOf(p).erase("amplitudes"); }},
          {"a huge amplitude", "range", [&](GlbParts& p) { ownOf(p)["amplitudes"][0] = 5.0; }},
          {"two amplitudes", "structure-count",
           [&](GlbParts& p) {
             ownOf(p)["amplitudes"] = {0.5, 0.5};
           }},
          {"a deviation above 1", "range", [&](GlbParts& p) { ownOf(p)["deviations"][0] = 1.5; }},
          {"five deviations", "structure-count",
           [&](GlbParts& p) { ownOf(p)["deviations"].erase(5); }},
          {"deviations that increase", "structure-deviations",
           [&](GlbParts& p) { ownOf(p)["deviations"][3] = 0.65; }},
          {"a long offset", "structure-offsets",
           [](GlbParts& p) {
             // The image ends the file: the second offset is in the first texel of the row after
             // that of the cosines.
             const std::size_t row = 64 * 4 * sizeof(float);
             const std::size_t offset = p.binary.size() - row * (1 + 48) + 2 * sizeof(float);
             p.binary[offset + 3] = std::byte{0x40}; // 2 and more
             p.binary[offset + 2] = std::byte{0x00};
           }},
      });
}

TEST_CASE("every fault of what the cosines share is found") {
  example::checkFaults(
      soundFile(),
      {
          {"nothing shared", "required",
           [](GlbParts& p) { p.extension()["noises"][0].erase("localRandomPhase"); }},
          {"a number", "type", [](GlbParts& p) { sharedOf(p) = 7; }},
          {"no size of the exemplar", "required",
           [](GlbParts& p) { sharedOf(p).erase("texelsPerTile"); }},
          {"an empty exemplar", "range", [](GlbParts& p) { sharedOf(p)["texelsPerTile"][0] = 0; }},
          {"a huge exemplar", "range",
           [](GlbParts& p) { sharedOf(p)["texelsPerTile"][1] = 16385; }},
          {"half a texel", "type", [](GlbParts& p) { sharedOf(p)["texelsPerTile"][0] = 16.5; }},
          {"no columns", "required", [](GlbParts& p) { sharedOf(p).erase("columns"); }},
          {"0 columns", "range", [](GlbParts& p) { sharedOf(p)["columns"] = 0; }},
          {"65 columns", "range", [](GlbParts& p) { sharedOf(p)["columns"] = 65; }},
          {"no rows", "required", [](GlbParts& p) { sharedOf(p).erase("rows"); }},
          {"odd rows", "rows-odd", [](GlbParts& p) { sharedOf(p)["rows"] = 7; }},
          {"66 rows", "range", [](GlbParts& p) { sharedOf(p)["rows"] = 66; }},
          {"no octaves", "required", [](GlbParts& p) { sharedOf(p).erase("octaves"); }},
          {"13 octaves", "count",
           [](GlbParts& p) { sharedOf(p)["octaves"] = std::vector<int>(13, 2); }},
          {"a negative number of cosines", "range",
           [](GlbParts& p) { sharedOf(p)["octaves"][0] = -1; }},
          {"half a cosine", "type", [](GlbParts& p) { sharedOf(p)["octaves"][0] = 1.5; }},
          {"too many cosines", "octaves-sum",
           [](GlbParts& p) {
             sharedOf(p)["octaves"] = {200, 100};
           }},
          {"an empty last octave", "octaves-last",
           [](GlbParts& p) {
             sharedOf(p)["octaves"] = {4, 0};
           }},
          {"an odd number of cosines", "octaves-odd",
           [](GlbParts& p) {
             sharedOf(p)["octaves"] = {1, 0, 3};
           }},
          {"no variants", "required", [](GlbParts& p) { sharedOf(p).erase("variants"); }},
          {"3 variants", "variants", [](GlbParts& p) { sharedOf(p)["variants"] = 3; }},
          {"64 variants", "range", [](GlbParts& p) { sharedOf(p)["variants"] = 64; }},
      });
}

TEST_CASE("every contradiction between a map and its cosines is found") {
  example::checkFaults(
      soundFile(), {
                       {"no image", "required", [](GlbParts& p) { p.map(0, 0).erase("cosines"); }},
                       {"an image out of range", "map-cosines-index",
                        [](GlbParts& p) { p.map(0, 0)["cosines"] = 99; }},
                       {"more cosines than rows", "map-cosines",
                        [](GlbParts& p) {
                          sharedOf(p)["octaves"] = {4, 0, 2};
                        }},
                       {"more variants than columns", "map-cosines",
                        [](GlbParts& p) { sharedOf(p)["variants"] = 4; }},
                       {"more dimensions than channels", "map-dimensions",
                        [](GlbParts& p) { p.map(0, 0)["dimensions"] = 2; }},
                       {"an amplitude whose sum could be infinite", "cosines-texels",
                        [](GlbParts& p) {
                          // The last texel: the amplitude is the upper half of the first float
                          // of its second cosine.
                          p.binary[p.binary.size() - 6] = std::byte{0x00};
                          p.binary[p.binary.size() - 5] = std::byte{0x41}; // 8
                        }},
                       {"a lower half that is not a number", "cosines-texels",
                        [](GlbParts& p) {
                          p.binary[p.binary.size() - 8] = std::byte{0xC0};
                          p.binary[p.binary.size() - 7] = std::byte{0x7F};
                          p.binary[p.binary.size() - 5] = std::byte{0x3D}; // the upper half
                        }},
                       {"cosines as an inverse table", "map-inverse-table",
                        [](GlbParts& p) { p.map(0, 0)["inverseTable"] = 0; }},
                   });
}

TEST_CASE("the constants of a noise count the cosines of each octave") {
  Bundle bundle = example::smallestCosines().bundle;
  auto& shared = bundle.noises[0].as<LocalRandomPhaseNoise>();
  shared.cosines = {2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24};
  const shader::LichenCosinesNoise part = cosinesPart(shaderNoise(bundle, 0));
  CHECK(part.octaves0 == 0x08060402u);
  CHECK(part.octaves1 == 0x100E0C0Au);
  CHECK(part.octaves2 == 0x18161412u);
  CHECK(part.variants == 2);
  CHECK(part.columns == 7);
  CHECK(part.rows == 6);
  CHECK(part.cosines == 156);
  CHECK(part.structure == 0);
}

TEST_CASE("the constants of a noise hold the size of its structure and what its levels leave") {
  Bundle bundle = example::smallestStructure().bundle;
  bundle.noises[0].as<LocalRandomPhaseNoise>().structure.rows = 128;
  CHECK(cosinesPart(shaderNoise(bundle, 0)).structure == 0x40000376u); // 0.25 of 65,535, 3, 7 and 6
  const shader::LichenMap map = shaderMap(bundle, bundle.noises[0], 0);
  CHECK(map.sumFactor.x == Approx(0.5 / 511.0));
  CHECK(map.mipRetained0.x == 0x8099B3CCu); // 0.8, 0.7, 0.6 and 0.5 of 255
  CHECK(map.mipRetained0.y == 0x00001A4Cu); // 0.3 and 0.1, then nothing
  const auto isGuided = [&](bool periodic, double tiles) {
    Placement placement;
    placement.periodic = periodic;
    placement.periodTilesX = placement.periodTilesY = tiles;
    return cosinesPart(shaderMaterial(bundle, MaterialNoise(), placement).material).guided != 0;
  };
  CHECK(isGuided(false, 0.0));
  CHECK(isGuided(true, 3.0));
  CHECK_FALSE(isGuided(true, 1.5));
}

TEST_CASE("a tile origin moves the cosines' lattice by whole cells, modulo 2^32") {
  const Bundle bundle = example::smallestCosines().bundle;
  const auto at = [&](std::int64_t x, std::int64_t y) {
    Placement placement;
    placement.tileOriginX = x;
    placement.tileOriginY = y;
    return shaderMaterial(bundle, MaterialNoise(), placement).material;
  };
  // 7 columns and 6 rows, each half a column to the right, in 8 tiles.
  CHECK(at(16, 0).cellI == 14);
  CHECK(at(0, 8).cellI == -3);
  CHECK(at(0, 8).cellJ == 6);
  CHECK(at(13, -3).cellI == 7 + 3);
  CHECK(at(13, -3).cellJ == -6);
  CHECK(at(13, -3).offsetX == 5.0f);
  CHECK(at(13, -3).offsetY == 5.0f);
  const std::int64_t far = std::int64_t(1) << 40;
  CHECK(std::uint32_t(at(far, 0).cellI) == std::uint32_t(7u * std::uint64_t(far / 8)));
}

TEST_CASE("a period holds at least three columns and four rows of cosines, in a later octave") {
  const Bundle bundle = example::smallestCosines().bundle;
  for (const double tiles : {0.5, 1.0, 2.5, 40.0}) {
    Placement placement;
    placement.periodic = true;
    placement.periodTilesX = placement.periodTilesY = tiles;
    const shader::LichenMaterial material =
        shaderMaterial(bundle, MaterialNoise(), placement).material;
    INFO(tiles << " tiles");
    CHECK(material.periodColumns >= 3);
    CHECK(material.periodRows >= 4);
    CHECK(material.periodRows % 2 == 0);
    const int octave = cosinesPart(material).firstOctave;
    CHECK((octave == 0) == (tiles == 40.0));
    CHECK(double(material.columnsPerTile) * tiles == Approx(material.periodColumns));
    // Within a fifth of the lattice without a period, where there is room for one.
    if (material.periodColumns > 3)
      CHECK(double(material.columnsPerTile) == Approx(7.0 / 8.0 * std::exp2(octave)).epsilon(0.2));
  }
}
