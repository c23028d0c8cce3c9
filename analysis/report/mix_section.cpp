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
#include <cassert>
#include <numeric>
#include <optional>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

/// Intervals between the steps that a path shows, at most.
constexpr std::size_t kMostIntervals = 4;
/// The spectrum of a step is computed from a result of twice the exemplar's width, and at most this
/// side.
constexpr int kLargestSpectrumSide = 1024;

/// An input or a step, and where on its path.
struct Place {
  std::optional<std::size_t> input;
  std::size_t step = 0; ///< without an input
  std::optional<double> along;
};

using Path = std::vector<Place>;

/// Steps from an input to the next.
std::size_t stepsApart(const BakeRecord& record) {
  return (record.mix->modelErrors.size() - 1) / (record.inputs.size() - 1);
}

Path pathFrom(const BakeRecord& record, std::size_t input) {
  const std::size_t apart = stepsApart(record);
  const std::size_t intervals = std::min(kMostIntervals, apart);
  Path path{{.input = input, .along = 0.0}};
  for (std::size_t k = 0; k <= intervals; ++k) {
    const std::size_t step = (k * apart + intervals / 2) / intervals;
    path.push_back(
        {.input = {}, .step = input * apart + step, .along = double(step) / double(apart)});
  }
  path.push_back({.input = input + 1, .along = 1.0});
  return path;
}

/// All inputs, and the one texture between them.
Path pathAround(const BakeRecord& record) {
  Path path;
  const std::size_t inputs = record.inputs.size();
  for (std::size_t input = 0; input < inputs; ++input)
    path.push_back({.input = input, .along = double(input) / double(inputs - 1)});
  path.push_back({});
  return path;
}

std::vector<Path> pathsOf(const BakeRecord& record) {
  if (!record.mix->weights.empty())
    return {pathAround(record)};
  std::vector<Path> paths;
  for (std::size_t input = 0; input + 1 < record.inputs.size(); ++input)
    paths.push_back(pathFrom(record, input));
  return paths;
}

bool isStep(const Place& place) { return !place.input; }

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
        noiseMap_(noise_.maps[*findMap(noise_, exemplarOf(0).target)]), look_(brightestLook()) {
    const auto [width, height] = exemplarSize(record.bundle, noise_, noiseMap_);
    width_ = int(width);
    extents_ = pictureExtents(int(width), int(height), side);
  }

  [[nodiscard]] const Extents& extents() const { return extents_; }

  [[nodiscard]] Result<Pane> pane(const Place& place, const Progress& progress) const {
    Result<Pane> made = isStep(place) ? step(place.step, progress) : exemplar(*place.input);
    if (made)
      made.value().json["along"] = place.along ? Json(*place.along) : Json();
    return made;
  }

