// SPDX-License-Identifier: MIT
// The engine plugin's parameters of a material: its block and its errors.
#include "plugin_plan.h"

#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

using namespace lichen;
using namespace lichen::test;

TEST_CASE("a material's block holds its parameters") {
  BundleFile file = example::smallest();
  file.bundle.materials[0]->scale = 0.5;
  file.bundle.materials[0]->rotation = 0.25;
  file.bundle.materials[0]->offset = {3.0, -1.75};
  file.bundle.materials[0]->seed = 9;
  const OwnedBundle bundle(file);
  const Filled filled = fill(parametersOf(bundle.handle));
  REQUIRE(filled.result == LICHEN_SUCCESS);
  const shader::LichenMaterial& material = filled.block.material;
  CHECK(material.uvToTileXX == Approx(2.0 * std::cos(0.25)));
  CHECK(material.uvToTileXY == Approx(2.0 * std::sin(0.25)));
  CHECK(material.uvToTileYX == Approx(-2.0 * std::sin(0.25)));
  CHECK(material.offsetX == 1.0f); // the cell holds an even number of tiles
  CHECK(material.offsetY == 0.25f);
  CHECK(std::array{material.cellI, material.cellJ} == latticeCell(2, -2));
  CHECK(material.seedWord == latticeSeed(9, 0));
  CHECK(material.maxAnisotropy == 1.0f);
}

TEST_CASE("the blocks of every kind of noise and mapping equal the bundle library's") {
  BundleFile mix = example::textonMix();
  mix.bundle.materials[1]->mix = {MixSource::direction, 0.0, {0.5, -1.0}, {2.0, 3.0}, 0, 0, 0, 0};
  for (BundleFile& file :
       std::array{example::everyMap(), example::smallestTexton(), example::smallestCosines(),
                  example::smallestQuilting(), std::move(mix)}) {
    const OwnedBundle bundle(file);
    for (std::uint32_t noise = 0; noise < file.bundle.noises.size(); ++noise) {
      shader::LichenNoiseConstants block{};
      REQUIRE(lichenGetNoiseConstants(bundle.handle, noise, &block) == LICHEN_SUCCESS);
      const shader::LichenNoiseConstants expected = shaderConstants(file.bundle, noise);
      CHECK(std::memcmp(&block, &expected, sizeof block) == 0);
    }
    for (std::uint32_t index = 0; index < file.bundle.materials.size(); ++index) {
      MaterialNoise material = *file.bundle.materials[index];
      auto parameters =
          got<LichenMaterialParameters>(lichenGetMaterialParameters, bundle.handle, index);
      material.impacts = parameters.impacts = 12.5;
      material.pointProcess = PointProcess::poisson;
      parameters.pointProcess = LICHEN_POINT_PROCESS_POISSON;
      for (const auto& [mapping, code] : {std::pair{Mapping::uv, LICHEN_MAPPING_UV},
                                          {Mapping::triplanar, LICHEN_MAPPING_TRIPLANAR},
                                          {Mapping::surface, LICHEN_MAPPING_SURFACE},
                                          {Mapping::solid, LICHEN_MAPPING_SOLID}}) {
        if (!mappingFits(file.bundle.noises[material.noise].method(), mapping))
          continue;
        material.mapping = mapping;
        parameters.mapping = code;
        material.seed = parameters.seed = 77;
        Placement placement;
        LichenPlacement hostPlacement = atOrigin();
        hostPlacement.tileOrigin[0] = placement.tileOriginX = -70000;
        hostPlacement.tileOrigin[1] = placement.tileOriginY = 10000000;
        placement.maxAnisotropy = 8.0;
        hostPlacement.maxAnisotropy = 8.0f;
        if (mapping != Mapping::uv)
          hostPlacement.tileOrigin[2] = placement.tileOriginZ = std::int64_t(1) << 40;
        else if (index == 0 && file.bundle.noises[0].method() == Method::tiling) {
          placement.periodic = true;
          placement.periodTilesX = hostPlacement.periodTiles[0] = 3.0;
          placement.periodTilesY = hostPlacement.periodTiles[1] = 2.0;
        }
        const Filled filled = fill(parameters, hostPlacement);
        REQUIRE(filled.message == "");
        const auto expected = shaderMaterial(file.bundle, material, placement);
        CHECK(std::memcmp(&filled.block, &expected,
                          mapping == Mapping::triplanar ? LICHEN_TRIPLANAR_MATERIAL_BYTES
                                                        : LICHEN_MATERIAL_BYTES) == 0);
      }
    }
  }
}

