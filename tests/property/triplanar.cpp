// SPDX-License-Identifier: MIT
// Triplanar noise: the exemplar's variance and histogram for any normal, the noise of texture
// coordinates where one plane has all the weight, and the same pattern from any tile origin.
#include "example_exemplar.h"

#include <lichen/tiling.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <evaluation/method_evaluator.h>
#include <random>

using namespace lichen;
using namespace lichen::test;

namespace {

using Vec3 = std::array<float, 3>;

/// A tiling noise and its evaluator, for a material with any mapping.
struct Tiling {
  Tiling() : bundle(baked()), evaluator(methodEvaluator(bundle, 0)) {}

  static Bundle baked() {
    const MapExemplar map = threeMaterials(128, 96, 11);
    TilingOptions options;
    options.bits = 16;
    Result<TilingBake> bake = bakeTiling("example", {&map, 1}, options);
    REQUIRE(bake);
    Bundle bundle;
    bundle.tables = std::move(bake.value().tables);
    bundle.noises = {std::move(bake.value().noise)};
    bundle.noises[0].tileSizeMetres = 0.5;
    return bundle;
  }

  Bundle bundle;
  std::shared_ptr<const MethodEvaluator> evaluator;
};

const Tiling& tiling() {
  static const Tiling noise;
  return noise;
}

MaterialNoise triplanarMaterial() {
  MaterialNoise material;
  material.mapping = Mapping::triplanar;
  return material;
}

/// Values at random positions of a surface, far enough apart to be independent.
template <class ValueAt>
std::vector<double> samples(const Vec3& normal, const ValueAt& valueAt) {
  constexpr std::size_t kCount = 4000;
  std::mt19937 generator(3u);
  std::uniform_real_distribution<float> metres(-200.0f, 200.0f);
  std::vector<double> values;
  for (std::size_t k = 0; k < kCount; ++k) {
    TriplanarFootprint at;
    for (float& coordinate : at.position)
      coordinate = metres(generator);
    at.normal = normal;
    values.push_back(double(valueAt(at)[0]));
  }
  std::sort(values.begin(), values.end());
  return values;
}

double varianceOf(const std::vector<double>& values) {
  double sum = 0.0, squares = 0.0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  const double n = double(values.size());
  return squares / n - sum * sum / (n * n);
}

/// The greatest difference of two distribution functions, from equally many sorted values.
double kolmogorovSmirnov(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0.0;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    (a[i] <= b[j] ? i : j) += 1;
    most = std::max(most, std::abs(double(i) - double(j)) / double(a.size()));
  }
  return most;
}

/// One plane, two and three planes of equal weight, and three of different weights.
const Vec3 kNormals[] = {
    {0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 0.0f}, {-1.0f, 1.0f, 1.0f}, {0.9f, -1.0f, 0.8f}};

} // namespace

TEST_CASE("variance and histogram are those of one plane for every normal, unlike linear triplanar "
          "blending") {
  const Tiling& t = tiling();
  const shader::LichenTriplanarMaterial use = shaderMaterial(t.bundle, triplanarMaterial(), {});
  const auto blended = [&](const TriplanarFootprint& at) {
    return t.evaluator->evaluate(0, use, at);
  };
  const auto plain = [&](const TriplanarFootprint& at) {
    const float most =
        std::max({std::abs(at.normal[0]), std::abs(at.normal[1]), std::abs(at.normal[2])});
    MethodEvaluator::Value sum{};
    float weights = 0.0f;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      TriplanarFootprint along = at;
      along.normal = {};
      along.normal[axis] = 1.0f; // all the weight
      const auto value = blended(along);
      const float weight = std::pow(std::abs(at.normal[axis]) / most, use.material.planeSharpness);
      for (std::size_t c = 0; c < 4; ++c)
        sum[c] += weight * value[c];
      weights += weight;
    }
    for (float& value : sum)
      value /= weights;
    return sum;
  };
  const std::vector<double> one = samples(kNormals[0], blended);
  for (std::size_t k = 1; k < std::size(kNormals); ++k) {
    INFO("normal " << k);
    const std::vector<double> many = samples(kNormals[k], blended);
    // For 4000 values with at most a Gaussian's kurtosis, the ratio of variances has a standard
    // error of sqrt(2 * 2 / 4000) = 3.2 %. The limit is five of these.
    CHECK(varianceOf(many) / varianceOf(one) == Approx(1.0).margin(0.16));
    // Kolmogorov-Smirnov, false alarms of 1e-6: sqrt(ln(2e6) / 2) sqrt(2 / 4000) = 0.060.
    CHECK(kolmogorovSmirnov(many, one) < 0.060);
    const std::vector<double> averaged = samples(kNormals[k], plain);
    CHECK(varianceOf(averaged) / varianceOf(one) < 0.7);
    CHECK(kolmogorovSmirnov(averaged, one) > 0.060);
  }
}

