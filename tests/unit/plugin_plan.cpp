// SPDX-License-Identifier: MIT
// The engine plugin's plan layer: its descriptions and its errors.
#include "plugin_plan.h"

#include "bundle_surgery.h"

#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

using namespace lichen;
using namespace lichen::test;

TEST_CASE("the inverse table of one dimension is a 3-D image one texel high and deep") {
  const OwnedBundle bundle(example::smallest());
  LichenMapProperties map;
  LICHEN_INIT(map, LICHEN_STRUCTURE_MAP_PROPERTIES);
  REQUIRE(lichenGetMapProperties(bundle.handle, 0, 0, &map) == LICHEN_SUCCESS);
  CHECK(map.target == LICHEN_TARGET_HEIGHT);
  CHECK(map.channelCount == 1);
  CHECK(map.channels[0] == LICHEN_CHANNEL_HEIGHT);
  LichenImageProperties image;
  LICHEN_INIT(image, LICHEN_STRUCTURE_IMAGE_PROPERTIES);
  REQUIRE(lichenGetImageProperties(bundle.handle, map.tableImage, &image) == LICHEN_SUCCESS);
  CHECK(image.dimensionality == 3);
  CHECK(image.width == 256);
  CHECK(image.height == 1);
  CHECK(image.depth == 1);
  CHECK(image.vkFormat == 9); // VK_FORMAT_R8_UNORM
  REQUIRE(lichenGetImageProperties(bundle.handle, map.image, &image) == LICHEN_SUCCESS);
  CHECK(image.dimensionality == 2);
  CHECK(image.mipLevels == 3);
}

TEST_CASE("the copies of an image cover its bytes without gaps") {
  const OwnedBundle bundle(example::smallest());
  LichenBundleProperties properties;
  LICHEN_INIT(properties, LICHEN_STRUCTURE_BUNDLE_PROPERTIES);
  REQUIRE(lichenGetBundleProperties(bundle.handle, &properties) == LICHEN_SUCCESS);
  REQUIRE(properties.imageCount == 4); // with the placeholders
  for (std::uint32_t i = 0; i < properties.imageCount; ++i) {
    LichenImageProperties image;
    LICHEN_INIT(image, LICHEN_STRUCTURE_IMAGE_PROPERTIES);
    REQUIRE(lichenGetImageProperties(bundle.handle, i, &image) == LICHEN_SUCCESS);
    std::size_t end = 0;
    for (std::uint32_t level = 0; level < image.mipLevels; ++level) {
      LichenCopy copy;
      LICHEN_INIT(copy, LICHEN_STRUCTURE_COPY);
      REQUIRE(lichenGetCopy(bundle.handle, i, level, &copy) == LICHEN_SUCCESS);
      CHECK(copy.offset == end);
      CHECK(copy.byteCount ==
            std::size_t(copy.width) * copy.height * copy.depth * image.texelBytes);
      end = copy.offset + copy.byteCount;
    }
    CHECK(end == image.byteCount);
    LichenCopy copy;
    LICHEN_INIT(copy, LICHEN_STRUCTURE_COPY);
    CHECK(lichenGetCopy(bundle.handle, i, image.mipLevels, &copy) == LICHEN_ERROR_USAGE);
  }
}

