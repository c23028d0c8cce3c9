// SPDX-License-Identifier: MIT
// Statistics of texton noise against closed forms, and its views against what mips store.
#include "base_color.h"
#include "bundle_of.h"
#include "synthetic_texton.h"

#include <lichen/texton.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <evaluation/method_evaluator.h>
#include <materials.h>
#include <random>
#include <sampling/texels.h>

using namespace lichen;
using namespace lichen::test;

namespace {

MaterialNoise materialOf(PointProcess process, std::uint32_t seed) {
  MaterialNoise material;
  material.pointProcess = process;
  material.seed = seed;
  return material;
}

/// A synthetic noise with its evaluator.
struct Evaluation {
  Evaluation(const SyntheticTexton& source, const MaterialNoise& materialNoise)
      : bundle(syntheticTextonBundle(source).bundle), evaluator(methodEvaluator(bundle, 0)),
        material(shaderMaterial(bundle, materialNoise, {})), constants(shaderNoise(bundle, 0)) {}

  /// Stored values minus their mean, of a pixel of a texel at a position in texels.
  [[nodiscard]] std::array<double, 3> at(double x, double y) const {
    const float pixelX = 1.0f / constants.tileTexelsX, pixelY = 1.0f / constants.tileTexelsY;
    const TileFootprint place{
        {float(x) * pixelX, float(y) * pixelY}, {pixelX, 0.0f}, {0.0f, pixelY}};
    const std::array<float, 3> gaussian = evaluator->gaussian(0, material, place).value;
    const std::vector<double>& scale = bundle.noises[0].maps[0].as<TextonMap>().scale;
    std::array<double, 3> stored{};
    for (std::size_t c = 0; c < scale.size(); ++c)
      stored[c] = (double(gaussian[c]) - 0.5) * scale[c];
    return stored;
  }

  Bundle bundle;
  std::shared_ptr<const MethodEvaluator> evaluator;
  shader::LichenTriplanarMaterial material;
  shader::LichenNoise constants;
};

const SyntheticTexton kColour{
    .coefficientsX = 12, .coefficientsY = 10, .mipLevels = 2, .wholeFloats = true};
/// Calls act(x, y) for `side` x `side` positions [texels]. Each is random in its own square, and
/// the squares are further apart than textons reach, so that the values are independent.
template <class Act>
void atIndependentPlaces(int side, double reachTexels, const Act& act) {
  std::mt19937 generator(3u);
  std::uniform_real_distribution<double> inside(0.0, 16.0);
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const double x = i * (reachTexels + 16.0) + inside(generator);
      const double y = j * (reachTexels + 16.0) + inside(generator);
      act(x, y);
    }
}

constexpr PointProcess kProcesses[] = {PointProcess::stratified, PointProcess::poisson};

} // namespace

TEST_CASE("the covariance at a lag is sum b(k - l) alpha alpha^T, for both processes") {
  const std::vector<double> alpha = syntheticCoefficients(kColour, 0);
  const std::vector<double> whole = covarianceAt(kColour, alpha, 0, 0);
  for (const PointProcess process : kProcesses) {
    const Evaluation noise(kColour, materialOf(process, 5));
    for (const auto& [lagX, lagY] :
         std::vector<std::array<int, 2>>{{0, 0}, {1, 0}, {0, 2}, {3, -1}, {-2, 5}, {13, 0}}) {
      std::array<double, 9> sum{};
      std::array<double, 3> mean{};
      constexpr int kSide = 120;
      constexpr double kCount = double(kSide) * kSide;
      atIndependentPlaces(kSide, 32.0, [&](double x, double y) {
        const auto here = noise.at(x, y), there = noise.at(x + lagX, y + lagY);
        for (std::size_t c = 0; c < 3; ++c) {
          mean[c] += here[c] / kCount;
          for (std::size_t d = 0; d < 3; ++d)
            sum[3 * c + d] += here[c] * there[d] / kCount;
        }
      });
      const std::vector<double> expected = covarianceAt(kColour, alpha, lagX, lagY);
      INFO("lag " << lagX << ", " << lagY << ", " << nameOf(process));
      for (std::size_t c = 0; c < 3; ++c) {
        // 5 standard errors, alpha 6e-7 each; standard errors are Gaussian, plus a tenth for the
        // kurtosis.
        CHECK(std::abs(mean[c]) < 5.0 * std::sqrt(whole[4 * c] / kCount));
        for (std::size_t d = 0; d < 3; ++d) {
          const double error = std::sqrt(
              (whole[4 * c] * whole[4 * d] + expected[3 * c + d] * expected[3 * c + d]) / kCount);
          CHECK(std::abs(sum[3 * c + d] - expected[3 * c + d]) < 5.0 * 1.1 * error);
        }
      }
    }
  }
}

