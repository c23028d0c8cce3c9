// SPDX-License-Identifier: MIT
// Solid noise of all methods that have it: its statistics and the spectra of its planes, its slopes
// in space, and its filter, against the exemplar and against averages.
#include "bundle_of.h"
#include "example_exemplar.h"

#include <lichen/local_random_phase.h>
#include <lichen/multiple_kernels.h>
#include <lichen/noise_evaluator.h>
#include <lichen/quality.h>
#include <lichen/spectrum.h>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <evaluation/method_evaluator.h>
#include <random>
#include <span>
#include <string>
#include <utility>

using namespace lichen;

namespace {

constexpr int kTexels = 128;
using Vec3 = std::array<float, 3>;

LocalRandomPhaseOptions withoutStructure() {
  LocalRandomPhaseOptions options;
  options.structure = 0.0;
  return options;
}

constexpr std::array<Method, 2> kMethods{Method::localRandomPhase, Method::multipleKernels};

/// The noise of a set by a method that has solids.
Bundle baked(Method method, std::span<const MapExemplar> maps,
             GaussianOnly gaussian = GaussianOnly::no) {
  if (method == Method::multipleKernels) {
    MultipleKernelsOptions options;
    options.gaussian = gaussian;
    return test::bundleOf(bakeMultipleKernels("example", maps, options));
  }
  LocalRandomPhaseOptions options = withoutStructure();
  options.gaussian = gaussian;
  return test::bundleOf(bakeLocalRandomPhase("example", maps, options));
}

const Bundle& example(Method method) {
  static const std::array<Bundle, 2> bundles = [] {
    const MapExemplar map = test::threeMaterials(kTexels, kTexels, 3);
    return std::array<Bundle, 2>{baked(kMethods[0], {&map, 1}), baked(kMethods[1], {&map, 1})};
  }();
  return bundles[method == kMethods[0] ? 0 : 1];
}

shader::LichenTriplanarMaterial solidMaterial(const Bundle& bundle, std::uint32_t seed) {
  MaterialNoise material;
  material.mapping = Mapping::solid;
  material.seed = seed;
  return shaderMaterial(bundle, material, {});
}

/// The first channel on a plane of `side` texels, spanned by two unit vectors [standard
/// deviations].
std::vector<float> planeOf(const Bundle& bundle, std::uint32_t seed, int side, const Vec3& right,
                           const Vec3& down) {
  const auto evaluator = methodEvaluator(bundle, 0);
  const shader::LichenTriplanarMaterial constants = solidMaterial(bundle, seed);
  std::vector<float> plane;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      SolidFootprint at{{0.37f, 1.21f, -0.83f}, {}, {}};
      for (std::size_t k = 0; k < 3; ++k)
        at.position[k] += (float(x) * right[k] + float(y) * down[k]) / float(kTexels);
      plane.push_back(6.0f * (evaluator->gaussian(0, constants, at).value[0] - 0.5f));
    }
  return plane;
}

/// The three channels of a Gaussian value in standard deviations from the mean.
Eigen::Vector3d deviations(const std::array<float, 3>& value) {
  return 6.0 *
         (Eigen::Vector3d(double(value[0]), double(value[1]), double(value[2])).array() - 0.5);
}

/// The root mean square difference of two radial power spectra [dB].
double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0.0;
  for (std::size_t radius = 2; radius < a.size(); ++radius)
    squares += std::pow(10.0 * std::log10(a[radius] / b[radius]), 2.0);
  return std::sqrt(squares / double(a.size() - 2));
}

} // namespace