TEST_CASE("a set has two blocks, two samplers, and an image and a table for each role") {
  const OwnedBundle bundle(example::smallest()); // one map: a height
  LichenMapProperties height;
  LICHEN_INIT(height, LICHEN_STRUCTURE_MAP_PROPERTIES);
  REQUIRE(lichenGetMapProperties(bundle.handle, 0, 0, &height) == LICHEN_SUCCESS);
  std::array<LichenBinding, LICHEN_SET_BINDINGS> bindings;
  for (std::uint32_t i = 0; i < LICHEN_SET_BINDINGS; ++i) {
    LICHEN_INIT(bindings[i], LICHEN_STRUCTURE_BINDING);
    REQUIRE(lichenGetBinding(bundle.handle, 0, i, &bindings[i]) == LICHEN_SUCCESS);
    CHECK(bindings[i].binding == i);
  }
  CHECK(bindings[LICHEN_BINDING_NOISE].kind == LICHEN_BINDING_NOISE_BUFFER);
  CHECK(bindings[LICHEN_BINDING_MATERIAL].kind == LICHEN_BINDING_MATERIAL_BUFFER);
  CHECK(bindings[LICHEN_BINDING_IMAGE_SAMPLER].kind == LICHEN_BINDING_SAMPLER);
  CHECK(bindings[LICHEN_BINDING_IMAGE_SAMPLER].sampler == LICHEN_SAMPLER_IMAGE);
  CHECK(bindings[LICHEN_BINDING_TABLE_SAMPLER].kind == LICHEN_BINDING_SAMPLER);
  CHECK(bindings[LICHEN_BINDING_TABLE_SAMPLER].sampler == LICHEN_SAMPLER_TABLE);
  for (std::uint32_t role = 0; role < LICHEN_MAX_MAPS; ++role) {
    INFO("role " << role);
    const LichenBinding& image = bindings[LICHEN_BINDING_IMAGE(role)];
    const LichenBinding& table = bindings[LICHEN_BINDING_TABLE(role)];
    CHECK(image.kind == LICHEN_BINDING_SAMPLED_IMAGE);
    CHECK(image.sampler == LICHEN_SAMPLER_IMAGE);
    CHECK(table.kind == LICHEN_BINDING_SAMPLED_IMAGE);
    CHECK(table.sampler == LICHEN_SAMPLER_TABLE);
    CHECK((image.image == height.image) == (role == LICHEN_HEIGHT));
    CHECK((table.image == height.tableImage) == (role == LICHEN_HEIGHT));
    for (const LichenBinding* one : {&image, &table}) {
      LichenImageProperties properties;
      LICHEN_INIT(properties, LICHEN_STRUCTURE_IMAGE_PROPERTIES);
      REQUIRE(lichenGetImageProperties(bundle.handle, one->image, &properties) == LICHEN_SUCCESS);
      CHECK(properties.dimensionality == (one == &image ? 2u : 3u));
      if (role != LICHEN_HEIGHT)
        CHECK(properties.byteCount == 4); // a placeholder
    }
  }
  LichenBinding binding;
  LICHEN_INIT(binding, LICHEN_STRUCTURE_BINDING);
  CHECK(lichenGetBinding(bundle.handle, 0, LICHEN_SET_BINDINGS, &binding) == LICHEN_ERROR_USAGE);
}

TEST_CASE("a noise's block holds the bundle's constants, each map at its role") {
  BundleFile file = example::smallest();
  example::setLosses(file.bundle.tables[0], {0.2f, 0.4f, 0.6f});
  const OwnedBundle bundle(file);
  shader::LichenNoiseConstants block{};
  REQUIRE(lichenGetNoiseConstants(bundle.handle, 0, &block) == LICHEN_SUCCESS);
  CHECK(block.noise.roles == 1u << LICHEN_HEIGHT);
  CHECK(block.noise.method == LICHEN_METHOD_TILING);
  CHECK(block.noise.tileTexelsX == 4.0f);
  CHECK(block.noise.offsetStepX == 0.25f); // every texel of 4 x 2
  CHECK(block.noise.offsetStepY == 0.5f);
  const shader::LichenMap& map = block.maps[LICHEN_HEIGHT];
  CHECK(map.widthTexels == 4.0f);
  CHECK(map.dimensions == 1);
  CHECK(map.mipCount == 3);
  CHECK(map.levelOffset == 0.0f);
  CHECK(map.interpolationLoss == Approx(51.0 / 255.0)); // the loss of level 0
  CHECK(map.mean.x == 0.5f);
  CHECK(map.mean.w == 1.0f);
  CHECK(block.maps[LICHEN_BASE_COLOR].mipCount == 0);
  CHECK(lichenGetNoiseConstants(bundle.handle, 1, &block) == LICHEN_ERROR_USAGE);
  CHECK(lichenGetNoiseConstants(bundle.handle, 0, nullptr) == LICHEN_ERROR_USAGE);
  CHECK(lichenGetNoiseConstants(nullptr, 0, &block) == LICHEN_ERROR_USAGE);
}

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

