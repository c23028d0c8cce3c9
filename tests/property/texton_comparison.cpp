// SPDX-License-Identifier: MIT
// The experiments of [GLM14] on generated materials, and the distance that judges them.
#include "example_exemplar.h"

#include <lichen/spectrum.h>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <gaussian/gaussian_texture.h>
#include <gaussian/model_covariance.h>
#include <gaussian/spot_noise.h>
#include <materials.h>
#include <numbers>
#include <texton/color_correction.h>
#include <texton/flatness.h>
#include <texton/model_distance.h>
#include <vector>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::texton;

namespace {

gaussian::GaussianModel modelOf(const MapExemplar& map) {
  return gaussian::gaussianModel(map.values, map.width, map.height, int(map.channels.size()));
}

gaussian::GaussianModel modelOf(const SrgbImage& image) {
  return gaussian::gaussianModel(image.values, image.width, image.height, image.channels);
}

FitOptions spotOptions(int side, std::uint32_t seed = 1) {
  FitOptions options;
  options.width = options.height = side;
  options.order = 0;
  options.seed = seed;
  return options;
}

/// The covariance matrix of all pixels and channels of a model's texture: kernels correlated on the
/// torus, pixel by pixel.
Eigen::MatrixXd covarianceMatrix(const gaussian::GaussianModel& model) {
  const int width = model.width(), height = model.height(), pixels = width * height;
  const int size = pixels * int(model.channels.size());
  // Column i is the kernel of channel i / pixels, moved to pixel i % pixels. The noise is the
  // transpose times white noise.
  Eigen::MatrixXd kernels(pixels, size);
  for (int i = 0; i < size; ++i) {
    const std::vector<float> kernel = inverseFft(model.channels[std::size_t(i / pixels)]);
    const int x = i % pixels % width, y = i % pixels / width;
    for (int p = 0; p < pixels; ++p)
      kernels(p, i) = double(kernel[std::size_t((y - p / width + height) % height * width +
                                                (x - p % width + width) % width)]);
  }
  return kernels.transpose() * kernels;
}

Eigen::MatrixXd squareRoot(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
         solver.eigenvectors().transpose();
}

using Plane = std::vector<std::complex<double>>;

/// The discrete Fourier transform by its definition; `sign` -1 is forward, +1 is inverse and
/// divides by the size.
Plane transformed(const Plane& plane, int width, int height, double sign) {
  Plane result;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      std::complex<double> sum = 0.0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          sum += plane[std::size_t(y * width + x)] *
                 std::polar(1.0, sign * 2.0 * std::numbers::pi *
                                     (double(u * x) / width + double(v * y) / height));
      result.push_back(sign > 0.0 ? sum / double(width * height) : sum);
    }
  }
  return result;
}

Plane planeOf(const std::vector<float>& values) { return {values.begin(), values.end()}; }

/// [GLM14] algorithm 2 word for word, in double precision, with the starting phases of
/// fitCoefficients.
std::vector<float> algorithmTwo(const gaussian::GaussianModel& model, const FitOptions& options) {
  const int width = model.width(), height = model.height();
  const std::size_t channels = model.channels.size();
  std::vector<Plane> target, texton;
  for (const HalfSpectrum& channel : model.channels) {
    target.push_back(transformed(planeOf(inverseFft(channel)), width, height, -1.0));
    texton.push_back(planeOf(phaseRandomizedPlane(channel, options.seed)));
  }
  for (int step = 0; step < options.projections; ++step) {
    for (Plane& plane : texton)
      plane = transformed(plane, width, height, -1.0);
    for (std::size_t i = 0; i < target[0].size(); ++i) {
      std::complex<double> product = 0.0;
      for (std::size_t c = 0; c < channels; ++c)
        product += std::conj(target[c][i]) * texton[c][i];
      for (std::size_t c = 0; c < channels; ++c)
        texton[c][i] = i == 0 ? 0.0 : product / std::abs(product) * target[c][i];
    }
    for (Plane& plane : texton) {
      plane = transformed(plane, width, height, 1.0);
      for (int p = 0; p < width * height; ++p)
        if (p % width >= options.width || p / width >= options.height)
          plane[std::size_t(p)] = 0.0;
    }
  }
  std::vector<float> coefficients;
  for (const Plane& plane : texton)
    for (int y = 0; y < options.height; ++y)
      for (int x = 0; x < options.width; ++x)
        coefficients.push_back(float(plane[std::size_t(y * width + x)].real()));
  return coefficients;
}

