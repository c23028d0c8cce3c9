// SPDX-License-Identifier: MIT
// Small bundles for the tests and for the extension's examples; see bundle_example.h.
#include "bundle_example.h"

#include "synthetic_texton.h"

#include <lichen/bfloat16_pair.h>
#include <lichen/bundle_merge.h>
#include <lichen/structure_texel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace lichen::example {
namespace {

/// Appends a table and returns its index.
std::size_t addTable(Bundle& bundle, Table table) {
  bundle.tables.push_back(std::move(table));
  return bundle.tables.size() - 1;
}

void addTiling(Bundle& bundle, NoiseMap& map, int dimensions, Table gaussian,
               std::optional<Table> inverse) {
  auto& tiling = map.as<TilingMap>();
  tiling.dimensions = dimensions;
  tiling.gaussian = addTable(bundle, std::move(gaussian));
  if (inverse)
    tiling.inverseTable = addTable(bundle, *std::move(inverse));
}

NoiseMap makeMap(MapTarget target, std::vector<MapChannel> channels, ValueEncoding encoding) {
  NoiseMap map;
  map.target = target;
  map.channels = std::move(channels);
  map.encoding = encoding;
  const std::size_t n = map.channels.size();
  map.mean.assign(n, encoding == ValueEncoding::slope ? 0.0 : 0.5);
  map.covariance.assign(n * n, 0.005);
  for (std::size_t i = 0; i < n; ++i)
    map.covariance[i * n + i] = 0.01;
  return map;
}

/// Averages of 2 x 2 texels of an image with even sides and `channels` interleaved values per
/// texel.
std::vector<double> halved(const std::vector<double>& image, std::size_t width,
                           std::size_t channels = 1) {
  std::vector<double> half;
  const std::size_t row = width * channels;
  for (std::size_t y = 0; y < image.size() / row; y += 2)
    for (std::size_t x = 0; x < width; x += 2)
      for (std::size_t c = 0; c < channels; ++c) {
        const double* texel = &image[y * row + x * channels + c];
        half.push_back((texel[0] + texel[channels] + texel[row] + texel[row + channels]) / 4.0);
      }
  return half;
}

/// Makes the table of a square image with averages as its mips.
Table tableWithAverages(std::string name, TexelFormat format, std::vector<double> image,
                        std::uint32_t side, std::uint32_t mipLevels) {
  Table table{std::move(name), format, side, side, 0, mipLevels, {}};
  for (std::uint32_t level = 0; level < mipLevels; ++level) {
    if (level > 0)
      image = halved(image, side >> (level - 1), std::size_t(channelCount(format)));
    appendTexels(table.texels, format, std::vector<float>(image.begin(), image.end()));
  }
  return table;
}

/// The integral of the squared bilinear interpolation of texels one unit wide.
double bilinearEnergy(const std::vector<double>& image, std::size_t side) {
  // [GLM17] section 4.1: the integrals of the product of two tents, by their distance.
  constexpr std::array<double, 2> kTents = {2.0 / 3.0, 1.0 / 6.0};
  double sum = 0.0;
  for (std::size_t i = 0; i < image.size(); ++i)
    for (std::size_t j = 0; j < image.size(); ++j) {
      const auto apart = [](std::size_t a, std::size_t b) { return a < b ? b - a : a - b; };
      const std::size_t dx = apart(i % side, j % side), dy = apart(i / side, j / side);
      if (dx <= 1 && dy <= 1)
        sum += kTents[dx] * kTents[dy] * image[i] * image[j];
    }
  return sum;
}

MaterialNoise useOf(std::size_t noise) {
  MaterialNoise use;
  use.noise = noise;
  return use;
}

/// Adds the only noise of a file without a scene, used by one material.
void addNoise(BundleFile& file, Noise noise) {
  file.bundle.noises.push_back(std::move(noise));
  file.bundle.materials.push_back(useOf(0));
  file.previews.emplace_back();
  file.shape = PreviewShape::none;
  file.generator = "lichen tests";
}

/// The same of one map.
void addNoise(BundleFile& file, Noise noise, NoiseMap map) {
  noise.maps.push_back(std::move(map));
  addNoise(file, std::move(noise));
}

} // namespace

BundleFile smallest() {
  BundleFile file;
  Noise noise;
  noise.name = "felt";
  NoiseMap map = makeMap(MapTarget::height, {MapChannel::height}, ValueEncoding::linear);
  map.as<TilingMap>().gaussian =
      addTable(file.bundle, gaussianTable("felt.height.gaussian", TexelFormat::rg8Unorm, 4, 2));
  map.as<TilingMap>().inverseTable = addTable(
      file.bundle, patternTable("felt.height.inverse", TexelFormat::r8Unorm, 256, 1, 1, 1));
  addNoise(file, std::move(noise), std::move(map));
  return file;
}