TEST_CASE("planes across z have the spectrum of the noise in the plane, and others nearly") {
  constexpr int kCrop = 32, kSide = 384;
  const Bundle& bundle = example(GENERATE(from_range(kMethods)));
  const auto evaluator = methodEvaluator(bundle, 0);
  const shader::LichenTriplanarMaterial flat = shaderMaterial(bundle, MaterialNoise(), {});
  std::vector<float> plane;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const TileFootprint at{{float(x) / float(kTexels), float(y) / float(kTexels)}, {}, {}};
      plane.push_back(6.0f * (evaluator->gaussian(0, flat, at).value[0] - 0.5f));
    }
  const std::vector<double> wanted = radialPowerSpectrum(plane, kSide, kSide, kCrop);
  const auto found = [&](const Vec3& right, const Vec3& down) {
    return distance(
        wanted, radialPowerSpectrum(planeOf(bundle, 1, kSide, right, down), kSide, kSide, kCrop));
  };
  CHECK(found({1, 0, 0}, {0, -1, 0}) < 0.5);
  CHECK(found({1, 0, 0}, {0, 0, 1}) < 1.5);
  CHECK(found({0, 1, 0}, {0, 0, 1}) < 1.5);
  const float half = std::sqrt(0.5f);
  CHECK(found({half, half, 0}, {0, 0, 1}) < 1.5);
  CHECK(found({half, 0, half}, {0, 1, 0}) < 1.5);
}

TEST_CASE("the slopes of a solid are the gradient of its height, along z too") {
  // A height and its slopes, one set: the same cosines and phases for both.
  constexpr float kRelief = 4.0f; // texels
  const MapExemplar color = test::threeMaterials(kTexels, kTexels, 3);
  MapExemplar height = color, slopes = color;
  const auto heightAt = [&](int x, int y) {
    const int row = (y + kTexels) % kTexels, column = (x + kTexels) % kTexels;
    return color.values[3 * std::size_t(row * kTexels + column)];
  };
  height.target = MapTarget::height;
  height.channels = {MapChannel::height};
  slopes.target = MapTarget::normal;
  slopes.channels = {MapChannel::slopeX, MapChannel::slopeY};
  height.encoding = ValueEncoding::linear;
  slopes.encoding = ValueEncoding::slope;
  height.values.clear();
  slopes.values.clear();
  for (int y = 0; y < kTexels; ++y)
    for (int x = 0; x < kTexels; ++x) {
      height.values.push_back(heightAt(x, y));
      slopes.values.push_back(0.5f * kRelief * (heightAt(x + 1, y) - heightAt(x - 1, y)));
      slopes.values.push_back(0.5f * kRelief * (heightAt(x, y - 1) - heightAt(x, y + 1)));
    }
  const Method method = GENERATE(from_range(kMethods));
  const auto [rotation, gaussian] =
      GENERATE(std::pair(0.0, GaussianOnly::yes), std::pair(0.7, GaussianOnly::yes),
               std::pair(0.0, GaussianOnly::no));
  const std::array<MapExemplar, 2> maps{height, slopes};
  const Bundle bundle = baked(method, maps, gaussian);
  MaterialNoise material;
  material.mapping = Mapping::solid;
  material.rotation = rotation;
  const auto evaluator = NoiseEvaluator::create(bundle, material).value();
  std::mt19937 generator(5u);
  std::uniform_real_distribution<float> place(-20.0f, 20.0f);
  std::array<double, 3> products{}, squares{}, differences{};
  double mixed = 0.0, alongZ = 0.0, acrossZ = 0.0; // of the gradient's own derivatives
  for (int sample = 0; sample < 20000; ++sample) {
    const SolidFootprint at{{place(generator), place(generator), place(generator)}, {}, {}};
    const auto gradient = evaluator->evaluate(1, at);
    for (std::size_t k = 0; k < 3; ++k) {
      SolidFootprint before = at, after = at;
      before.position[k] -= 1.0f / float(kTexels);
      after.position[k] += 1.0f / float(kTexels);
      const double difference =
          0.5 * double(kRelief) *
          (double(evaluator->evaluate(0, after)[0]) - double(evaluator->evaluate(0, before)[0]));
      if (sample % 8 == 0 && k < 2) {
        SolidFootprint below = at, above = at;
        below.position[2] -= 1.0f / float(kTexels);
        above.position[2] += 1.0f / float(kTexels);
        const double across =
            double(evaluator->evaluate(1, above)[k]) - double(evaluator->evaluate(1, below)[k]);
        const double along =
            double(evaluator->evaluate(1, after)[2]) - double(evaluator->evaluate(1, before)[2]);
        mixed += across * along;
        acrossZ += across * across;
        alongZ += along * along;
      }
      products[k] += double(gradient[k]) * difference;
      squares[k] += double(gradient[k]) * double(gradient[k]);
      differences[k] += difference * difference;
    }
  }
  std::array<double, 3> correlation{};
  for (std::size_t k = 0; k < 3; ++k) {
    INFO("axis " << k << ", rotation " << rotation << ", table " << (gaussian == GaussianOnly::no));
    correlation[k] = products[k] / std::sqrt(squares[k] * differences[k]);
    // Cosines of a set that are not in one phase with the height decorrelate, and tables more.
    // Kernels keep no phases between channels: their slopes are as steep as the height.
    if (method == Method::localRandomPhase)
      CHECK(correlation[k] > (gaussian == GaussianOnly::no ? 0.4 : 0.7));
    CHECK(std::sqrt(squares[k] / differences[k]) == Approx(1.0).margin(0.3));
  }
  // A gradient has no curl: it changes along z across z as it does across z along z.
  INFO(nameOf(method) << ", rotation " << rotation);
  // Kernels have no phases between channels, so less of that is left. The standard error is 0.014.
  CHECK(mixed / std::sqrt(alongZ * acrossZ) > (method == Method::localRandomPhase ? 0.45 : 0.15));
  if (method == Method::localRandomPhase)
    CHECK(correlation[2] > 0.45 * (correlation[0] + correlation[1]));
}

