// SPDX-License-Identifier: MIT
// Synthetic noises for the tests; see synthetic_noise.h.
#include "synthetic_noise.h"

#include "glb_of.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace lichen::test {
namespace {

using enum TexelFormat;

TexelFormat gaussianFormat(const SyntheticMap& map) {
  if (map.dimensions == 1)
    return map.eightBit ? rg8Unorm : rg16Sfloat;
  return map.eightBit ? rgba8Unorm : rgba16Sfloat;
}

/// Averages of 2 x 2 texels; the last one repeats if a side is odd.
std::vector<float> halved(const std::vector<float>& level, std::uint32_t width,
                          std::uint32_t height, std::size_t channels) {
  const std::uint32_t w = std::max(1u, width / 2), h = std::max(1u, height / 2);
  std::vector<float> result(std::size_t(w) * h * channels);
  for (std::uint32_t y = 0; y < h; ++y)
    for (std::uint32_t x = 0; x < w; ++x)
      for (std::size_t c = 0; c < channels; ++c) {
        float sum = 0.0f;
        for (std::uint32_t k = 0; k < 4; ++k) {
          const std::uint32_t sx = std::min(2 * x + k % 2, width - 1);
          const std::uint32_t sy = std::min(2 * y + k / 2, height - 1);
          sum += level[(std::size_t(sy) * width + sx) * channels + c];
        }
        result[(std::size_t(y) * w + x) * channels + c] = sum / 4.0f;
      }
  return result;
}

Table gaussianTable(const SyntheticMap& map, std::mt19937& generator) {
  Table table;
  table.format = gaussianFormat(map);
  table.width = map.width;
  table.height = map.height;
  table.mipLevels = std::uint32_t(std::bit_width(std::max(map.width, map.height)));
  const auto channels = std::size_t(channelCount(table.format));
  std::normal_distribution<float> gaussian(kStoredGaussianMean, 1.0f / 6.0f);
  std::vector<float> level(std::size_t(map.width) * map.height * channels);
  std::generate(level.begin(), level.end(), [&] { return gaussian(generator); });
  std::uint32_t width = map.width, height = map.height;
  for (std::uint32_t l = 0; l < table.mipLevels; ++l) {
    // Not what these images lose, but different in every level.
    for (std::size_t i = channels - 1; i < level.size(); i += channels)
      level[i] = float(1.0 - 0.9 * std::pow(0.4, double(l)));
    appendTexels(table.texels, table.format, level);
    level = halved(level, width, height, channels);
    width = std::max(1u, width / 2);
    height = std::max(1u, height / 2);
  }
  return table;
}

/// Channel c of cell (x, y, z) in [0, 1]^3; `kept` is the remaining share of its contrast.
float tableValue(double x, double y, double z, std::size_t c, double kept) {
  constexpr double kTurn = 3.0; // radians over the unit cube: smooth, not linear, not symmetric
  const double phase = double(c) + kTurn * (x + 0.7 * y - 0.4 * z);
  return float(0.5 + kept * (0.25 * std::sin(phase) + 0.2 * (x - 0.5) * double(c == 0 ? 1 : -1)));
}

Table inverseTable(const SyntheticMap& map) {
  constexpr std::uint32_t kCells[] = {256, 64, 32};
  const std::uint32_t cells = kCells[map.dimensions - 1];
  Table table;
  const bool slopes = map.dimensions == 2; // the format requires floats for slopes
  table.format = map.eightBit && !slopes ? rgba8Unorm : rgba16Sfloat;
  table.width = cells;
  table.height = map.dimensions > 1 ? cells : 1;
  table.depth = map.dimensions > 2 ? cells : 1;
  table.mipLevels = std::uint32_t(map.levels);
  for (std::uint32_t level = 0; level < table.mipLevels; ++level) {
    const auto side = [level](std::uint32_t size) { return std::max(1u, size >> level); };
    const std::uint32_t columns = side(table.width), rows = side(table.height);
    const std::uint32_t slices = side(table.depth);
    std::vector<float> values;
    for (std::uint32_t z = 0; z < slices; ++z)
      for (std::uint32_t y = 0; y < rows; ++y)
        for (std::uint32_t x = 0; x < columns; ++x)
          for (std::size_t c = 0; c < 4; ++c)
            values.push_back(tableValue((x + 0.5) / columns, (y + 0.5) / rows, (z + 0.5) / slices,
                                        c, 1.0 - double(level) / double(map.levels)));
    appendTexels(table.texels, table.format, values);
  }
  return table;
}

NoiseMap describeMap(const SyntheticMap& source) {
  using enum MapChannel;
  NoiseMap map;
  if (source.dimensions == 3) {
    map.target = MapTarget::baseColor;
    map.channels = {red, green, blue};
    map.encoding = ValueEncoding::root;
  } else if (source.dimensions == 2) {
    map.target = MapTarget::normal;
    map.channels = {slopeX, slopeY};
    map.encoding = ValueEncoding::slope;
  } else if (source.table == SyntheticTable::none) {
    map.target = MapTarget::height;
    map.channels = {height};
    map.encoding = ValueEncoding::log2;
  } else {
    map.target = MapTarget::occlusionRoughnessMetallic;
    map.channels = {occlusion, roughness, metallic};
    map.encoding = ValueEncoding::linear;
  }
  const std::size_t n = map.channels.size();
  map.mean.assign(n, 0.5);
  map.covariance.assign(n * n, source.table == SyntheticTable::none ? 0.006 : 0.0);
  for (std::size_t i = 0; i < n; ++i)
    map.covariance[i * n + i] = 0.01;
  map.as<TilingMap>().dimensions = source.dimensions;
  return map;
}

} // namespace

BundleFile syntheticBundle(std::span<const SyntheticMap> maps) {
  std::mt19937 generator(20181001u);
  BundleFile file;
  Noise noise;
  noise.name = "synthetic";
  noise.as<TilingNoise>().grain = maps.front().grain;
  for (const SyntheticMap& source : maps) {
    Table gaussian = gaussianTable(source, generator);
    NoiseMap map = describeMap(source);
    map.as<TilingMap>().gaussian = file.bundle.tables.size();
    file.bundle.tables.push_back(std::move(gaussian));
    if (source.table != SyntheticTable::none) {
      map.as<TilingMap>().inverseTable = file.bundle.tables.size();
      file.bundle.tables.push_back(inverseTable(source));
    }
    noise.maps.push_back(std::move(map));
  }
  file.bundle.noises.push_back(std::move(noise));
  file.bundle.materials.emplace_back(MaterialNoise{});
  file.previews.emplace_back();
  file.shape = PreviewShape::none;
  file.generator = "lichen tests";
  return file;
}

std::vector<std::byte> syntheticGlb(std::span<const SyntheticMap> maps) {
  return glbOf(syntheticBundle(maps));
}

} // namespace lichen::test
