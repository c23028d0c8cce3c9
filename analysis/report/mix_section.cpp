// SPDX-License-Identifier: MIT
// Bundle of a mix and its inputs -> the JSON of the section that shows the steps between them.
#include "mix_section.h"

#include "exemplar/resample.h"
#include "method_report.h"
#include "section_figures.h"

#include <lichen/map_picture.h>
#include <lichen/synthesize.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

/// The spectrum of a step is computed from a result of twice the exemplar's width, and at most this
/// side.
constexpr int kLargestSpectrumSide = 1024;

/// An input, or a step that is shown as large as this input.
struct Place {
  std::size_t input = 0;
  std::optional<std::size_t> step;
};

/// A pane's JSON, and pixels at the noise's scale for its spectrum.
struct Pane {
  Json json;
  SrgbImage pixels;
};

/// One map of a mix.
class MixedMap {
public:
  MixedMap(const BakeRecord& record, std::size_t map, int side)
      : record_(record), map_(map), side_(side), material_(*record.bundle.materials.front()),
        noise_(record.bundle.noises[material_.noise]),
        noiseMap_(noise_.maps[*findMap(noise_, record.inputs.front().exemplars[map].target)]),
        width_(int(exemplarSize(record.bundle, noise_, noiseMap_)[0])) {}

  [[nodiscard]] Result<Pane> pane(const Place& place) const {
    return place.step ? step(place.input, *place.step) : exemplar(place.input);
  }

private:
  [[nodiscard]] const MapExemplar& exemplarOf(std::size_t input) const {
    return record_.inputs[input].exemplars[map_];
  }
  [[nodiscard]] SrgbImage picture(std::size_t input, const auto& values) const {
    return MapLook(exemplarOf(input), noiseMap_.encoding).picture(values);
  }

  /// An exemplar is as wide as the noise's.
  [[nodiscard]] Result<Pane> exemplar(std::size_t input) const {
    MapExemplar map = exemplarOf(input);
    if (map.width != width_)
      map = exemplar::resampled(map, width_, std::max(1, map.height * width_ / map.width), false);
    SrgbImage pixels = picture(input, map);
    const auto [width, height] = exemplarExtents(map, side_);
    Result<Json> small = pictureJson(reduced(pixels, width, height));
    if (!small)
      return small.error();
    small.value()["name"] = record_.inputs[input].name;
    return Pane{std::move(small).value(), std::move(pixels)};
  }

  [[nodiscard]] Result<Pane> step(std::size_t input, std::size_t step) const {
    const std::size_t last = record_.modelErrors.size() - 1;
    const double weight = last > 0 ? double(step) / double(last) : 0.0;
    SynthesisOptions options;
    options.material = material_;
    options.map = noiseMap_.target;
    options.mix = {weight, weight};
    options.width = options.height = std::min(2 * width_, kLargestSpectrumSide);
    const Result<LinearImage> large = synthesize(record_.bundle, options);
    const auto [width, height] = exemplarExtents(exemplarOf(input), side_);
    options.texelsPerTile = options.width = width;
    options.height = height;
    const Result<LinearImage> small = synthesize(record_.bundle, options);
    for (const Result<LinearImage>* made : {&large, &small})
      if (!*made)
        return made->error();
    Result<Json> json = pictureJson(picture(input, small.value()));
    Result<Json> kernel =
        reportOf(noise_.method()).image(record_.bundle, noise_, noiseMap_, weight, side_);
    for (const Result<Json>* made : {&json, &kernel})
      if (!*made)
        return made->error();
    json.value()["step"] = step + 1;
    json.value()["weight"] = weight;
    json.value()["modelError"] = record_.modelErrors[step];
    json.value()["kernel"] = std::move(kernel).value();
    return Pane{std::move(json).value(), picture(input, large.value())};
  }

  const BakeRecord& record_;
  std::size_t map_;
  int side_;
  const MaterialNoise& material_;
  const Noise& noise_;
  const NoiseMap& noiseMap_;
  int width_;
};

/// The places from an input to the next.
std::vector<Place> pathFrom(const BakeRecord& record, std::size_t input) {
  const std::size_t apart = (record.modelErrors.size() - 1) / (record.inputs.size() - 1);
  const std::size_t intervals = std::min(std::size_t(kMostPathPanes - 3), apart);
  std::vector<Place> path;
  path.push_back({input, {}});
  for (std::size_t k = 0; k <= intervals; ++k)
    path.push_back({2 * k <= intervals ? input : input + 1,
                    input * apart + (k * apart + intervals / 2) / intervals});
  path.push_back({input + 1, {}});
  return path;
}

/// All inputs, and the one texture between them.
std::vector<Place> placesAround(const BakeRecord& record) {
  std::vector<Place> places;
  for (std::size_t input = 0; input < record.inputs.size(); ++input)
    places.push_back({input, {}});
  places.push_back({0, 0});
  return places;
}

Result<Json> describePath(const MixedMap& map, const std::vector<Place>& places) {
  Json panes = Json::array(), curves = Json::array();
  std::vector<SrgbImage> images;
  for (const Place& place : places) {
    Result<Pane> pane = map.pane(place);
    if (!pane)
      return pane.error();
    panes.push_back(std::move(pane.value().json));
    images.push_back(std::move(pane.value().pixels));
  }
  int crop = spectrumCrop(images.front(), images.back());
  for (const SrgbImage& image : images)
    crop = std::min(crop, spectrumCrop(image, image));
  for (std::size_t i = 0; i < places.size() && crop > 0; ++i)
    curves.push_back(
        {{"kind", places[i].step ? "result" : "exemplar"}, {"power", decibels(images[i], crop)}});
  return Json{{"panes", std::move(panes)},
              {"spectrum", crop > 0 ? Json{{"cropSide", crop}, {"curves", curves}} : Json()}};
}

} // namespace

Result<Json> describeMix(const BakeRecord& record, std::size_t map, int side) {
  const MixedMap mixed(record, map, side);
  std::vector<std::vector<Place>> all;
  if (record.modelErrors.size() == 1)
    all.push_back(placesAround(record));
  else
    for (std::size_t input = 0; input + 1 < record.inputs.size(); ++input)
      all.push_back(pathFrom(record, input));
  Json paths = Json::array();
  for (const std::vector<Place>& places : all) {
    Result<Json> path = describePath(mixed, places);
    if (!path)
      return path;
    paths.push_back(std::move(path).value());
  }
  return Json{{"target", nameOf(record.inputs.front().exemplars[map].target)},
              {"paths", std::move(paths)}};
}

} // namespace lichen
