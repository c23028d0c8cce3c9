// SPDX-License-Identifier: MIT
// Noises without outlines of all kinds of exemplars: their decoded values have the exemplar's
// distribution, and maps of a set correlate.
#include "bundle_of.h"
#include "statistics_of_maps.h"

#include <lichen/local_random_phase.h>
#include <lichen/multiple_kernels.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr int kTexels = 128, kSmall = 64; // sides of exemplars

Bundle bakedAs(Method method, std::span<const MapExemplar> maps) {
  if (method == Method::multipleKernels)
    return bundleOf(bakeMultipleKernels("kind", maps, {}));
  LocalRandomPhaseOptions options;
  options.structure = 0.0;
  return bundleOf(bakeLocalRandomPhase("kind", maps, options));
}

/// Checks the mean, the deviation and quantiles of each decoded channel of the noise against the
/// exemplar's. The tolerance of mean and deviation, in deviations of the exemplar, is five standard
/// errors of the mean of 512^2 texels that correlate over 9. `ofQuantiles` is
/// the tolerance of quantiles, `ofKernels` the same for multiple kernels.
void checkDistribution(const MapExemplar& map, double ofQuantiles,
                       std::optional<double> ofKernels = {}) {
  for (const Method method : {Method::localRandomPhase, Method::multipleKernels}) {
    INFO(nameOf(method));
    constexpr double kOfMoments = 0.03;
    const double ofQuantile =
        method == Method::multipleKernels ? ofKernels.value_or(ofQuantiles) : ofQuantiles;
    const Bundle bundle = bakedAs(method, {&map, 1});
    const LinearImage image = synthesized(bundle, map.target);
    const std::size_t channels = map.channels.size();
    REQUIRE(std::size_t(image.channels) == channels);
    const std::vector<float> values = decodedValues(map);
    for (std::size_t c = 0; c < channels; ++c) {
      std::vector<double> wanted = channelOf(values, channels, c),
                          found = channelOf(image.values, channels, c);
      const double deviation = std::sqrt(covarianceOf(wanted, wanted));
      INFO("channel " << c << ", deviation " << deviation);
      CHECK(meanOf(found) == Approx(meanOf(wanted)).margin(kOfMoments * deviation));
      CHECK(std::sqrt(covarianceOf(found, found)) ==
            Approx(deviation).margin(kOfMoments * deviation));
      std::sort(wanted.begin(), wanted.end());
      std::sort(found.begin(), found.end());
      for (const double share : {0.05, 0.25, 0.5, 0.75, 0.95}) {
        INFO("quantile " << share);
        CHECK(found[std::size_t(share * double(found.size()))] ==
              Approx(wanted[std::size_t(share * double(wanted.size()))])
                  .margin(ofQuantile * deviation));
      }
    }
  }
}

} // namespace

TEST_CASE("the noise of slopes has their distribution") {
  MapExemplar map = emptyMap(MapTarget::normal, {MapChannel::slopeX, MapChannel::slopeY},
                             ValueEncoding::slope, kTexels);
  const auto fields = gaussianFields(2, 2, kTexels);
  for (std::size_t i = 0; i < fields[0].size(); ++i) {
    map.values.push_back(float(std::exp(0.6 * fields[0][i]) - 1.2));
    map.values.push_back(float(0.5 * fields[0][i] + 0.8 * fields[1][i]));
  }
  // The outer quantiles lie too far out, with the same inverse table in tiling too. Measured 0.066,
  // 0.100 and 0.120: how FFTs round depends on the processor, and the fit of kernels differs with
  // it.
  checkDistribution(map, 0.09, 0.15);
}

TEST_CASE("the noise of light far above 1 has its distribution") {
  MapExemplar map =
      emptyMap(MapTarget::emissive, {MapChannel::red, MapChannel::green, MapChannel::blue},
               ValueEncoding::log2, kTexels);
  const auto fields = gaussianFields(4, 3, kTexels);
  constexpr std::array<double, 3> kScale{4.0, 1.0, 2.0};
  for (std::size_t i = 0; i < fields[0].size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const double light = kScale[c] * std::exp(0.4 * fields[3][i] + 0.4 * fields[c][i]);
      map.values.push_back(float(std::log2(1.0 + light)));
    }
  const std::vector<float> light = decodedValues(map);
  REQUIRE(*std::max_element(light.begin(), light.end()) > 16.0f);
  checkDistribution(map, 0.13); // measured 0.098
}

TEST_CASE("the noise of two channels of a map of three has their distribution") {
  MapExemplar map =
      emptyMap(MapTarget::occlusionRoughnessMetallic, {MapChannel::roughness, MapChannel::metallic},
               ValueEncoding::linear, kTexels);
  const auto fields = gaussianFields(2, 6, kTexels);
  for (std::size_t i = 0; i < fields[0].size(); ++i)
    for (std::size_t c = 0; c < 2; ++c)
      map.values.push_back(float(1.0 / (1.0 + std::exp(1.0 - fields[0][i] - fields[c][i]))));
  checkDistribution(map, 0.09);
}

TEST_CASE("a height that follows the colour does so in the noise") {
  std::vector<MapExemplar> maps{
      emptyMap(MapTarget::baseColor, {MapChannel::red, MapChannel::green, MapChannel::blue},
               ValueEncoding::srgb, kSmall),
      emptyMap(MapTarget::height, {MapChannel::height}, ValueEncoding::linear, kSmall)};
  // The colour follows the first field, red most and blue against it, and so does the height.
  constexpr std::array<double, 3> kShared{0.9, 0.6, -0.6};
  const auto fields = gaussianFields(5, 4, kSmall);
  for (std::size_t i = 0; i < fields[0].size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double own = std::sqrt(1.0 - kShared[c] * kShared[c]);
      const double g = kShared[c] * fields[0][i] + own * fields[c + 1][i];
      maps[0].values.push_back(float(1.0 / (1.0 + std::exp(0.5 - 1.2 * g))));
    }
    const double g = 0.95 * fields[0][i] + 0.31 * fields[4][i];
    maps[1].values.push_back(float(0.1 + 0.2 * std::exp(0.5 * g)));
  }
  const std::array<double, 3> wanted =
      correlationsWithHeight(decodedValues(maps[0]), maps[1].values);
  CHECK(std::abs(wanted[0]) > 0.7);
  std::vector<Bundle> noises{bakedAs(Method::localRandomPhase, maps),
                             bakedAs(Method::multipleKernels, maps)};
  LocalRandomPhaseOptions options;
  options.structure = 0.5;
  noises.push_back(bundleOf(bakeLocalRandomPhase("structured", maps, options)));
  for (const Bundle& bundle : noises) {
    const std::array<double, 3> found =
        correlationsWithHeight(synthesized(bundle, MapTarget::baseColor, 2).values,
                               synthesized(bundle, MapTarget::height, 2).values);
    for (std::size_t c = 0; c < 3; ++c) {
      INFO(bundle.noises[0].name << ", " << nameOf(bundle.noises[0].method()) << ", channel " << c);
      CHECK(found[c] == Approx(wanted[c]).margin(0.1));
    }
  }
}
