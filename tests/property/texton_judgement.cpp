// SPDX-License-Identifier: MIT
// The judgement of a stored texton, and the Gaussian texture it is compared with.
#include "bundle_of.h"
#include "example_exemplar.h"

#include <lichen/texton.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <texton/judgement.h>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr int kSide = 64;

/// Three correlated channels of low contrast, so that no value is clamped.
MapExemplar faint() {
  MapExemplar map = threeMaterials(kSide, kSide, 3);
  for (float& value : map.values)
    value = 0.5f + 0.1f * (value - 0.5f);
  return map;
}

struct Baked {
  Bundle bundle;
  TextonQuality quality;
};

Baked bakedOf(const MapExemplar& map, int order, int support) {
  TextonOptions options;
  options.order = order;
  options.support = support;
  options.bits = 16;
  const Result<MethodBake> bake = bakeTexton("grain", {&map, 1}, options);
  return {bundleOf(bake), bake.value().figures.quality};
}

/// Covariance of two channels of interleaved values about the given mean.
double covarianceOf(const MapExemplar& map, const std::vector<double>& mean, std::size_t a,
                    std::size_t b) {
  const std::size_t n = map.channels.size();
  double sum = 0.0;
  for (std::size_t i = 0; i < map.values.size(); i += n)
    sum += (double(map.values[i + a]) - mean[a]) * (double(map.values[i + b]) - mean[b]);
  return sum / double(map.values.size() / n);
}

} // namespace

TEST_CASE("a stored texton has the error and flatness that its bake found, at every order") {
  const MapExemplar map = faint();
  for (const int order : {0, 1, 3}) {
    INFO("order " << order);
    const Baked baked = bakedOf(map, order, 24);
    const Noise& noise = baked.bundle.noises[0];
    const texton::TextonJudgement judgement =
        texton::judgeTexton(baked.bundle, noise, noise.maps[0], map);
    // Texels are 32-bit floats, and the covariance is corrected twice, to 1e-6 each.
    CHECK(judgement.modelError == Approx(baked.quality.modelError).epsilon(4e-6));
    CHECK(judgement.flatness == Approx(baked.quality.flatness).epsilon(4e-6));
    CHECK(judgement.flatness <= 4.0); // the limit of a fit
  }
}

TEST_CASE(
    "the Gaussian version has mean and covariance of the map, and twice the exemplar's sides") {
  const MapExemplar map = faint();
  const Baked baked = bakedOf(map, 1, 24);
  NoiseMap noise = baked.bundle.noises[0].maps[0];
  const MapExemplar gaussian = texton::gaussianVersion(noise, map, 1);
  CHECK(gaussian.width == kSide);
  CHECK(gaussian.height == kSide);
  // Random phases do not change moduli, so the sample has the covariance itself.
  for (std::size_t a = 0; a < 3; ++a) {
    double mean = 0.0;
    for (std::size_t i = a; i < gaussian.values.size(); i += 3)
      mean += double(gaussian.values[i]) * 3.0 / double(gaussian.values.size());
    CHECK(mean == Approx(noise.mean[a]).margin(1e-6));
    for (std::size_t b = 0; b < 3; ++b)
      CHECK(covarianceOf(gaussian, noise.mean, a, b) ==
            Approx(noise.covariance[3 * a + b])
                .margin(1e-4 * std::sqrt(noise.covariance[4 * a] * noise.covariance[4 * b])));
  }
  // Four times the covariance is twice the distance from the mean.
  for (double& value : noise.covariance)
    value *= 4.0;
  const MapExemplar doubled = texton::gaussianVersion(noise, map, 1);
  for (std::size_t i = 0; i < doubled.values.size(); i += 97)
    CHECK(double(doubled.values[i]) - noise.mean[i % 3] ==
          Approx(2.0 * (double(gaussian.values[i]) - noise.mean[i % 3])).margin(1e-5));
  CHECK(texton::gaussianVersion(noise, map, 2).values != doubled.values);
}
