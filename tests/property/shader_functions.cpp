// SPDX-License-Identifier: MIT
// Functions of the shader library against closed forms: distribution function, waves, windows, and
// the cells of distant impacts.
#define LICHEN_METHODS 15
#include "evaluation/shader_library.h"
#include "synthetic_texton.h"

#include <lichen/shader_parameters.h>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <local_random_phase/octave_lattice.h>
#include <multiple_kernels/kernel.h>
#include <numbers>
#include <random>

using namespace lichen;
using namespace lichen::test;

namespace {

using Library = glsl::ShaderLibrary;

float cdf(float value) { return Library().lichenGaussianCdf(glsl::vec3(value)).x.v; }

} // namespace

TEST_CASE(
    "the polynomial distribution function is within 1.9e-4 of the exact one, where a table of "
    "256 cells has lookups between centres") {
  double largest = 0.0;
  for (int k = 0; k <= 100000; ++k) {
    const double value = k / 100000.0;
    const double exact = 0.5 * std::erfc(-6.0 * (value - 0.5) / std::numbers::sqrt2);
    const double within = std::clamp(exact, 0.5 / 256.0, 1.0 - 0.5 / 256.0);
    largest = std::max(largest, std::abs(double(cdf(float(value))) - within));
  }
  CHECK(largest < 1.9e-4);
  CHECK(largest > 1.0e-4); // as documented, not more exact
}

TEST_CASE("the polynomial distribution function never decreases and is odd about the middle") {
  float before = -1.0f;
  for (int k = -20000; k <= 120000; ++k) {
    const float value = float(k) / 100000.0f;
    const float here = cdf(value);
    REQUIRE(here >= before - 1e-7f); // the rounding of floats
    REQUIRE(here + cdf(1.0f - value) == Approx(1.0f).epsilon(1e-6));
    before = here;
  }
}

TEST_CASE("the polynomial of the cosine and the loss of a footprint are as near as they state") {
  Library library;
  double cosine = 0.0;
  for (int k = -30000; k <= 30000; ++k) {
    const float turns = float(k) * 1e-4f;
    const float found = library.lichenCosineOfTurns(glsl::vec4(turns)).x.v;
    cosine = std::max(cosine,
                      std::abs(double(found) - std::cos(2.0 * std::numbers::pi * double(turns))));
  }
  CHECK(cosine <= 1.1e-4);
  const auto retainedAt = [&](double squaredCycles) {
    return double(library.lichenCosineRetained(glsl::vec4(squaredCycles)).x.v);
  };
  double loss = 0.0; // of sinc, up to its first zero
  for (double cycles = 1e-3; cycles <= 1.0; cycles += 1e-3) {
    const double phase = std::numbers::pi * cycles;
    loss = std::max(loss, std::abs(retainedAt(cycles * cycles) - std::sin(phase) / phase));
  }
  CHECK(loss < 0.093);            // (1 - pi^2 / 18)^3, where sinc is 0
  CHECK(retainedAt(-1.0) == 1.0); // a long footprint, by rounding
  CHECK(retainedAt(2.0) == 0.0);
}

TEST_CASE(
    "each channel that a map of occlusion, roughness and metallic has goes to its own place") {
  Library library;
  for (std::uint32_t channels = 0; channels < 8; ++channels) {
    Library::LichenMap map{};
    map.ormChannels = channels;
    const glsl::vec3 found = library.lichenOrm({1.0f, 2.0f, 3.0f}, {-1.0f, -2.0f, -3.0f}, map);
    float stored = 1.0f; // the value holds only what the map has, in order
    for (int channel = 0; channel < 3; ++channel) {
      INFO(channels << ", " << channel);
      const bool isThere = (channels >> channel & 1u) != 0;
      CHECK(found[channel].v == (isThere ? stored : -1.0f - float(channel)));
      stored += isThere ? 1.0f : 0.0f;
    }
  }
}