/// The textures of the model are those of a kernel: the error is only rounding, 1e-4 in the root.
constexpr double kNoError = 1e-3;

/// The part of planes of the model's size, one a channel, that starts at (left, top), times
/// `scale`.
TextonCoefficients cut(const std::vector<std::vector<float>>& planes,
                       const gaussian::GaussianModel& model, int left, int top, int width,
                       int height, double scale) {
  TextonCoefficients part{width, height, int(planes.size()), {}};
  for (const std::vector<float>& plane : planes)
    for (int y = top; y < top + height; ++y)
      for (int x = left; x < left + width; ++x)
        part.values.push_back(float(scale) * plane[std::size_t(y * model.width() + x)]);
  return part;
}

/// [GLM14] section 4: the luminance texton around its centre.
TextonCoefficients luminanceTexton(const gaussian::GaussianModel& model, int width, int height) {
  const TextonCoefficients whole = gaussian::luminanceTexton(model);
  std::vector<std::vector<float>> planes;
  for (auto plane = whole.values.begin(); plane != whole.values.end();
       plane += whole.width * whole.height)
    planes.emplace_back(plane, plane + whole.width * whole.height);
  return cut(planes, model, model.width() / 2 - width / 2, model.height() / 2 - height / 2, width,
             height, 1.0);
}

/// Part of a random-phase texture of the model: the start of algorithm 2, but scaled to the model's
/// variance. The paper cuts without this scale, and its error is then near 1 whatever the part is
/// (0.95 for 31 x 31 of 512 x 512).
TextonCoefficients randomPhaseKernel(const gaussian::GaussianModel& model, int width, int height,
                                     std::uint32_t seed) {
  std::vector<std::vector<float>> planes;
  for (const HalfSpectrum& channel : model.channels)
    planes.push_back(phaseRandomizedPlane(channel, seed));
  return cut(planes, model, 0, 0, width, height,
             std::sqrt(double(model.width() * model.height()) / (width * height)));
}

/// Error and flatness of a spot, with the model's covariance: without that correction the nearest
/// spot has less variance than the model.
struct KernelJudgement {
  double modelError = 0.0, flatness = 0.0;
};
KernelJudgement judgedKernel(const gaussian::GaussianModel& model, TextonCoefficients spot) {
  REQUIRE(correctCovariance(spot, 0, gaussian::modelCovariance(model)));
  return {relativeModelError(model, spot, 0), flatness(spot, kLuminanceWeights)};
}

/// The kernels of [GLM14] figure 4, of one support.
struct KernelComparison {
  KernelJudgement texton, luminance, randomPhase;
};
KernelComparison compareKernels(const gaussian::GaussianModel& model,
                                const TextonCoefficients& texton) {
  const int width = texton.width, height = texton.height;
  return {judgedKernel(model, texton), judgedKernel(model, luminanceTexton(model, width, height)),
          judgedKernel(model, randomPhaseKernel(model, width, height, 1))};
}

/// The texton of the luminance of a spot's noise.
TextonCoefficients luminanceOf(const TextonCoefficients& spot) {
  SrgbImage image(spot.width, spot.height, 3);
  const std::size_t pixels = image.pixelCount();
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = spot.values[i % 3 * pixels + i / 3];
  return {spot.width, spot.height, 1, luminancePlane(image)};
}

/// The variance of its noise, summed over the channels.
double energy(const TextonCoefficients& spot) {
  double sum = 0.0;
  for (const float value : spot.values)
    sum += double(value) * double(value);
  return sum;
}

/// Kolmogorov distance from a sample to the normal law with mean 0 and this variance.
double distanceToNormal(std::vector<double> sample, double variance) {
  std::sort(sample.begin(), sample.end());
  const double count = double(sample.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double share = 0.5 * std::erfc(-sample[i] / std::sqrt(2.0 * variance));
    distance = std::max({distance, double(i + 1) / count - share, share - double(i) / count});
  }
  return distance;
}

} // namespace

