// SPDX-License-Identifier: MIT
// Labels of pixels from painted pictures and from colours, and exemplars of one label.
#include "random_field.h"

#include <lichen/layers.h>
#include <lichen/spectrum.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <exemplar/color_space.h>
#include <random>

using namespace lichen;

namespace {

constexpr int kSide = 256;
constexpr std::size_t kPixels = std::size_t(kSide) * kSide;

using Color = std::array<float, 3>;

/// Blobs of some 40 pixels; label k lies between the cuts k - 1 and k.
LabelImage blobs(const std::vector<float>& cuts, std::uint32_t seed) {
  LabelImage labels{kSide, kSide, int(cuts.size()) + 1, {}};
  for (const float value : test::randomField(kSide, test::bellPower(4.0), seed))
    labels.labels.push_back(std::uint8_t(
        std::count_if(cuts.begin(), cuts.end(), [&](float cut) { return value > cut; })));
  return labels;
}

/// A grain of colours that correlate, about this mean.
std::vector<float> grain(const Color& mean, double cycles, std::uint32_t seed) {
  const std::vector<float> light = test::randomField(kSide, test::bellPower(cycles), seed),
                           hue = test::randomField(kSide, test::bellPower(cycles), seed + 1);
  std::vector<float> values;
  for (std::size_t i = 0; i < kPixels; ++i) {
    const Color color{mean[0] + 0.06f * light[i] + 0.02f * hue[i], mean[1] + 0.06f * light[i],
                      mean[2] + 0.04f * light[i] - 0.03f * hue[i]};
    values.insert(values.end(), color.begin(), color.end());
  }
  return values;
}

MapExemplar colorMap(std::vector<float> values) {
  return {MapTarget::baseColor,
          {MapChannel::red, MapChannel::green, MapChannel::blue},
          ValueEncoding::srgb,
          kSide,
          kSide,
          std::move(values)};
}

/// The materials of two or three labels, each over the whole tile.
std::vector<std::vector<float>> materials() {
  return {grain({0.25f, 0.35f, 0.2f}, 30.0, 11), grain({0.5f, 0.45f, 0.45f}, 50.0, 21),
          grain({0.75f, 0.55f, 0.35f}, 40.0, 31)};
}

MapExemplar mixed(const LabelImage& labels) {
  const std::vector<std::vector<float>> all = materials();
  std::vector<float> values(3 * kPixels);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = all[labels.labels[i / 3]][i];
  return colorMap(std::move(values));
}

SrgbImage painted(const LabelImage& labels, const std::vector<Color>& colors) {
  SrgbImage picture(labels.width, labels.height, 3);
  for (std::size_t i = 0; i < labels.labels.size(); ++i)
    std::copy_n(colors[labels.labels[i]].data(), 3, &picture.values[3 * i]);
  return picture;
}

double shareOfEqual(const LabelImage& a, const LabelImage& b) {
  double equal = 0.0;
  for (std::size_t i = 0; i < a.labels.size(); ++i)
    equal += a.labels[i] == b.labels[i] ? 1.0 : 0.0;
  return equal / double(a.labels.size());
}

constexpr int kLags = 4;

/// The autocorrelation of green at lags below kLags.
std::vector<double> shortLags(const std::vector<float>& values) {
  std::vector<float> green;
  for (std::size_t i = 1; i < values.size(); i += 3)
    green.push_back(values[i]);
  std::vector<double> lags = autocovariance(green, kSide, kSide, kLags);
  const double variance = lags[lags.size() / 2];
  for (double& lag : lags)
    lag /= variance;
  return lags;
}

bool anyOtherWithin(const LabelImage& labels, int x, int y, int radius) {
  for (int row = std::max(0, y - radius); row <= std::min(kSide - 1, y + radius); ++row)
    for (int column = std::max(0, x - radius); column <= std::min(kSide - 1, x + radius); ++column)
      if (labels.labels[std::size_t(row * kSide + column)] !=
          labels.labels[std::size_t(y * kSide + x)])
        return true;
  return false;
}

} // namespace

TEST_CASE("a painted picture has a label for each colour, by ascending luminance") {
  const LabelImage labels = blobs({-0.5f, 0.3f, 0.9f}, 3);
  // Numbered by their luminance, not by where they come first. Two of them differ by two codes.
  const std::vector<Color> colors{{0.0f, 0.0f, 0.2f},
                                  {0.0f, 0.0f, 0.2f + 2.0f / 255.0f},
                                  {0.9f, 0.1f, 0.1f},
                                  {0.5f, 0.8f, 0.5f}};
  const Result<LabelImage> found = labelsFromPicture(painted(labels, colors), "labels.png");
  REQUIRE(found);
  CHECK(found.value().count == 4);
  CHECK(found.value().labels == labels.labels);
}