TEST_CASE("a pixel of a solid loses the variance that averages over it lose") {
  const Bundle& bundle = example(GENERATE(from_range(kMethods)));
  const auto evaluator = methodEvaluator(bundle, 0);
  const shader::LichenTriplanarMaterial constants = solidMaterial(bundle, 9);
  std::mt19937 generator(6u);
  std::uniform_real_distribution<float> place(-20.0f, 20.0f);
  std::normal_distribution<float> gaussian;
  for (const float texels : {2.0f, 6.0f, 20.0f}) {
    double averages = 0.0, filtered = 0.0, lost = 0.0, product = 0.0;
    constexpr int kSamples = 1500, kInner = 8;
    for (int sample = 0; sample < kSamples; ++sample) {
      SolidFootprint at{{place(generator), place(generator), place(generator)}, {}, {}};
      // A parallelogram in any direction, one side of which is half as long and slanted.
      Eigen::Vector3f right(gaussian(generator), gaussian(generator), gaussian(generator));
      right.normalize();
      const Eigen::Vector3f down =
          right
              .cross(Eigen::Vector3f(gaussian(generator), gaussian(generator), gaussian(generator)))
              .normalized();
      for (std::size_t k = 0; k < 3; ++k) {
        at.dx[k] = texels / float(kTexels) * right[Eigen::Index(k)];
        at.dy[k] =
            0.5f * texels / float(kTexels) * (down[Eigen::Index(k)] + right[Eigen::Index(k)]);
      }
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (int inner = 0; inner < kInner * kInner; ++inner) {
        const float u = (float(inner % kInner) + 0.5f) / kInner - 0.5f;
        const float v = (float(inner / kInner) + 0.5f) / kInner - 0.5f;
        SolidFootprint there{at.position, {}, {}};
        for (std::size_t k = 0; k < 3; ++k)
          there.position[k] += u * at.dx[k] + v * at.dy[k];
        mean +=
            deviations(evaluator->gaussian(0, constants, there).value) / double(kInner * kInner);
      }
      const MethodEvaluator::Gaussian pixel = evaluator->gaussian(0, constants, at);
      const Eigen::Vector3d own = deviations(pixel.value);
      averages += mean.squaredNorm() / (3.0 * kSamples);
      filtered += own.squaredNorm() / (3.0 * kSamples);
      product += own.dot(mean) / (3.0 * kSamples);
      lost += double(pixel.lost[0]) / kSamples;
    }
    INFO(texels << " texels: average " << averages << ", filtered " << filtered << ", lost "
                << lost);
    CHECK(filtered + lost == Approx(1.0).margin(0.05));
    // Averages keep the little that is left of a cosine beyond its first zero.
    CHECK(filtered == Approx(averages).margin(0.1));
    // A pixel attenuates a kernel and does not widen it. Those as small as a texel therefore differ
    // from their average.
    if (averages > 0.3)
      CHECK(product / std::sqrt(averages * filtered) >
            (bundle.noises[0].method() == Method::localRandomPhase ? 0.95 : 0.88));
  }
}