TEST_CASE("the transport distance is Gelbrich's formula on the covariance matrices of all pixels") {
  // tr A + tr B - 2 tr (A^1/2 B A^1/2)^1/2 [PC19], for odd and even sides.
  const MapExemplar map = threeMaterials(32, 32, 5);
  for (const auto& [width, height] : {std::pair{5, 4}, std::pair{6, 3}}) {
    const gaussian::GaussianModel a = modelOf(cropped(map, 1, 2, width, height));
    const gaussian::GaussianModel b = modelOf(cropped(map, 17, 11, width, height));
    const Eigen::MatrixXd covarianceA = covarianceMatrix(a);
    const Eigen::MatrixXd covarianceB = covarianceMatrix(b);
    const Eigen::MatrixXd root = squareRoot(covarianceA);
    const double expected = covarianceA.trace() + covarianceB.trace() -
                            2.0 * squareRoot(root * covarianceB * root).trace();
    const double pixels = width * height;
    CHECK(modelVariance(a) == Approx(covarianceA.trace() / pixels).epsilon(1e-5));
    CHECK(squaredTransportDistance(a, b) == Approx(expected / pixels).epsilon(1e-4));
    CHECK(squaredTransportDistance(b, a) == Approx(expected / pixels).epsilon(1e-4));
    CHECK(squaredTransportDistance(a, a) < 1e-6 * modelVariance(a));
  }
}

TEST_CASE("the alternating projections of order 0 are algorithm 2") {
  const gaussian::GaussianModel model = modelOf(cropped(threeMaterials(32, 32, 5), 3, 4, 12, 9));
  FitOptions options = spotOptions(5, 3);
  options.height = 4;
  for (const int projections : {1, 2, 50}) {
    options.projections = projections;
    const std::vector<float> expected = algorithmTwo(model, options);
    const TextonCoefficients texton =
        fitCoefficients(model, options, FitMethod::alternatingProjections);
    REQUIRE(texton.values.size() == expected.size());
    double difference = 0.0, size = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      difference += std::pow(double(texton.values[i]) - double(expected[i]), 2.0);
      size += std::pow(double(expected[i]), 2.0);
    }
    // Projections amplify rounding only slightly: 1e-5 after 50.
    CHECK(std::sqrt(difference / size) < 1e-4);
  }
}

TEST_CASE("without cropping every comparison kernel has the model's texture") {
  const gaussian::GaussianModel model = modelOf(cropped(threeMaterials(32, 32, 5), 3, 4, 21, 18));
  FitOptions whole;
  whole.width = 21;
  whole.height = 18;
  whole.order = 0;
  const KernelComparison comparison =
      compareKernels(model, fitCoefficients(model, whole, FitMethod::transportDistance));
  CHECK(comparison.texton.modelError < kNoError);
  CHECK(comparison.luminance.modelError < kNoError);
  CHECK(comparison.randomPhase.modelError < kNoError);
}

TEST_CASE("parts of random-phase textures have noises as strong as the model's, on average") {
  const gaussian::GaussianModel model = modelOf(cropped(threeMaterials(32, 32, 5), 3, 4, 21, 18));
  constexpr int kParts = 400;
  double mean = 0.0, squares = 0.0;
  for (std::uint32_t seed = 0; seed < kParts; ++seed) {
    const double variance = energy(randomPhaseKernel(model, 4, 5, seed)) / modelVariance(model);
    mean += variance / kParts;
    squares += variance * variance / kParts;
  }
  // 4.5 standard errors: one false alarm in 150,000.
  CHECK(mean == Approx(1.0).margin(4.5 * std::sqrt((squares - mean * mean) / kParts)));
}

TEST_CASE(
    "the luminance texton of one channel has a positive spectrum, with its peak in the middle") {
  const MapExemplar map = cropped(threeMaterials(32, 32, 5), 3, 4, 15, 12);
  SrgbImage image(15, 12, 3);
  image.values = map.values;
  const std::vector<float> grey = luminancePlane(image);
  const gaussian::GaussianModel model = gaussian::gaussianModel(grey, 15, 12, 1);
  const TextonCoefficients texton = gaussian::luminanceTexton(model);
  const auto peak = std::max_element(texton.values.begin(), texton.values.end());
  CHECK(peak - texton.values.begin() == 12 / 2 * 15 + 15 / 2);
  const HalfSpectrum spectrum = forwardFft(texton.values, 15, 12);
  for (int v = 0; v < 12; ++v) {
    for (int u = 0; u < spectrum.columns(); ++u) {
      const std::complex<double> centred =
          std::complex<double>(spectrum.at(u, v)) *
          std::polar(1.0, 2.0 * std::numbers::pi * (7.0 * u / 15 + 6.0 * v / 12));
      const double power = std::abs(std::complex<double>(model.channels[0].at(u, v)));
      CHECK(std::abs(centred - power) < 1e-5);
    }
  }
}