TEST_CASE("smooth edges and the noise of a JPEG leave the painted labels") {
  const LabelImage labels = blobs({-0.5f, 0.5f}, 3);
  SrgbImage picture = painted(labels, {{0.1f, 0.1f, 0.1f}, {0.8f, 0.2f, 0.2f}, {0.9f, 0.9f, 0.9f}});
  const SrgbImage sharp = picture;
  std::mt19937 generator(1);
  for (int y = 1; y < kSide - 1; ++y)
    for (int x = 1; x < kSide - 1; ++x)
      for (int c = 0; c < 3; ++c) {
        float sum = 0.0f;
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx)
            sum += sharp.pixel(x + dx, y + dy)[c] / 9.0f;
        // Up to 8 codes either way.
        picture.pixel(x, y)[c] = sum + (float(generator() % 17) - 8.0f) / 255.0f;
      }
  const Result<LabelImage> found = labelsFromPicture(picture, "labels.jpg");
  REQUIRE(found);
  CHECK(found.value().count == 3);
  CHECK(shareOfEqual(found.value(), labels) > 0.97); // blurred edges may move by a pixel
}

TEST_CASE("a picture with one colour or five is refused, and the message counts them") {
  const auto messageOf = [](const SrgbImage& picture) {
    const Result<LabelImage> found = labelsFromPicture(picture, "labels.png");
    REQUIRE_FALSE(found);
    CHECK(found.error().kind == ErrorKind::badInput);
    return found.error().message;
  };
  using Catch::Matchers::Contains;
  CHECK_THAT(messageOf(SrgbImage(kSide, kSide, 3)), Contains("labels.png: 1 colour covers"));
  const LabelImage labels = blobs({-0.8f, -0.2f, 0.3f, 0.9f}, 3);
  const auto grey = [](float value) { return Color{value, value, value}; };
  CHECK_THAT(
      messageOf(painted(labels, {grey(0.0f), grey(0.25f), grey(0.5f), grey(0.75f), grey(1.0f)})),
      Contains("5 colours cover"));
  // A second colour of a few pixels.
  SrgbImage dot(kSide, kSide, 1);
  std::fill_n(dot.values.begin(), kPixels / 200, 1.0f);
  CHECK_THAT(messageOf(dot), Contains("1 colour covers"));
}

TEST_CASE("clusters of colours recover a mask of two and of three materials") {
  for (const std::vector<float>& cuts : {std::vector{0.2f}, std::vector{-0.5f, 0.6f}}) {
    const LabelImage labels = blobs(cuts, 5);
    const MapExemplar map = mixed(labels);
    const Result<LabelImage> found = clusterLabels(map, labels.count);
    REQUIRE(found);
    INFO(labels.count << " labels");
    CHECK(found.value().count == labels.count);
    CHECK(shareOfEqual(found.value(), labels) > 0.95);
    CHECK(labelSeparation(map, found.value()) > 0.5);
    CHECK(clusterLabels(map, labels.count).value().labels == found.value().labels);
  }
}

TEST_CASE("one material has no clusters, and its labels are not separate") {
  const MapExemplar map = colorMap(materials()[0]);
  const Result<LabelImage> found = clusterLabels(map, 2);
  REQUIRE(found);
  CHECK(labelSeparation(map, found.value()) < 0.1);
}

TEST_CASE("clusters need a count from 2 to 4 and as many colours") {
  const MapExemplar map = mixed(blobs({0.0f}, 5));
  for (const int count : {1, 5}) {
    const Result<LabelImage> found = clusterLabels(map, count);
    REQUIRE_FALSE(found);
    CHECK(found.error().kind == ErrorKind::usage);
  }
  const Result<LabelImage> even = clusterLabels(colorMap(std::vector(3 * kPixels, 0.5f)), 2);
  REQUIRE_FALSE(even);
  CHECK(even.error().kind == ErrorKind::badInput);
}

TEST_CASE("the exemplar of a label keeps its pixels, and elsewhere has its statistics") {
  const LabelImage labels = blobs({0.2f}, 5);
  const MapExemplar map = mixed(labels);
  for (int label = 0; label < 2; ++label) {
    const std::vector<float> pure = materials()[std::size_t(label)];
    const std::vector<MapExemplar> found = exemplarsOfLabel({&map, 1}, labels, label);
    REQUIRE(found.size() == 1);
    const std::vector<float>& values = found[0].values;
    REQUIRE(values.size() == map.values.size());
    INFO("label " << label);

    std::size_t kept = 0, inside = 0;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        if (const auto i = std::size_t(y * kSide + x);
            labels.labels[i] == label && !anyOtherWithin(labels, x, y, 4)) {
          ++inside;
          kept += std::equal(&values[3 * i], &values[3 * i] + 3, &map.values[3 * i]) ? 1u : 0u;
        }
    CHECK(inside > kPixels / 5);
    CHECK(kept == inside);

    const exemplar::Moments own = exemplar::momentsOf(values, 3),
                            wanted = exemplar::momentsOf(pure, 3);
    const double trace = wanted.covariance.trace();
    const double worstMean = (own.mean - wanted.mean).cwiseAbs().maxCoeff() / std::sqrt(trace);
    const double worstCovariance =
        (own.covariance - wanted.covariance).cwiseAbs().maxCoeff() / trace;
    double worstLag = 0.0;
    const std::vector<double> lags = shortLags(values), pureLags = shortLags(pure);
    for (std::size_t k = 0; k < lags.size(); ++k)
      worstLag = std::max(worstLag, std::abs(lags[k] - pureLags[k]));
    // Measured 0.02, 0.008 and 0.026.
    INFO("mean " << worstMean << ", covariance " << worstCovariance << ", lags " << worstLag);
    CHECK(worstMean < 0.03);
    CHECK(worstCovariance < 0.02);
    CHECK(worstLag < 0.04);
    CHECK(*std::max_element(values.begin(), values.end()) <=
          *std::max_element(map.values.begin(), map.values.end()));
  }
}

