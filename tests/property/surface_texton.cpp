// SPDX-License-Identifier: MIT
// Statistics of texton noise on surfaces against closed forms.
#include "texton_evaluation.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <random>

using namespace lichen;
using namespace lichen::test;

namespace {

using Vec = std::array<double, 3>;

Vec sum(double a, const Vec& x, double b, const Vec& y) {
  return {a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]};
}
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec unit(const Vec& v) { return sum(1.0 / std::hypot(v[0], v[1], v[2]), v, 0.0, v); }

/// A tangent plane: the directions of the exemplar's right and down on it, and the normal.
struct Plane {
  explicit Plane(const Vec& normal, const Vec& along = {0.36, 0.48, -0.8}) : outward(unit(normal)) {
    right = unit(cross(along, outward));
    down = cross(right, outward); // against the bitangent
  }
  Vec right{}, down{}, outward{};
};

MaterialNoise onSurface(MaterialNoise material) {
  material.mapping = Mapping::surface;
  return material;
}

/// For a material with surface mapping.
struct Evaluation : TextonEvaluation {
  Evaluation(const SyntheticTexton& source, const MaterialNoise& materialNoise)
      : TextonEvaluation(source, onSurface(materialNoise)) {}

  /// A pixel of a texel at a position in texels on a plane.
  [[nodiscard]] SurfaceFootprint footprint(const Vec& place, const Plane& plane) const {
    const double metresPerTexel =
        double(constants.tileSizeMetres) /
        std::hypot(double(material.material.uvToTileXX), double(material.material.uvToTileXY)) /
        double(constants.tileTexelsX);
    SurfaceFootprint at;
    for (std::size_t k = 0; k < 3; ++k) {
      at.position[k] = float(place[k] * metresPerTexel);
      at.dx[k] = float(plane.right[k] * metresPerTexel);
      at.dy[k] = float(plane.down[k] * metresPerTexel);
      at.normal[k] = float(plane.outward[k]);
      at.tangent[k] = float(plane.right[k]);
    }
    at.tangent[3] = 1.0f;
    return at;
  }

  /// Stored values minus their mean at this position.
  [[nodiscard]] Vec at(const Vec& place, const Plane& plane) const {
    return storedAt(footprint(place, plane));
  }
};

const SyntheticTexton kColour{
    .coefficientsX = 12, .coefficientsY = 10, .mipLevels = 2, .wholeFloats = true};
/// Calls act(position) for `count` positions [texels]. Each is random in its own cube, and the
/// cubes are further apart than textons reach, so that the values are independent.
template <class Act>
void atIndependentPlaces(int count, const Act& act) {
  constexpr double kApart = 64.0; // more than the reach of the textons above and all lags below
  constexpr int kSide = 30;
  std::mt19937 generator(3u);
  std::uniform_real_distribution<double> inside(0.0, 16.0);
  for (int k = 0; k < count; ++k)
    act(Vec{k % kSide * kApart + inside(generator), k / kSide % kSide * kApart + inside(generator),
            k / (kSide * kSide) * kApart + inside(generator)});
}

/// The share of the covariance that remains between parallel tangent planes `distance` apart: int
/// w(t) w(t + d) dt / int w^2 dt with w(t) = (1 - 2 |t| / r)+.
double attenuationAcrossPlanes(double distance, double thickness) {
  constexpr int kSamples = 4000;
  const auto weight = [&](double t) { return std::max(0.0, 1.0 - 2.0 * std::abs(t) / thickness); };
  double product = 0.0, square = 0.0;
  for (int k = 0; k < kSamples; ++k) {
    const double t = ((k + 0.5) / kSamples - 0.5) * thickness;
    product += weight(t) * weight(t + distance);
    square += weight(t) * weight(t);
  }
  return product / square;
}

double thicknessOf(const SyntheticTexton& texton) {
  return std::sqrt(double(texton.coefficientsX + texton.order) *
                   double(texton.coefficientsY + texton.order));
}

} // namespace

TEST_CASE("a tangent plane of any direction has the covariance of noise in the plane, and "
          "falls across planes as the weights do") {
  struct Case {
    Vec normal;
    PointProcess process;
  };
  const std::vector<double> alpha = syntheticCoefficients(kColour, 0);
  const std::vector<double> whole = covarianceAt(kColour, alpha, 0, 0);
  for (const Case& one : {Case{{0.0, 0.0, 1.0}, PointProcess::stratified},
                          Case{{1.0, -2.0, 0.5}, PointProcess::stratified},
                          Case{{-1.0, 1.0, 1.0}, PointProcess::poisson}}) {
    const Plane plane(one.normal);
    const Evaluation noise(kColour, materialOf(one.process, 30.0, 5));
    // Lags along the exemplar's x and y, and across planes. [texels]
    for (const auto& [lagX, lagY, across] : std::vector<std::array<int, 3>>{
             {0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {3, -1, 0}, {13, 0, 0}, {0, 0, 3}, {1, 1, 6}}) {
      std::array<double, 9> products{};
      Vec mean{};
      constexpr int kPlaces = 3000;
      constexpr double kCount = kPlaces;
      atIndependentPlaces(kPlaces, [&](const Vec& place) {
        const Vec along = sum(lagX, plane.right, lagY, plane.down);
        const Vec here = noise.at(place, plane);
        const Vec there =
            noise.at(sum(1.0, place, 1.0, sum(1.0, along, across, plane.outward)), plane);
        for (std::size_t c = 0; c < 3; ++c) {
          mean[c] += here[c] / kCount;
          for (std::size_t d = 0; d < 3; ++d)
            products[3 * c + d] += here[c] * there[d] / kCount;
        }
      });
      const double attenuation = attenuationAcrossPlanes(across, thicknessOf(kColour));
      const std::vector<double> inPlane = covarianceAt(kColour, alpha, lagX, lagY);
      INFO("lag " << lagX << ", " << lagY << ", " << across << ", " << nameOf(one.process));
      for (std::size_t c = 0; c < 3; ++c) {
        // 5 standard errors, alpha 6e-7 each; standard errors are Gaussian, plus a tenth for the
        // kurtosis.
        CHECK(std::abs(mean[c]) < 5.0 * std::sqrt(whole[4 * c] / kCount));
        for (std::size_t d = 0; d < 3; ++d) {
          const double expected = attenuation * inPlane[3 * c + d];
          const double error =
              std::sqrt((whole[4 * c] * whole[4 * d] + expected * expected) / kCount);
          CHECK(std::abs(products[3 * c + d] - expected) < 5.0 * 1.1 * error);
        }
      }
    }
  }
}

TEST_CASE("noise works without a tangent") {
  const Evaluation noise(kColour, materialOf(PointProcess::stratified, 30.0, 6));
  SurfaceFootprint lost = noise.footprint({7.0, -3.0, 20.0}, Plane({1.0, 1.0, -0.3}));
  for (const float x : {0.0f, -1e-9f}) {
    lost.tangent = {x, x, x, 1.0f};
    CHECK(std::isfinite(noise.evaluator->gaussian(0, noise.material, lost).value[0]));
  }
}
