// SPDX-License-Identifier: MIT
// Triplanar noise, tested through the CPU twin: the exemplar's variance and histogram for any
// normal, the noise of texture coordinates where one plane has all the weight, gradients of a
// height in space, and the same pattern from any tile origin.
#include "checkout_paths.h"
#include "example_exemplar.h"
#include "synthetic_texton.h"
#include "triplanar/planes.h"

#include <lichen/texton_evaluate.h>
#include <lichen/tiling.h>
#include <lichen/tiling_evaluate.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

using namespace lichen;
using namespace lichen::test;

namespace {

using Vec3 = std::array<float, 3>;

/// A tiling noise and its CPU twin, for a material with any mapping.
struct Tiling {
  Tiling() : bundle(baked()), twin(TilingEvaluator::create(bundle, 0).value()) {}

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
  TilingEvaluator twin;
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
  const auto blended = [&](const TriplanarFootprint& at) { return t.twin.evaluate(0, use, at); };
  const auto plain = [&](const TriplanarFootprint& at) {
    TilingEvaluator::Value sum{};
    float weights = 0.0f;
    for (const triplanar::Plane& plane : triplanar::planesAt(at, use, shaderNoise(t.bundle, 0))) {
      const auto value = t.twin.evaluate(0, plane.material, plane.at);
      for (std::size_t c = 0; c < 4; ++c)
        sum[c] += plane.weight * value[c];
      weights += plane.weight;
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
  const shader::LichenMaterial flat = shaderMaterial(t.bundle, material, {}).material;
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
    const auto expected = t.twin.evaluate(0, flat, uv);
    const auto value = t.twin.evaluate(0, use, at);
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
      const auto expected = t.twin.evaluate(0, planesFar, at);
      // Tiles of half a metre.
      at.position[0] += 1.5f;
      at.position[1] -= 1.0f;
      at.position[2] += 3.5f;
      const auto value = t.twin.evaluate(0, planesNear, at);
      for (std::size_t c = 0; c < 4; ++c)
        REQUIRE(value[c] == Approx(expected[c]).margin(4e-3));
    }
  }
}

TEST_CASE("the gradient in space is that of the blended height") {
  // Order 3, whose derivatives are continuous; a tile is 0.8 m wide.
  const SyntheticTexton source{.order = 3, .channels = 1};
  Bundle bundle = syntheticTextonBundle(source).bundle;
  bundle.noises[0].tileSizeMetres = 0.8;
  const TextonEvaluator twin = TextonEvaluator::create(bundle, 0).value();
  MaterialNoise material = triplanarMaterial();
  material.rotation = 0.4;
  material.planeSharpness = 2.0;
  const shader::LichenTriplanarMaterial use = shaderMaterial(bundle, material, {});
  const shader::LichenNoise noise = shaderNoise(bundle, 0);
  const double deviation = bundle.noises[0].maps[0].as<TextonMap>().scale[0];
  std::mt19937 generator(8u);
  std::uniform_real_distribution<float> metres(-1.0f, 1.0f);
  std::normal_distribution<float> gaussian;
  for (int k = 0; k < 100; ++k) {
    TriplanarFootprint at;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at.position[axis] = metres(generator);
      at.normal[axis] = gaussian(generator);
    }
    // Slopes of a height in metres: to the right, and upwards, against y.
    const float tilesPerMetre = 1.0f / 0.8f;
    const auto slopes =
        triplanar::blendedSlopes(triplanar::planesAt(at, use, noise), [&](const auto& plane) {
          const auto d = twin.gradient(0, plane.material, plane.at);
          return std::array<float, 4>{d[1] * tilesPerMetre,
                                      -d[2] * tilesPerMetre * noise.tileAspect, 0.0f, 0.0f};
        });
    for (std::size_t axis = 0; axis < 3; ++axis) {
      constexpr float kStep = 4e-4f; // metres, a thirtieth of a texel
      const auto heightAt = [&](float step) {
        TriplanarFootprint moved = at;
        moved.position[axis] += step;
        return (double(twin.gaussian(0, use, moved)[0]) - 0.5) * deviation;
      };
      const double difference = (heightAt(kStep) - heightAt(-kStep)) / (2.0 * double(kStep));
      // Gradients are up to 20. Sums are rounded by some 1e-5 of 0.1, over 8e-4 m; the third
      // derivative over a thirtieth of a texel adds to that.
      REQUIRE(double(slopes[axis]) == Approx(difference).margin(0.05));
    }
  }
}

TEST_CASE("the frames of the planes are right-handed and look along x, y and z") {
  const shader::LichenTriplanarMaterial use =
      shaderMaterial(tiling().bundle, triplanarMaterial(), {});
  TriplanarFootprint at;
  at.normal = {1.0f, 1.0f, 1.0f};
  const std::array<triplanar::Plane, 3> planes =
      triplanar::planesAt(at, use, shaderNoise(tiling().bundle, 0));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& [right, up] = planes[axis].axes;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      CHECK(right[a] * up[b] - right[b] * up[a] == (k == axis ? 1.0f : 0.0f));
    }
  }
}