TEST_CASE("colours keep their cross-spectra in the luminance texton, whose luminance is in phase") {
  const gaussian::GaussianModel model = modelOf(cropped(threeMaterials(32, 32, 5), 3, 4, 15, 12));
  const gaussian::GaussianModel kernel = noiseModel(gaussian::luminanceTexton(model), 0, 15, 12);
  for (std::size_t i = 1; i < model.channels[0].values.size(); ++i) {
    std::complex<double> sum = 0.0, kernelSum = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      sum += std::complex<double>(model.channels[c].values[i]);
      kernelSum += std::complex<double>(kernel.channels[c].values[i]);
      const auto cross = model.channels[c].values[i] * std::conj(model.channels[0].values[i]);
      const auto kept = kernel.channels[c].values[i] * std::conj(kernel.channels[0].values[i]);
      CHECK(std::abs(cross - kept) < 1e-5f);
    }
    CHECK(std::abs(kernelSum) == Approx(std::abs(sum)).margin(1e-5));
  }
}

TEST_CASE("flatness is 1 for one magnitude, r^2 for one pixel, and of the weighted channels") {
  TextonCoefficients spot{4, 4, 2, std::vector<float>(32, 0.0f)};
  const std::vector<float> first{1.0f, 0.0f}, both{1.0f, 2.0f};
  CHECK(flatness(spot, first) == 0.0);
  spot.values[5] = -3.0f;
  CHECK(flatness(spot, first) == Approx(16.0));
  CHECK(flatness(spot, both) == Approx(16.0));
  for (std::size_t i = 16; i < 32; ++i)
    spot.values[i] = i % 2 == 0 ? 0.5f : -0.5f;
  CHECK(flatness(spot, std::vector<float>{0.0f, 1.0f}) == Approx(1.0));
  // Fifteen of magnitude 1, and -3 - 1 at an odd pixel.
  CHECK(flatness(spot, both) == Approx(16.0 * (15.0 + 256.0) / (31.0 * 31.0)));
}

TEST_CASE("restarts gain less than 1 % over one run that takes as long", "[large]") {
  // [GLM14] section 3.2. Compares the best of 8 runs of 50 projections with one run of 400, the
  // mean of two: on the six generated materials the gain is -0.7 % to 0.2 %.
  for (const auto& generate : {exemplars::granite, exemplars::rust}) {
    const gaussian::GaussianModel model = modelOf(generate(128));
    const auto error = [&](std::uint32_t seed, int projections) {
      FitOptions options = spotOptions(31, seed);
      options.projections = projections;
      return relativeModelError(
          model, fitCoefficients(model, options, FitMethod::alternatingProjections), 0);
    };
    double best = 1.0;
    for (std::uint32_t seed = 1; seed <= 8; ++seed)
      best = std::min(best, error(seed, 50));
    CHECK(best > 0.99 * 0.5 * (error(9, 400) + error(10, 400)));
  }
}

TEST_CASE("starts scatter by less than 1 % of the error") {
  const gaussian::GaussianModel model = modelOf(exemplars::rust(64));
  double sum = 0.0, squares = 0.0;
  constexpr int kStarts = 8;
  for (std::uint32_t seed = 1; seed <= kStarts; ++seed) {
    const double error = relativeModelError(
        model, fitCoefficients(model, spotOptions(16, seed), FitMethod::transportDistance), 0);
    sum += error / kStarts;
    squares += error * error / kStarts;
  }
  CHECK(std::sqrt(squares - sum * sum) < 0.01 * sum);
}

TEST_CASE("for a given support the texton is nearest to the model, and as flat as a cropped "
          "random-phase texture",
          "[large]") {
  // [GLM14] figure 4, with the paper's support of 31 pixels.
  for (const auto& material : exemplars::kMaterials) {
    INFO(material.name);
    const gaussian::GaussianModel model = modelOf(material.generate(128));
    const KernelComparison comparison = compareKernels(
        model, fitCoefficients(model, spotOptions(31), FitMethod::transportDistance));
    // 0.95 to 0.99 of it.
    CHECK(comparison.texton.modelError < comparison.luminance.modelError);
    CHECK(comparison.luminance.modelError < comparison.randomPhase.modelError);
    // Normally distributed values have 3; energy concentrated in a few pixels gives hundreds.
    CHECK(comparison.texton.flatness < 4.0);
    CHECK(comparison.randomPhase.flatness < 4.5);
    CHECK(comparison.luminance.flatness > 50.0);
  }
}

