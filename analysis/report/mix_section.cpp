// SPDX-License-Identifier: MIT
// Bundle of a mix and its inputs -> the section that shows the steps between them.
#include "mix_section.h"

#include "charts.h"
#include "exemplar/resample.h"
#include "markup.h"
#include "method_report.h"
#include "pictures.h"

#include <lichen/map_picture.h>
#include <lichen/synthesize.h>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <functional>
#include <numeric>
#include <optional>

namespace lichen {
namespace {

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

/// A pane's markup, and pixels at the noise's scale for its spectrum.
struct Pane {
  std::string markup;
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

  /// `width`: as a share of the page's.
  [[nodiscard]] Result<Pane> pane(const Place& place, double width,
                                  const Progress& progress) const {
    return isStep(place) ? step(place, width, progress) : exemplar(place, width);
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
  [[nodiscard]] Result<Pane> exemplar(const Place& place, double width) const {
    const std::size_t input = *place.input;
    MapExemplar map = exemplarOf(input);
    if (map.width != width_)
      map = exemplar::resampled(map, width_, std::max(1, map.height * width_ / map.width), false);
    SrgbImage pixels = look_.picture(map);
    const int height = std::clamp(map.height * extents_[0] / width_, 1, extents_[1]);
    const Result<Picture> picture =
        encodedPicture(reduced(pixels, extents_[0], height), record_.inputs[input].name);
    if (!picture)
      return picture.error();
    std::string share;
    if (const std::span<const double> weights = record_.mix->weights; !weights.empty())
      share =
          fmt::format(", {} %", shownNumber(100.0 * weights[input] /
                                            std::accumulate(weights.begin(), weights.end(), 0.0)));
    return Pane{paneMarkup(imageMarkup(picture.value(), {.small = width}),
                           captionOf(place, "exemplar", picture.value().title, share)),
                std::move(pixels)};
  }

  [[nodiscard]] Result<Pane> step(const Place& place, double width,
                                  const Progress& progress) const {
    const std::size_t last = record_.mix->modelErrors.size() - 1;
    const double weight = last > 0 ? double(place.step) / double(last) : 0.0;
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
    const Result<Picture> picture =
        encodedPicture(look_.picture(small.value()),
                       place.along ? fmt::format("Step {}", place.step + 1) : "The mix");
    const Result<std::vector<Picture>> kernel =
        reportOf(noise_.method())
            .pictures({record_.bundle, noise_, noiseMap_, look_, weight, side_});
    if (!picture)
      return picture.error();
    if (!kernel)
      return kernel.error();
    const std::string numbers =
        fmt::format("{}, model error {}", place.along ? ", weight " + shownNumber(weight) : "",
                    shownNumber(record_.mix->modelErrors[place.step]));
    return Pane{
        paneMarkup(imageMarkup(picture.value(), {.small = width}) +
                       imageMarkup(kernel.value().front(), {.small = width / 2, .large = 0.5}),
                   captionOf(place, "result", picture.value().title, numbers)),
        look_.picture(noise.value())};
  }

  /// The key of the pane's curve, its name, and what else stands below it.
  [[nodiscard]] static std::string captionOf(const Place& place, std::string_view kind,
                                             std::string_view name, std::string_view rest) {
    return fmt::format("<i {}></i> {}{}", lookAlong("key " + std::string(kind), place.along),
                       element("b", htmlText(name)), rest);
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

/// The panes of a path, and their spectra.
Result<std::string> describePath(const MixedMap& map, const BakeRecord& record, const Path& path,
                                 const Progress& progress) {
  std::string panes;
  std::vector<SrgbImage> images;
  const auto steps = double(std::count_if(path.begin(), path.end(), isStep));
  double done = 0.0; // steps take nearly all of the time
  for (const Place& place : path) {
    const double next = done + (isStep(place) ? 1.0 : 0.0);
    Result<Pane> pane =
        map.pane(place, 1.0 / double(path.size()), partOf(progress, done / steps, next / steps));
    if (!pane)
      return pane.error();
    done = next;
    panes += pane.value().markup;
    images.push_back(std::move(pane.value().pixels));
  }
  std::string section = element("div class=\"panes\"", panes);
  int crop = spectrumCrop(images.front(), images.back());
  for (const SrgbImage& image : images)
    crop = std::min(crop, spectrumCrop(image, image));
  if (crop == 0)
    return section;
  std::vector<SpectrumCurve> curves;
  for (const bool noise : {false, true}) // the inputs' wide lines lie below
    for (std::size_t i = 0; i < path.size(); ++i)
      if (isStep(path[i]) == noise)
        curves.push_back(
            spectrumCurve(noise ? "result" : "exemplar", images[i], crop, path[i].along));
  const auto nameOfInput = [&](std::size_t input) { return htmlText(record.inputs[input].name); };
  const auto inputs = std::ranges::count_if(path, std::not_fn(isStep));
  return section +
         element(
             "p class=\"quiet\"",
             fmt::format("{} <i class=\"ramp\"></i> {}: power spectra of the luminance, averaged "
                         "over directions. Wide lines are the inputs, {}.",
                         nameOfInput(*path.front().input),
                         nameOfInput(*path.front().input + std::size_t(inputs) - 1),
                         path.back().input ? "thin ones the steps" : "the thin one the mix")) +
         spectrumChart(curves, crop);
}

} // namespace

std::size_t mixPictures(const BakeRecord& record) {
  std::size_t pictures = 0;
  for (const Path& path : pathsOf(record))
    for (const Place& place : path)
      pictures += isStep(place) ? 2u : 1u; // the noise and what it fetches from; or the exemplar
  return pictures;
}

Result<std::string> describeMix(const BakeRecord& record, std::size_t map, int side,
                                const Progress& progress) {
  assert(record.mix && record.inputs.size() > 1);
  const MixedMap mixed(record, map, side);
  const std::vector<Path> paths = pathsOf(record);
  const auto count = double(paths.size());
  std::string section =
      element("h2", fmt::format("{}: {}", nameOf(record.inputs.front().exemplars[map].target),
                                record.mix->weights.empty() ? "from input to input"
                                                            : "between the inputs")) +
      element("p class=\"quiet\"",
              "The inputs and the noise between them, all at one scale. Below the noise is the "
              "image that the shader adds up at random points, enlarged; grey is zero. "
              "Model error: how far the spectra of the noise are from those of the texture that it "
              "should show, as a share of the deviation.");
  double done = 0.0;
  for (const Path& path : paths) {
    const Result<std::string> described =
        describePath(mixed, record, path, partOf(progress, done / count, (done + 1.0) / count));
    if (!described)
      return described;
    section += described.value();
    ++done;
  }
  return element("article", section) + "\n";
}

} // namespace lichen
