// SPDX-License-Identifier: MIT
// The engine plugin's plan layer: its descriptions and its errors.
#include "plugin_plan.h"

#include "bundle_surgery.h"

#include <lichen/lattice.h>

#include <catch2/catch.hpp>

#include <algorithm>
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
  REQUIRE(properties.imageCount == 2);
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

TEST_CASE("bindings are consecutive: the uniform block, then two for each map") {
  const OwnedBundle bundle(example::smallest());
  LichenBinding binding;
  LICHEN_INIT(binding, LICHEN_STRUCTURE_BINDING);
  for (std::uint32_t i = 0; i < 3; ++i) {
    REQUIRE(lichenGetBinding(bundle.handle, 0, i, &binding) == LICHEN_SUCCESS);
    CHECK(binding.binding == i);
    CHECK((binding.kind == LICHEN_BINDING_UNIFORM_BUFFER) == (i == 0));
    CHECK((binding.sampler == LICHEN_SAMPLER_TABLE) == (i == 2));
  }
  CHECK(lichenGetBinding(bundle.handle, 0, 3, &binding) == LICHEN_ERROR_USAGE);
}

TEST_CASE("uniforms hold the bundle's constants and the material's parameters") {
  BundleFile file = example::smallest();
  file.bundle.materials[0]->scale = 0.5;
  file.bundle.materials[0]->rotation = 0.25;
  file.bundle.materials[0]->offset = {3.0, -1.75};
  file.bundle.materials[0]->seed = 9;
  example::setLosses(file.bundle.tables[0], {0.2f, 0.4f, 0.6f});
  const OwnedBundle bundle(file);
  const Filled filled = fill(bundle.handle, uniformInfo());
  REQUIRE(filled.result == LICHEN_SUCCESS);
  const shader::LichenNoise& noise = filled.uniforms.noise;
  CHECK(noise.uvToTileXX == Approx(2.0 * std::cos(0.25)));
  CHECK(noise.uvToTileXY == Approx(2.0 * std::sin(0.25)));
  CHECK(noise.uvToTileYX == Approx(-2.0 * std::sin(0.25)));
  CHECK(noise.offsetX == 1.0f); // the cell holds an even number of tiles
  CHECK(noise.offsetY == 0.25f);
  CHECK(std::array{noise.cellI, noise.cellJ} == latticeCell(2, -2));
  CHECK(noise.seedWord == latticeSeed(9, 0));
  CHECK(noise.maxAnisotropy == 1.0f);
  CHECK(noise.offsetStepX == 0.25f); // every texel of 4 x 2
  CHECK(noise.offsetStepY == 0.5f);
  const shader::LichenMap& map = filled.uniforms.maps[0];
  CHECK(map.widthTexels == 4.0f);
  CHECK(map.dimensions == 1);
  CHECK(map.mipCount == 3);
  CHECK(map.levelOffset == 0.0f);
  CHECK(map.interpolationLoss == Approx(51.0 / 255.0)); // the loss of level 0
  CHECK(map.mean.x == 0.5f);
  CHECK(map.mean.w == 1.0f);
}

TEST_CASE("an override replaces the material's value, and a tile origin moves the lattice") {
  const OwnedBundle bundle(example::smallest());
  LichenUniformInfo info = uniformInfo();
  info.overrides = LICHEN_OVERRIDE_SEED | LICHEN_OVERRIDE_SCALE;
  info.seed = 77;
  info.scale = 4.0;
  info.contrast = 3.0; // ignored: not in `overrides`
  info.tileOrigin[0] = 10000000;
  info.tileOrigin[1] = -3;
  const Filled filled = fill(bundle.handle, info);
  REQUIRE(filled.result == LICHEN_SUCCESS);
  CHECK(filled.uniforms.noise.seed == 77);
  CHECK(filled.uniforms.noise.uvToTileXX == 0.25f);
  CHECK(filled.uniforms.noise.contrast == 1.0f);
  CHECK(std::array{filled.uniforms.noise.cellI, filled.uniforms.noise.cellJ} ==
        latticeCell(10000000, -3));
}