TEST_CASE("a material's block is that of the bundle library, with any parameters and placement") {
  BundleFile file = example::smallest();
  MaterialNoise& own = *file.bundle.materials[0];
  own.mapping = Mapping::triplanar;
  own.seed = 0xfedcba98u;
  own.scale = 0.3;
  own.offset = {0.25, -7.5};
  own.rotation = 1.25;
  own.blendSharpness = 2.5;
  own.contrast = 0.75;
  own.planeSharpness = 5.0;
  own.tileRotation = 4;
  const OwnedBundle bundle(file);
  const auto same = [&](const MaterialNoise& material, const Placement& placement,
                        const Filled& filled) {
    INFO(filled.message);
    REQUIRE(filled.result == LICHEN_SUCCESS);
    const shader::LichenTriplanarMaterial expected =
        shaderMaterial(file.bundle, material, placement);
    const std::size_t bytes = material.mapping == Mapping::triplanar
                                  ? LICHEN_TRIPLANAR_MATERIAL_BYTES
                                  : LICHEN_MATERIAL_BYTES;
    CHECK(std::memcmp(&filled.block, &expected, bytes) == 0);
  };
  LichenMaterialParameters parameters = parametersOf(bundle.handle);
  same(own, {}, fill(parameters));
  // The bundle need not live: only the parameters are read.
  Placement placement;
  placement.tileOriginX = 10000000;
  placement.tileOriginY = -3;
  placement.tileOriginZ = std::int64_t(1) << 40;
  placement.maxAnisotropy = 8.0;
  LichenPlacement hostPlacement = atOrigin();
  hostPlacement.tileOrigin[0] = placement.tileOriginX;
  hostPlacement.tileOrigin[1] = placement.tileOriginY;
  hostPlacement.tileOrigin[2] = placement.tileOriginZ;
  hostPlacement.maxAnisotropy = 8.0f;
  same(own, placement, fill(parameters, hostPlacement));
  MaterialNoise changed = own;
  changed.seed = 77;
  changed.scale = 4.0;
  changed.mapping = Mapping::uv;
  changed.tileRotation = 0;
  parameters.seed = 77;
  parameters.scale = 4.0;
  parameters.mapping = LICHEN_MAPPING_UV;
  parameters.tileRotation = 0;
  placement.tileOriginZ = 0;
  placement.periodic = true;
  placement.periodTilesX = hostPlacement.periodTiles[0] = 3.0;
  placement.periodTilesY = hostPlacement.periodTiles[1] = 2.0;
  hostPlacement.tileOrigin[2] = 0;
  same(changed, placement, fill(parameters, hostPlacement));
}

