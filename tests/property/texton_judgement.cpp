// SPDX-License-Identifier: MIT
// The report on a stored texton next to other spots, and the Gaussian texture it is compared with.
#include "example_exemplar.h"

#include <lichen/texton.h>
#include <lichen/texton_comparison.h>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <exemplar/value_encoding.h>
#include <gaussian/kernels.h>
#include <gaussian/model_covariance.h>
#include <texton/color_correction.h>
#include <texton/fit.h>
#include <texton/interpolation.h>
#include <transport/covariance_map.h>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::texton;

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
  Result<TextonBake> bake = bakeTexton("grain", {&map, 1}, options);
  REQUIRE(bake);
  Baked baked;
  baked.bundle.noises = {std::move(bake.value().noise)};
  baked.bundle.tables = std::move(bake.value().tables);
  baked.quality = std::move(bake.value().quality);
  return baked;
}

KernelComparison comparisonOf(const Baked& baked, const MapExemplar& map) {
  const Result<KernelComparison> comparison = compareTexton(baked.bundle, 0, map);
  REQUIRE(comparison);
  return comparison.value();
}

/// The rounding of float spectra, in the root of a mean square.
constexpr double kRounding = 2e-6;

/// [GLM17] eq. 4: divides by the transform of the B-spline. Interpolating the coefficients of the
/// result gives `model` again.
gaussian::GaussianModel deconvolved(gaussian::GaussianModel model, int order) {
  for (HalfSpectrum& channel : model.channels)
    for (int v = 0; v < kSide; ++v)
      for (int u = 0; u < channel.columns(); ++u)
        channel.at(u, v) *= float(1.0 / std::sqrt(kernelPower(order, double(u) / kSide) *
                                                  kernelPower(order, double(v) / kSide)));
  return model;
}

/// The optimal map from a covariance to the model's, for channels relative to the model's standard
/// deviations.
Eigen::MatrixXd correctionOf(const gaussian::GaussianModel& model,
                             const Eigen::MatrixXd& covariance) {
  const Eigen::MatrixXd wanted = gaussian::modelCovariance(model);
  const Eigen::VectorXd units = wanted.diagonal().cwiseSqrt();
  const Eigen::MatrixXd over = units.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd from = over * covariance * over, to = over * wanted * over;
  return units.asDiagonal() * transport::covarianceMap(from, to) * over;
}

/// The relative error of a model's own kernels after this change of colours.
double errorOfColors(const gaussian::GaussianModel& model, const Eigen::MatrixXd& change) {
  double distance = 0.0, power = 0.0;
  const HalfSpectrum& first = model.channels[0];
  for (int v = 0; v < kSide; ++v)
    for (int u = 0; u < first.columns(); ++u) {
      Eigen::Vector3cd t;
      for (int c = 0; c < 3; ++c)
        t[c] = std::complex<double>(model.channels[std::size_t(c)].at(u, v));
      const Eigen::Vector3cd h = change * t;
      const double weight = first.multiplicity(u);
      distance += weight * (t.squaredNorm() + h.squaredNorm() - 2.0 * std::abs(h.dot(t)));
      power += weight * t.squaredNorm();
    }
  return std::sqrt(std::max(distance, 0.0) / power);
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
    const KernelComparison comparison = comparisonOf(baked, map);
    // Texels are 32-bit floats, and the covariance is corrected twice, to 1e-6 each.
    CHECK(comparison.texton.modelError == Approx(baked.quality.modelError).epsilon(4e-6));
    CHECK(comparison.texton.flatness == Approx(baked.quality.flatness).epsilon(4e-6));
    CHECK(comparison.texton.impactsNeeded() == Approx(10.0 * comparison.texton.flatness));
    CHECK(comparison.texton.flatness <= 4.0); // the limit of a fit
    CHECK(comparison.luminance.flatness > 2.0 * comparison.texton.flatness);
    CHECK(comparison.randomPhase.modelError > comparison.texton.modelError);
  }
}