TEST_CASE("scale and offset move a solid") {
  const MapExemplar map = test::threeMaterials(64, 48, 3); // no square
  const Bundle bundle = baked(GENERATE(from_range(kMethods)), {&map, 1});
  const auto evaluator = methodEvaluator(bundle, 0);
  std::mt19937 generator(6u);
  std::uniform_real_distribution<float> metres(-0.5f, 0.5f);
  for (const double rotation : {0.0, 0.7}) {
    MaterialNoise own;
    own.mapping = Mapping::solid;
    own.rotation = rotation;
    own.scale = 0.5; // tiles of half a metre
    MaterialNoise shifted = own, atTwice = own;
    shifted.offset = {0.25, -31.5};
    atTwice.scale = 1.0;
    const auto constants = [&](const MaterialNoise& material) {
      return shaderMaterial(bundle, material, {});
    };
    for (int k = 0; k < 100; ++k) {
      const SolidFootprint at{{metres(generator), metres(generator), metres(generator)}, {}, {}};
      const auto same = [&](const shader::LichenTriplanarMaterial& a, const SolidFootprint& atA,
                            const shader::LichenTriplanarMaterial& b, const SolidFootprint& atB) {
        const auto first = evaluator->gaussian(0, a, atA).value;
        const auto second = evaluator->gaussian(0, b, atB).value;
        for (std::size_t c = 0; c < 3; ++c)
          CHECK(double(first[c]) == Approx(double(second[c])).margin(4e-3));
      };
      SolidFootprint doubled = at, offset = at;
      for (float& coordinate : doubled.position)
        coordinate *= 2.0f;
      same(constants(own), at, constants(atTwice), doubled);
      // The offset in metres to the right and down, rotated back; tiles are as high as 48 / 64.
      const double x = 0.25 * 0.5, y = -31.5 * 0.5 * 48.0 / 64.0;
      offset.position[0] += float(std::cos(rotation) * x - std::sin(rotation) * y);
      offset.position[1] -= float(std::sin(rotation) * x + std::cos(rotation) * y);
      same(constants(shifted), at, constants(own), offset);
    }
  }
}

TEST_CASE("a noise of a plane is refused in a solid, by name") {
  const MapExemplar map = test::threeMaterials(64, 64, 3);
  LocalRandomPhaseOptions structured;
  structured.structure = 0.5;
  MultipleKernelsOptions sinc;
  sinc.window = KernelWindow::sinc;
  const std::string refusal = "noise 'x' does not fit the mapping solid: ";
  MaterialNoise material;
  material.mapping = Mapping::solid;
  for (const auto& [bundle, reason] :
       {std::pair(test::bundleOf(bakeLocalRandomPhase("x", {&map, 1}, structured)),
                  "it has a structure, which lies in a plane"),
        std::pair(test::bundleOf(bakeMultipleKernels("x", {&map, 1}, sinc)),
                  "its kernels have a window on a square, and in solids all have gabor")}) {
    const auto refused = NoiseEvaluator::create(bundle, material);
    REQUIRE(!refused);
    CHECK(refused.error().kind == ErrorKind::usage);
    CHECK(refused.error().message == refusal + reason);
  }
}