TEST_CASE("a mask that is linear in tiles gives a mix its slope") {
  const Bundle bundle = syntheticTextonBundle({.coefficientsX = 12, .coefficientsY = 10}).bundle;
  const auto noise = std::bit_cast<Library::LichenNoise>(shaderNoise(bundle, 0));
  // Texture coordinates are 2 and -3 times the tiles'; the mask rises by 0.2 and 0.5 a tile.
  using glsl::vec2;
  const glsl::mat2 tiles(vec2(0.01f, 0.002f), vec2(-0.003f, 0.02f));
  const glsl::mat2 uv(vec2(2.0f, -3.0f) * tiles[0], vec2(2.0f, -3.0f) * tiles[1]);
  Library library;
  const glsl::mat2 reach = library.lichenMaskReach(uv, tiles, noise);
  const auto maskAt = [](const vec2& at) { return 0.1f * at.x - 0.5f / 3.0f * at.y; };
  Library::LichenPoint point;
  library.lichenMixByMask(
      point, 0.4f, {maskAt(reach[0]) - maskAt(-reach[0]), maskAt(reach[1]) - maskAt(-reach[1])},
      noise);
  CHECK(point.texton.mixWeight.v == 0.4f);
  CHECK(point.texton.mixGradient.x.v == Approx(0.2f));
  CHECK(point.texton.mixGradient.y.v == Approx(0.5f));
}

TEST_CASE("windows of cosines and spreads of kernels equal the bakes'") {
  Library library;
  std::mt19937 generator(2u);
  std::uniform_real_distribution<float> place(0.0f, 1.0f);
  for (int k = 0; k < 1000; ++k) {
    const float column = place(generator), row = place(generator);
    const auto expected = local_random_phase::windowsAt(double(column), double(row));
    const float corner = float(expected.corner[0][0]);
    const glsl::vec3 found = library.lichenCosineWindows({column - corner, column - 1.0f, column},
                                                         {row - corner, row, row - 1.0f});
    for (int vertex = 0; vertex < 3; ++vertex)
      REQUIRE(double(found[vertex].v) == Approx(expected.weight[std::size_t(vertex)]).margin(1e-5));
  }
  // By quadrature.
  for (const KernelWindow window :
       {KernelWindow::gabor, KernelWindow::sinc, KernelWindow::gaussianSinc}) {
    INFO(nameOf(window));
    CHECK(double(library.lichenKernelSpread(std::uint32_t(window)).v) ==
          Approx(multiple_kernels::windowSpread(window)).epsilon(3e-4));
  }
}

TEST_CASE("the index of a distant cell is exact, modulo 2^32 or the period") {
  shader::LichenNoise hostNoise{};
  hostNoise.tileTexelsX = hostNoise.tileTexelsY = 16384.0f;
  shader::LichenTextonNoise texton{};
  texton.coefficientsX = texton.coefficientsY = 1;
  texton.frameX = texton.frameY = 2;
  texton.mipCount = 1;
  setPart(hostNoise, texton);
  const auto noise = std::bit_cast<Library::LichenNoise>(hostNoise);
  Library::LichenMaterial material{};
  material.columnsPerTile = material.rowsPerTile = 49152.0f; // 3 cells per texel
  const auto firstCellAt = [&](std::int64_t x, std::int64_t y) {
    const glsl::vec2 none(0.0f);
    Library::LichenImpacts impacts;
    Library().lichenSetPoint(impacts, glsl::vec2(float(x), float(y)), none, none, material, noise);
    return impacts.firstCell;
  };
  for (const std::int32_t period : {0, 7, 49152 * 5, 1 << 29})
    for (const std::int64_t tiles : {0ll, 1ll, -1ll, 43691ll, -65537ll, 1ll << 27, -(1ll << 27)}) {
      material.periodColumns = material.periodRows = period;
      material.cellI = material.cellJ = period == 0 ? 0x7fffffff : 3;
      const glsl::ivec2 here = firstCellAt(tiles, -tiles), origin = firstCellAt(0, 0);
      for (int k = 0; k < 2; ++k) {
        const std::int64_t moved =
            std::int64_t(std::uint32_t(origin[k])) + (k == 0 ? tiles : -tiles) * 49152;
        const std::int64_t modulus = period == 0 ? std::int64_t(1) << 32 : period;
        INFO("period " << period << ", tiles " << tiles);
        CHECK(std::int64_t(std::uint32_t(here[k])) == (moved % modulus + modulus) % modulus);
      }
    }
}