TEST_CASE(
    "a spot as large as the exemplar has its Gaussian texture, up to the correction of colours") {
  // The covariance of a spot's noise is that of its texels within the support, and the model's is
  // that of texels on the torus. They agree for order 0; other orders lack the products across the
  // border.
  const MapExemplar map = faint();
  const gaussian::GaussianModel model =
      gaussian::gaussianModel(exemplar::asStored(map).values, kSide, kSide, 3);
  for (const int order : {0, 1, 3}) {
    INFO("order " << order);
    Baked baked = bakedOf(map, order, kSide + order); // as many coefficients as texels
    REQUIRE(baked.bundle.noises[0].as<TextonShape>().coefficientsX == kSide);
    const KernelComparison comparison = comparisonOf(baked, map);
    const gaussian::GaussianModel coefficients = deconvolved(model, order);
    const auto expected = [&](const TextonCoefficients& spot) {
      CHECK(relativeModelError(model, spot, order) < kRounding);
      return errorOfColors(model, correctionOf(model, noiseCovariance(spot, order)));
    };
    CHECK(
        comparison.luminance.modelError ==
        Approx(expected(gaussian::luminanceTexton(coefficients, kSide, kSide))).margin(kRounding));
    CHECK(comparison.randomPhase.modelError ==
          Approx(expected(gaussian::randomPhaseKernel(coefficients, kSide, kSide, 1)))
              .margin(kRounding));
  }
}

TEST_CASE(
    "the Gaussian version has mean and covariance of the map, and twice the exemplar's sides") {
  const MapExemplar map = faint();
  const Baked baked = bakedOf(map, 1, 24);
  NoiseMap noise = baked.bundle.noises[0].maps[0];
  const Result<MapExemplar> made = gaussianVersion(noise, map, 1);
  REQUIRE(made);
  const MapExemplar& gaussian = made.value();
  CHECK(gaussian.width == 2 * kSide);
  CHECK(gaussian.height == 2 * kSide);
  // Patches of some 7 x 7 texels: 330 independent values. Variances have a standard error of sqrt(2
  // / 330), 8 %, and covariances less than that relative to their channels' standard deviations.
  // 4.5 of them: alpha 7e-6 each.
  constexpr double kScatter = 4.5 * 0.08;
  const double deviation = std::sqrt(noise.covariance[0] / 330.0);
  for (std::size_t a = 0; a < 3; ++a) {
    double mean = 0.0;
    for (std::size_t i = a; i < gaussian.values.size(); i += 3)
      mean += double(gaussian.values[i]) * 3.0 / double(gaussian.values.size());
    CHECK(mean == Approx(noise.mean[a]).margin(4.5 * deviation));
    for (std::size_t b = 0; b < 3; ++b)
      CHECK(covarianceOf(gaussian, noise.mean, a, b) ==
            Approx(noise.covariance[3 * a + b])
                .margin(kScatter * std::sqrt(noise.covariance[4 * a] * noise.covariance[4 * b])));
  }
  // Four times the covariance is twice the distance from the mean.
  for (double& value : noise.covariance)
    value *= 4.0;
  const MapExemplar doubled = gaussianVersion(noise, map, 1).value();
  for (std::size_t i = 0; i < doubled.values.size(); i += 97)
    CHECK(double(doubled.values[i]) - noise.mean[i % 3] ==
          Approx(2.0 * (double(gaussian.values[i]) - noise.mean[i % 3])).margin(1e-5));
  const Result<MapExemplar> other = gaussianVersion(noise, map, 2);
  CHECK(other.value().values != doubled.values);
}

TEST_CASE("textons are compared with exemplars of their own channels and method only") {
  const MapExemplar map = faint();
  Baked baked = bakedOf(map, 1, 24);
  CHECK_FALSE(compareTexton(baked.bundle, 1, map));
  MapExemplar other = map;
  other.target = MapTarget::emissive;
  CHECK_FALSE(compareTexton(baked.bundle, 0, other));
  other = map;
  other.channels = {MapChannel::red};
  other.values.resize(map.values.size() / 3);
  const Result<KernelComparison> channels = compareTexton(baked.bundle, 0, other);
  REQUIRE_FALSE(channels);
  CHECK(channels.error().kind == ErrorKind::badInput);
  CHECK_FALSE(gaussianVersion(baked.bundle.noises[0].maps[0], other, 1));
  baked.bundle.noises[0].data = TilingNoise();
  const Result<KernelComparison> method = compareTexton(baked.bundle, 0, map);
  REQUIRE_FALSE(method);
  CHECK(method.error().message.find("tiling, not texton") != std::string::npos);
}