private:
  [[nodiscard]] const MapExemplar& exemplarOf(std::size_t input) const {
    return record_.inputs[input].exemplars[map_];
  }

  /// One look for all pictures; of light above 1, that of the input with the brightest.
  [[nodiscard]] MapLook brightestLook() const {
    MapLook brightest(exemplarOf(0), noiseMap_.encoding);
    for (std::size_t input = 1; input < record_.inputs.size(); ++input)
      if (MapLook look(exemplarOf(input), noiseMap_.encoding); look.largest() > brightest.largest())
        brightest = std::move(look);
    return brightest;
  }

  /// An exemplar is as wide as the noise's.
  [[nodiscard]] Result<Pane> exemplar(std::size_t input) const {
    MapExemplar map = exemplarOf(input);
    if (map.width != width_)
      map = exemplar::resampled(map, width_, std::max(1, map.height * width_ / map.width), false);
    SrgbImage pixels = look_.picture(map);
    const int height = std::clamp(map.height * extents_[0] / width_, 1, extents_[1]);
    Result<Json> small = pictureJson(reduced(pixels, extents_[0], height));
    if (!small)
      return small.error();
    small.value()["name"] = record_.inputs[input].name;
    if (const std::span<const double> weights = record_.mix->weights; !weights.empty())
      small.value()["share"] =
          weights[input] / std::accumulate(weights.begin(), weights.end(), 0.0);
    return Pane{std::move(small).value(), std::move(pixels)};
  }

  [[nodiscard]] Result<Pane> step(std::size_t step, const Progress& progress) const {
    const std::size_t last = record_.mix->modelErrors.size() - 1;
    const double weight = last > 0 ? double(step) / double(last) : 0.0;
    SynthesisOptions options;
    options.material = material_;
    options.map = noiseMap_.target;
    options.mix = {weight, weight};
    options.width = options.height = std::min(2 * width_, kLargestSpectrumSide);
    const double large = double(options.width) * options.height;
    const double share = large / (large + double(extents_[0]) * extents_[1]);
    options.progress = partOf(progress, 0.0, share);
    const Result<LinearImage> noise = synthesize(record_.bundle, options);
    if (!noise)
      return noise.error();
    options.texelsPerTile = options.width = extents_[0];
    options.height = extents_[1];
    options.progress = partOf(progress, share, 1.0);
    const Result<LinearImage> small = synthesize(record_.bundle, options);
    if (!small)
      return small.error();
    Result<Json> json = pictureJson(look_.picture(small.value()));
    Result<Json> kernel =
        reportOf(noise_.method()).image(record_.bundle, noise_, noiseMap_, weight, side_);
    for (const Result<Json>* made : {&json, &kernel})
      if (!*made)
        return made->error();
    json.value()["step"] = step + 1;
    json.value()["weight"] = weight;
    json.value()["modelError"] = record_.mix->modelErrors[step];
    json.value()["kernel"] = std::move(kernel).value();
    return Pane{std::move(json).value(), look_.picture(noise.value())};
  }

  const BakeRecord& record_;
  std::size_t map_;
  int side_;
  const MaterialNoise& material_;
  const Noise& noise_;
  const NoiseMap& noiseMap_;
  MapLook look_;
  int width_ = 0;
  Extents extents_{};
};

Result<Json> describePath(const MixedMap& map, const Path& path, const Progress& progress) {
  Json panes = Json::array(), curves = Json::array();
  std::vector<SrgbImage> images;
  const auto steps = double(std::count_if(path.begin(), path.end(), isStep));
  double done = 0.0; // steps take nearly all of the time
  for (const Place& place : path) {
    const double next = done + (isStep(place) ? 1.0 : 0.0);
    Result<Pane> pane = map.pane(place, partOf(progress, done / steps, next / steps));
    if (!pane)
      return pane.error();
    done = next;
    panes.push_back(std::move(pane.value().json));
    images.push_back(std::move(pane.value().pixels));
  }
  int crop = spectrumCrop(images.front(), images.back());
  for (const SrgbImage& image : images)
    crop = std::min(crop, spectrumCrop(image, image));
  for (std::size_t i = 0; i < path.size() && crop > 0; ++i)
    curves.push_back({{"kind", isStep(path[i]) ? "result" : "exemplar"},
                      {"along", panes[i]["along"]},
                      {"power", decibels(images[i], crop)}});
  return Json{{"panes", std::move(panes)},
              {"spectrum", crop > 0 ? Json{{"cropSide", crop}, {"curves", curves}} : Json()}};
}

} // namespace

std::size_t mixPictures(const BakeRecord& record) {
  std::size_t pictures = 0;
  for (const Path& path : pathsOf(record))
    for (const Place& place : path)
      pictures += isStep(place) ? 2u : 1u; // the noise and what it fetches from; or the exemplar
  return pictures;
}

Result<Json> describeMix(const BakeRecord& record, std::size_t map, int side,
                         const Progress& progress) {
  assert(record.mix && record.inputs.size() > 1);
  const MixedMap mixed(record, map, side);
  const std::vector<Path> paths = pathsOf(record);
  const auto count = double(paths.size());
  Json shown = Json::array();
  for (const Path& path : paths) {
    const auto done = double(shown.size());
    Result<Json> described =
        describePath(mixed, path, partOf(progress, done / count, (done + 1.0) / count));
    if (!described)
      return described;
    shown.push_back(std::move(described).value());
  }
  return Json{{"target", nameOf(record.inputs.front().exemplars[map].target)},
              {"extents", mixed.extents()},
              {"paths", std::move(shown)}};
}

} // namespace lichen