TEST_CASE("the error for a parameter outside its range names it") {
  const OwnedBundle bundle(example::smallest());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  struct Case {
    const char* name;
    void (*set)(LichenUniformInfo&, double);
    std::vector<double> bad;
  };
  const Case cases[] = {
      {"scale",
       [](LichenUniformInfo& i, double v) { i.scale = v; },
       {0.0, -1.0, 0.9e-6, 1.1e6, nan, infinity}},
      {"offset",
       [](LichenUniformInfo& i, double v) { i.offset[1] = v; },
       {1.1e9, -1.1e9, nan, infinity}},
      {"rotation",
       [](LichenUniformInfo& i, double v) { i.rotation = v; },
       {1.1e6, -1.1e6, nan, infinity}},
      {"blendSharpness",
       [](LichenUniformInfo& i, double v) { i.blendSharpness = v; },
       {0.2, 17.0, nan}},
      {"contrast", [](LichenUniformInfo& i, double v) { i.contrast = v; }, {-0.1, 4.1, nan}},
      {"planeSharpness",
       [](LichenUniformInfo& i, double v) { i.planeSharpness = v; },
       {0.9, 65.0, nan}},
      {"impacts", [](LichenUniformInfo& i, double v) { i.impacts = v; }, {0.9, 1001.0, nan}},
      {"maxAnisotropy",
       [](LichenUniformInfo& i, double v) { i.maxAnisotropy = float(v); },
       {-1.0, 65.0, nan}},
      {"tileOrigin",
       [](LichenUniformInfo& i, double v) { i.tileOrigin[0] = std::int64_t(v); },
       {1e13, -1e13}},
      {"periodTiles",
       [](LichenUniformInfo& i, double v) { i.periodTiles[0] = v; },
       {1.0, -1.0, 0.5, 65537.0, nan}},
      {"overrides",
       [](LichenUniformInfo& i, double v) { i.overrides |= std::uint32_t(v); },
       {4096.0, 2147483648.0}},
      {"tileRotation",
       [](LichenUniformInfo& i, double v) {
         i.overrides |= LICHEN_OVERRIDE_TILE_ROTATION;
         i.tileRotation = std::uint32_t(v);
       },
       {65537.0, 4294967295.0}},
      {"tileOriginZ",
       [](LichenUniformInfo& i, double v) { i.tileOriginZ = std::int64_t(v); },
       {1e13, -1e13}},
      {"mapping",
       [](LichenUniformInfo& i, double v) {
         i.overrides |= LICHEN_OVERRIDE_MAPPING;
         i.mapping = LichenMapping(int(v));
       },
       {2.0, 3.0, 4.0}}, // 2 (surface) needs textons
  };
  for (const Case& one : cases)
    for (const double value : one.bad) {
      LichenUniformInfo info = uniformInfo();
      info.overrides = LICHEN_OVERRIDE_SCALE | LICHEN_OVERRIDE_OFFSET | LICHEN_OVERRIDE_ROTATION |
                       LICHEN_OVERRIDE_BLEND_SHARPNESS | LICHEN_OVERRIDE_CONTRAST |
                       LICHEN_OVERRIDE_IMPACTS | LICHEN_OVERRIDE_PLANE_SHARPNESS;
      info.scale = info.planeSharpness = info.blendSharpness = info.contrast = info.impacts = 1.0;
      one.set(info, value);
      const Filled filled = fill(bundle.handle, info);
      INFO(one.name << " = " << value);
      CHECK(filled.result == LICHEN_ERROR_USAGE);
      CHECK(filled.message.find(one.name) != std::string::npos);
    }
  LichenUniformInfo info = uniformInfo();
  info.material = 1;
  CHECK(fill(bundle.handle, info).message.find("material 1") != std::string::npos);
}

TEST_CASE("a fractional period requires a tile origin of 0") {
  const OwnedBundle bundle(example::smallest());
  LichenUniformInfo info = uniformInfo();
  info.periodTiles[0] = info.periodTiles[1] = 1.5;
  CHECK(fill(bundle.handle, info).result == LICHEN_SUCCESS);
  info.tileOrigin[0] = 1;
  CHECK(fill(bundle.handle, info).result == LICHEN_ERROR_USAGE);
}

