// SPDX-License-Identifier: MIT
// Map (height, width, channels) -> labels (height, width): clusters of smoothed colours, then the
// majority of each pixel's surroundings.
#include "color_clusters.h"
#include "exemplar/planes.h"
#include "exemplar/value_encoding.h"
#include "label_means.h"

#include <lichen/layers.h>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lichen {
namespace {

using namespace layers;

/// The radius of the squares over which colours and labels are averaged [pixels].
int smoothingRadius(int width, int height) {
  constexpr int kSideOverRadius = 256; // regions are then at least about 2 % of the side wide
  return std::max(1, (width + height) / 2 / kSideOverRadius);
}

/// How much differences of hue and chroma count, for one of lightness. Shadows and relief change
/// the lightness of one material: by 1 the labels of photographs follow shadows, by 3 the
/// materials.
constexpr float kChroma = 3.0f;

/// The map's colours in OKLab with scaled chroma, each averaged over its surroundings.
std::vector<Lab> smoothedColors(const MapExemplar& map) {
  std::vector<Lab> colors = oklabOf(map);
  const int radius = smoothingRadius(map.width, map.height);
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<float> plane;
    plane.reserve(colors.size());
    for (const Lab& color : colors)
      plane.push_back(color[c]);
    // Twice: a square alone has corners.
    for (int pass = 0; pass < 2; ++pass)
      plane = exemplar::boxMean(plane, map.width, map.height, radius);
    for (std::size_t i = 0; i < colors.size(); ++i)
      colors[i][c] = (c == 0 ? 1.0f : kChroma) * plane[i];
  }
  return colors;
}

/// Gives each pixel the label that most pixels around it have.
void takeMajority(LabelImage& labels) {
  // Twice the radius of the colours: specks are no regions.
  const int radius = 2 * smoothingRadius(labels.width, labels.height);
  std::vector<float> most(labels.labels.size(), 0.0f);
  std::vector<std::uint8_t> majority(labels.labels.size());
  for (int label = 0; label < labels.count; ++label) {
    std::vector<float> share(labels.labels.size());
    for (std::size_t i = 0; i < share.size(); ++i)
      share[i] = labels.labels[i] == label ? 1.0f : 0.0f;
    for (int pass = 0; pass < 2; ++pass)
      share = exemplar::boxMean(share, labels.width, labels.height, radius);
    for (std::size_t i = 0; i < share.size(); ++i)
      if (share[i] > most[i]) {
        most[i] = share[i];
        majority[i] = std::uint8_t(label);
      }
  }
  labels.labels = std::move(majority);
}

/// Colours of pixels at equal distances.
std::vector<Lab> sampled(const std::vector<Lab>& colors, int width) {
  constexpr std::size_t kSamples = 1 << 14;
  std::size_t step = std::max<std::size_t>(1, colors.size() / kSamples);
  if (std::size_t(width) % step == 0) // else all samples would be of few columns
    ++step;
  std::vector<Lab> samples;
  for (std::size_t i = 0; i < colors.size(); i += step)
    samples.push_back(colors[i]);
  return samples;
}

Result<LabelImage> clustersOf(const MapExemplar& map, int count) {
  if (Result<void> checked = exemplar::checkRanges(map); !checked)
    return checked.error();
  if (count < kFewestLabels || count > kMostLabels)
    return Error{ErrorKind::usage, std::to_string(count) + " labels; expected 2 to 4"};
  const std::vector<Lab> colors = smoothedColors(map);
  const std::vector<Lab> centers = clusterCenters(sampled(colors, map.width), std::size_t(count));
  if (centers.size() < std::size_t(count))
    return Error{ErrorKind::badInput, "the exemplar has " + std::to_string(centers.size()) +
                                          (centers.size() == 1 ? " colour" : " colours") +
                                          "; expected at least " + std::to_string(count) +
                                          " for as many labels"};
  LabelImage labels{map.width, map.height, count, std::vector<std::uint8_t>(colors.size())};
  tbb::parallel_for(std::size_t(0), colors.size(), [&](std::size_t i) {
    labels.labels[i] = std::uint8_t(nearestOf(centers, colors[i]));
  });
  takeMajority(labels);
  for (int label = 0; label < count; ++label) {
    const auto pixels = std::count(labels.labels.begin(), labels.labels.end(), label);
    if (const double share = double(pixels) / double(colors.size()); share < kLeastLabelShare)
      return Error{ErrorKind::badInput,
                   fmt::format("one of {} colours covers {:.1f} % of the exemplar; expected at "
                               "least 1 %: use fewer labels, or paint them",
                               count, 100.0 * share)};
  }
  return labels;
}

/// How many of `positions`, on an axis where the two means are at 0 and 1, lie near `center`.
double near(const std::vector<float>& positions, float center) {
  constexpr float kHalfWidth = 0.1f;
  return double(std::count_if(positions.begin(), positions.end(), [&](float position) {
    return std::abs(position - center) < kHalfWidth;
  }));
}

} // namespace

Result<LabelImage> clusterLabels(const MapExemplar& baseColor, int count) {
  return withinMemory([] { return std::string("not enough memory to find labels by colour"); },
                      [&] { return clustersOf(baseColor, count); });
}

double labelSeparation(const MapExemplar& baseColor, const LabelImage& labels) {
  const std::vector<Lab> colors = smoothedColors(baseColor);
  const LabelImage ofPixel = resizedLabels(labels, baseColor.width, baseColor.height);
  const std::vector<LabelMean> means = labelMeans(colors, ofPixel);
  double least = 1.0;
  for (int a = 0; a < labels.count; ++a)
    for (int b = a + 1; b < labels.count; ++b) {
      const Lab &from = means[std::size_t(a)].color, &to = means[std::size_t(b)].color;
      const float square = squaredDistance(from, to);
      if (square == 0.0f)
        return 0.0;
      std::vector<float> positions;
      for (std::size_t i = 0; i < colors.size(); ++i)
        if (ofPixel.labels[i] == a || ofPixel.labels[i] == b) {
          float product = 0.0f;
          for (std::size_t c = 0; c < 3; ++c)
            product += (colors[i][c] - from[c]) * (to[c] - from[c]);
          positions.push_back(product / square);
        }
      const double rarer = std::min(near(positions, 0.0f), near(positions, 1.0f));
      least = std::min(least, 1.0 - near(positions, 0.5f) / std::max(1.0, rarer));
    }
  return std::max(0.0, least);
}

} // namespace lichen