namespace {

const nlohmann::json& vectors() {
  static const nlohmann::json file = [] {
    std::ifstream stream(sourcePath("docs/gltf_extension/test_vectors.json"));
    return nlohmann::json::parse(stream);
  }();
  return file;
}

/// A texton noise whose tiles have these texels, for a material that a test vector describes.
struct Textons {
  explicit Textons(const nlohmann::json& v)
      : bundle(syntheticTextonBundle({.texelsPerTileX = v["texelsPerTile"][0],
                                      .texelsPerTileY = v["texelsPerTile"][1]})
                   .bundle) {
    material = triplanarMaterial();
    material.rotation = v["rotation"];
  }
  Bundle bundle;
  MaterialNoise material;
};

} // namespace

TEST_CASE("weights, positions and gradients of planes match the published test vectors") {
  for (const nlohmann::json& v : vectors()["planeWeights"]) {
    shader::LichenTriplanarMaterial use = shaderMaterial(tiling().bundle, triplanarMaterial(), {});
    use.material.planeSharpness = v["planeSharpness"];
    TriplanarFootprint at;
    at.normal = v["normal"].get<Vec3>();
    const std::array<triplanar::Plane, 3> planes =
        triplanar::planesAt(at, use, shaderNoise(tiling().bundle, 0));
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK(double(planes[axis].weight) == Approx(v["weights"][axis].get<double>()).margin(1e-5));
  }
  for (const nlohmann::json& v : vectors()["planePlaces"]) {
    Textons textons(v);
    textons.material.scale = v["scale"];
    textons.bundle.noises[0].tileSizeMetres = v["tileSize"];
    TriplanarFootprint at;
    at.position = v["position"].get<Vec3>();
    at.normal = {1.0f, 1.0f, 1.0f};
    const std::array<triplanar::Plane, 3> planes = triplanar::planesAt(
        at, shaderMaterial(textons.bundle, textons.material, {}), shaderNoise(textons.bundle, 0));
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t k = 0; k < 2; ++k)
        CHECK(double(planes[axis].at.position[k]) ==
              Approx(v["tiles"][axis][k].get<double>()).margin(1e-5));
  }
  for (const nlohmann::json& v : vectors()["planeGradients"]) {
    MaterialNoise material = triplanarMaterial();
    material.rotation = v["rotation"];
    TriplanarFootprint at;
    at.normal = {1.0f, 1.0f, 1.0f};
    std::array<triplanar::Plane, 3> planes = triplanar::planesAt(
        at, shaderMaterial(tiling().bundle, material, {}), shaderNoise(tiling().bundle, 0));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t other = 0; other < 3; ++other)
        planes[other].weight = other == axis ? 1.0f : 0.0f;
      const auto gradient = triplanar::blendedSlopes(planes, [&](const triplanar::Plane&) {
        return std::array<float, 4>{v["slopes"][0], v["slopes"][1], 0.0f, 0.0f};
      });
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(double(gradient[k]) == Approx(v["gradients"][axis][k].get<double>()).margin(1e-6));
    }
  }
}

TEST_CASE("the origins of planes match the published test vectors") {
  for (const nlohmann::json& v : vectors()["planeOrigins"]) {
    Textons textons(v);
    textons.material.offset = v["offset"].get<std::array<double, 2>>();
    Placement placement;
    placement.tileOriginX = v["tileOrigin"][0];
    placement.tileOriginY = v["tileOrigin"][1];
    placement.tileOriginZ = v["tileOrigin"][2];
    const shader::LichenTriplanarMaterial use =
        shaderMaterial(textons.bundle, textons.material, placement);
    const shader::LichenMaterial& x = use.material;
    const shader::LichenPlane planes[] = {
        {x.cellI, x.cellJ, x.offsetX, x.offsetY, x.seedWord, 0, 0, 0}, use.planeY, use.planeZ};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      INFO("tileOrigin " << v["tileOrigin"] << ", plane " << axis);
      const nlohmann::json& expected = v["planes"][axis];
      const auto tile = expected["tile"].get<std::array<std::int64_t, 2>>();
      // A tile is a whole number of cells, counted modulo 2^32.
      CHECK(std::uint32_t(planes[axis].cellI) ==
            std::uint32_t(std::uint64_t(tile[0]) * std::uint64_t(x.columnsPerTile)));
      CHECK(std::uint32_t(planes[axis].cellJ) ==
            std::uint32_t(std::uint64_t(tile[1]) * std::uint64_t(x.rowsPerTile)));
      // Origins of 1.3e8 tiles in doubles.
      CHECK(double(planes[axis].offsetX) == Approx(expected["rest"][0].get<double>()).margin(2e-7));
      CHECK(double(planes[axis].offsetY) == Approx(expected["rest"][1].get<double>()).margin(2e-7));
      CHECK(planes[axis].seedWord == latticeSeed(textons.material.seed, std::uint32_t(axis)));
    }
  }
}
