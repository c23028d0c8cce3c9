// SPDX-License-Identifier: MIT
// Map of a bundle and its exemplar -> the JSON of its section of the report.
#include "map_section.h"

#include "data_uri.h"

#include <lichen/judgement_json.h>
#include <lichen/noise_comparison.h>
#include <lichen/spectrum.h>
#include <lichen/synthesize.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lichen {
namespace {

constexpr int kShownExemplars = 2; // of the result, a side

/// {"png": data URI}, or the encoder's refusal.
template <class AnyImage>
Result<JsonTree> picture(const AnyImage& image) {
  Result<std::string> uri = pngDataUri(image);
  if (!uri)
    return uri.error();
  return JsonTree{{"png", std::move(uri).value()}};
}

/// The mean of the block of pixels under each pixel of a smaller image.
SrgbImage reduced(const SrgbImage& image, int width, int height) {
  SrgbImage small(width, height, image.channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int left = x * image.width / width, right = (x + 1) * image.width / width;
      const int top = y * image.height / height, bottom = (y + 1) * image.height / height;
      for (int c = 0; c < image.channels; ++c) {
        double sum = 0.0;
        for (int v = top; v < bottom; ++v)
          for (int u = left; u < right; ++u)
            sum += double(image.pixel(u, v)[c]);
        small.pixel(x, y)[c] = float(sum / (double(right - left) * double(bottom - top)));
      }
    }
  return small;
}

JsonTree histogramsOf(const NoiseComparison& comparison) {
  constexpr std::size_t kBins = 64;
  const auto countsOf = [](const SrgbImage& image, std::size_t channel) {
    std::array<double, kBins> counts{};
    for (std::size_t i = channel; i < image.values.size(); i += std::size_t(image.channels)) {
      const float place = std::clamp(image.values[i], 0.0f, 1.0f) * float(kBins);
      counts[std::min(std::size_t(place), kBins - 1)] += 1.0 / double(image.pixelCount());
    }
    return counts;
  };
  JsonTree histograms = JsonTree::array();
  const std::vector<std::string>& names = comparison.look.channelNames();
  for (std::size_t c = 0; c < names.size(); ++c)
    histograms.push_back({{"channel", names[c]},
                          {"largest", comparison.look.largest()},
                          {"exemplar", countsOf(comparison.exemplar, c)},
                          {"result", countsOf(comparison.result, c)}});
  return histograms;
}

/// In decibels by cycles per crop, of a texton that of the Gaussian texture too; null where the
/// exemplar is too small for spectrum_distance_db.
JsonTree spectrumOf(const NoiseComparison& comparison) {
  const auto shorter = [](const SrgbImage& image) { return std::min(image.width, image.height); };
  const int crop =
      comparedCropSide(std::min(shorter(comparison.exemplar), shorter(comparison.result)));
  if (crop < 2 * kLowestComparedCycles)
    return {};
  constexpr double kLeastPower = 1e-12; // of an image without variance
  const auto decibels = [&](const SrgbImage& image) {
    std::vector<double> power =
        radialPowerSpectrum(luminancePlane(image), image.width, image.height, crop);
    for (double& value : power)
      value = 10.0 * std::log10(std::max(value, kLeastPower));
    return power;
  };
  return {{"cropSide", crop},
          {"exemplar", decibels(comparison.exemplar)},
          {"gaussian", comparison.gaussian ? JsonTree(decibels(*comparison.gaussian)) : JsonTree()},
          {"result", decibels(comparison.result)}};
}

template <class Judgement>
JsonTree listOf(const std::vector<Judgement>& judgements) {
  JsonTree list = JsonTree::array();
  for (const Judgement& judgement : judgements)
    list.push_back(jsonOf(judgement));
  return list;
}

/// The finest level of the Gaussian image with no more pixels than a square of `side`.
Result<JsonTree> gaussianPicture(const Table& table, int side) {
  const auto shift = [&](std::uint32_t extent, std::uint32_t level) {
    return std::max(1u, extent >> level);
  };
  std::uint32_t level = 0;
  while (level + 1 < table.mipLevels &&
         double(shift(table.width, level)) * shift(table.height, level) > double(side) * side)
    ++level;
  const std::vector<float> texels = decodeLevel(table, level);
  const auto stored = std::size_t(channelCount(table.format));
  const std::size_t colours = std::min<std::size_t>(stored, 3); // a fourth is unused
  LinearImage image(int(shift(table.width, level)), int(shift(table.height, level)), int(colours));
  for (std::size_t i = 0; i < image.pixelCount(); ++i)
    std::copy_n(&texels[i * stored], colours, &image.values[i * colours]);
  return picture(twoAsRedGreen(std::move(image)));
}

/// The coefficients of a texton, of a mix the first: grey is 0, the range that of the largest.
Result<JsonTree> textonPicture(const Table& table, const TextonShape& shape, std::size_t channels) {
  const std::vector<float> texels = decodeLevel(table, 0);
  const auto stored = std::size_t(channelCount(table.format));
  float largest = std::numeric_limits<float>::min();
  for (std::size_t i = 0; i < texels.size(); ++i)
    if (i % stored < channels)
      largest = std::max(largest, std::abs(texels[i]));
  LinearImage image(shape.coefficientsX, shape.coefficientsY, int(channels));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < channels; ++c)
        image.pixel(x, y)[c] =
            0.5f +
            0.5f * texels[(std::size_t(y) * table.width + std::size_t(x)) * stored + c] / largest;
  return picture(twoAsRedGreen(std::move(image)));
}

