// SPDX-License-Identifier: MIT
// The engine plugin's plan layer: its descriptions and its errors.
#include "plugin_plan.h"

#include "bundle_surgery.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstring>

using namespace lichen;
using namespace lichen::test;

TEST_CASE("the inverse table of one dimension is a 3-D image one texel high and deep") {
  const OwnedBundle bundle(example::smallest());
  auto map = got<LichenMapProperties>(lichenGetMapProperties, bundle.handle, 0, 0);
  CHECK(map.target == LICHEN_TARGET_HEIGHT);
  CHECK(map.channelCount == 1);
  CHECK(map.channels[0] == LICHEN_CHANNEL_HEIGHT);
  auto image = got<LichenImageProperties>(lichenGetImageProperties, bundle.handle, map.tableImage);
  CHECK(image.dimensionality == 3);
  CHECK(image.width == 256);
  CHECK(image.height == 1);
  CHECK(image.depth == 1);
  CHECK(image.vkFormat == 9); // VK_FORMAT_R8_UNORM
  REQUIRE(lichenGetImageProperties(bundle.handle, map.image, &image) == LICHEN_SUCCESS);
  CHECK(image.dimensionality == 2);
  CHECK(image.mipLevels == 3);
}

TEST_CASE("of all images, only cosines need no linear filter") {
  const OwnedBundle bundle(example::smallestCosines());
  auto map = got<LichenMapProperties>(lichenGetMapProperties, bundle.handle, 0, 0);
  auto properties = got<LichenBundleProperties>(lichenGetBundleProperties, bundle.handle);
  for (std::uint32_t i = 0; i < properties.imageCount; ++i) {
    auto image = got<LichenImageProperties>(lichenGetImageProperties, bundle.handle, i);
    CHECK(image.fetchedOnly == (i == map.image ? 1 : 0));
  }
}

