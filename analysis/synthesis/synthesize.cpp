// SPDX-License-Identifier: MIT
// Bundle and options -> image. Evaluates each pixel with the noise's evaluator.
#include "progress_part.h"

#include <lichen/image_io.h>
#include <lichen/shader_parameters.h>
#include <lichen/synthesize.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <span>

namespace lichen {
namespace {

constexpr int kMaxPreviewSide = 1024;
constexpr double kMiddle = 0.5; // of a mix
/// Pixels between two calls of the progress: up to a second's work, with enough rows for many
/// threads.
constexpr int kPixelsPerStrip = 1 << 20;
constexpr int kPointsAtOnce = 64;
/// A smaller periodic lattice would need less than three columns and four rows.
constexpr double kLeastPeriodTiles = 0.5;

Error usage(std::string message) { return {ErrorKind::usage, std::move(message)}; }

/// The shortest text that parses back to the same number.
std::string text(double number) {
  std::array<char, 32> digits{}; // 24 are enough
  return std::string(digits.data(),
                     std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

Result<void> checkRange(const char* name, double value, NumberRange range) {
  if (value >= range.least && value <= range.most)
    return {};
  return usage(std::string(name) + " " + text(value) + "; expected a number from " +
               text(range.least) + " to " + text(range.most));
}

Result<void> check(const Bundle& bundle, const SynthesisOptions& options) {
  if (options.width < 1 || options.height < 1 || options.width > kMaxImageSide ||
      options.height > kMaxImageSide)
    return usage("size " + std::to_string(options.width) + "x" + std::to_string(options.height) +
                 "; expected sides from 1 to " + std::to_string(kMaxImageSide) + " pixels");
  if (options.material.noise >= bundle.noises.size())
    return usage("noise " + std::to_string(options.material.noise) + ": the bundle has " +
                 std::to_string(bundle.noises.size()));
  if (options.stride < 1 || (options.tileable && options.stride != 1))
    return usage("stride " + std::to_string(options.stride) +
                 "; expected 1, or more if the image is not tileable");
  if (options.texelsPerTile != 0.0)
    if (Result<void> checked =
            checkRange("texels per tile", options.texelsPerTile, kTexelsPerTileRange);
        !checked)
      return checked;
  if (Result<void> checked =
          checkRange("blend sharpness", options.material.blendSharpness, kBlendSharpnessRange);
      !checked)
    return checked;
  if (Result<void> checked = checkRange("contrast", options.material.contrast, kContrastRange);
      !checked)
    return checked;
  if (Result<void> checked = checkRange("impacts", options.material.impacts, kImpactsRange);
      !checked)
    return checked;
  for (const double weight : options.mix)
    if (Result<void> checked = checkRange("mix", weight, kMixWeightRange); !checked)
      return checked;
  if (options.tileable && options.mix[0] != options.mix[1])
    return usage("mix " + text(options.mix[0]) + "," + text(options.mix[1]) +
                 " of a tileable image; expected one weight");
  for (const double coordinate : options.origin)
    if (Result<void> checked = checkRange("origin", coordinate, kOriginRange); !checked)
      return checked;
  return {};
}

/// The offset of the image's top left corner from the lattice's integer tile origin. A periodic
/// lattice starts at 0 and has no origin, so the corner is inside its first period.
double startOf(double origin, double periodTiles, bool periodic) {
  if (!periodic)
    return origin - std::floor(origin);
  const double start = std::fmod(origin, periodTiles);
  return start < 0.0 ? start + periodTiles : start;
}

/// The material on a plane whose coordinates are tiles.
MaterialNoise onTiles(MaterialNoise material) {
  material.mapping = Mapping::uv;
  material.scale = 1.0;
  material.offset = {0.0, 0.0};
  material.rotation = 0.0;
  return material;
}

/// Like synthesize(), with pixels per tile along each axis and options in range. Throws Interrupted
/// and std::bad_alloc.
Result<LinearImage> evaluatePixels(const Bundle& bundle, const SynthesisOptions& options,
                                   const std::array<double, 2>& pixelsPerTile, std::size_t map) {
  Placement placement;
  placement.periodic = options.tileable;
  placement.periodTilesX = options.width / pixelsPerTile[0];
  placement.periodTilesY = options.height / pixelsPerTile[1];
  if (!options.tileable) {
    placement.tileOriginX = std::int64_t(std::floor(options.origin[0]));
    placement.tileOriginY = std::int64_t(std::floor(options.origin[1]));
  }
  const std::array<double, 2> start{
      startOf(options.origin[0], placement.periodTilesX, options.tileable),
      startOf(options.origin[1], placement.periodTilesY, options.tileable)};
  const MaterialNoise material = onTiles(options.material);
  const Result<std::unique_ptr<const NoiseEvaluator>> evaluator =
      NoiseEvaluator::create(bundle, material, placement, options.evaluation);
  if (!evaluator)
    return evaluator.error();

  LinearImage image(options.width, options.height,
                    int(bundle.noises[options.material.noise].maps[map].channels.size()));
  const auto evaluateRow = [&](int y) {
    PlanePoint first;
    first.at.dx = {float(1.0 / pixelsPerTile[0]), 0.0f};
    first.at.dy = {0.0f, float(1.0 / pixelsPerTile[1])};
    first.at.position[1] = float(start[1] + (double(y) * options.stride + 0.5) / pixelsPerTile[1]);
    const double mixRise = options.mix[1] - options.mix[0];
    first.mix.gradient[0] =
        float(mixRise * pixelsPerTile[0] / (double(options.width) * options.stride));
    std::array<PlanePoint, kPointsAtOnce> points;
    points.fill(first);
    std::array<NoiseEvaluator::Value, kPointsAtOnce> values;
    for (int begin = 0; begin < image.width; begin += kPointsAtOnce) {
      const int count = std::min(kPointsAtOnce, image.width - begin);
      for (int k = 0; k < count; ++k) {
        const double pixel = double(begin + k) * options.stride + 0.5;
        const double along = pixel / (double(options.width) * options.stride);
        PlanePoint& point = points[std::size_t(k)];
        point.mix.weight = float(options.mix[0] + mixRise * along);
        point.at.position[0] = float(start[0] + pixel / pixelsPerTile[0]);
      }
      evaluator.value()->evaluate(map, std::span(points).first(std::size_t(count)), values);
      for (int k = 0; k < count; ++k)
        std::copy_n(values[std::size_t(k)].begin(), image.channels, image.pixel(begin + k, y));
    }
  };
  const ProgressPart progress(options.progress);
  const int stripRows = std::max(1, kPixelsPerStrip / image.width);
  for (int y = 0; y < image.height; y += stripRows) {
    tbb::parallel_for(y, std::min(y + stripRows, image.height), evaluateRow);
    progress.reach(double(std::min(y + stripRows, image.height)) / image.height);
  }
  return image;
}

} // namespace

std::array<double, 2> pixelsPerTile(const Bundle& bundle, std::size_t noise, const NoiseMap& map,
                                    double texelsPerTile) {
  if (texelsPerTile == 0.0) {
    const auto [width, height] = exemplarSize(bundle, bundle.noises[noise], map);
    return {double(width), double(height)};
  }
  const shader::LichenNoise tile = shaderNoise(bundle, noise);
  return {texelsPerTile, texelsPerTile * double(tile.tileTexelsY) / double(tile.tileTexelsX)};
}

Result<LinearImage> synthesize(const Bundle& bundle, const SynthesisOptions& options) {
  const auto exhausted = [&] {
    return "not enough memory for an image of " + std::to_string(options.width) + "x" +
           std::to_string(options.height);
  };
  return withinMemory(exhausted, [&]() -> Result<LinearImage> {
    if (Result<void> checked = check(bundle, options); !checked)
      return checked.error();
    const std::optional<std::size_t> map =
        findMap(bundle.noises[options.material.noise], options.map);
    if (!map)
      return usage("noise '" + bundle.noises[options.material.noise].name + "' has no map " +
                   std::string(nameOf(options.map)));
    const Noise& noise = bundle.noises[options.material.noise];
    const std::array<double, 2> perTile =
        pixelsPerTile(bundle, options.material.noise, noise.maps[*map], options.texelsPerTile);
    const double tiles = std::min(options.width / perTile[0], options.height / perTile[1]);
    const double largest = perTile[0] * tiles / kLeastPeriodTiles;
    if (options.tileable && tiles < kLeastPeriodTiles)
      return usage("size " + std::to_string(options.width) + "x" + std::to_string(options.height) +
                   " is under half a tile; a tileable image needs at least " +
                   std::to_string(int(std::ceil(kLeastPeriodTiles * perTile[0]))) + "x" +
                   std::to_string(int(std::ceil(kLeastPeriodTiles * perTile[1]))) +
                   ", or at most " + text(largest < 1.0 ? largest : std::floor(largest)) +
                   " texels per tile");
    try {
      return evaluatePixels(bundle, options, perTile, *map);
    } catch (const Interrupted&) {
      return Error{ErrorKind::environment, "interrupted"};
    }
  });
}

Result<LinearImage> synthesizePreview(const Bundle& bundle, const MaterialNoise& material,
                                      MapTarget target, int tiles) {
  const auto exhausted = [tiles] {
    return "not enough memory for a preview with " + std::to_string(tiles) + " tiles a side";
  };
  return withinMemory(exhausted, [&]() -> Result<LinearImage> {
    SynthesisOptions options;
    options.material = material;
    options.map = target;
    options.tileable = true;
    options.width = options.height = 1; // until the noise is known
    if (Result<void> checked = check(bundle, options); !checked)
      return checked.error();
    if (tiles < 1 || tiles > kMaxPreviewSide)
      return usage("a preview with " + std::to_string(tiles) + " tiles per side; expected 1 to " +
                   std::to_string(kMaxPreviewSide));
    const Noise& noise = bundle.noises[options.material.noise];
    const std::optional<std::size_t> map = findMap(noise, target);
    if (!map)
      return usage("noise '" + noise.name + "' has no map " + std::string(nameOf(target)));
    std::uint32_t width = 0, height = 0;
    for (const NoiseMap& each : noise.maps) {
      const std::array<std::uint32_t, 2> tile = exemplarSize(bundle, noise, each);
      width = std::max(width, tile[0]);
      height = std::max(height, tile[1]);
    }
    const auto side = [tiles](std::uint32_t texels) {
      const auto wanted = std::bit_ceil(std::uint64_t(texels) * std::uint64_t(tiles));
      return int(std::min<std::uint64_t>(wanted, std::uint64_t(kMaxPreviewSide)));
    };
    options.mix = {kMiddle, kMiddle};
    options.width = side(width);
    options.height = side(height);
    return evaluatePixels(bundle, options,
                          {double(options.width) / tiles, double(options.height) / tiles}, *map);
  });
}

} // namespace lichen