BundleFile smallestTexton() {
  BundleFile file;
  Noise noise;
  noise.name = "dune";
  auto& shape = noise.data.emplace<TextonShape>();
  shape.coefficientsX = shape.coefficientsY = 8;
  shape.texelsPerTileX = shape.texelsPerTileY = 32;
  shape.mipLevels = shape.mostMipLevels();
  const std::size_t side = shape.frameWidth();
  std::vector<double> texels(side * side);
  for (std::size_t y = 0; y < std::size_t(shape.coefficientsY); ++y)
    for (std::size_t x = 0; x < std::size_t(shape.coefficientsX); ++x) {
      const auto arch = [](std::size_t k) {
        return std::sin(std::numbers::pi * (double(k) + 0.5) / 8.0);
      };
      texels[y * side + x] = arch(x) * arch(y);
    }
  NoiseMap map = makeMap(MapTarget::height, {MapChannel::height}, ValueEncoding::linear);
  auto& texton = map.data.emplace<TextonMap>();
  texton.mipLoss = {0.0};
  const double energy = bilinearEnergy(texels, side);
  texton.scale = {6.0 * std::sqrt(map.covariance[0])};
  for (double& texel : texels)
    texel /= 6.0 * std::sqrt(energy); // makes the variance the map's
  const std::vector<double> coarse = halved(texels, side);
  constexpr double kCoarseTexelArea = 4.0;
  texton.mipLoss.push_back(1.0 - 36.0 * kCoarseTexelArea * bilinearEnergy(coarse, side / 2));
  texton.image =
      addTable(file.bundle,
               tableWithAverages("dune.height.texton", TexelFormat::r16Sfloat, std::move(texels),
                                 std::uint32_t(side), std::uint32_t(shape.mipLevels)));
  addNoise(file, std::move(noise), std::move(map));
  return file;
}

BundleFile smallestCosines() {
  BundleFile file;
  Noise noise;
  noise.name = "swell";
  noise.data = LocalRandomPhaseNoise{16, 12, 7, 6, {2, 0, 2}, 2, {}};
  NoiseMap map = makeMap(MapTarget::height, {MapChannel::height}, ValueEncoding::linear);
  Table table;
  table.name = "swell.height.cosines";
  table.format = TexelFormat::rgba32Sfloat;
  table.width = 3;
  table.height = 2;
  struct Example {
    std::array<float, 4> box; // middle, size
    float first, second;      // amplitudes of two variants
    float phase;              // of the second
  };
  // The variance of an amplitude a is a^2 / 2; together they have 1 / 36.
  constexpr std::array<Example, 4> kCosines{{{{0.5f, 1.5f, 1.0f, 1.0f}, 0.1667f, -0.1667f, 0.25f},
                                             {{1.5f, -1.0f, 1.0f, 2.0f}, 0.0833f, 0.0833f, 0.0f},
                                             {{4.0f, 1.5f, 4.0f, 3.0f}, 0.1443f, 0.1443f, 0.5f},
                                             {{4.0f, 1.5f, 4.0f, 3.0f}, 0.0f, 0.0f, 0.0f}}};
  for (std::size_t row = 0; row < kCosines.size(); row += kRowCosines) {
    const std::span pair(&kCosines[row], kRowCosines);
    const auto append = [&](const auto& numbersOf) {
      std::vector<float> texel;
      for (const Example& own : pair) {
        const std::array<float, 4> numbers = numbersOf(own);
        texel.push_back(bfloat16Pair(numbers[0], numbers[1]));
        texel.push_back(bfloat16Pair(numbers[2], numbers[3]));
      }
      appendTexels(table.texels, table.format, texel);
    };
    append([](const Example& own) { return own.box; });
    append([](const Example& own) { return std::array{own.first, 0.0f, 0.0f, 0.0f}; });
    append([](const Example& own) { return std::array{own.second, 0.0f, 0.0f, own.phase}; });
  }
  map.data = LocalRandomPhaseMap{addTable(file.bundle, std::move(table)), std::nullopt, 1, {}, {}};
  addNoise(file, std::move(noise), std::move(map));
  return file;
}