TEST_CASE("maps of other sizes take the same copies") {
  const LabelImage labels = blobs({0.2f}, 5);
  const MapExemplar map = mixed(labels);
  // Half the size: each pixel is one of the map's.
  MapExemplar half = map;
  half.width = half.height = kSide / 2;
  half.values.clear();
  for (int y = 0; y < kSide; y += 2)
    for (int x = 0; x < kSide; x += 2)
      half.values.insert(half.values.end(), &map.values[std::size_t(3 * (y * kSide + x))],
                         &map.values[std::size_t(3 * (y * kSide + x))] + 3);
  const std::vector<MapExemplar> found = exemplarsOfLabel(std::vector{map, map, half}, labels, 0);
  CHECK(found[0].values == found[1].values);
  REQUIRE(found[2].values.size() == half.values.size());
  double product = 0.0, squares = 0.0, halfSquares = 0.0;
  const double mean = exemplar::momentsOf(found[0].values, 3).mean[1],
               halfMean = exemplar::momentsOf(found[2].values, 3).mean[1];
  for (int y = 0; y < kSide / 2; ++y)
    for (int x = 0; x < kSide / 2; ++x) {
      const double whole =
          double(found[0].values[std::size_t(3 * (2 * y * kSide + 2 * x) + 1)]) - mean;
      const double other =
          double(found[2].values[std::size_t(3 * (y * (kSide / 2) + x) + 1)]) - halfMean;
      product += whole * other;
      squares += whole * whole;
      halfSquares += other * other;
    }
  // An offset of an odd number of pixels is half a pixel off in the smaller map. Measured 0.85.
  CHECK(product > 0.8 * std::sqrt(squares * halfSquares));
}

TEST_CASE("a label without an inside fills the tile all the same") {
  // Lines one pixel wide, every eighth.
  LabelImage labels{kSide, kSide, 2, std::vector<std::uint8_t>(kPixels, 0)};
  MapExemplar map = colorMap(std::vector(3 * kPixels, 0.2f));
  std::mt19937 generator(1);
  for (std::size_t i = 0; i < kPixels; ++i)
    if (i % 8 == 0) {
      labels.labels[i] = 1;
      for (std::size_t c = 0; c < 3; ++c)
        map.values[3 * i + c] = 0.7f + 0.1f * float(generator() & 1u);
    }
  const std::vector<MapExemplar> found = exemplarsOfLabel({&map, 1}, labels, 1);
  CHECK(*std::min_element(found[0].values.begin(), found[0].values.end()) >= 0.7f);
}

TEST_CASE("labels of near colours are split last") {
  // Dark red, white and nearly white.
  const LabelImage labels = blobs({-0.2f, 0.8f}, 5);
  std::vector<float> values;
  const std::array<Color, 3> colors{{{0.2f, 0.1f, 0.1f}, {0.9f, 0.9f, 0.9f}, {0.95f, 0.9f, 0.8f}}};
  for (const std::uint8_t label : labels.labels)
    values.insert(values.end(), colors[label].begin(), colors[label].end());
  const std::vector<LayerSplit> splits = splitLayers(colorMap(values), labels);
  REQUIRE(splits.size() == 2);
  const auto count = [&](int label) {
    return double(std::count(labels.labels.begin(), labels.labels.end(), label));
  };
  CHECK_FALSE(splits[0].below.isNode);
  CHECK(splits[0].below.index == 0);
  CHECK(splits[0].above.isNode);
  CHECK(splits[0].above.index == 1);
  CHECK(splits[0].proportion == Approx(1.0 - count(0) / double(kPixels)));
  CHECK_FALSE(splits[1].below.isNode);
  CHECK_FALSE(splits[1].above.isNode);
  const std::size_t darker = splits[1].below.index, lighter = splits[1].above.index;
  CHECK(darker + lighter == 3);
  CHECK(splits[1].proportion == Approx(count(int(lighter)) / (count(1) + count(2))));
}
