// SPDX-License-Identifier: MIT
// make_bundle_goldens SOURCE_FOLDER writes the golden bundle bytes of tests/golden and the examples
// of docs/gltf_extension. Only the target regenerate_bundle_goldens runs it, when the format
// changes on purpose.
//
// The texton example is "dune", which bundle_example.h describes. The tiling example is "felt": a
// 16 x 16 image of white Gaussian noise, decoded to shades between two colours. Its base colour has
// one dimension, so the Gaussian image has two channels and the inverse table is 256 x 1 x 1.
#include "bundle_example.h"

#include <lichen/bundle_writer.h>
#include <lichen/files.h>
#include <lichen/image_io.h>
#include <lichen/lattice.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

using namespace lichen;

namespace {

constexpr std::uint32_t kSide = 16;
constexpr std::size_t kCells = 256; // of a one-dimensional inverse table
constexpr double kSigma = 1.0 / 6.0;
constexpr std::array<double, 3> kDark = {0.16, 0.20, 0.12}; // light
constexpr std::array<double, 3> kBright = {0.52, 0.50, 0.34};

double uniformOf(double gaussian) {
  return 0.5 * std::erfc(-(gaussian - 0.5) / (kSigma * std::sqrt(2.0)));
}

double gaussianOf(double uniform) {
  double low = -1.0, high = 2.0;
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2.0;
    (uniformOf(middle) < uniform ? low : high) = middle;
  }
  return low;
}

/// Maps a uniform value to the exemplar's light: mostly dark, with bright fibres.
double brightness(double uniform) { return uniform * uniform * (3.0 - 2.0 * uniform); }

/// E[brightness(U(g + e))], e ~ N(0, lost / 36), by a sum over quantiles of e.
double filteredBrightness(double gaussian, double lost) {
  constexpr int kSamples = 256;
  double sum = 0.0;
  for (int i = 0; i < kSamples; ++i)
    sum += brightness(
        uniformOf(gaussian + std::sqrt(lost) * (gaussianOf((i + 0.5) / kSamples) - 0.5)));
  return sum / kSamples;
}

/// The quantiles of the Gaussian, in an order that the published hash fixes.
std::vector<float> whiteNoise() {
  constexpr std::uint32_t kCount = kSide * kSide;
  std::vector<std::uint32_t> order(kCount);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [](auto a, auto b) { return pcg(a) < pcg(b); });
  std::vector<float> values(kCount);
  for (std::uint32_t rank = 0; rank < kCount; ++rank)
    values[order[rank]] = float(gaussianOf((rank + 0.5) / kCount));
  return values;
}

/// For white noise, level l keeps 4^-l of the variance; a bilinear fetch at a random place keeps
/// (2/3)^2 of what its texels have, but of the last one, which is constant.
Table gaussianImage(std::vector<float> level) {
  constexpr float kKeptByFetch = 4.0f / 9.0f;
  Table table{"felt.baseColor.gaussian",
              TexelFormat::rg8Unorm,
              kSide,
              kSide,
              0,
              example::fullMipChain(kSide, kSide),
              {}};
  std::vector<float> losses;
  float kept = 1.0f;
  for (std::size_t side = kSide;; side /= 2) {
    std::vector<float> texels;
    for (const float value : level) {
      texels.push_back(value - 0.5f + kStoredGaussianMean);
      texels.push_back(0.0f);
    }
    appendTexels(table.texels, table.format, texels);
    losses.push_back(side == 1 ? 1.0f : 1.0f - kKeptByFetch * kept);
    kept /= 4.0f;
    if (side == 1)
      break;
    std::vector<float> half;
    for (std::size_t y = 0; y < side; y += 2)
      for (std::size_t x = 0; x < side; x += 2)
        half.push_back((level[y * side + x] + level[y * side + x + 1] + level[(y + 1) * side + x] +
                        level[(y + 1) * side + x + 1]) /
                       4.0f);
    level = std::move(half);
  }
  example::setLosses(table, losses);
  return table;
}

double lightOf(double brightness, std::size_t channel) {
  return kDark[channel] + brightness * (kBright[channel] - kDark[channel]);
}