BundleFile smallestKernels() {
  BundleFile file;
  Noise noise;
  noise.name = "ripples";
  noise.data = MultipleKernelsNoise{16, 12, 2, 1, 2, KernelWindow::gabor, false};
  NoiseMap map = makeMap(MapTarget::height, {MapChannel::height}, ValueEncoding::linear);
  KernelRow row;
  row.frequency = {3.0f, -1.5f};
  row.columns = 40;
  row.rows = 32;
  row.toWindow = {4.0f, 0.0f, 1.0f, 3.0f};
  row.amplitude = 0.8f;
  row.cubes = 24;
  row.layers = 24;
  row.toWindowZ = 4.5f;
  row.colors[0][0] = 0.1350f; // squares, of cosines halved, sum to 1 / 36
  KernelRow ring = row;
  ring.frequency = {5.0f, 0.0f};
  ring.toWindow = {4.0f, 0.0f, 0.0f, 4.0f};
  ring.colors[0][0] = 0.0833f;
  PatternCosine across, down;
  across.frequency = {2.0f, 0.0f};
  across.waves[0] = {0.03f, -0.04f};
  down.frequency = {0.0f, -3.0f};
  down.waves[0] = {0.05f, 0.0f};
  Table table = kernelTable({row, ring}, {across, down});
  table.name = "ripples.height.kernels";
  map.data = MultipleKernelsMap{addTable(file.bundle, std::move(table)), std::nullopt, 1};
  addNoise(file, std::move(noise), std::move(map));
  return file;
}

BundleFile smallestStructure() {
  BundleFile file = smallestCosines();
  auto& shared = file.bundle.noises[0].as<LocalRandomPhaseNoise>();
  shared.structure = {64, 64, 3, 0.25};
  auto& map = file.bundle.noises[0].maps[0].as<LocalRandomPhaseMap>();
  map.structureAmplitudes = {0.5};
  map.structureDeviations = {0.8, 0.7, 0.6, 0.5, 0.3, 0.1};
  Table& table = file.bundle.tables[map.cosines];
  const std::vector<float> cosines = decodeLevel(table, 0);
  const CosineImageLayout layout(shared);
  std::vector<float> texels(4 * std::size_t(layout.width) * layout.height,
                            structureTexel({1, 2, 3}));
  for (std::size_t row = 0; row < layout.cosineRows; ++row)
    std::copy_n(&cosines[4 * row * layout.cosineColumns], 4 * layout.cosineColumns,
                &texels[4 * row * layout.width]);
  constexpr std::array<float, 6> kOffsets{0.0f, 0.0f, 0.25f, -0.5f, 0.5f, 0.125f};
  std::copy(kOffsets.begin(), kOffsets.end(),
            &texels[4 * std::size_t(layout.offsetRow) * layout.width]);
  table.width = layout.width;
  table.height = layout.height;
  table.texels.clear();
  appendTexels(table.texels, table.format, texels);
  return file;
}

BundleFile smallestQuilting() {
  BundleFile file;
  Bundle& bundle = file.bundle;
  Noise noise;
  noise.name = "bricks";
  constexpr double kReach = 0.125; // from a texel to the centre of its cell
  constexpr double kCorrelation = 0.5;
  noise.data = QuiltingNoise{
      Grain::none, kReach, kCorrelation, {{0.0, 0.0}, {0.5, 0.0}, {0.0, 0.5}, {0.5, 0.5}}};
  constexpr std::uint32_t kSide = 4, kMips = 3;
  std::vector<double> ways, heights, slopes;
  for (std::size_t i = 0; i < kSide * kSide; ++i) {
    const std::size_t x = i % kSide, y = i / kSide;
    ways.insert(ways.end(), {x % 2 == 0 ? 1.0 : 0.0, y % 2 == 0 ? 1.0 : 0.0, 1.0, 1.0});
    heights.push_back(double(i * 5 % 16 * 16) / 255.0); // averages are whole bytes too
    const std::array<double, 2> slope{0.25 * double(x) - 0.5, 0.5 - 0.125 * double(y)};
    slopes.insert(slopes.end(),
                  {slope[0], slope[1], 0.5 * (slope[0] * slope[0] + slope[1] * slope[1]), 1.0});
  }
  Table cells = tableWithAverages("bricks.cells", TexelFormat::rgba8Unorm, ways, kSide, kMips);
  setChannel(cells, 2, {1.0f, 0.0f, 0.0f}); // beyond level 0 the mean way is 0
  const std::size_t cellTable = addTable(bundle, std::move(cells));
  const auto addMap = [&](NoiseMap map, Table image) {
    map.data = QuiltingMap{addTable(bundle, std::move(image)), cellTable};
    noise.maps.push_back(std::move(map));
  };
  addMap(makeMap(MapTarget::height, {MapChannel::height}, ValueEncoding::linear),
         tableWithAverages("bricks.height.image", TexelFormat::r8Unorm, heights, kSide, kMips));
  addMap(makeMap(MapTarget::normal, {MapChannel::slopeX, MapChannel::slopeY}, ValueEncoding::slope),
         tableWithAverages("bricks.normal.image", TexelFormat::rgba16Sfloat, slopes, kSide, kMips));
  addNoise(file, std::move(noise));
  return file;
}

