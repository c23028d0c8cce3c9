// SPDX-License-Identifier: MIT
#include "filtered_views.h"

#include <lichen/lattice.h>
#include <lichen/noise_evaluator.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace lichen::test {
namespace {

Light lightOf(const std::array<float, 4>& value) {
  return {double(value[0]), double(value[1]), double(value[2])};
}

/// A point of a plane through the origin that is oblique to x, y and z.
TriplanarFootprint askew(const TileFootprint& at, float tileMetres) {
  using Vec3 = std::array<float, 3>;
  // Unit vectors at right angles. With their normal, all three planes have weight.
  constexpr Vec3 kAlong{2.0f / 11.0f, -9.0f / 11.0f, 6.0f / 11.0f};
  constexpr Vec3 kAcross{9.0f / 11.0f, -2.0f / 11.0f, -6.0f / 11.0f};
  constexpr Vec3 kNormal{6.0f / 11.0f, 6.0f / 11.0f, 7.0f / 11.0f};
  const auto inSpace = [&](const std::array<float, 2>& v) {
    Vec3 result{};
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = tileMetres * (v[0] * kAlong[k] + v[1] * kAcross[k]);
    return result;
  };
  return {inSpace(at.position), inSpace(at.dx), inSpace(at.dy), kNormal};
}

/// Two averages over disjoint sets of points in a pixel, so that their errors are independent.
struct Sampled {
  Light filtered, first, second;
};

Light averaged(const Plane& plane, const TileFootprint& pixel, int samples, std::uint32_t seed) {
  Light sum{};
  for (int y = 0; y < samples; ++y)
    for (int x = 0; x < samples; ++x) {
      const auto random = pcg3d({std::uint32_t(x), std::uint32_t(y), seed});
      const float u = (float(x) + float(random[0] >> 8u) * 0x1p-24f) / float(samples) - 0.5f;
      const float v = (float(y) + float(random[1] >> 8u) * 0x1p-24f) / float(samples) - 0.5f;
      TileFootprint point;
      for (std::size_t k = 0; k < 2; ++k)
        point.position[k] = pixel.position[k] + u * pixel.dx[k] + v * pixel.dy[k];
      const Light light = plane(point);
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += light[c] / (samples * samples);
    }
  return sum;
}

Sampled sampled(const Plane& plane, const TileFootprint& pixel, int samples, std::uint32_t seed) {
  return {plane(pixel), averaged(plane, pixel, samples, 2 * seed),
          averaged(plane, pixel, samples, 2 * seed + 1)};
}

/// Accumulates the statistics of one channel over pixels.
struct Moments {
  void add(double filtered, double first, double second) {
    const double mean = 0.5 * (first + second);
    f += filtered, a += first, b += second;
    ff += filtered * filtered, ab += first * second, fm += filtered * mean;
    noise += 0.25 * (first - second) * (first - second);
    ++count;
  }
  [[nodiscard]] double filteredVariance() const { return ff / count - (f / count) * (f / count); }
  [[nodiscard]] double sampledVariance() const { return ab / count - (a / count) * (b / count); }
  /// The standard error of the sampled mean about the mean of the same pixels.
  [[nodiscard]] double standardError() const { return std::sqrt(noise) / count; }
  [[nodiscard]] double meanError() const { return (f - 0.5 * (a + b)) / count; }
  [[nodiscard]] double squaredDifference() const { return (ff - 2.0 * fm + ab) / count; }

  double f = 0, a = 0, b = 0, ff = 0, ab = 0, fm = 0, noise = 0, count = 0;
};

} // namespace

double FilteredView::contrast() const { return std::sqrt(filteredVariance / sampledVariance); }
double FilteredView::difference() const {
  return std::sqrt(std::max(0.0, squaredDifference) / sampledVariance);
}
double FilteredView::standardError(double difference, int pixels) const {
  const double ofChannel = std::max(0.0, sampledVariance) / 3.0;
  return std::sqrt(scatter * scatter + difference * difference * ofChannel / pixels);
}
double FilteredView::meanTolerance(double difference, int pixels) const {
  return 0.004 + 3.0 * standardError(difference, pixels);
}

Plane noisePlane(const Bundle& bundle, Mapping mapping, const Placement& placement,
                 bool nearestTableLevel, double contrast) {
  MaterialNoise material;
  material.contrast = contrast;
  material.mapping = mapping;
  const std::shared_ptr<const NoiseEvaluator> noise =
      NoiseEvaluator::create(bundle, material, placement, {nearestTableLevel}).value();
  const auto metres = float(bundle.noises[0].tileSizeMetres);
  return [=](const TileFootprint& at) {
    return lightOf(mapping == Mapping::triplanar ? noise->evaluate(0, askew(at, metres))
                                                 : noise->evaluate(0, at));
  };
}