/// All slabs of a separable table, one below the other: a row for each axis, with what its values
/// give where the others are at their mean.
LinearImage axesPicture(const Table& table, const TilingMap& map, std::size_t channels) {
  const std::vector<float> texels = decodeLevel(table, 0);
  const auto stored = std::size_t(channelCount(table.format));
  const std::size_t axes = map.tableBasis.size() / channels;
  LinearImage image(int(table.width), int(table.height * axes), int(channels));
  for (std::size_t slab = 0; slab < table.height; ++slab)
    for (std::size_t axis = 0; axis < axes; ++axis)
      for (std::size_t x = 0; x < table.width; ++x)
        for (std::size_t c = 0; c < channels; ++c)
          image.pixel(int(x), int(slab * axes + axis))[c] =
              std::max(0.0f, float(map.tableOffset[c] +
                                   map.tableBasis[c * axes + axis] *
                                       double(texels[(slab * table.width + x) * stored + axis])));
  return image;
}

/// All slabs of a joint table: one below the other, their slices side by side.
LinearImage slicesPicture(const Table& table, std::size_t channels, std::size_t slices) {
  const std::vector<float> texels = decodeLevel(table, 0);
  const auto stored = std::size_t(channelCount(table.format));
  const std::size_t layers = std::max(table.depth, 1u), width = table.width;
  const std::size_t rows = table.height;
  LinearImage image(int(width * slices), int(rows * (layers / slices)), int(channels));
  for (std::size_t z = 0; z < layers; ++z)
    for (std::size_t y = 0; y < rows; ++y)
      for (std::size_t x = 0; x < width; ++x)
        std::copy_n(&texels[((z * rows + y) * width + x) * stored], std::min(channels, stored),
                    image.pixel(int(z % slices * width + x), int(z / slices * rows + y)));
  return image;
}

Result<JsonTree> tablePicture(const Table& table, const NoiseMap& map, const MapLook& look) {
  const auto& tiling = map.as<TilingMap>();
  const std::size_t channels = map.channels.size();
  const std::size_t slices = table.depth > 0 ? table.depth / tiling.levels.size() : 1;
  Result<JsonTree> shown = picture(look.picture(tableKindOf(tiling) == TableKind::joint
                                                    ? slicesPicture(table, channels, slices)
                                                    : axesPicture(table, tiling, channels)));
  if (!shown)
    return shown.error();
  return JsonTree{
      {"picture", std::move(shown).value()}, {"slices", slices}, {"levels", tiling.levels}};
}

std::string summaryOf(const MapExemplar& exemplar) {
  std::string text;
  for (const MapChannel channel : exemplar.channels)
    text += (text.empty() ? "" : ", ") + std::string(nameOf(channel));
  return text + "; " + std::string(nameOf(exemplar.encoding)) + "; " +
         std::to_string(exemplar.width) + " x " + std::to_string(exemplar.height) + " pixels";
}

using Extents = std::array<int, 2>;

/// Of a picture of the exemplar with its proportions, of as many pixels as a square of `side`.
Extents exemplarExtents(const MapExemplar& exemplar, int side) {
  const double pixels = double(exemplar.width) * double(exemplar.height);
  const double shrink = std::min(1.0, side / std::sqrt(pixels));
  return {std::max(1, int(exemplar.width * shrink)), std::max(1, int(exemplar.height * shrink))};
}