TEST_CASE("the copies of an image cover its bytes without gaps") {
  const OwnedBundle bundle(example::smallest());
  auto properties = got<LichenBundleProperties>(lichenGetBundleProperties, bundle.handle);
  REQUIRE(properties.imageCount == 4); // with the placeholders
  for (std::uint32_t i = 0; i < properties.imageCount; ++i) {
    auto image = got<LichenImageProperties>(lichenGetImageProperties, bundle.handle, i);
    std::size_t end = 0;
    for (std::uint32_t level = 0; level < image.mipLevels; ++level) {
      auto copy = got<LichenCopy>(lichenGetCopy, bundle.handle, i, level);
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

TEST_CASE("a set has two blocks, two samplers, an image and a table for each role, and cells") {
  const OwnedBundle bundle(example::smallest()); // one map: a height
  auto height = got<LichenMapProperties>(lichenGetMapProperties, bundle.handle, 0, 0);
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
      auto properties =
          got<LichenImageProperties>(lichenGetImageProperties, bundle.handle, one->image);
      CHECK(properties.dimensionality == (one == &image ? 2u : 3u));
      if (role != LICHEN_HEIGHT)
        CHECK(properties.byteCount == 4); // a placeholder
    }
  }
  const LichenBinding& cells = bindings[LICHEN_BINDING_CELLS];
  CHECK(cells.kind == LICHEN_BINDING_SAMPLED_IMAGE);
  CHECK(cells.sampler == LICHEN_SAMPLER_IMAGE);
  CHECK(cells.image == bindings[LICHEN_BINDING_IMAGE(LICHEN_BASE_COLOR)].image); // a placeholder
  LichenBinding binding;
  LICHEN_INIT(binding, LICHEN_STRUCTURE_BINDING);
  CHECK(lichenGetBinding(bundle.handle, 0, LICHEN_LAYERED_SET_BINDINGS, &binding) ==
        LICHEN_ERROR_USAGE);
}

TEST_CASE("the set of a quilting noise has its cells, and no table") {
  const OwnedBundle bundle(example::smallestQuilting());
  const auto imageAt = [&](std::uint32_t index) {
    auto binding = got<LichenBinding>(lichenGetBinding, bundle.handle, 0, index);
    auto image = got<LichenImageProperties>(lichenGetImageProperties, bundle.handle, binding.image);
    return image;
  };
  CHECK(imageAt(LICHEN_BINDING_CELLS).name == std::string("bricks.cells"));
  CHECK(imageAt(LICHEN_BINDING_CELLS).fetchedOnly == 0);
  CHECK(imageAt(LICHEN_BINDING_IMAGE(LICHEN_HEIGHT)).name == std::string("bricks.height.image"));
  CHECK(imageAt(LICHEN_BINDING_IMAGE(LICHEN_NORMAL)).name == std::string("bricks.normal.image"));
  CHECK(imageAt(LICHEN_BINDING_TABLE(LICHEN_HEIGHT)).byteCount == 4); // a placeholder
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

TEST_CASE("a map of another shape than the tile has a level of its own, and the mean loss") {
  // "moss" has 8 x 8 texels of colour and 8 x 4 of slopes: half as many.
  const OwnedBundle bundle(example::everyMap());
  shader::LichenNoiseConstants block{};
  REQUIRE(lichenGetNoiseConstants(bundle.handle, 1, &block) == LICHEN_SUCCESS);
  CHECK(block.maps[LICHEN_BASE_COLOR].levelOffset == 0.0f);
  CHECK(block.maps[LICHEN_NORMAL].levelOffset == -0.5f);
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
  auto properties = got<LichenBundleProperties>(lichenGetBundleProperties, parsed.bundle);
  CHECK(properties.noiseCount == 0);
  CHECK(properties.imageCount == 0);
  auto material = got<LichenMaterialProperties>(lichenGetMaterialProperties, parsed.bundle, 0);
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
  auto map = got<LichenMapProperties>(lichenGetMapProperties, bundle.handle, 1, opacity);
  auto binding =
      got<LichenBinding>(lichenGetBinding, bundle.handle, 1, LICHEN_BINDING_TABLE(LICHEN_OPACITY));
  CHECK(binding.image == map.tableImage);
  CHECK(binding.sampler == LICHEN_SAMPLER_TABLE);
  auto image = got<LichenImageProperties>(lichenGetImageProperties, bundle.handle, map.tableImage);
  CHECK(image.dimensionality == 3);
  CHECK(image.byteCount == 4);
}

TEST_CASE(
    "each map of a mix has a table of its steps, and the material states the weight's source") {
  const BundleFile file = example::textonMix();
  const NoiseMap& colors = file.bundle.noises[1].maps[0];
  const auto& texton = colors.as<TextonMap>();
  const OwnedBundle bundle(file);
  auto noise = got<LichenNoiseProperties>(lichenGetNoiseProperties, bundle.handle, 0);
  CHECK(noise.mixSteps == 1);
  REQUIRE(lichenGetNoiseProperties(bundle.handle, 1, &noise) == LICHEN_SUCCESS);
  CHECK(noise.mixSteps == 3);
  auto map = got<LichenMapProperties>(lichenGetMapProperties, bundle.handle, 1, 0);
  auto image = got<LichenImageProperties>(lichenGetImageProperties, bundle.handle, map.tableImage);
  CHECK(image.vkFormat == 97); // VK_FORMAT_R16G16B16A16_SFLOAT, which every device filters
  CHECK(image.dimensionality == 3);
  CHECK(image.width == 3);
  CHECK(image.height == 1);
  CHECK(image.depth == LICHEN_MIX_ROWS);
  // Means 0.5, 0.4 and 0.3 minus the first; deviations over the largest, a sixth of the scale.
  Table table{"mix", TexelFormat::rgba16Sfloat, 3, 1, LICHEN_MIX_ROWS, 1, {}};
  const auto* bytes = static_cast<const std::byte*>(image.bytes);
  table.texels.assign(bytes, bytes + image.byteCount);
  const std::vector<float> texels = decodeLevel(table, 0);
  const auto texel = [&](std::size_t row, std::size_t step, std::size_t component) {
    return double(texels.at((row * 3 + step) * 4 + component));
  };
  for (std::size_t step = 0; step < 3; ++step) {
    CHECK(texel(LICHEN_MIX_MEAN, step, 1) == Approx(-0.1 * double(step)).epsilon(1.0 / 2048));
    const double variance =
        (step == 0 ? colors.covariance : texton.laterSteps[step - 1].covariance)[8];
    CHECK(texel(LICHEN_MIX_DEVIATION, step, 2) ==
          Approx(6.0 * std::sqrt(variance) / texton.scale[2]).epsilon(1e-3));
    for (std::size_t c = 0; c < 3; ++c) {
      const std::span<const double> ofChannel =
          lossRow(step == 0 ? texton.mipLoss : texton.laterSteps[step - 1].mipLoss, c, 3);
      CHECK(texel(LICHEN_MIX_RETAINED + 1, step, c) ==
            Approx(std::sqrt(1.0 - ofChannel[1])).epsilon(1e-3));
      // The last value repeats.
      CHECK(texel(LICHEN_MIX_RETAINED + 15, step, c) ==
            Approx(std::sqrt(1.0 - ofChannel.back())).epsilon(1e-3));
    }
  }
  auto material = got<LichenMaterialProperties>(lichenGetMaterialProperties, bundle.handle, 1);
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
    auto material = got<LichenMaterialProperties>(lichenGetMaterialProperties, bundle.handle, 0);
    CHECK(material.space ==
          (space == NoiseSpace::object ? LICHEN_SPACE_OBJECT : LICHEN_SPACE_WORLD));
  }
}

TEST_CASE("parsing something that is not a bundle is an error") {
  const std::vector<std::byte> noise(100, std::byte(7));
  CHECK(parse(parseInfo(noise)).result == LICHEN_ERROR_BAD_BUNDLE);
}