TEST_CASE("the blocks of every kind of noise and mapping are those of the bundle library") {
  BundleFile mix = example::textonMix();
  mix.bundle.materials[1]->mix = {MixSource::direction, 0.0, {0.5, -1.0}, {2.0, 3.0}, 0, 0, 0, 0};
  for (BundleFile& file :
       std::array{example::everyMap(), example::smallestTexton(), std::move(mix)}) {
    const OwnedBundle bundle(file);
    for (std::uint32_t noise = 0; noise < file.bundle.noises.size(); ++noise) {
      shader::LichenNoiseConstants block{};
      REQUIRE(lichenGetNoiseConstants(bundle.handle, noise, &block) == LICHEN_SUCCESS);
      const shader::LichenNoiseConstants expected = shaderConstants(file.bundle, noise);
      CHECK(std::memcmp(&block, &expected, sizeof block) == 0);
    }
    for (std::uint32_t index = 0; index < file.bundle.materials.size(); ++index) {
      MaterialNoise material = *file.bundle.materials[index];
      LichenMaterialParameters parameters;
      LICHEN_INIT(parameters, LICHEN_STRUCTURE_MATERIAL_PARAMETERS);
      REQUIRE(lichenGetMaterialParameters(bundle.handle, index, &parameters) == LICHEN_SUCCESS);
      material.impacts = parameters.impacts = 12.5;
      material.pointProcess = PointProcess::poisson;
      parameters.pointProcess = LICHEN_POINT_PROCESS_POISSON;
      for (const auto& [mapping, code] : {std::pair{Mapping::uv, LICHEN_MAPPING_UV},
                                          {Mapping::triplanar, LICHEN_MAPPING_TRIPLANAR},
                                          {Mapping::surface, LICHEN_MAPPING_SURFACE}}) {
        if (!mappingFits(file.bundle.noises[material.noise].method(), mapping))
          continue;
        material.mapping = mapping;
        parameters.mapping = code;
        Placement placement;
        placement.tileOriginX = -70000;
        LichenPlacement hostPlacement = atOrigin();
        hostPlacement.tileOrigin[0] = placement.tileOriginX;
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

TEST_CASE("the default parameters are those of a material that says nothing") {
  const BundleFile file = example::smallest();
  const OwnedBundle bundle(file);
  LichenMaterialParameters parameters;
  LICHEN_INIT(parameters, LICHEN_STRUCTURE_MATERIAL_PARAMETERS);
  REQUIRE(lichenGetDefaultParameters(bundle.handle, 0, &parameters) == LICHEN_SUCCESS);
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
    // Of any alignment; no placement is the origin.
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
  using Parameters = LichenMaterialParameters;
  const Case cases[] = {
      {"scale",
       [](Parameters& p, LichenPlacement&, double v) { p.scale = v; },
       {0.0, -1.0, 0.9e-6, 1.1e6, nan, infinity}},
      {"offset[1]",
       [](Parameters& p, LichenPlacement&, double v) { p.offset[1] = v; },
       {1.1e9, -1.1e9, nan, infinity}},
      {"rotation",
       [](Parameters& p, LichenPlacement&, double v) { p.rotation = v; },
       {1.1e6, -1.1e6, nan, infinity}},
      {"blendSharpness",
       [](Parameters& p, LichenPlacement&, double v) { p.blendSharpness = v; },
       {0.2, 17.0, nan}},
      {"contrast",
       [](Parameters& p, LichenPlacement&, double v) { p.contrast = v; },
       {-0.1, 4.1, nan}},
      {"planeSharpness",
       [](Parameters& p, LichenPlacement&, double v) { p.planeSharpness = v; },
       {0.9, 65.0, nan}},
      {"impacts",
       [](Parameters& p, LichenPlacement&, double v) { p.impacts = v; },
       {0.9, 1001.0, nan}},
      {"mixWeight",
       [](Parameters& p, LichenPlacement&, double v) { p.mixWeight = v; },
       {-0.1, 1.1, nan}},
      {"mixSource",
       [](Parameters& p, LichenPlacement&, double v) { p.mixSource = LichenMixSource(int(v)); },
       {4.0}},
      {"mixStart[0]",
       [](Parameters& p, LichenPlacement&, double v) { p.mixStart[0] = v; },
       {1.1e9, -1.1e9, nan, infinity}},
      {"mixEnd",
       [](Parameters& p, LichenPlacement&, double v) {
         p.mixSource = LICHEN_MIX_DIRECTION;
         p.mixEnd[0] = p.mixStart[0] + v;
         p.mixEnd[1] = p.mixStart[1];
       },
       {0.0, nan, infinity}},
      {"pointProcess",
       [](Parameters& p, LichenPlacement&, double v) {
         p.pointProcess = LichenPointProcess(int(v));
       },
       {2.0}},
      {"tileRotation",
       [](Parameters& p, LichenPlacement&, double v) { p.tileRotation = std::uint32_t(v); },
       {65537.0, 4294967295.0}},
      {"mapping",
       [](Parameters& p, LichenPlacement&, double v) { p.mapping = LichenMapping(int(v)); },
       {2.0, 3.0, 4.0}}, // 2 (surface) needs textons
      {"maxAnisotropy",
       [](Parameters&, LichenPlacement& i, double v) { i.maxAnisotropy = float(v); },
       {-1.0, 65.0, nan}},
      {"tileOrigin[0]",
       [](Parameters&, LichenPlacement& i, double v) { i.tileOrigin[0] = std::int64_t(v); },
       {1e13, -1e13}},
      {"tileOrigin[2]",
       [](Parameters&, LichenPlacement& i, double v) { i.tileOrigin[2] = std::int64_t(v); },
       {1e13, -1e13}},
      {"periodTiles",
       [](Parameters&, LichenPlacement& i, double v) { i.periodTiles[0] = v; },
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

TEST_CASE("parameters that the library has not written are an error") {
  LichenMaterialParameters parameters;
  LICHEN_INIT(parameters, LICHEN_STRUCTURE_MATERIAL_PARAMETERS);
  const Filled filled = fill(parameters);
  CHECK(filled.result == LICHEN_ERROR_USAGE);
  CHECK(filled.message.find("lichenGetMaterialParameters") != std::string::npos);
  const OwnedBundle bundle(example::smallest());
  for (std::size_t word = 0; word < std::size(parameters.ofNoise); ++word) {
    parameters = parametersOf(bundle.handle);
    parameters.ofNoise[word] ^= 0x7f800000u; // of a float, infinity
    INFO("word " << word);
    CHECK(fill(parameters).result == LICHEN_ERROR_USAGE);
  }
}

namespace {

std::string switchesOf(const std::vector<LichenMaterialParameters>& materials,
                       const LichenPlacement* placement = nullptr) {
  std::vector<const LichenMaterialParameters*> pointers;
  for (const LichenMaterialParameters& material : materials)
    pointers.push_back(&material);
  char text[LICHEN_SWITCH_BYTES] = "";
  CHECK(lichenGetShaderSwitches(pointers.data(), std::uint32_t(pointers.size()), placement, text,
                                sizeof text, nullptr) == LICHEN_SUCCESS);
  return text;
}

} // namespace

TEST_CASE("the switches leave out what no material needs") {
  const OwnedBundle tiling(example::smallest());
  const LichenMaterialParameters plain = parametersOf(tiling.handle);
  const std::string left = " -DLICHEN_OMIT_TEXTONS -DLICHEN_OMIT_TRIPLANAR";
  CHECK(switchesOf({plain}) ==
        "-DLICHEN_ROLES=16" + left +
            " -DLICHEN_GAUSSIAN_ONLY=0 -DLICHEN_TILE_ROTATION=0 -DLICHEN_BLEND_SHARPNESS=0"
            " -DLICHEN_PERIODIC_LATTICE=0");
  LichenMaterialParameters turned = plain;
  turned.tileRotation = 4;
  turned.blendSharpness = 2.0;
  LichenPlacement placement = atOrigin();
  placement.periodTiles[0] = placement.periodTiles[1] = 2.0;
  placement.maxAnisotropy = 8.0f;
  CHECK(switchesOf({plain, turned}, &placement) ==
        "-DLICHEN_ROLES=16" + left + " -DLICHEN_GAUSSIAN_ONLY=0 -DLICHEN_ANISOTROPIC=1");
  LichenMaterialParameters inPlanes = plain;
  inPlanes.mapping = LICHEN_MAPPING_TRIPLANAR;
  CHECK(switchesOf({inPlanes}).find(" -DLICHEN_OTHER_MAPPINGS=0 ") != std::string::npos);
  CHECK(switchesOf({inPlanes, plain}).find("MAPPINGS") == std::string::npos);
  // Of two bundles and methods.
  const OwnedBundle textons(example::textonMix());
  LichenMaterialParameters mixed;
  LICHEN_INIT(mixed, LICHEN_STRUCTURE_MATERIAL_PARAMETERS);
  REQUIRE(lichenGetMaterialParameters(textons.handle, 1, &mixed) == LICHEN_SUCCESS);
  const std::string both = switchesOf({plain, mixed});
  CHECK(both.find("OMIT_TEXTONS") == std::string::npos);
  CHECK(both.find("TILING_NOISES") == std::string::npos);
  CHECK(both.find("MIXED_TEXTONS") == std::string::npos);
  CHECK(switchesOf({mixed}).find(" -DLICHEN_TILING_NOISES=0") != std::string::npos);
  mixed.pointProcess = LICHEN_POINT_PROCESS_STRATIFIED;
  CHECK(switchesOf({mixed}).find(" -DLICHEN_POISSON_POINTS=0") != std::string::npos);
  mixed.pointProcess = LICHEN_POINT_PROCESS_POISSON;
  CHECK(switchesOf({mixed}).find("POISSON") == std::string::npos);
}

TEST_CASE("every text of switches fits, and a buffer that is too small is an error") {
  const OwnedBundle bundle(example::smallest());
  const LichenMaterialParameters parameters = parametersOf(bundle.handle);
  const LichenMaterialParameters* const pointer = &parameters;
  char text[8] = "before";
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  CHECK(lichenGetShaderSwitches(&pointer, 1, nullptr, text, sizeof text, &diagnostic) ==
        LICHEN_ERROR_USAGE);
  CHECK(std::string(diagnostic.text) == "textBytes 8 is too small; expected at least 512");
  CHECK(std::string(text) == "before");
  CHECK(lichenGetShaderSwitches(nullptr, 1, nullptr, text, sizeof text, nullptr) ==
        LICHEN_ERROR_USAGE);
  CHECK(lichenGetShaderSwitches(&pointer, 0, nullptr, text, sizeof text, nullptr) ==
        LICHEN_ERROR_USAGE);
  CHECK(switchesOf({parameters}).size() < LICHEN_SWITCH_BYTES / 2);
}

TEST_CASE("a fractional period requires a tile origin of 0") {
  const OwnedBundle bundle(example::smallest());
  LichenPlacement placement = atOrigin();
  placement.periodTiles[0] = placement.periodTiles[1] = 1.5;
  CHECK(fill(parametersOf(bundle.handle), placement).result == LICHEN_SUCCESS);
  placement.tileOrigin[0] = 1;
  CHECK(fill(parametersOf(bundle.handle), placement).message ==
        "periodTiles[0] 1.5 must be a whole number when tileOrigin[0] is not 0");
}

TEST_CASE("a period along one axis only is an error that names the cure") {
  const OwnedBundle bundle(example::smallest());
  LichenPlacement placement = atOrigin();
  placement.periodTiles[0] = 3.0;
  CHECK(fill(parametersOf(bundle.handle), placement).message ==
        "periodTiles[1] 0 is out of range; expected 1 to 65536, or 0 on both axes for none");
}

TEST_CASE("a period is an error for triplanar mapping") {
  const OwnedBundle bundle(example::smallest());
  LichenMaterialParameters parameters = parametersOf(bundle.handle);
  parameters.mapping = LICHEN_MAPPING_TRIPLANAR;
  LichenPlacement placement = atOrigin();
  CHECK(fill(parameters, placement).result == LICHEN_SUCCESS);
  placement.periodTiles[0] = placement.periodTiles[1] = 2.0;
  const Filled filled = fill(parameters, placement);
  CHECK(filled.result == LICHEN_ERROR_USAGE);
  CHECK(filled.message ==
        "periodTiles 2 is not supported for triplanar mapping, which cannot repeat; set it to 0");
}

TEST_CASE("a file without noises is an empty bundle") {
  const std::string gltf = R"({"asset": {"version": "2.0"}, "materials": [{}]})";
  LichenParseInfo info;
  LICHEN_INIT(info, LICHEN_STRUCTURE_PARSE_INFO);
  info.headerVersion = LICHEN_HEADER_VERSION;
  info.bytes = gltf.data();
  info.byteCount = gltf.size();
  const Parsed parsed = parse(info);
  REQUIRE(parsed.result == LICHEN_SUCCESS);
  LichenBundleProperties properties;
  LICHEN_INIT(properties, LICHEN_STRUCTURE_BUNDLE_PROPERTIES);
  CHECK(lichenGetBundleProperties(parsed.bundle, &properties) == LICHEN_SUCCESS);
  CHECK(properties.noiseCount == 0);
  CHECK(properties.materialCount == 1);
  lichenDestroyBundle(parsed.bundle);
}

TEST_CASE("a material whose noise has a later revision has no noise, and states the revision") {
  example::GlbParts parts(encodeGlb(example::smallest()).value());
  parts.extension()["noises"][0]["revision"] = 3;
  const std::vector<std::byte> glb = parts.join();
  const Parsed parsed = parse(parseInfo(glb));
  REQUIRE(parsed.result == LICHEN_SUCCESS);
  LichenBundleProperties properties;
  LICHEN_INIT(properties, LICHEN_STRUCTURE_BUNDLE_PROPERTIES);
  REQUIRE(lichenGetBundleProperties(parsed.bundle, &properties) == LICHEN_SUCCESS);
  CHECK(properties.noiseCount == 0);
  CHECK(properties.imageCount == 0);
  LichenMaterialProperties material;
  LICHEN_INIT(material, LICHEN_STRUCTURE_MATERIAL_PROPERTIES);
  REQUIRE(lichenGetMaterialProperties(parsed.bundle, 0, &material) == LICHEN_SUCCESS);
  CHECK(material.noise == LICHEN_NO_NOISE);
  CHECK(material.unknownRevision == 3);
  LichenMaterialParameters parameters;
  LICHEN_INIT(parameters, LICHEN_STRUCTURE_MATERIAL_PARAMETERS);
  CHECK(lichenGetMaterialParameters(parsed.bundle, 0, &parameters) == LICHEN_ERROR_USAGE);
  lichenDestroyBundle(parsed.bundle);
  const OwnedBundle known(example::smallest());
  REQUIRE(lichenGetMaterialProperties(known.handle, 0, &material) == LICHEN_SUCCESS);
  CHECK(material.unknownRevision == 0);
}

TEST_CASE("a map without an inverse table has a placeholder of one texel at its table's binding") {
  const BundleFile file = example::everyMap();
  const OwnedBundle bundle(file);
  constexpr std::uint32_t opacity = 3;
  REQUIRE_FALSE(file.bundle.noises[1].maps[opacity].as<TilingMap>().inverseTable.has_value());
  LichenMapProperties map;
  LICHEN_INIT(map, LICHEN_STRUCTURE_MAP_PROPERTIES);
  REQUIRE(lichenGetMapProperties(bundle.handle, 1, opacity, &map) == LICHEN_SUCCESS);
  CHECK(map.tableKind == LICHEN_TABLE_NONE);
  LichenBinding binding;
  LICHEN_INIT(binding, LICHEN_STRUCTURE_BINDING);
  REQUIRE(lichenGetBinding(bundle.handle, 1, LICHEN_BINDING_TABLE(LICHEN_OPACITY), &binding) ==
          LICHEN_SUCCESS);
  CHECK(binding.image == map.tableImage);
  CHECK(binding.sampler == LICHEN_SAMPLER_TABLE);
  LichenImageProperties image;
  LICHEN_INIT(image, LICHEN_STRUCTURE_IMAGE_PROPERTIES);
  REQUIRE(lichenGetImageProperties(bundle.handle, map.tableImage, &image) == LICHEN_SUCCESS);
  CHECK(image.dimensionality == 3);
  CHECK(image.byteCount == 4);
  REQUIRE(lichenGetMapProperties(bundle.handle, 1, 0, &map) == LICHEN_SUCCESS);
  CHECK(map.tableKind == LICHEN_TABLE_JOINT);
}

TEST_CASE(
    "each map of a mix has a table of its steps, and the material states the weight's source") {
  const BundleFile file = example::textonMix();
  const std::vector<double>& losses =
      file.bundle.noises[1].maps[0].as<TextonMap>().mipLoss; // of all steps
  const OwnedBundle bundle(file);
  LichenNoiseProperties noise;
  LICHEN_INIT(noise, LICHEN_STRUCTURE_NOISE_PROPERTIES);
  REQUIRE(lichenGetNoiseProperties(bundle.handle, 0, &noise) == LICHEN_SUCCESS);
  CHECK(noise.mixSteps == 1);
  CHECK(noise.textonOrder == 0);
  REQUIRE(lichenGetNoiseProperties(bundle.handle, 1, &noise) == LICHEN_SUCCESS);
  CHECK(noise.mixSteps == 3);
  CHECK(noise.textonOrder ==
        std::uint32_t(example::textonMix().bundle.noises[1].as<TextonShape>().order));
  LichenMapProperties map;
  LICHEN_INIT(map, LICHEN_STRUCTURE_MAP_PROPERTIES);
  REQUIRE(lichenGetMapProperties(bundle.handle, 1, 0, &map) == LICHEN_SUCCESS);
  CHECK(map.tableKind == LICHEN_TABLE_NONE);
  LichenImageProperties image;
  LICHEN_INIT(image, LICHEN_STRUCTURE_IMAGE_PROPERTIES);
  REQUIRE(lichenGetImageProperties(bundle.handle, map.tableImage, &image) == LICHEN_SUCCESS);
  CHECK(image.vkFormat == 97); // VK_FORMAT_R16G16B16A16_SFLOAT, which every device filters
  CHECK(image.dimensionality == 3);
  CHECK(image.width == 3);
  CHECK(image.height == 1);
  CHECK(image.depth == LICHEN_MIX_ROWS);
  // Means 0.5, 0.375 and 0.25 minus the first; deviations 1, 0.75 and 0.5 of the largest.
  Table table{"mix", TexelFormat::rgba16Sfloat, 3, 1, LICHEN_MIX_ROWS, 1, {}};
  const auto* bytes = static_cast<const std::byte*>(image.bytes);
  table.texels.assign(bytes, bytes + image.byteCount);
  const std::vector<float> texels = decodeLevel(table, 0);
  const auto texel = [&](std::size_t row, std::size_t step, std::size_t component) {
    return double(texels.at((row * 3 + step) * 4 + component));
  };
  for (std::size_t step = 0; step < 3; ++step) {
    CHECK(texel(LICHEN_MIX_MEAN, step, 1) == Approx(-0.125 * double(step)).margin(1e-6));
    CHECK(texel(LICHEN_MIX_DEVIATION, step, 2) == Approx(1.0 - 0.25 * double(step)).epsilon(1e-3));
    for (std::size_t c = 0; c < 3; ++c) {
      const std::span<const double> ofChannel = lossRow(losses, c, 3);
      CHECK(texel(LICHEN_MIX_KEPT + 1, step, c) ==
            Approx(std::sqrt(1.0 - ofChannel[1])).epsilon(1e-3));
      // The last value repeats.
      CHECK(texel(LICHEN_MIX_KEPT + 15, step, c) ==
            Approx(std::sqrt(1.0 - ofChannel.back())).epsilon(1e-3));
    }
  }
  LichenMaterialProperties material;
  LICHEN_INIT(material, LICHEN_STRUCTURE_MATERIAL_PROPERTIES);
  REQUIRE(lichenGetMaterialProperties(bundle.handle, 1, &material) == LICHEN_SUCCESS);
  CHECK(material.mixSource == LICHEN_MIX_VERTEX_COLOR);
  CHECK(material.mixSet == 1);
  CHECK(material.mixChannel == 2);
}

TEST_CASE("a material states the space of its positions") {
  for (const NoiseSpace space : {NoiseSpace::world, NoiseSpace::object}) {
    BundleFile file = example::smallest();
    file.bundle.materials[0]->mapping = Mapping::triplanar;
    file.bundle.materials[0]->space = space;
    const OwnedBundle bundle(file);
    LichenMaterialProperties material;
    LICHEN_INIT(material, LICHEN_STRUCTURE_MATERIAL_PROPERTIES);
    REQUIRE(lichenGetMaterialProperties(bundle.handle, 0, &material) == LICHEN_SUCCESS);
    CHECK(material.space ==
          (space == NoiseSpace::object ? LICHEN_SPACE_OBJECT : LICHEN_SPACE_WORLD));
  }
}

TEST_CASE("parsing something that is not a bundle is an error") {
  const std::vector<std::byte> noise(100, std::byte(7));
  CHECK(parse(parseInfo(noise)).result == LICHEN_ERROR_BAD_BUNDLE);
}