TEST_CASE("noise on a surface works without a tangent") {
  MaterialNoise material = materialOf(PointProcess::stratified, 6);
  material.mapping = Mapping::surface;
  const Evaluation noise(kColour, material);
  SurfaceFootprint lost;
  lost.position = {7.0f, -3.0f, 20.0f};
  lost.normal = {1.0f, 1.0f, -0.3f};
  for (const float x : {0.0f, -1e-9f}) {
    lost.tangent = {x, x, x, 1.0f};
    CHECK(std::isfinite(noise.evaluator->gaussian(0, noise.material, lost).value[0]));
  }
}

namespace {

/// A noise with one material, and its evaluator.
struct View {
  explicit View(Bundle of)
      : bundle(std::move(of)), evaluator(methodEvaluator(bundle, 0)),
        material(shaderMaterial(bundle, {}, {})) {}

  /// A pixel's footprint with these sides. [tiles]
  [[nodiscard]] static TileFootprint place(double x, double y, double width, double height) {
    return {{float(x), float(y)}, {float(width), 0.0f}, {0.0f, float(height)}};
  }

  Bundle bundle;
  std::shared_ptr<const MethodEvaluator> evaluator;
  shader::LichenTriplanarMaterial material;
};

} // namespace

TEST_CASE("between two mips textons have the variance that both mips store") {
  // White coefficients under a bell, then smoother and smoother ones.
  for (const int smoothings : {0, 1, 3, 10, 30}) {
    const SyntheticTexton source{.coefficientsX = 40,
                                 .coefficientsY = 40,
                                 .mipLevels = 4,
                                 .channels = 1,
                                 .wholeFloats = true,
                                 .smoothings = smoothings};
    const View view(syntheticTextonBundle(source).bundle);
    const RepeatingImage image(view.bundle.tables[0]);
    const auto energy = [&](float level) {
      constexpr int kSamples = 480; // per side, 10 per texel
      double sum = 0.0;
      for (int k = 0; k < kSamples * kSamples; ++k)
        sum += std::pow(double(image.at(float(k % kSamples + 0.5) / kSamples,
                                        float(k / kSamples + 0.5) / kSamples, level)[0]),
                        2);
      return sum;
    };
    const double whole = energy(0.0f);
    for (const float level : {0.5f, 1.5f, 2.25f}) {
      const double kept = energy(level) / whole;
      // Textons are fetched half a level below the footprint's (docs/decisions/003).
      const double pixel = std::exp2(double(level) + 0.5);
      const TileFootprint at =
          View::place(0.0, 0.0, pixel / source.texelsPerTileX, pixel / source.texelsPerTileY);
      const double lost = double(view.evaluator->gaussian(0, view.material, at).lost[0]);
      INFO("smoothings " << smoothings << ", level " << level << ", kept " << kept);
      // Up to 3.6 %, plus the quantization of small amplitudes to bytes.
      CHECK(1.0 - lost == Approx(kept).epsilon(0.045));
    }
  }
}

TEST_CASE(
    "each channel of a view has the variance that its losses leave, also beyond the last mip") {
  constexpr int kSide = 128;
  TextonOptions options;
  options.support = 32;
  options.order = GENERATE(1, 3);
  const MapExemplar rust = baseColor(exemplars::rust(kSide));
  const View view(bundleOf(bakeTexton("exemplar", {&rust, 1}, options)));
  const NoiseMap& map = view.bundle.noises[0].maps[0];
  for (const std::size_t level : {1u, 2u, 5u}) {
    // Textons are fetched half a level below the footprint's (docs/decisions/003).
    const float pixel = std::exp2(float(level) + 0.5f) / float(kSide);
    constexpr int kPlaces = 64; // per side, further apart than textons reach
    std::array<double, 3> variance{};
    for (int k = 0; k < kPlaces * kPlaces; ++k) {
      TileFootprint at;
      at.position = {1.37f * float(k % kPlaces), 1.61f * float(k / kPlaces)};
      at.dx = {pixel, 0.0f};
      at.dy = {0.0f, pixel};
      const auto value = view.evaluator->gaussian(0, view.material, at).value;
      for (std::size_t c = 0; c < 3; ++c)
        variance[c] += 36.0 * std::pow(double(value[c]) - 0.5, 2) / (kPlaces * kPlaces);
    }
    for (std::size_t c = 0; c < 3; ++c) {
      INFO("order " << options.order << ", level " << level << ", channel " << c);
      const double kept = 1.0 - lossRow(map.as<TextonMap>().mipLoss, c, 3)[level];
      // Five standard errors, sqrt(3 / 4096) each, for 4,096 values with a kurtosis of up to 4,
      // plus the quantization of the kept amplitudes to bytes.
      CHECK(variance[c] == Approx(kept).epsilon(0.14).margin(std::sqrt(kept) / 255.0));
    }
  }
}
