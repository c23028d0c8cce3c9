// SPDX-License-Identifier: MIT
// Map of a bundle and its exemplar -> the JSON of the map's section in the report.
#include "map_section.h"

#include "method_report.h"
#include "section_figures.h"

#include <lichen/judgement_json.h>
#include <lichen/noise_comparison.h>
#include <lichen/synthesize.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kShownExemplars = 2; // of the result, per side

Json histogramsOf(const NoiseComparison& comparison) {
  constexpr std::size_t kBins = 64;
  const auto countsOf = [](const SrgbImage& image, std::size_t channel) {
    std::array<double, kBins> counts{};
    for (std::size_t i = channel; i < image.values.size(); i += std::size_t(image.channels)) {
      const float place = std::clamp(image.values[i], 0.0f, 1.0f) * float(kBins);
      counts[std::min(std::size_t(place), kBins - 1)] += 1.0 / double(image.pixelCount());
    }
    return counts;
  };
  Json histograms = Json::array();
  const std::vector<std::string>& names = comparison.look.channelNames();
  for (std::size_t c = 0; c < names.size(); ++c)
    histograms.push_back({{"channel", names[c]},
                          {"largest", comparison.look.largest()},
                          {"exemplar", countsOf(comparison.exemplar, c)},
                          {"result", countsOf(comparison.result, c)}});
  return histograms;
}

/// Spectra in decibels by cycles per crop; for a texton also the Gaussian texture's. Null if the
/// exemplar is too small for spectrum_distance_db.
Json spectrumOf(const NoiseComparison& comparison) {
  const int crop = spectrumCrop(comparison.exemplar, comparison.result);
  if (crop == 0)
    return {};
  Json curves = Json::array();
  const auto add = [&](const char* kind, const SrgbImage& image) {
    curves.push_back({{"kind", kind}, {"power", decibels(image, crop)}});
  };
  add("exemplar", comparison.exemplar);
  if (comparison.gaussian)
    add("gaussian", *comparison.gaussian);
  add("result", comparison.result);
  return {{"cropSide", crop}, {"curves", std::move(curves)}};
}

Json measuresOf(const NoiseComparison& comparison) {
  Json list = Json::array();
  for (const Measure& measure : comparison.measures)
    list.push_back(jsonOf(measure));
  return list;
}

Json risksOf(const ShownExemplar& shown, SettingWords words) {
  Json list = Json::array();
  for (const Risk& risk : shown.risks)
    list.push_back(jsonOf(risk, words));
  return list;
}

std::string summaryOf(const MapExemplar& exemplar) {
  std::string text;
  for (const MapChannel channel : exemplar.channels)
    text += (text.empty() ? "" : ", ") + std::string(nameOf(channel));
  return text + "; " + std::string(nameOf(exemplar.encoding)) + "; " +
         std::to_string(exemplar.width) + " x " + std::to_string(exemplar.height) + " pixels";
}

/// The size of the result's picture at the same scale: kShownExemplars per side, or, for narrow
/// exemplars, enough to make it half as wide as long.
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

/// Adds pictures of the original, the exemplar, its Gaussian texture and the result, at one scale.
/// The original is null if the exemplar is unchanged; the Gaussian texture is null if there is
/// none.
Result<void> addPictures(Json& section, const Bundle& bundle, const MaterialNoise& material,
                         const ShownExemplar& shown, const NoiseComparison& comparison,
                         int exemplarSide) {
  const auto [width, height] =
      pictureExtents(shown.exemplar.width, shown.exemplar.height, exemplarSide);
  SynthesisOptions options;
  options.material = material;
  options.map = shown.exemplar.target;
  options.texelsPerTile = width;
  options.mix = {material.mix.weight, material.mix.weight};
  const Extents extents = resultExtents({width, height}, exemplarSide);
  options.width = extents[0];
  options.height = extents[1];
  const Result<LinearImage> result = synthesize(bundle, options);
  if (!result)
    return result.error();
  Result<Json> original = Json();
  if (const std::optional<MapExemplar>& before = shown.origin.original; before)
    original = pictureJson(reduced(comparison.look.picture(*before), width, height));
  Result<Json> gaussian = Json();
  if (const std::optional<SrgbImage>& texture = comparison.gaussian; texture)
    gaussian = pictureJson(reduced(*texture, width * texture->width / comparison.exemplar.width,
                                   height * texture->height / comparison.exemplar.height));
  Result<Json> exemplar = pictureJson(reduced(comparison.exemplar, width, height));
  Result<Json> shownResult = pictureJson(comparison.look.picture(result.value()));
  for (const Result<Json>* made : {&original, &exemplar, &gaussian, &shownResult})
    if (!*made)
      return made->error();
  section["original"] = std::move(original).value();
  section["exemplar"] = std::move(exemplar).value();
  section["gaussian"] = std::move(gaussian).value();
  section["result"] = std::move(shownResult).value();
  return {};
}

} // namespace

Result<Json> describeMap(const Bundle& bundle, const MaterialNoise& material,
                         const ShownExemplar& shown, SettingWords words, int exemplarSide,
                         const Progress& progress) {
  const MapExemplar& exemplar = shown.exemplar;
  const Result<NoiseComparison> comparison = compareNoise(bundle, material, exemplar, progress);
  if (!comparison)
    return comparison.error();
  const Noise& noise = bundle.noises[material.noise];
  const NoiseMap& map = noise.maps[*findMap(noise, exemplar.target)]; // compareNoise() has found it
  Json section{{"target", nameOf(exemplar.target)},
               {"summary", summaryOf(exemplar)},
               {"measures", measuresOf(comparison.value())},
               {"risks", risksOf(shown, words)},
               {"steps", shown.origin.steps},
               {"histograms", histogramsOf(comparison.value())},
               {"spectrum", spectrumOf(comparison.value())}};
  if (Result<void> added =
          addPictures(section, bundle, material, shown, comparison.value(), exemplarSide);
      !added)
    return added.error();
  const MethodReport& method = reportOf(noise.method());
  Result<Json> image = method.image(bundle, noise, map, material.mix.weight, exemplarSide);
  if (!image)
    return image.error();
  Result<Json> further =
      method.furtherImages(bundle, noise, map, comparison.value().look, exemplarSide);
  if (!further)
    return further.error();
  Result<Json> table = method.table(bundle, map, comparison.value().look);
  if (!table)
    return table.error();
  section["image"] = std::move(image).value();
  section["furtherImages"] = std::move(further).value();
  section["table"] = std::move(table).value();
  return section;
}

} // namespace lichen