TEST_CASE("the default parameters belong to a material that says nothing") {
  const BundleFile file = example::smallest();
  const OwnedBundle bundle(file);
  auto parameters = got<LichenMaterialParameters>(lichenGetDefaultParameters, bundle.handle, 0);
  const Filled filled = fill(parameters);
  REQUIRE(filled.result == LICHEN_SUCCESS);
  const shader::LichenMaterial expected =
      shaderMaterial(file.bundle, MaterialNoise{}, Placement{}).material;
  CHECK(std::memcmp(&filled.block.material, &expected, sizeof expected) == 0);
  CHECK(lichenGetDefaultParameters(bundle.handle, 1, &parameters) == LICHEN_ERROR_USAGE);
  CHECK(lichenGetMaterialParameters(bundle.handle, 1, &parameters) == LICHEN_ERROR_USAGE);
}

TEST_CASE("only the bytes of the mapping's block are written") {
  const OwnedBundle bundle(example::smallest());
  LichenMaterialParameters parameters = parametersOf(bundle.handle);
  constexpr unsigned char kUntouched = 0xA5;
  for (const auto& [mapping, bytes] :
       {std::pair{LICHEN_MAPPING_UV, LICHEN_MATERIAL_BYTES},
        std::pair{LICHEN_MAPPING_TRIPLANAR, LICHEN_TRIPLANAR_MATERIAL_BYTES}}) {
    std::array<unsigned char, LICHEN_TRIPLANAR_MATERIAL_BYTES + 16> block;
    block.fill(kUntouched);
    parameters.mapping = mapping;
    // The block may have any alignment; no placement is the origin.
    REQUIRE(lichenFillMaterial(&parameters, nullptr, block.data() + 1, nullptr) == LICHEN_SUCCESS);
    CHECK(block.front() == kUntouched);
    CHECK(std::count(block.begin() + 1 + bytes, block.end(), kUntouched) ==
          block.end() - (block.begin() + 1 + bytes));
  }
}

TEST_CASE("the error for a parameter outside its range names it") {
  const OwnedBundle bundle(example::smallest());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  struct Case {
    const char* name;
    void (*set)(LichenMaterialParameters&, LichenPlacement&, double);
    std::vector<double> bad;
  };
  const Case cases[] = {
      {"scale",
       [](auto& p, auto&, double v) { p.scale = v; },
       {0.0, -1.0, 0.9e-6, 1.1e6, nan, infinity}},
      {"offset[1]",
       [](auto& p, auto&, double v) { p.offset[1] = v; },
       {1.1e9, -1.1e9, nan, infinity}},
      {"rotation",
       [](auto& p, auto&, double v) { p.rotation = v; },
       {1.1e6, -1.1e6, nan, infinity}},
      {"blendSharpness", [](auto& p, auto&, double v) { p.blendSharpness = v; }, {0.2, 17.0, nan}},
      {"contrast", [](auto& p, auto&, double v) { p.contrast = v; }, {-0.1, 4.1, nan}},
      {"planeSharpness", [](auto& p, auto&, double v) { p.planeSharpness = v; }, {0.9, 65.0, nan}},
      {"impacts", [](auto& p, auto&, double v) { p.impacts = v; }, {0.9, 1001.0, nan}},
      {"mixWeight", [](auto& p, auto&, double v) { p.mixWeight = v; }, {-0.1, 1.1, nan}},
      {"mixSource", [](auto& p, auto&, double v) { p.mixSource = LichenMixSource(int(v)); }, {4.0}},
      {"mixStart[0]",
       [](auto& p, auto&, double v) { p.mixStart[0] = v; },
       {1.1e9, -1.1e9, nan, infinity}},
      {"mixEnd",
       [](auto& p, auto&, double v) {
         p.mixSource = LICHEN_MIX_DIRECTION;
         p.mixEnd[0] = p.mixStart[0] + v;
         p.mixEnd[1] = p.mixStart[1];
       },
       {0.0, nan, infinity}},
      {"pointProcess",
       [](auto& p, auto&, double v) { p.pointProcess = LichenPointProcess(int(v)); },
       {2.0}},
      {"tileRotation",
       [](auto& p, auto&, double v) { p.tileRotation = std::uint32_t(v); },
       {3.0, 4.0, 5.0, 65536.0, 4294967295.0}}, // 4: tiles are not square
      {"mapping",
       [](auto& p, auto&, double v) { p.mapping = LichenMapping(int(v)); },
       {2.0, 3.0, 4.0}}, // 2 (surface) needs textons
      {"maxAnisotropy",
       [](auto&, auto& i, double v) { i.maxAnisotropy = float(v); },
       {-1.0, 65.0, nan}},
      {"tileOrigin[0]",
       [](auto&, auto& i, double v) { i.tileOrigin[0] = std::int64_t(v); },
       {1e13, -1e13}},
      {"tileOrigin[2]",
       [](auto&, auto& i, double v) { i.tileOrigin[2] = std::int64_t(v); },
       {1e13, -1e13}},
      {"periodTiles",
       [](auto&, auto& i, double v) { i.periodTiles[0] = v; },
       {1.0, -1.0, 0.5, 65537.0, nan}},
  };
  for (const Case& one : cases)
    for (const double value : one.bad) {
      LichenMaterialParameters parameters = parametersOf(bundle.handle);
      LichenPlacement placement = atOrigin();
      one.set(parameters, placement, value);
      const Filled filled = fill(parameters, placement);
      INFO(one.name << " = " << value);
      CHECK(filled.result == LICHEN_ERROR_USAGE);
      INFO(filled.message);
      CHECK(filled.message.starts_with(one.name));
      CHECK((filled.message.find("expected") != std::string::npos ||
             filled.message.find("is closer than") != std::string::npos));
    }
}

