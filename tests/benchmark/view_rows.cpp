// SPDX-License-Identifier: MIT
// Views from one texel to 100 tiles per pixel, and a camera that moves over a floor, against
// supersampling: contrast, mean colour, features and shimmer. Covers tiling and textons, on texture
// coordinates and triplanar.
#include "exemplars.h"
#include "rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filtered_views.h>

namespace lichen::bench {
namespace {

constexpr int kExemplarSide = 256;
/// A pixel has twice the square of this many points. A standard deviation of 0.2 is accurate to
/// 0.01 in each.
constexpr int kSamples = 8;

/// Per view: ratios of deviations are accurate to 2 %.
constexpr int kPixels = 1000;

struct Kind {
  const char* name;
  Method method;
  Mapping mapping;
  bool nearestTableLevel = false;
};
constexpr std::array<Kind, 5> kKinds{
    {{"tiling", Method::tiling, Mapping::uv, {}},
     {"tiling, nearest table level", Method::tiling, Mapping::uv, true},
     {"tiling in three planes", Method::tiling, Mapping::triplanar, {}},
     {"textons", Method::texton, Mapping::uv, {}},
     {"textons in three planes", Method::texton, Mapping::triplanar, {}}}};

/// Pixel sizes in texels, and the ratio of length to width.
struct Size {
  double texels, slant;
  double contrastTarget; ///< 0 if an average has too little contrast for a ratio
};
/// The targets are this project's own.
constexpr std::array<Size, 10> kSizes{{{0.125, 1, 0.1},
                                       {1, 1, 0.1},
                                       {2, 1, 0.1},
                                       {4, 1, 0.1},
                                       {8, 1, 0.1},
                                       {16, 1, 0.1},
                                       {1, 4, 0.1},
                                       {4, 4, 0.1},
                                       {kExemplarSide, 1, 0},
                                       {100 * kExemplarSide, 1, 0}}};

struct ViewMeasures {
  std::array<std::vector<double>, kSizes.size()> contrast, difference, mean;
  std::array<std::vector<double>, kSizes.size()> meanBeyond; ///< less two standard errors
  std::vector<double> steps, variance, points;
  std::vector<double> alignedContrast, alignedMean; ///< of tiling with texture coordinates
};

/// Mean and deviation of light, over all channels.
struct Spread {
  void add(std::size_t c, double light) {
    sum[c] += light;
    squares += light * light;
    count += c == 0 ? 1 : 0;
  }
  [[nodiscard]] double mean(std::size_t c) const { return sum[c] / count; }
  [[nodiscard]] double deviation() const {
    double variance = squares / count;
    for (std::size_t c = 0; c < 3; ++c)
      variance -= mean(c) * mean(c);
    return std::sqrt(variance);
  }
  std::array<double, 3> sum{};
  double squares = 0.0, count = 0.0;
};

/// One texel a pixel, at the texels' centres, where every fetch is a texel: the noise has the
/// exemplar's own colours.
void measureAligned(const test::Plane& plane, const SrgbImage& exemplar, ViewMeasures& all) {
  constexpr int kPoints = 1 << 16;
  constexpr std::uint32_t kTexels = 32 * kExemplarSide; // a side, of the field of pixels
  Spread seen, wanted;
  TileFootprint pixel;
  pixel.dx[0] = pixel.dy[1] = 1.0f / kExemplarSide;
  for (std::uint32_t k = 0; k < kPoints; ++k) {
    const auto random = pcg3d({k, 29u, 5u});
    for (std::size_t axis = 0; axis < 2; ++axis)
      pixel.position[axis] = (float(random[axis] % kTexels) + 0.5f) / kExemplarSide;
    const test::Light light = plane(pixel);
    for (std::size_t c = 0; c < 3; ++c)
      seen.add(c, light[c]);
  }
  const LinearImage image = toLinear(exemplar);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        wanted.add(c, double(image.pixel(x, y)[c]));
  double meanError = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
    meanError = std::max(meanError, std::abs(seen.mean(c) - wanted.mean(c)));
  all.alignedMean.push_back(meanError);
  all.alignedContrast.push_back(std::abs(seen.deviation() / wanted.deviation() - 1.0));
}

void measure(const test::Plane& plane, ViewMeasures& all) {
  for (std::size_t k = 0; k < kSizes.size(); ++k) {
    const double side = kSizes[k].texels / kExemplarSide;
    const test::FilteredView view =
        test::filteredView(plane, side, kSizes[k].slant * side, kPixels, kSamples);
    all.contrast[k].push_back(view.contrast() - 1.0);
    all.difference[k].push_back(view.difference());
    all.mean[k].push_back(view.meanError);
    all.meanBeyond[k].push_back(
        std::max(0.0, view.meanError - 2.0 * view.standardError(view.difference(), kPixels)));
  }
  const test::CameraMove move = test::cameraMove(plane, kSamples / 2);
  all.steps.push_back(move.filteredStep / move.sampledStep);
  all.variance.push_back(move.filteredVariance / move.sampledVariance);
  all.points.push_back(move.pointStep / move.sampledStep);
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

double smallest(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}

std::vector<Row> rowsOf(const Kind& kind, const ViewMeasures& all) {
  constexpr double kMeanTarget = 0.004; // TARGETS.md
  std::vector<Row> rows;
  for (std::size_t k = 0; k < kSizes.size(); ++k) {
    const Size& size = kSizes[k];
    const std::string pixel = fmt::format("{}, pixels of {} x {} texels", kind.name, size.texels,
                                          size.slant * size.texels);
    if (size.contrastTarget == 0.0) {
      rows.push_back({pixel + ": mean colour off by, worst exemplar", largest(all.mean[k]),
                      kMeanTarget, "", fmt::format("median {:.4f}", median(all.mean[k]))});
      continue;
    }
    std::vector<double> off = all.contrast[k];
    for (double& value : off)
      value = std::abs(value);
    rows.push_back(
        {pixel + ": contrast off by, median", 100.0 * median(off), 100.0 * size.contrastTarget, "%",
         fmt::format(
             "from {:+.0f} to {:+.0f} %; difference {:.2f} of the deviation; mean colour off by "
             "{:.4f} at most",
             100.0 * smallest(all.contrast[k]), 100.0 * largest(all.contrast[k]),
             median(all.difference[k]), largest(all.mean[k]))});
    rows.push_back({pixel + ": mean colour off by, less two standard errors, worst exemplar",
                    largest(all.meanBeyond[k]), kMeanTarget, "", ""});
  }
  constexpr double kStepTarget = 1.2;
  rows.push_back(
      {fmt::format("{}: shimmer over supersampled frames', median", kind.name), median(all.steps),
       kStepTarget, "",
       fmt::format("squared steps of 60 frames; worst {:.2f}; unfiltered {:.1f}; variance over the "
                   "frames {:.2f}",
                   largest(all.steps), median(all.points), median(all.variance))});
  if (!all.alignedMean.empty()) {
    rows.push_back({fmt::format("{}, aligned, 1 texel a pixel: contrast off by, median", kind.name),
                    100.0 * median(all.alignedContrast), 3.0, "%",
                    fmt::format("worst {:.1f} %", 100.0 * largest(all.alignedContrast))});
    rows.push_back({"the same: mean colour off by, worst exemplar", largest(all.alignedMean),
                    kMeanTarget, "", fmt::format("median {:.4f}", median(all.alignedMean))});
  }
  return rows;
}

} // namespace

std::vector<Row> viewRows() {
  std::array<ViewMeasures, kKinds.size()> all;
  for (const Exemplar& exemplar : exemplars256()) {
    const Bundle tiling = bakedBundle(exemplar.image), texton = textonBundle(exemplar.image);
    for (std::size_t k = 0; k < kKinds.size(); ++k) {
      const Kind& kind = kKinds[k];
      const Bundle& bundle = kind.method == Method::tiling ? tiling : texton;
      const test::Plane plane = test::noisePlane(bundle, kind.mapping, {}, kind.nearestTableLevel);
      measure(plane, all[k]);
      if (kind.method == Method::tiling && kind.mapping == Mapping::uv)
        measureAligned(plane, exemplar.image, all[k]);
    }
  }
  std::vector<Row> rows;
  for (std::size_t k = 0; k < kKinds.size(); ++k)
    for (Row& row : rowsOf(kKinds[k], all[k]))
      rows.push_back(std::move(row));
  return rows;
}

} // namespace lichen::bench