TEST_CASE("a period is an error for triplanar mapping") {
  const OwnedBundle bundle(example::smallest());
  LichenUniformInfo info = uniformInfo();
  info.overrides = LICHEN_OVERRIDE_MAPPING;
  info.mapping = LICHEN_MAPPING_TRIPLANAR;
  CHECK(fill(bundle.handle, info).result == LICHEN_SUCCESS);
  info.periodTiles[0] = info.periodTiles[1] = 2.0;
  const Filled filled = fill(bundle.handle, info);
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
  CHECK(fill(parsed.bundle, uniformInfo()).result == LICHEN_ERROR_USAGE);
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
  REQUIRE(lichenGetBinding(bundle.handle, 1, 2 + 2 * opacity, &binding) == LICHEN_SUCCESS);
  CHECK(binding.image == map.tableImage);
  CHECK(binding.sampler == LICHEN_SAMPLER_TABLE);
  LichenImageProperties image;
  LICHEN_INIT(image, LICHEN_STRUCTURE_IMAGE_PROPERTIES);
  REQUIRE(lichenGetImageProperties(bundle.handle, map.tableImage, &image) == LICHEN_SUCCESS);
  CHECK(image.dimensionality == 3);
  CHECK(image.byteCount == 1);
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
  REQUIRE(lichenGetNoiseProperties(bundle.handle, 1, &noise) == LICHEN_SUCCESS);
  CHECK(noise.mixSteps == 3);
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

TEST_CASE("a material's parameters, passed back as overrides, change nothing") {
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
  LichenMaterialProperties material;
  LICHEN_INIT(material, LICHEN_STRUCTURE_MATERIAL_PROPERTIES);
  REQUIRE(lichenGetMaterialProperties(bundle.handle, 0, &material) == LICHEN_SUCCESS);
  CHECK(material.scale == 0.3);
  CHECK(material.impacts == own.impacts);
  CHECK(material.pointProcess == LICHEN_POINT_PROCESS_STRATIFIED);

  LichenUniformInfo overriding = uniformInfo();
  overriding.overrides =
      LICHEN_OVERRIDE_NOISE | LICHEN_OVERRIDE_SCALE | LICHEN_OVERRIDE_OFFSET |
      LICHEN_OVERRIDE_ROTATION | LICHEN_OVERRIDE_SEED | LICHEN_OVERRIDE_BLEND_SHARPNESS |
      LICHEN_OVERRIDE_CONTRAST | LICHEN_OVERRIDE_IMPACTS | LICHEN_OVERRIDE_POINT_PROCESS |
      LICHEN_OVERRIDE_MAPPING | LICHEN_OVERRIDE_PLANE_SHARPNESS | LICHEN_OVERRIDE_TILE_ROTATION;
  overriding.noise = material.noise;
  overriding.scale = material.scale;
  std::copy_n(material.offset, 2, overriding.offset);
  overriding.rotation = material.rotation;
  overriding.seed = material.seed;
  overriding.blendSharpness = material.blendSharpness;
  overriding.contrast = material.contrast;
  overriding.impacts = material.impacts;
  overriding.pointProcess = material.pointProcess;
  overriding.mapping = material.mapping;
  overriding.planeSharpness = material.planeSharpness;
  overriding.tileRotation = material.tileRotation;
  const Filled byMaterial = fill(bundle.handle, uniformInfo());
  const Filled byOverrides = fill(bundle.handle, overriding);
  REQUIRE(byMaterial.result == LICHEN_SUCCESS);
  REQUIRE(byOverrides.result == LICHEN_SUCCESS);
  CHECK(std::memcmp(&byOverrides.uniforms, &byMaterial.uniforms, sizeof byMaterial.uniforms) == 0);
}

TEST_CASE("parsing something that is not a bundle is an error") {
  const std::vector<std::byte> noise(100, std::byte(7));
  CHECK(parse(parseInfo(noise)).result == LICHEN_ERROR_BAD_BUNDLE);
}