TEST_CASE("where one plane has all the weight, the noise is that of its texture coordinates") {
  const Tiling& t = tiling();
  MaterialNoise material = triplanarMaterial();
  material.scale = 1.3;
  material.offset = {0.25, -3.5};
  material.seed = 77;
  const shader::LichenTriplanarMaterial use = shaderMaterial(t.bundle, material, {});
  // Plane 0 has the seed word of texture coordinates.
  material.mapping = Mapping::uv;
  const shader::LichenTriplanarMaterial flat = shaderMaterial(t.bundle, material, {});
  std::mt19937 generator(5u);
  std::uniform_real_distribution<float> metres(-3.0f, 3.0f);
  const float aspect = 128.0f / 96.0f;
  for (int k = 0; k < 200; ++k) {
    TriplanarFootprint at;
    for (float& coordinate : at.position)
      coordinate = metres(generator);
    at.normal = {k % 2 == 0 ? 2.0f : -2.0f, 0.7f, -0.5f};
    // A tile is half a metre wide, times the scale; right is -z, down is -y.
    TileFootprint uv;
    uv.position = {-at.position[2] / (0.5f * 1.3f), -at.position[1] / (0.5f * 1.3f) * aspect};
    const auto expected = t.evaluator->evaluate(0, flat, uv);
    const auto value = t.evaluator->evaluate(0, use, at);
    for (std::size_t c = 0; c < 4; ++c)
      // Positions of 10 tiles, rounded to 2^-20 of a tile of 128 texels.
      REQUIRE(value[c] == Approx(expected[c]).margin(2e-3));
  }
}

TEST_CASE("the pattern does not depend on the tile origin") {
  const Tiling& t = tiling();
  for (const double rotation : {0.0, 0.7}) {
    MaterialNoise material = triplanarMaterial();
    material.rotation = rotation;
    Placement near;
    near.tileOriginX = 10000000;
    near.tileOriginY = -9999999;
    near.tileOriginZ = 123456789;
    Placement far = near;
    far.tileOriginX += 3;
    far.tileOriginY -= 2;
    far.tileOriginZ += 7;
    const shader::LichenTriplanarMaterial planesNear = shaderMaterial(t.bundle, material, near);
    const shader::LichenTriplanarMaterial planesFar = shaderMaterial(t.bundle, material, far);
    std::mt19937 generator(6u);
    std::uniform_real_distribution<float> metres(-0.5f, 0.5f);
    std::normal_distribution<float> gaussian;
    for (int k = 0; k < 200; ++k) {
      TriplanarFootprint at;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        at.position[axis] = metres(generator);
        at.normal[axis] = gaussian(generator);
      }
      const auto expected = t.evaluator->evaluate(0, planesFar, at);
      // Tiles of half a metre.
      at.position[0] += 1.5f;
      at.position[1] -= 1.0f;
      at.position[2] += 3.5f;
      const auto value = t.evaluator->evaluate(0, planesNear, at);
      for (std::size_t c = 0; c < 4; ++c)
        REQUIRE(value[c] == Approx(expected[c]).margin(4e-3));
    }
  }
}