TEST_CASE("the sums of impacts, weights and squared weights on surfaces follow proposition 3") {
  // [GLM17] section 6: lambda r^3 impacts. The integral of the weight over t is r / 2 and of
  // its square r / 3; the amplitude makes the variance the texton's.
  const SyntheticTexton texton{.coefficientsX = 12, .coefficientsY = 10};
  const Bundle bundle = syntheticTextonBundle(texton).bundle;
  const auto noise = std::bit_cast<Library::LichenNoise>(shaderNoise(bundle, 0));
  const double area = 13.0 * 11.0, thickness = std::sqrt(area); // of order 1
  Library library;
  for (const PointProcess process : {PointProcess::stratified, PointProcess::poisson})
    for (const glsl::vec3& normal : {glsl::vec3(0.0f, 1.0f, 0.0f), glsl::vec3(1.0f, 2.0f, 3.0f)}) {
      MaterialNoise use;
      use.mapping = Mapping::surface;
      use.pointProcess = process;
      use.impacts = 30.0;
      const shader::LichenMaterial material = shaderMaterial(bundle, use, {}).material;
      const auto part = partOf<shader::LichenTextonMaterial>(material);
      const double lambda = std::pow(double(part.surfaceCubeTexels), -3.0);
      CHECK(lambda * area * thickness == Approx(60.0).epsilon(0.1)); // whole cells
      const Eigen::Vector3d expected =
          lambda * area * thickness * Eigen::Vector3d(1.0, 1.0 / 2.0, 1.0 / 3.0);
      CHECK(double(part.amplitude) * double(part.amplitude) * expected[2] ==
            Approx(area).epsilon(1e-5));
      constexpr int kPlaces = 2000;
      std::mt19937 generator(3u);
      std::uniform_real_distribution<float> metres(-50.0f, 50.0f); // 6400 texels apart
      Eigen::Array3d mean = Eigen::Array3d::Zero(), square = mean;
      for (int place = 0; place < kPlaces; ++place) {
        const glsl::vec3 position(metres(generator), metres(generator), metres(generator));
        const glsl::vec3 none(0.0f);
        const Library::LichenSurfaceCubes cubes =
            library
                .lichenPointSurfaceGrad(position, none, none, normal,
                                        glsl::vec4(0.36f, 0.48f, -0.8f, 1.0f),
                                        std::bit_cast<Library::LichenMaterial>(material), noise)
                .point.texton.cubes;
        Eigen::Array3d sums = Eigen::Array3d::Zero();
        Library::LichenSurfaceWalk walk = library.lichenFirstSurfaceImpact(cubes);
        while (library.lichenHasImpact(walk, cubes)) {
          library.lichenSurfaceStep(walk, cubes);
          const double weight = std::abs(double(walk.weight.v));
          if (walk.isReached)
            sums += Eigen::Array3d(1.0, weight, weight * weight);
        }
        mean += sums / kPlaces;
        square += sums * sums / kPlaces;
      }
      INFO(nameOf(process) << ", normal z " << normal.z.v);
      for (Eigen::Index k = 0; k < 3; ++k) // 5 standard errors, alpha 6e-7
        CHECK(std::abs(mean[k] - expected[k]) <
              5.0 * std::sqrt((square[k] - mean[k] * mean[k]) / kPlaces));
    }
}

TEST_CASE("the four vertices around a point of a solid are those in reach, and the squares of "
          "their windows sum to 1") {
  Library library;
  Library::LichenMaterial material{};
  material.columnsPerTile = 3.5f;
  material.rowsPerTile = 4.25f;
  const Eigen::Array3f perTile(3.5f, 4.25f, 3.5f);
  std::mt19937 generator(1u);
  std::uniform_real_distribution<float> place(-2.0f, 2.0f);
  for (int sample = 0; sample < 2000; ++sample) {
    const Eigen::Array3f position(place(generator), place(generator), place(generator));
    Library::LichenCosinesPoint point;
    library.lichenSetSolidPoint(point, {position[0], position[1], position[2]}, {}, material);
    const Library::LichenSolidVertices vertices = library.lichenSolidVertices(point, 0, material);
    CHECK(std::abs(dot(vertices.windows, vertices.windows).v - 1.0f) < 1e-6f);
    // Vertices within half the diagonal of a cube's face, where windows end.
    const Eigen::Array3f cubes = position * perTile;
    const Eigen::Array3f near = (cubes + cubes.sum() / 3.0f).floor();
    for (int n = 0; n < 7 * 7 * 7; ++n) {
      const Eigen::Array3f vertex =
          near + Eigen::Array3f(float(n % 7 - 3), float(n / 7 % 7 - 3), float(n / 49 - 3));
      const Eigen::Array3f offset = cubes - vertex + vertex.sum() / 6.0f;
      if (offset.matrix().squaredNorm() > 0.5f - 1e-5f)
        continue;
      int found = 0;
      for (int k = 0; k < 4; ++k) {
        const Eigen::Array3f own(vertices.offsetX[k].v, vertices.offsetY[k].v,
                                 vertices.offsetZ[k].v);
        if (vertices.windows[k] > 0.0f && (own * perTile - offset).matrix().norm() < 1e-5f)
          ++found;
      }
      CHECK(found == 1);
    }
  }
}
