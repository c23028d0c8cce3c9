// SPDX-License-Identifier: MIT
// Texton coefficients against the definitions and against the papers' algorithm.
#include "example_exemplar.h"
#include "papers_texton.h"

#include <lichen/spectrum.h>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <numbers>
#include <texton/border_penalty.h>
#include <texton/coefficients.h>
#include <texton/fit.h>
#include <texton/gaussian_model.h>
#include <vector>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::texton;

namespace {

texton::GaussianModel modelOf(const MapExemplar& map) {
  return texton::gaussianModel(map.values, map.width, map.height, int(map.channels.size()));
}

FitOptions support(int side, int order = 1) {
  FitOptions options;
  options.width = side;
  options.height = side;
  options.order = order;
  return options;
}

/// ALGORITHMS section 2, term by term over the full plane, in double precision.
double errorByDefinition(const texton::GaussianModel& model, const TextonCoefficients& texton,
                         int order) {
  double distance = 0.0;
  double total = 0.0;
  const int width = model.width();
  const int height = model.height();
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      if (u == 0 && v == 0)
        continue;
      const double kernel =
          std::sqrt(kernelPower(order, double(u) / width) * kernelPower(order, double(v) / height));
      std::complex<double> product = 0.0;
      for (int c = 0; c < texton.channels; ++c) {
        const HalfSpectrum& half = model.channels[std::size_t(c)];
        const std::complex<double> t =
            u < half.columns()
                ? std::complex<double>(half.at(u, v))
                : std::conj(std::complex<double>(half.at(width - u, (height - v) % height)));
        std::complex<double> h = 0.0;
        for (int y = 0; y < texton.height; ++y)
          for (int x = 0; x < texton.width; ++x)
            h += double(texton.values[std::size_t((c * texton.height + y) * texton.width + x)]) *
                 std::polar(kernel, -2.0 * std::numbers::pi *
                                        (double(u) * x / width + double(v) * y / height));
        distance += std::norm(h) + std::norm(t);
        total += std::norm(t);
        product += std::conj(h) * t;
      }
      distance -= 2.0 * std::abs(product);
    }
  }
  return std::sqrt(distance / total);
}

/// The covariance matrix of all pixels and channels of a model's texture: kernels correlated on the
/// torus, pixel by pixel.
Eigen::MatrixXd covarianceMatrix(const texton::GaussianModel& model) {
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

} // namespace

TEST_CASE("the kernel's autocorrelation is the sampled B-spline of twice the degree and one") {
  // [UAE93] table 1 for degree 3; the others by numerical integration of products of splines.
  CHECK(kernelAutocorrelation(0) == std::vector<double>{1.0});
  for (int order = 1; order <= 4; ++order) {
    const std::vector<double> b = kernelAutocorrelation(order);
    REQUIRE(b.size() == std::size_t(order) + 1);
    // Samples of a spline of degree d, the (d + 1)-fold convolution of a box, by Riemann sums.
    constexpr int kStepsPerTexel = 64;
    std::vector<double> spline(kStepsPerTexel, 1.0);
    for (int degree = 1; degree <= 2 * order + 1; ++degree) {
      std::vector<double> next(spline.size() + kStepsPerTexel - 1, 0.0);
      for (std::size_t i = 0; i < spline.size(); ++i)
        for (std::size_t j = 0; j < kStepsPerTexel; ++j)
          next[i + j] += spline[i] / kStepsPerTexel;
      spline = next;
    }
    // The variance of a box of n samples is 1 / (12 n^2) less than of one of length 1. The
    // error is half of that for each box times the spline's second derivative, at most 2. The next
    // order is n^-4.
    const double tolerance =
        1.01 * double(2 * order + 2) / (12.0 * kStepsPerTexel * kStepsPerTexel);
    for (int j = 0; j <= order; ++j) {
      const std::size_t middle = (spline.size() - 1) / 2 + std::size_t(j * kStepsPerTexel);
      CHECK(b[std::size_t(j)] == Approx(spline[middle]).margin(tolerance));
    }
  }
  CHECK(kernelPower(1, 0.0) == Approx(1.0));
  CHECK(kernelPower(3, 0.0) == Approx(1.0));
  CHECK(kernelPower(1, 0.5) == Approx(1.0 / 3.0)); // [GLM17]: (2 + cos 2 pi x) / 3
}

