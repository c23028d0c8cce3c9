// SPDX-License-Identifier: MIT
// Lit pictures of a set of maps from 1/4 to 64 texels a pixel against supersampling: brightness and
// pixels.
#include "exemplars.h"
#include "rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <lit_views.h>
#include <materials.h>
#include <stdexcept>

namespace lichen::bench {
namespace {

constexpr int kExemplarSide = 256;
constexpr std::uint32_t kMostPixels = 128; // a side
/// Deviation of the slopes along each axis: the worn surface tilts by 11 degrees.
constexpr double kSlopeDeviation = 0.2;
constexpr float kSmoothest = 0.35f, kRoughest = 0.85f; // roughness, from dark to light

/// Widths of a pixel in texels.
constexpr std::array<double, 5> kFootprints{0.25, 1.0, 4.0, 16.0, 64.0};
/// From here on a pixel needs a filter.
constexpr double kLeastFiltered = 4.0;

struct View {
  const char* name;
  test::Viewpoint from;
};
std::array<View, 3> views() {
  return {{{"above", {}},
           {"toward the sun", test::towardSun()},
           {"away from it", test::awayFromSun()}}};
}

/// The generated set with a smoother relief, in rough and smooth parts, without height and metal.
std::vector<MapExemplar> smoothSet() {
  constexpr int kSide = kExemplarSide;
  std::vector<MapExemplar> maps = materialSet(kSide);
  const std::vector<float> height = test::smoothed(maps.back().values, kSide, 1);
  maps.pop_back();
  const auto heightAt = [&](int x, int y) {
    return height[std::size_t((y + kSide) % kSide * kSide + (x + kSide) % kSide)];
  };
  const auto [lowest, highest] = std::minmax_element(height.begin(), height.end());
  MapExemplar &normal = maps[1], &orm = maps[2];
  normal.values.clear();
  orm.values.clear();
  orm.channels = {MapChannel::roughness};
  double squares = 0.0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const float right = heightAt(x + 1, y) - heightAt(x - 1, y);
      const float up = heightAt(x, y - 1) - heightAt(x, y + 1);
      normal.values.insert(normal.values.end(), {right, up});
      squares += double(right) * double(right) + double(up) * double(up);
      orm.values.push_back(kSmoothest + (kRoughest - kSmoothest) * (heightAt(x, y) - *lowest) /
                                            (*highest - *lowest));
    }
  const double deviation = std::sqrt(squares / double(normal.values.size()));
  for (float& slope : normal.values)
    slope *= float(kSlopeDeviation / deviation);
  return maps;
}

BundleFile fileOf(Bundle bundle) {
  BundleFile file;
  file.bundle = std::move(bundle);
  file.bundle.materials = {MaterialNoise{}};
  file.bundle.materialNames = {"benchmark"};
  file.previews.emplace_back();
  file.shape = PreviewShape::none;
  file.generator = "lichen-bench";
  return file;
}

/// A row for each footprint and one for the pixels.
void appendRows(std::vector<Row>& rows, const std::string& what, test::LitPlane plane) {
  // Two steps of an 8-bit sRGB picture at a medium grey, where one is 1.7 % of the light: less does
  // not show as a band between near and far.
  constexpr double kMeanTarget = 3.0;
  // A pixel should be no farther from its average than a sample that is not filtered at all.
  constexpr double kPixelTarget = 1.0;
  double worstPixels = 0.0;
  std::string worstWhere;
  for (const double texels : kFootprints) {
    double worst = 0.0;
    std::string note;
    for (const View& view : views()) {
      const test::LitError error = plane.seen(texels, view.from, kMostPixels);
      worst = std::max(worst, 100.0 * std::abs(error.meanError));
      note += fmt::format("{}{} {:+.1f} %, pixels {:.2f} of {:.2f}", note.empty() ? "" : "; ",
                          view.name, 100.0 * error.meanError, error.pixelError, error.aliasing);
      const double pixels = error.pixelError / error.aliasing;
      if (texels >= kLeastFiltered && pixels > worstPixels) {
        worstPixels = pixels;
        worstWhere = fmt::format("{}, {:g} texels a pixel", view.name, texels);
      }
    }
    rows.push_back(
        {fmt::format("{}, {:g} texels a pixel: brightness off by, worst view", what, texels), worst,
         kMeanTarget, "%", note});
  }
  rows.push_back(
      {fmt::format("{}, from {:g} texels a pixel on: pixels off by, over samples without "
                   "a filter, worst view",
                   what, kLeastFiltered),
       worstPixels, kPixelTarget, "", worstWhere});
}

std::vector<Row> measure() {
  Result<std::unique_ptr<VulkanDevice>> device = VulkanDevice::create({});
  if (!device)
    throw std::runtime_error(device.error().message);
  VulkanDevice& gpu = *device.value();
  const std::vector<MapExemplar> maps = smoothSet();
  const BundleFile tiling = fileOf(bakedBundle(maps));
  std::vector<Row> rows;
  constexpr double kRoughness = 0.5; // about the mean of the map
  const BundleFile slopes = fileOf(bakedBundle(std::span(maps).subspan(1, 1)));
  appendRows(rows, "slopes alone, not metal", {gpu, slopes, kExemplarSide, kRoughness, 0.0});
  appendRows(rows, "not metal", {gpu, tiling, kExemplarSide, 1.0, 0.0});
  appendRows(rows, "metal", {gpu, tiling, kExemplarSide, 1.0, 1.0});
  return rows;
}

} // namespace

std::vector<Row> litRows() {
  try {
    return measure();
  } catch (const std::exception& problem) {
    return {
        {"brightness of lit pictures against supersampling", 0.0, 3.0, "%", problem.what(), true}};
  }
}

} // namespace lichen::bench