namespace {

constexpr std::size_t kOrders = 9; // 0 to 8

/// Cumulants of spot noise with Poisson points, relative to its standard deviation. Campbell's
/// theorem: the cumulant of order n is the intensity times sum h^n.
std::array<double, kOrders> cumulantsOf(const TextonCoefficients& spot, double intensity) {
  std::array<double, kOrders> cumulants{};
  for (std::size_t n = 2; n < kOrders; ++n) {
    for (const float value : spot.values)
      cumulants[n] += std::pow(double(value), double(n));
    cumulants[n] *= intensity / std::pow(intensity * energy(spot), 0.5 * double(n));
  }
  return cumulants;
}

/// The standard deviation of the fourth power of a variable with these cumulants.
double fourthPowerDeviation(const std::array<double, kOrders>& cumulants) {
  std::array<double, kOrders> moments{1.0};
  for (std::size_t n = 1; n < kOrders; ++n) {
    double binomial = 1.0; // n - 1 over k - 1
    for (std::size_t k = 1; k <= n; ++k) {
      moments[n] += binomial * cumulants[k] * moments[n - k];
      binomial *= double(n - k) / double(k);
    }
  }
  return std::sqrt(moments[8] - moments[4] * moments[4]);
}

} // namespace

TEST_CASE("with 30 impacts per pixel a texton gives nearly normal noise, and the luminance texton "
          "does not",
          "[large]") {
  constexpr int kSupport = 31, kSamples = 16384;
  constexpr double kImpacts = 30.0, kIntensity = kImpacts / (kSupport * kSupport);
  // Kolmogorov's law: a normal sample exceeds it with probability 2 exp(-2 * 2.47^2) = 1e-5.
  const double chance = 2.47 / std::sqrt(double(kSamples));
  struct Judgement {
    double distance = 0.0; // Kolmogorov distance to the normal law
    double excess = 0.0;   // kurtosis minus 3
    double error = 0.0;    // standard error of the excess
    double skewness = 0.0; // by the closed form
  };
  for (const auto& generate : {exemplars::granite, exemplars::rust}) {
    const gaussian::GaussianModel model = modelOf(generate(128));
    const auto judged = [&](const TextonCoefficients& spot) {
      const TextonCoefficients luminance = luminanceOf(spot);
      const double variance = energy(luminance);
      Judgement judgement{.excess = -3.0};
      std::vector<double> sample;
      for (int i = 0; i < kSamples; ++i) {
        // Pixels one support apart are independent.
        const gaussian::PixelDomain pixel{i * kSupport, 0, 1, 1, false};
        const gaussian::NoisePlanes noise = gaussian::discreteSpotNoise(
            luminance, kIntensity, pixel, 1, gaussian::Summation::direct);
        sample.push_back(double(noise.values[0]));
        judgement.excess += std::pow(sample.back(), 4) / (variance * variance * kSamples);
      }
      judgement.distance = distanceToNormal(std::move(sample), variance);
      const std::array<double, kOrders> cumulants = cumulantsOf(luminance, kIntensity);
      judgement.error = fourthPowerDeviation(cumulants) / std::sqrt(double(kSamples));
      judgement.skewness = cumulants[3];
      // The paper compares this: flatness over impacts is the distance to the Gaussian limit.
      const double excess = flatness(luminance, std::vector<float>{1.0f}) / kImpacts;
      CHECK(cumulants[4] == Approx(excess).epsilon(1e-4));
      CHECK(std::abs(judgement.excess - excess) < 5.0 * judgement.error);
      return judgement;
    };
    const Judgement texton =
        judged(fitCoefficients(model, spotOptions(kSupport), FitMethod::transportDistance));
    const Judgement luminance = judged(luminanceTexton(model, kSupport, kSupport));
    CHECK(texton.excess < 4.0 / kImpacts + 5.0 * texton.error);
    CHECK(luminance.excess > texton.excess + 5.0 * std::hypot(texton.error, luminance.error));
    // A nearly normal law deviates by its skewness / 6 times |1 - x^2| phi(x), at most 0.4.
    CHECK(texton.distance < chance + 0.4 / 6.0 * std::abs(texton.skewness));
    CHECK(luminance.distance > 2.0 * chance);
  }
}