TEST_CASE("the transport distance is Gelbrich's formula on the covariance matrices of all pixels") {
  // tr A + tr B - 2 tr (A^1/2 B A^1/2)^1/2 [PC19], for odd and even sides.
  const MapExemplar map = threeMaterials(32, 32, 5);
  for (const auto& [width, height] : {std::pair{5, 4}, std::pair{6, 3}}) {
    const texton::GaussianModel a = modelOf(cropped(map, 1, 2, width, height));
    const texton::GaussianModel b = modelOf(cropped(map, 17, 11, width, height));
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

TEST_CASE("the relative model error is its definition, for every order and odd sizes") {
  const MapExemplar map = cropped(threeMaterials(32, 32, 5), 3, 4, 21, 18);
  const texton::GaussianModel model = modelOf(map);
  for (const int order : {0, 1, 3}) {
    FitOptions options = support(7, order);
    options.height = 5;
    for (const TextonCoefficients& texton :
         {fitCoefficients(model, options), papersTexton(model, options)}) {
      // Rounding of float coefficients and transforms: 1e-6 of the power.
      CHECK(relativeModelError(model, texton, order) ==
            Approx(errorByDefinition(model, texton, order)).epsilon(1e-4));
    }
  }
}

namespace {

/// With the model's covariance, as the papers' textons have it.
TextonCoefficients corrected(const texton::GaussianModel& model, TextonCoefficients texton,
                             int order) {
  REQUIRE(correctCovariance(texton, order, texton::modelCovariance(model)));
  return texton;
}

} // namespace

TEST_CASE(
    "a texton of 32 or 64 texels is nearer to the model than the papers' algorithm finds, one "
    "of 16 as near, and neither has a border") {
  // Three materials in patches of some 20 texels: slow waves that reach beyond the supports.
  const texton::GaussianModel model = modelOf(threeMaterials(128, 128, 7, 6));
  struct Bound {
    int side;
    double papers;     // error relative to the papers' algorithm
    double visibility; // of the border, mean over the starts
  };
  // The least error that the starts reach has no closed form. If the model changes by a float's
  // rounding, as with another machine's transforms, the ratios of the worst order are 1.0008,
  // 0.9831 and 0.9815, with standard deviations of 0.0009, 0.0008 and 0.0011; the bounds are four
  // of these above. The visibilities are 0.73, 1.02 and 1.56, with standard deviations of 0.02,
  // 0.04 and 0.06; without the border's penalty 0.9 and 1.2, 1.1 and 1.4, 2.5 and 2.0 for the
  // orders 0 and 1.
  for (const Bound& bound :
       {Bound{16, 1.0045, 0.81}, Bound{32, 0.9863, 1.05}, Bound{64, 0.9859, 1.7}}) {
    for (const int order : {0, 1, 3}) {
      double ours = 0.0, papers = 0.0, visibility = 0.0;
      for (const std::uint32_t seed : {1u, 2u, 3u}) {
        FitOptions options = support(bound.side - order, order);
        options.seed = seed;
        const TextonCoefficients texton = corrected(model, fitCoefficients(model, options), order);
        ours += relativeModelError(model, texton, order);
        papers +=
            relativeModelError(model, corrected(model, papersTexton(model, options), order), order);
        visibility += borderVisibility(texton) / 3.0;
        CHECK(flatness(texton, kLuminanceWeights) <= 4.0);
      }
      INFO("order " << order << ", support " << bound.side);
      CHECK(ours < bound.papers * papers);
      CHECK(visibility < bound.visibility);
    }
  }
}

TEST_CASE("a nearly grey texton gets the covariance of another nearly grey exemplar") {
  // Like scanned letters. The deviation from grey has 1e-7 of the variance of one exemplar and 2e-6
  // of the other's, and their product counts as zero variance.
  const texton::GaussianModel model = modelOf(threeMaterials(64, 64, 7, 6));
  TextonCoefficients texton = fitCoefficients(model, support(23));
  const std::size_t texels = texton.values.size() / 3;
  for (std::size_t i = 0; i < texels; ++i)
    for (std::size_t c = 1; c < 3; ++c)
      texton.values[c * texels + i] = texton.values[i] + 1e-2f * texton.values[c * texels + i];
  const double variance = noiseCovariance(texton, 1)(0, 0);
  Eigen::MatrixXd wanted = Eigen::MatrixXd::Constant(3, 3, variance);
  wanted.diagonal().array() += 2e-6 * variance;
  REQUIRE(correctCovariance(texton, 1, wanted));
  CHECK((noiseCovariance(texton, 1) - wanted).cwiseAbs().maxCoeff() <= 1.01e-6 * variance);
}

TEST_CASE("the visibility of a border is the mean step across it over that inside") {
  // Steps averaged along runs of a quarter of the side, term by term.
  TextonCoefficients texton{9, 8, 1, {}};
  for (int i = 0; i < 72; ++i)
    texton.values.push_back(float(i * i % 11) - 3.0f);
  const auto at = [&](int x, int y) {
    const bool isInside = x >= 0 && y >= 0 && x < 9 && y < 8;
    return isInside ? double(texton.values[std::size_t(y * 9 + x)]) : 0.0;
  };
  double border = 0.0, inside = 0.0;
  constexpr int kRun = 2; // a quarter of 8, and of 9 rounded
  for (int x = 0; x <= 9; ++x)
    for (int y = 0; y + kRun <= 8; ++y) {
      const double step = (at(x, y) + at(x, y + 1) - at(x - 1, y) - at(x - 1, y + 1)) / kRun;
      (x == 0 || x == 9 ? border : inside) += step * step / 7 / (x == 0 || x == 9 ? 2 : 8);
    }
  for (int y = 0; y <= 8; ++y)
    for (int x = 0; x + kRun <= 9; ++x) {
      const double step = (at(x, y) + at(x + 1, y) - at(x, y - 1) - at(x + 1, y - 1)) / kRun;
      (y == 0 || y == 8 ? border : inside) += step * step / 8 / (y == 0 || y == 8 ? 2 : 7);
    }
  CHECK(borderVisibility(texton) == Approx(std::sqrt(border / inside)).epsilon(1e-5));
}

TEST_CASE("no material's texton has few bright texels, whatever its spectrum") {
  // A few dots on grey: the texton of least error would be a dot, and the noise would be single
  // dots.
  MapExemplar dots = threeMaterials(64, 64, 21);
  std::fill(dots.values.begin(), dots.values.end(), 0.5f);
  for (const std::size_t pixel : {517u, 1840u, 3033u})
    std::fill_n(dots.values.begin() + std::ptrdiff_t(3 * pixel), 3, 1.0f);
  for (const int order : {0, 1, 3})
    CHECK(flatness(fitCoefficients(modelOf(dots), support(24, order)), kLuminanceWeights) <= 4.0);
}

TEST_CASE("a support as large as the exemplar reproduces the model with the papers' algorithm, and "
          "up to the cost of flatness with ours") {
  const texton::GaussianModel model = modelOf(threeMaterials(24, 20, 9));
  struct Cost {
    int order;
    double error;
  };
  // Any phases fit, but most have peaks and a visible border. The error that the limits on these
  // leave has no closed form: 0.021552, 0.009673 and 0.000397, also for a model changed by a
  // float's rounding.
  for (const auto& [order, cost] : {Cost{0, 0.0216}, Cost{1, 0.0097}, Cost{3, 0.0004}}) {
    FitOptions options = support(24, order);
    options.height = 20;
    // Rounding of floats, 2^-24 each, after 50 forward and inverse transforms.
    CHECK(relativeModelError(model, papersTexton(model, options), order) < 1e-6);
    CHECK(relativeModelError(model, fitCoefficients(model, options), order) < cost);
  }
}

TEST_CASE("an exemplar of one colour has a texton of zeros, without an error") {
  MapExemplar map = threeMaterials(16, 16, 3);
  std::fill(map.values.begin(), map.values.end(), 0.25f);
  const texton::GaussianModel model = modelOf(map);
  const TextonCoefficients texton = fitCoefficients(model, support(8));
  for (const float value : texton.values)
    CHECK(std::abs(value) < 1e-6f);
  CHECK(relativeModelError(model, texton, 1) == 0.0);
}