BundleFile textonMix() {
  BundleFile file = smallest();
  Bundle& bundle = file.bundle;
  Noise noise;
  for (const int channels : {3, 2, 1}) {
    Bundle added = test::syntheticTextonBundle({.coefficientsX = 9,
                                                .coefficientsY = 17,
                                                .order = 3,
                                                .mipLevels = 2,
                                                .texelsPerTileX = 100,
                                                .texelsPerTileY = 50,
                                                .steps = 3,
                                                .channels = channels,
                                                .wholeFloats = channels < 3,
                                                .lossLevels = 3})
                       .bundle;
    NoiseMap& map = added.noises[0].maps[0];
    map.as<TextonMap>().image = addTable(bundle, std::move(added.tables[0]));
    noise.maps.push_back(std::move(map));
    noise.data = added.noises[0].data;
  }
  noise.name = "sand to moss";
  bundle.noises.push_back(std::move(noise));
  MaterialNoise use = useOf(1);
  use.mapping = Mapping::surface;
  use.impacts = 12.5;
  use.pointProcess = PointProcess::poisson;
  use.mix.source = MixSource::vertexColor;
  use.mix.colorSet = 1;
  use.mix.channel = 2;
  bundle.materials.push_back(use);
  file.previews.emplace_back();
  return file;
}

BundleFile everyMap() {
  using enum MapChannel;
  BundleFile file = smallest();
  file.previews.front().baseColor = tinyPng();
  Bundle& bundle = file.bundle;
  Noise noise;
  noise.name = "moss";
  noise.tileSizeMetres = 0.5;

  NoiseMap color = makeMap(MapTarget::baseColor, {red, green, blue}, ValueEncoding::root);
  addTiling(bundle, color, 3, gaussianTable("", TexelFormat::rgba8Unorm, 8, 8),
            patternTable("", TexelFormat::rgba8Unorm, 32, 32, 32, 5));
  noise.maps.push_back(std::move(color));

  NoiseMap normal = makeMap(MapTarget::normal, {slopeX, slopeY}, ValueEncoding::slope);
  addTiling(bundle, normal, 2, gaussianTable("", TexelFormat::rgba16Sfloat, 8, 4),
            patternTable("", TexelFormat::rgba16Sfloat, 64, 64, 1, 5));
  noise.maps.push_back(std::move(normal));

  NoiseMap grey = makeMap(MapTarget::occlusionRoughnessMetallic, {occlusion, roughness, metallic},
                          ValueEncoding::linear);
  addTiling(bundle, grey, 1, gaussianTable("", TexelFormat::rg16Sfloat, 8, 8),
            patternTable("", TexelFormat::rgba16Sfloat, 256, 1, 1, 5));
  noise.maps.push_back(std::move(grey));

  NoiseMap opacityMap = makeMap(MapTarget::opacity, {opacity}, ValueEncoding::linear);
  addTiling(bundle, opacityMap, 1, gaussianTable("", TexelFormat::rg16Sfloat, 1, 1), {});
  noise.maps.push_back(std::move(opacityMap));

  NoiseMap glow = makeMap(MapTarget::emissive, {red, green, blue}, ValueEncoding::root);
  addTiling(bundle, glow, 1, gaussianTable("", TexelFormat::rg8Unorm, 4, 4),
            patternTable("", TexelFormat::rgba32Sfloat, 16, 1, 1, 4));
  noise.maps.push_back(std::move(glow));

  bundle.noises.push_back(std::move(noise));
  MaterialNoise use = useOf(1);
  use.mapping = Mapping::triplanar;
  use.scale = 0.25;
  use.offset = {0.5, -3.0};
  use.rotation = 0.1;
  use.seed = 4294967295u;
  use.blendSharpness = 2.0;
  use.planeSharpness = 4.0;
  use.contrast = 0.9;
  use.tileRotation = 4;
  bundle.materials.push_back(use);
  bundle.materialNames = {"", "wet moss"};
  PreviewImages preview;
  preview.baseColor = tinyPng();
  preview.normal = tinyPng();
  preview.occlusionRoughnessMetallic = tinyPng();
  preview.tilesPerImage = 2;
  file.previews.push_back(std::move(preview));
  file.shape = PreviewShape::sphere;
  return file;
}

BundleFile layered() {
  Bundle layer = smallestKernels().bundle;
  layer.noises[0].maps[0].target = MapTarget::occlusionRoughnessMetallic;
  layer.noises[0].maps[0].channels = {MapChannel::occlusion};
  const BundledNoise noise{&layer, 0};
  BundleFile file;
  file.bundle = layerNoises("layered", std::array{noise, noise}, std::array{noise},
                            {{0, 0.3, 0.2, {false, 1}, {false, 0}}})
                    .value();
  file.previews.emplace_back();
  file.shape = PreviewShape::none;
  return file;
}

} // namespace lichen::example
