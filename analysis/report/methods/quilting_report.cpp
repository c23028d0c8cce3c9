// SPDX-License-Identifier: MIT
// A quilting noise and its exemplar -> measures, and pictures of the cells, of the offsets and of
// what tiles at them agree on.
#include "../method_report.h"
#include "exemplar/value_encoding.h"
#include "sampling/texels.h"
#include "suitability/risk_of.h"

#include <lichen/quilting.h>
#include <lichen/regularity.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

/// The mean of the exemplar moved by each of `offsets` [tiles], decoded.
LinearImage meanOver(const Table& table, std::span<const std::array<double, 2>> offsets,
                     const NoiseMap& map, const Extents& extents) {
  const RepeatingImage exemplar(table);
  const auto level = float(std::max(0.0, std::log2(double(table.width) / extents[0])));
  LinearImage mean(extents[0], extents[1], int(map.channels.size()));
  for (int y = 0; y < mean.height; ++y)
    for (int x = 0; x < mean.width; ++x)
      for (const std::array<double, 2>& offset : offsets) {
        const RepeatingImage::Value texel =
            exemplar.at(float((x + 0.5) / mean.width + offset[0]),
                        float((y + 0.5) / mean.height + offset[1]), level);
        for (std::size_t c = 0; c < map.channels.size(); ++c)
          mean.pixel(x, y)[c] += exemplar::decoded(texel[c], map.encoding) / float(offsets.size());
      }
  return mean;
}

/// Marks a point [tiles] of a picture: white in a black frame, which show on any colour.
void mark(SrgbImage& image, const std::array<double, 2>& point) {
  constexpr int kDot = 2, kFrame = 3; // half a side [pixels]
  const auto wrapped = [](double at, int side) {
    return ((int(std::lround(at)) % side) + side) % side;
  };
  for (int down = -kFrame; down <= kFrame; ++down)
    for (int across = -kFrame; across <= kFrame; ++across)
      std::fill_n(image.pixel(wrapped(point[0] * image.width + across, image.width),
                              wrapped(point[1] * image.height + down, image.height)),
                  image.channels, std::max(std::abs(down), std::abs(across)) <= kDot ? 1.0f : 0.0f);
}

Result<std::vector<Risk>> assess(const AssessedMap& assessed, const Progress&) {
  constexpr double kNone = 0.0, kMild = 0.5;
  double score = kNone;
  std::string reason = "the first map tells whether the exemplar repeats";
  if (assessed.place == 0 &&
      std::min(assessed.map().width, assessed.map().height) < kLeastRegularSide) {
    reason = "the exemplar is too small to show whether it repeats";
  } else if (assessed.place == 0) {
    const Result<Regularity> regularity =
        regularityOf(assessed.maps, assessed.bordersFit ? Periodic::yes : Periodic::no);
    if (!regularity)
      return regularity.error();
    const bool isClear = regularity.value().isClear();
    score = isClear ? kNone : kMild;
    reason = isClear ? "the exemplar repeats or has clear outlines"
                     : "the exemplar neither repeats nor has clear outlines";
  }
  return std::vector<Risk>{
      suitability::riskOf("cuts", score, reason, "and its noise looks cut into pieces",
                          {{{"method", std::string(nameOf(Method::tiling))}}, {}})};
}

Result<void> measure(const ComparedResult& result, NoiseComparison& comparison) {
  Result<std::vector<Measure>> measures = measureResult(comparison.exemplar, comparison.result);
  if (!measures)
    return measures.error();
  comparison.measures = std::move(measures).value();
  const Noise& noise = result.bundle.noises[result.options.material.noise];
  const Result<std::optional<double>> mismatch = cutMismatch(result.bundle, noise, result.map);
  if (!mismatch)
    return mismatch.error();
  comparison.measures.push_back({kCutMismatchName, "", "how different tiles are where they are cut",
                                 mismatch.value(), kCutMismatchTarget,
                                 mismatch.value() ? "" : "the exemplar has no outlines"});
  return {};
}

Result<std::vector<Picture>> pictures(const DrawnMap& drawn) {
  const NoiseMap& map = drawn.map;
  const auto& shared = drawn.noise.as<QuiltingNoise>();
  std::vector<Result<Picture>> made;
  made.push_back(encodedPicture(
      twoAsRedGreen(levelPicture(drawn.bundle.tables[map.as<QuiltingMap>().cells], 2, drawn.side)),
      "Cells",
      ". The vector from each texel to the centre of its cell: red to the right, green down. Tiles "
      "are cut along the outlines of cells."));
  if (!shared.offsets.empty()) {
    const Table& table = drawn.bundle.tables[map.as<QuiltingMap>().image];
    const Extents extents = pictureExtents(int(table.width), int(table.height), drawn.side);
    constexpr std::array<std::array<double, 2>, 1> kUnmoved{};
    SrgbImage marked = drawn.look.picture(meanOver(table, kUnmoved, map, extents));
    for (const std::array<double, 2>& offset : shared.offsets)
      mark(marked, offset);
    made.push_back(encodedPicture(
        marked, "Offsets",
        fmt::format(". Each tile is the exemplar moved by one of {} offsets, at which it nearly "
                    "repeats. It shows one of the marked points where an unmoved tile shows the "
                    "upper left corner.",
                    shared.offsets.size())));
    made.push_back(encodedPicture(
        drawn.look.picture(meanOver(table, shared.offsets, map, extents)), "Mean over the offsets",
        fmt::format(
            ". What tiles at these offsets agree on. The clearer it is, the better tiles fit "
            "together; they correlate by {:.2f}.",
            shared.correlation)));
  }
  return allOf(std::move(made));
}

} // namespace

/// The pictures: the exemplar, twice, the exemplar before flattening, a result of 2 x 2 exemplars,
/// the cells, the offsets and the mean over them.
extern const MethodReport kQuiltingReport{
    .assess = assess, .measure = measure, .pictures = pictures, .picturePixels = 10.0};

} // namespace lichen