/// Roots of the mean light over what each level averages.
Table inverseTable() {
  Table table{
      "felt.baseColor.inverse", TexelFormat::rgba8Unorm, kCells, 1, 1, kMostTableLevels, {}};
  std::vector<float> texels;
  for (std::uint32_t level = 0; level < kMostTableLevels; ++level) {
    const double kept = 1.0 - double(level) / double(kMostTableLevels);
    const std::size_t cells = kCells >> level;
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const double gaussian = gaussianOf((double(cell) + 0.5) / double(cells));
      const double t = filteredBrightness(gaussian, 1.0 - kept * kept);
      for (std::size_t c = 0; c < 3; ++c)
        texels.push_back(float(std::sqrt(lightOf(t, c))));
      texels.push_back(1.0f);
    }
  }
  appendTexels(table.texels, table.format, texels);
  return table;
}

/// The exemplar itself, which tiles, as the preview.
SrgbImage exemplar(const std::vector<float>& gaussian) {
  SrgbImage image(kSide, kSide, 3);
  for (std::size_t i = 0; i < gaussian.size(); ++i) {
    const double t = brightness(uniformOf(double(gaussian[i])));
    for (std::size_t c = 0; c < 3; ++c)
      image.values[3 * i + c] = linearToSrgb(float(lightOf(t, c)));
  }
  return image;
}

/// Mean and covariance of the roots of light.
void setStatistics(NoiseMap& map, const std::vector<float>& gaussian) {
  const double count = double(gaussian.size());
  std::vector<std::array<double, 3>> roots;
  for (const float value : gaussian) {
    const double t = brightness(uniformOf(double(value)));
    roots.push_back({});
    for (std::size_t c = 0; c < 3; ++c)
      roots.back()[c] = std::sqrt(lightOf(t, c));
  }
  map.mean.assign(3, 0.0);
  map.covariance.assign(9, 0.0);
  for (const auto& root : roots)
    for (std::size_t c = 0; c < 3; ++c)
      map.mean[c] += root[c] / count;
  for (const auto& root : roots)
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        map.covariance[3 * a + b] += (root[a] - map.mean[a]) * (root[b] - map.mean[b]) / count;
}

BundleFile feltExample() {
  const std::vector<float> gaussian = whiteNoise();
  const SrgbImage image = exemplar(gaussian);
  BundleFile file;
  NoiseMap map;
  map.channels = {MapChannel::red, MapChannel::green, MapChannel::blue};
  setStatistics(map, gaussian);
  auto& tiling = map.as<TilingMap>();
  tiling.gaussian = 0;
  tiling.inverseTable = 1;
  file.bundle.tables = {gaussianImage(gaussian), inverseTable()};
  Noise noise;
  noise.name = "felt";
  noise.tileSizeMetres = 0.1;
  noise.maps.push_back(std::move(map));
  file.bundle.noises.push_back(std::move(noise));
  file.bundle.materials.emplace_back(MaterialNoise{});
  PreviewImages preview;
  preview.baseColor = encodePng(image, 8).value();
  file.previews.push_back(std::move(preview));
  file.shape = PreviewShape::plane;
  file.generator = "lichen make_bundle_goldens";
  return file;
}

bool report(const Result<void>& result) {
  if (!result)
    std::fprintf(stderr, "%s\n", result.error().message.c_str());
  return result.ok();
}

} // namespace

int main(int argumentCount, char** arguments) {
  if (argumentCount != 2) {
    std::fprintf(stderr, "usage: make_bundle_goldens SOURCE_FOLDER\n");
    return 2;
  }
  const std::filesystem::path source = arguments[1];
  const std::filesystem::path golden = source / "tests/golden";
  const std::filesystem::path examples = source / "docs/gltf_extension/examples";
  const BundleFile felt = feltExample();
  BundleFile dune = example::smallestTexton();
  dune.generator = felt.generator;
  const bool written =
      report(writeBundle(golden / "bundle_smallest.glb", example::smallest())) &&
      report(writeBundle(golden / "bundle_texton.glb", example::smallestTexton())) &&
      report(writeBundle(golden / "bundle_cosines.glb", example::smallestCosines())) &&
      report(writeBundle(golden / "bundle_kernels.glb", example::smallestKernels())) &&
      report(writeBundle(golden / "bundle_quilting.glb", example::smallestQuilting())) &&
      report(writeBundle(golden / "bundle_layers.glb", example::layered())) &&
      report(replaceFile(golden / "table_mips.ktx2", encodeKtx2(example::tableWithMips()))) &&
      report(writeBundle(examples / "felt.glb", felt)) &&
      report(writeBundle(examples / "felt.gltf", felt)) &&
      report(writeBundle(examples / "dune.glb", dune)) &&
      report(writeBundle(examples / "dune.gltf", dune));
  return written ? 0 : 1;
}