FilteredView filteredView(const Plane& plane, double width, double height, int pixels,
                          int samples) {
  // Spread over enough tiles that pixels are nearly independent, and few enough that floats resolve
  // a thousandth of a texel out of 256.
  constexpr double kLeastSide = 32.0;
  const double side = std::max(kLeastSide, 2.0 * std::max(width, height));
  std::vector<Sampled> all(static_cast<std::size_t>(pixels));
  tbb::parallel_for(0, pixels, [&](int k) {
    const auto random = pcg3d({std::uint32_t(k), 17u, 3u});
    TileFootprint pixel;
    pixel.position = {float((double(random[0]) * 0x1p-32 - 0.5) * side),
                      float((double(random[1]) * 0x1p-32 - 0.5) * side)};
    pixel.dx = {float(width), 0.0f};
    pixel.dy = {0.0f, float(height)};
    all[std::size_t(k)] = sampled(plane, pixel, samples, std::uint32_t(k));
  });
  FilteredView view;
  for (std::size_t c = 0; c < 3; ++c) {
    Moments moments;
    for (const Sampled& one : all)
      moments.add(one.filtered[c], one.first[c], one.second[c]);
    view.meanError = std::max(view.meanError, std::abs(moments.meanError()));
    view.scatter = std::max(view.scatter, moments.standardError());
    view.filteredVariance += moments.filteredVariance();
    view.sampledVariance += moments.sampledVariance();
    view.squaredDifference += moments.squaredDifference();
  }
  return view;
}

CameraMove cameraMove(const Plane& floor, int samples) {
  constexpr int kFrames = 60, kColumns = 96, kRows = 64, kEvery = 6; // pixels
  constexpr double kHeight = 0.5, kFocal = 1.2; // tiles; half the picture's width is 1
  constexpr double kPixel = 2.0 / kColumns;
  constexpr double kFirstRow = 1.0; // below the horizon, the top of the picture: 69 tiles away
  // Per frame: a seventh of a pixel sideways, and in 30 frames the length of the nearest pixel. The
  // ratios have no period.
  constexpr double kSideways = 0.0027, kForwards = 0.0041;
  struct Camera {
    double x, z;
    /// The point of the floor at a position of the picture, in pixels from the middle of its top
    /// edge.
    [[nodiscard]] std::array<double, 2> seen(double column, double row) const {
      const double depth = kFocal * kHeight / (row * kPixel);
      return {x + column * kPixel * depth / kFocal, z + depth};
    }
  };
  struct Place {
    double x, z;
    std::vector<Sampled> frames;
    std::vector<Light> points;
  };
  std::vector<Place> places;
  for (int row = int(kFirstRow); row < kRows; row += kEvery)
    for (int column = kEvery / 2 - kColumns / 2; column < kColumns / 2; column += kEvery) {
      const auto at = Camera{0.0, 0.0}.seen(column + 0.5, row + 0.5);
      places.push_back({at[0], at[1], {}, {}});
    }
  tbb::parallel_for(std::size_t(0), places.size(), [&](std::size_t p) {
    Place& place = places[p];
    for (int frame = 0; frame < kFrames; ++frame) {
      const double t = frame - 0.5 * kFrames;
      const Camera camera{kSideways * t, kForwards * t};
      const double row = kFocal * kHeight / ((place.z - camera.z) * kPixel);
      const double column = (place.x - camera.x) * kFocal / ((place.z - camera.z) * kPixel);
      const double middleX = std::floor(column) + 0.5, middleY = std::floor(row) + 0.5;
      const auto at = camera.seen(middleX, middleY);
      TileFootprint pixel, point;
      point.position = pixel.position = {float(at[0]), float(at[1])};
      // The derivatives at the centre of the pixel.
      const double depth = kFocal * kHeight / (middleY * kPixel);
      pixel.dx = {float(kPixel * depth / kFocal), 0.0f};
      pixel.dy = {float(-middleX * kPixel * depth / (kFocal * middleY)), float(-depth / middleY)};
      const auto seed = std::uint32_t(p * kFrames + std::size_t(frame));
      place.frames.push_back(sampled(floor, pixel, samples, seed));
      place.points.push_back(floor(point));
    }
  });
  CameraMove move;
  for (const Place& place : places)
    for (std::size_t c = 0; c < 3; ++c) {
      Moments over, steps;
      for (std::size_t k = 0; k < place.frames.size(); ++k) {
        const Sampled& now = place.frames[k];
        over.add(now.filtered[c], now.first[c], now.second[c]);
        if (k == 0)
          continue;
        const Sampled& before = place.frames[k - 1];
        steps.add(now.filtered[c] - before.filtered[c], now.first[c] - before.first[c],
                  now.second[c] - before.second[c]);
        const double pointStep = place.points[k][c] - place.points[k - 1][c];
        move.pointStep += pointStep * pointStep;
      }
      move.filteredVariance += over.filteredVariance();
      move.sampledVariance += over.sampledVariance();
      move.filteredStep += steps.ff;
      move.sampledStep += steps.ab;
    }
  return move;
}

} // namespace lichen::test