/// Of a picture of the result at the same scale: kShownExemplars a side or, of narrow ones, as many
/// as make it half as wide as long.
Extents resultExtents(const Extents& exemplar, int side) {
  Extents extents{kShownExemplars * exemplar[0], kShownExemplars * exemplar[1]};
  const std::size_t longer = extents[0] < extents[1] ? 1 : 0;
  int& length = extents[longer];
  int& breadth = extents[1 - longer];
  if (length > 2 * breadth) {
    length = std::min(length, int(std::sqrt(2.0) * kShownExemplars * side)); // as many pixels
    breadth = std::max(breadth, length / 2);
  }
  return extents;
}

/// Adds pictures of original, exemplar, its Gaussian texture and result at one scale; the first is
/// null where the exemplar is as it was, the third where there is none.
Result<void> addPictures(JsonTree& section, const Bundle& bundle, const MaterialNoise& material,
                         const ShownExemplar& shown, const NoiseComparison& comparison,
                         int exemplarSide) {
  const auto [width, height] = exemplarExtents(shown.exemplar, exemplarSide);
  SynthesisOptions options;
  options.material = material;
  options.map = shown.exemplar.target;
  options.texelsPerTile = width;
  const Extents extents = resultExtents({width, height}, exemplarSide);
  options.width = extents[0];
  options.height = extents[1];
  const Result<LinearImage> result = synthesize(bundle, options);
  if (!result)
    return result.error();
  Result<JsonTree> original = JsonTree();
  if (const std::optional<MapExemplar>& before = shown.origin.original; before)
    original = picture(reduced(comparison.look.picture(*before), width, height));
  Result<JsonTree> gaussian = JsonTree();
  if (const std::optional<SrgbImage>& texture = comparison.gaussian; texture)
    gaussian = picture(reduced(*texture, 2 * width, 2 * height));
  Result<JsonTree> exemplar = picture(reduced(comparison.exemplar, width, height));
  Result<JsonTree> shownResult = picture(comparison.look.picture(result.value()));
  for (const Result<JsonTree>* made : {&original, &exemplar, &gaussian, &shownResult})
    if (!*made)
      return made->error();
  section["original"] = std::move(original).value();
  section["exemplar"] = std::move(exemplar).value();
  section["gaussian"] = std::move(gaussian).value();
  section["result"] = std::move(shownResult).value();
  return {};
}

} // namespace

Result<JsonTree> describeMap(const Bundle& bundle, const MaterialNoise& material,
                             const ShownExemplar& shown, int exemplarSide,
                             const Progress& progress) {
  const MapExemplar& exemplar = shown.exemplar;
  const Result<NoiseComparison> comparison = compareNoise(bundle, material, exemplar, progress);
  if (!comparison)
    return comparison.error();
  const Noise& noise = bundle.noises[material.noise];
  const NoiseMap& map = noise.maps[*findMap(noise, exemplar.target)]; // which was compared
  JsonTree section{{"target", nameOf(exemplar.target)},
                   {"summary", summaryOf(exemplar)},
                   {"measures", listOf(comparison.value().measures)},
                   {"risks", listOf(shown.risks)},
                   {"steps", shown.origin.steps},
                   {"histograms", histogramsOf(comparison.value())},
                   {"spectrum", spectrumOf(comparison.value())}};
  if (Result<void> added =
          addPictures(section, bundle, material, shown, comparison.value(), exemplarSide);
      !added)
    return added.error();
  const auto* tiling = std::get_if<TilingMap>(&map.data);
  Result<JsonTree> image = tiling != nullptr
                               ? gaussianPicture(bundle.tables[tiling->gaussian], exemplarSide)
                               : textonPicture(bundle.tables[map.as<TextonMap>().image],
                                               noise.as<TextonShape>(), map.channels.size());
  if (!image)
    return image.error();
  section["image"] = std::move(image).value();
  section["method"] = nameOf(noise.method());
  section["kernels"] =
      comparison.value().kernels ? jsonOf(*comparison.value().kernels) : JsonTree();
  section["table"] = JsonTree();
  if (tiling != nullptr && tiling->inverseTable) {
    Result<JsonTree> table =
        tablePicture(bundle.tables[*tiling->inverseTable], map, comparison.value().look);
    if (!table)
      return table.error();
    section["table"] = std::move(table).value();
  }
  return section;
}

} // namespace lichen
