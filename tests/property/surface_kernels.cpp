// SPDX-License-Identifier: MIT
// Multiple-kernels noise on surfaces: its covariance in tangent planes and the number of its
// impacts, against closed forms.
#include "bundle_of.h"
#include "example_exemplar.h"

#include <lichen/multiple_kernels.h>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <evaluation/method_evaluator.h>
#include <multiple_kernels/kernel.h>
#include <numbers>
#include <random>

using namespace lichen;
using namespace lichen::multiple_kernels;

namespace {

constexpr int kWidth = 96, kHeight = 64;
constexpr double kAspect = double(kWidth) / kHeight;

Bundle bundleOf(KernelWindow window) {
  const MapExemplar map = test::threeMaterials(kWidth, kHeight, 3);
  MultipleKernelsOptions options;
  options.kernels = 5;
  options.window = window;
  Bundle bundle = test::bundleOf(bakeMultipleKernels("example", {&map, 1}, options));
  bundle.materials = {MaterialNoise()};
  bundle.materials[0]->mapping = Mapping::surface;
  return bundle;
}

std::vector<KernelRow> rowsOf(const Bundle& bundle) {
  const Noise& noise = bundle.noises[0];
  return kernelRows(bundle.tables[noise.maps[0].as<MultipleKernelsMap>().kernels],
                    noise.as<MultipleKernelsNoise>());
}

/// The correlation of a kernel's window with itself at a distance in its coordinates, by
/// quadrature.
double windowCorrelation(KernelWindow window, double p, double q) {
  constexpr int kSide = 200;
  double both = 0.0, squares = 0.0;
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      const double x = (2.0 * i + 1.0) / kSide - 1.0, y = (2.0 * j + 1.0) / kSide - 1.0;
      const double value = windowAt(window, x, y);
      squares += value * value;
      both += value * windowAt(window, x + p, y + q);
    }
  return both / squares;
}

/// The covariance of the first channel at a distance [tiles].
double expectedCovariance(const Bundle& bundle, double dx, double dy) {
  const KernelWindow window = bundle.noises[0].as<MultipleKernelsNoise>().window;
  double sum = 0.0;
  for (const KernelRow& row : rowsOf(bundle)) {
    double own = 0.0;
    for (const float factor : row.colors[0])
      own += double(factor) * double(factor);
    const auto& q = row.toWindow;
    sum += own * windowCorrelation(window, q[0] * dx + q[1] * dy, q[2] * dx + q[3] * dy) *
           std::cos(2.0 * std::numbers::pi * (row.frequency[0] * dx + row.frequency[1] * dy));
  }
  return sum;
}

} // namespace

TEST_CASE("on any tangent plane kernels have the covariance of the plane") {
  for (const KernelWindow window : {KernelWindow::gabor, KernelWindow::gaussianSinc}) {
    const Bundle bundle = bundleOf(window);
    const auto evaluator = methodEvaluator(bundle, 0);
    const shader::LichenTriplanarMaterial material =
        shaderMaterial(bundle, *bundle.materials[0], {});
    // In texels. The exemplar's features are several texels wide.
    const std::array<std::array<double, 2>, 4> distances{
        {{0.0, 0.0}, {3.0, 0.0}, {0.0, 4.0}, {-5.0, 7.0}}};
    std::array<double, 4> sums{}, squares{};
    constexpr int kPlaces = 6000;
    std::mt19937 generator(5u);
    std::normal_distribution<float> gaussian;
    std::uniform_real_distribution<float> tiles(-500.0f, 500.0f);
    for (int place = 0; place < kPlaces; ++place) {
      SurfaceFootprint at;
      for (std::size_t k = 0; k < 3; ++k) {
        at.position[k] = tiles(generator);
        at.normal[k] = gaussian(generator);
        at.tangent[k] = gaussian(generator);
      }
      at.tangent[3] = 1.0f;
      // In a right-handed tangent frame, whose bitangent points up.
      const Eigen::Vector3f outward = Eigen::Vector3f(at.normal.data()).normalized();
      const Eigen::Vector3f tangent(at.tangent.data());
      const Eigen::Vector3f right = (tangent - outward.dot(tangent) * outward).normalized();
      const Eigen::Vector3f down = right.cross(outward);
      const double here = double(evaluator->gaussian(0, material, at).value[0]) - 0.5;
      for (std::size_t d = 0; d < distances.size(); ++d) {
        SurfaceFootprint there = at;
        for (std::size_t k = 0; k < 3; ++k)
          there.position[k] += float(distances[d][0] / kWidth * double(right[Eigen::Index(k)]) +
                                     distances[d][1] / kWidth * double(down[Eigen::Index(k)]));
        const double value =
            here * (double(evaluator->gaussian(0, material, there).value[0]) - 0.5);
        sums[d] += value / kPlaces;
        squares[d] += value * value / kPlaces;
      }
    }
    for (std::size_t d = 0; d < distances.size(); ++d) {
      const double expected =
          expectedCovariance(bundle, distances[d][0] / kWidth, distances[d][1] / kHeight);
      INFO(nameOf(window) << " at " << distances[d][0] << ", " << distances[d][1] << ": " << sums[d]
                          << " of " << expected);
      // 5 standard errors, alpha 6e-7. Texels are square, in the plane too.
      CHECK(std::abs(sums[d] - expected) <
            5.0 * std::sqrt((squares[d] - sums[d] * sums[d]) / kPlaces));
    }
  }
}
