// SPDX-License-Identifier: MIT
// What the shader's constants hold of a noise and its material, and the numbers that images pack.
#include "bundle_example.h"

#include <lichen/bfloat16_pair.h>
#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>
#include <lichen/structure_texel.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace lichen;

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

TEST_CASE("the constants of a noise count the cosines of each octave") {
  Bundle bundle = example::smallestCosines().bundle;
  auto& shared = bundle.noises[0].as<LocalRandomPhaseNoise>();
  shared.cosines = {2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24};
  const auto part = partOf<shader::LichenCosinesNoise>(shaderNoise(bundle, 0));
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
  CHECK(partOf<shader::LichenCosinesNoise>(shaderNoise(bundle, 0)).structure ==
        0x40000376u); // 0.25 of 65,535, 3, 7 and 6
  const shader::LichenMap map = shaderMap(bundle, bundle.noises[0], 0);
  CHECK(map.sumFactor.x == Approx(0.5 / 511.0));
  CHECK(map.mipRetained0.x == 0x8099B3CCu); // 0.8, 0.7, 0.6 and 0.5 of 255
  CHECK(map.mipRetained0.y == 0x00001A4Cu); // 0.3 and 0.1, then nothing
  const auto isGuided = [&](bool periodic, double tiles) {
    Placement placement;
    placement.periodic = periodic;
    placement.periodTilesX = placement.periodTilesY = tiles;
    return partOf<shader::LichenCosinesMaterial>(
               shaderMaterial(bundle, MaterialNoise(), placement).material)
               .guided != 0;
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
    const int octave = partOf<shader::LichenCosinesMaterial>(material).firstOctave;
    CHECK((octave == 0) == (tiles == 40.0));
    CHECK(double(material.columnsPerTile) * tiles == Approx(material.periodColumns));
    // Within a fifth of the lattice without a period, where there is room for one.
    if (material.periodColumns > 3)
      CHECK(double(material.columnsPerTile) == Approx(7.0 / 8.0 * std::exp2(octave)).epsilon(0.2));
  }
}

TEST_CASE("the constants of a kernels noise and its material have the numbers of its kernels") {
  const Bundle bundle = example::smallestKernels().bundle;
  const auto noise = partOf<shader::LichenKernelsNoise>(shaderNoise(bundle, 0));
  CHECK(noise.kernels == 2);
  CHECK(noise.rings == 1);
  CHECK(noise.cosines == 2);
  CHECK(noise.window == LICHEN_WINDOW_GABOR);
  Placement placement;
  placement.tileOriginX = 8 * 5 + 3;
  placement.tileOriginY = -8 - 1;
  const shader::LichenMaterial material =
      shaderMaterial(bundle, MaterialNoise(), placement).material;
  CHECK(material.cellI == 5);
  CHECK(material.offsetX == 3.0f);
  CHECK(material.cellJ == -2);
  CHECK(material.offsetY == 7.0f);
}

TEST_CASE("the constants of a quilting noise hold its reach, its offsets and the size of cells") {
  BundleFile file = example::smallestQuilting();
  constexpr double kBelowOne = 0.9999999; // rounds to a whole tile, which is none
  file.bundle.noises[0].as<QuiltingNoise>().offsets.push_back({kBelowOne, 0.25});
  file.bundle.tables[0] = example::constantTable(TexelFormat::rgba8Unorm, 8, 0.5f);
  const Bundle bundle = parseBundle(encodeGlb(file).value(), "quilting").value();
  const shader::LichenNoiseConstants constants = shaderConstants(bundle, 0);
  CHECK(constants.noise.method == LICHEN_METHOD_QUILTING);
  CHECK(constants.noise.tileTexelsX == 4.0f);
  const auto part = partOf<shader::LichenQuiltingNoise>(constants.noise);
  CHECK(part.reach == 0.125f);
  CHECK(part.cellLevelOffset == 1.0f); // twice as wide as the map
  CHECK(part.offsets == 5);
  constexpr std::uint32_t kHalf = 0x8000, kQuarter = 0x4000;
  CHECK(constants.offsets[0].x == 0);
  CHECK(constants.offsets[0].y == kHalf);
  CHECK(constants.offsets[0].z == kHalf << 16u);
  CHECK(constants.offsets[0].w == (kHalf | kHalf << 16u));
  CHECK(constants.offsets[1].x == kQuarter << 16u);
  CHECK(constants.offsets[1].y == 0);
}

TEST_CASE("the constants of a quilting map have the mean of what its texels stand for") {
  const auto meanOf = [](ValueEncoding encoding, float value) {
    BundleFile file = example::smallestQuilting();
    file.bundle.tables[1] = example::constantTable(TexelFormat::r16Sfloat, 4, value);
    file.bundle.noises[0].maps[0].encoding = encoding;
    return shaderMap(file.bundle, file.bundle.noises[0], 0).mean.x;
  };
  CHECK(meanOf(ValueEncoding::linear, 0.25f) == 0.25f);
  CHECK(meanOf(ValueEncoding::root, 0.25f) == 0.0625f);
  CHECK(meanOf(ValueEncoding::log2, 3.0f) == 7.0f);
  // The third value of slopes is their variance, the mean of both axes.
  const Bundle bundle = example::smallestQuilting().bundle;
  const shader::LichenMap normal = shaderMap(bundle, bundle.noises[0], 1);
  CHECK(normal.decoding == LICHEN_DECODING_NONE);
  double sumX = 0.0, sumY = 0.0, squares = 0.0;
  const std::vector<float> texels = decodeLevel(bundle.tables[2], 0);
  for (std::size_t i = 0; i < texels.size(); i += 4) {
    sumX += double(texels[i]);
    sumY += double(texels[i + 1]);
    squares +=
        double(texels[i]) * double(texels[i]) + double(texels[i + 1]) * double(texels[i + 1]);
  }
  const double count = double(texels.size()) / 4.0;
  const double meanX = sumX / count, meanY = sumY / count;
  constexpr double kHalfRounding = 1e-3;
  CHECK(normal.mean.x == Approx(meanX).margin(kHalfRounding));
  CHECK(normal.mean.y == Approx(meanY).margin(kHalfRounding));
  CHECK(normal.mean.z ==
        Approx((squares / count - meanX * meanX - meanY * meanY) / 2.0).margin(kHalfRounding));
}

TEST_CASE("a tile origin of quilting is one of the lattice, and the rest an offset") {
  const Bundle bundle = example::smallestQuilting().bundle;
  Placement placement;
  placement.tileOriginX = 2 * 5 + 1;
  placement.tileOriginY = -3;
  const shader::LichenMaterial material =
      shaderMaterial(bundle, MaterialNoise(), placement).material;
  CHECK(material.cellI == 5 * 7 + 3 * 2);
  CHECK(material.offsetX == 1.0f);
  CHECK(material.cellJ == -3 * 4);
  CHECK(material.offsetY == 0.0f);
  CHECK(material.columnsPerTile == 3.5f);
  CHECK(material.rowsPerTile == 4.0f);
}