TEST_CASE("a noise takes quarter turns of its tiles if they are square, or if it has none") {
  const OwnedBundle oblong(example::smallest()), square(example::everyMap()),
      quilting(example::smallestQuilting());
  const auto check = [](LichenBundle bundle, std::uint32_t noise, bool isTaken) {
    auto properties = got<LichenNoiseProperties>(lichenGetNoiseProperties, bundle, noise);
    CHECK(properties.takesQuarterTurns == (isTaken ? 1u : 0u));
    auto parameters = got<LichenMaterialParameters>(lichenGetDefaultParameters, bundle, noise);
    parameters.tileRotation = 2;
    CHECK(fill(parameters).result == LICHEN_SUCCESS);
    parameters.tileRotation = 4;
    CHECK((fill(parameters).result == LICHEN_SUCCESS) == isTaken);
  };
  check(oblong.handle, 0, false);
  check(square.handle, 1, true);
  check(quilting.handle, 0, true);
}

TEST_CASE("parameters that the library has not written are an error") {
  LichenMaterialParameters parameters;
  LICHEN_INIT(parameters, LICHEN_STRUCTURE_MATERIAL_PARAMETERS);
  const Filled filled = fill(parameters);
  CHECK(filled.result == LICHEN_ERROR_USAGE);
  CHECK(filled.message.find("lichenGetMaterialParameters") != std::string::npos);
  const OwnedBundle bundle(example::smallest());
  for (std::size_t word = 0; word < std::size(parameters.noiseSummary); ++word) {
    parameters = parametersOf(bundle.handle);
    parameters.noiseSummary[word] ^= 0x7f800000u; // of a float, infinity
    INFO("word " << word);
    CHECK(fill(parameters).result == LICHEN_ERROR_USAGE);
  }
}

TEST_CASE("a solid of a noise with a structure is refused, and the properties say which has one") {
  const OwnedBundle cosines(example::smallestCosines()), structure(example::smallestStructure());
  LichenMaterialParameters parameters = parametersOf(structure.handle);
  parameters.mapping = LICHEN_MAPPING_SOLID;
  const Filled refused = fill(parameters);
  CHECK(refused.result == LICHEN_ERROR_USAGE);
  CHECK(refused.message == "mapping 3 (solid) does not fit the noise: it has a structure, which "
                           "lies in a plane");
  parameters = parametersOf(cosines.handle);
  parameters.mapping = LICHEN_MAPPING_SOLID;
  CHECK(fill(parameters).result == LICHEN_SUCCESS);
  for (const auto& [handle, expected] : {std::pair{cosines.handle, 0u}, {structure.handle, 1u}}) {
    auto noise = got<LichenNoiseProperties>(lichenGetNoiseProperties, handle, 0);
    CHECK(((noise.mappings >> LICHEN_MAPPING_SOLID) & 1u) == 1u - expected);
  }
}

TEST_CASE("a period is on both axes of a plane, and whole beyond the tile origin of 0") {
  const OwnedBundle bundle(example::smallest());
  LichenMaterialParameters parameters = parametersOf(bundle.handle);
  const auto messageOf = [&](double first, double second, std::int64_t origin) {
    LichenPlacement placement = atOrigin();
    placement.periodTiles[0] = first;
    placement.periodTiles[1] = second;
    placement.tileOrigin[0] = origin;
    const Filled filled = fill(parameters, placement);
    CHECK(filled.result == (filled.message.empty() ? LICHEN_SUCCESS : LICHEN_ERROR_USAGE));
    return filled.message;
  };
  CHECK(messageOf(1.5, 1.5, 0) == "");
  CHECK(messageOf(1.5, 1.5, 1) ==
        "periodTiles[0] 1.5 must be a whole number when tileOrigin[0] is not 0");
  CHECK(messageOf(3.0, 0.0, 0) ==
        "periodTiles[1] 0 is out of range; expected 1 to 65536, or 0 on both axes for none");
  parameters.mapping = LICHEN_MAPPING_TRIPLANAR;
  CHECK(messageOf(0.0, 0.0, 0) == "");
  CHECK(messageOf(2.0, 2.0, 0) ==
        "periodTiles 2 is not supported for triplanar mapping, which cannot repeat; set it to 0");
}
