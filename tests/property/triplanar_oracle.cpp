// SPDX-License-Identifier: MIT
// Noise in three planes, of every method, against an oracle in double precision: "Noise in three
// planes" of docs/gltf_extension/README.md, from values of each plane as a noise of its own on
// texture coordinates.
#include "bundle_of.h"
#include "example_exemplar.h"
#include "gaussian_reader.h"
#include "oracle_footprints.h"
#include "slopes_of_color.h"
#include "synthetic_noise.h"
#include "synthetic_texton.h"

#include <lichen/lattice.h>
#include <lichen/local_random_phase.h>
#include <lichen/multiple_kernels.h>
#include <lichen/quilting.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace lichen;
using namespace lichen::test;

namespace {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Evaluator = std::unique_ptr<const NoiseEvaluator>;
using NamedNoise = std::pair<const char*, Bundle>;

constexpr int kWidth = 64, kHeight = 48;
constexpr double kAspect = double(kWidth) / kHeight, kTileMetres = 0.5;
/// Seeds whose noise on texture coordinates equals the first one's in the planes x, y and z.
constexpr std::array<std::uint32_t, 3> kSeeds{7u, 4134746869u, 254121764u};
static_assert(latticeSeed(kSeeds[1], 0) == latticeSeed(kSeeds[0], 1) &&
              latticeSeed(kSeeds[2], 0) == latticeSeed(kSeeds[0], 2));

struct Use {
  MaterialNoise material;
  Placement placement;
};
std::vector<Use> uses() {
  std::vector<Use> uses(2);
  for (Use& use : uses) {
    use.material.mapping = Mapping::triplanar;
    use.material.seed = kSeeds[0];
  }
  MaterialNoise& moved = uses[1].material;
  moved.scale = 0.8;
  moved.rotation = 0.6;
  moved.planeSharpness = 2.0;
  moved.contrast = 1.4;
  moved.offset = {0.25, -1.5};
  uses[1].placement = {.tileOriginX = 1, .tileOriginY = 2, .tileOriginZ = -3};
  return uses;
}

/// The material of each plane on its tiles.
std::array<MaterialNoise, 3> ofPlanes(double contrast) {
  std::array<MaterialNoise, 3> materials;
  for (std::size_t k = 0; k < 3; ++k) {
    materials[k].seed = kSeeds[k];
    materials[k].contrast = contrast;
  }
  return materials;
}

struct Plane {
  double weight;
  double seen; ///< share of a slope's variance
  TileFootprint at;
};

Vec3 vectorOf(const std::array<float, 3>& v) { return {double(v[0]), double(v[1]), double(v[2])}; }

/// Steps 1 and 2.
std::array<Plane, 3> planesAt(const TriplanarFootprint& at, const Use& use) {
  const MaterialNoise& material = use.material;
  const double c = std::cos(material.rotation), s = std::sin(material.rotation);
  const double metres = material.scale * kTileMetres; // of a tile
  const Vec3 n = vectorOf(at.normal).normalized();
  const Vec3 origin(double(use.placement.tileOriginX), double(use.placement.tileOriginY),
                    double(use.placement.tileOriginZ));
  std::array<Plane, 3> planes{};
  double squares = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    // A vector in tile widths -> the tiles of the plane.
    const auto tiles = [&](const Vec3& v) {
      const Vec2 uv = std::array{Vec2(-v[2], -v[1]), Vec2(v[0], v[2]), Vec2(v[0], -v[1])}[k];
      return Vec2(c * uv[0] + s * uv[1], kAspect * (-s * uv[0] + c * uv[1]));
    };
    const auto rounded = [](const Vec2& v) { return std::array{float(v[0]), float(v[1])}; };
    Plane& plane = planes[k];
    plane.at = {rounded(Vec2(material.offset[0], material.offset[1]) +
                        tiles(origin + vectorOf(at.position) / metres)),
                rounded(tiles(vectorOf(at.dx) / metres)), rounded(tiles(vectorOf(at.dy) / metres))};
    const double across = std::abs(n[Eigen::Index(k)]);
    plane.weight = std::max(
        0.0, std::pow(across / n.cwiseAbs().maxCoeff(), material.planeSharpness) - 1.0 / 64.0);
    plane.seen = (1.0 + across * across) / 2.0;
    squares += plane.weight * plane.weight;
  }
  for (Plane& plane : planes)
    plane.weight /= std::sqrt(squares);
  return planes;
}

Bundle inMetres(Bundle bundle) {
  bundle.noises[0].tileSizeMetres = kTileMetres;
  return bundle;
}
Bundle textons(const SyntheticTexton& texton) {
  return inMetres(syntheticTextonBundle(texton).bundle);
}
Bundle tiling(int dimensions, Grain grain) {
  const SyntheticMap map{
      .dimensions = dimensions, .width = kWidth, .height = kHeight, .grain = grain};
  return inMetres(syntheticBundle(std::span(&map, 1)).bundle);
}
Bundle cosines(const MapExemplar& map, double structure) {
  LocalRandomPhaseOptions options;
  options.bits = 16;
  options.cosines = 24;
  options.structure = options.guide = structure;
  return inMetres(bundleOf(bakeLocalRandomPhase("cosines", {&map, 1}, options)));
}
Bundle kernels(const MapExemplar& map) {
  MultipleKernelsOptions options;
  options.bits = 16;
  options.kernels = 6;
  options.perturbation.emplace().cosines = 7;
  return inMetres(bundleOf(bakeMultipleKernels("kernels", {&map, 1}, options)));
}
Bundle quilting(const MapExemplar& map) {
  QuiltingOptions options;
  options.bits = 16;
  options.guide = 0.0;
  return inMetres(bundleOf(bakeQuilting("quilting", {&map, 1}, options)));
}

/// Positions below 16 tiles are rounded on both ways, by up to 2^-20 of a tile in all. In
/// deviations noises have slopes below 500 a tile, and the cuts of quilting have slopes of 16 in a
/// quarter of a tile. Footprints are rounded by a few 2^-24.
constexpr double kTolerance = 5e-4;

} // namespace

TEST_CASE("Gaussian values of three planes are blended before they are decoded") {
  const MapExemplar color = threeMaterials(kWidth, kHeight, 5);
  for (const auto& [name, bundle] :
       {NamedNoise("tiling", tiling(3, Grain::none)), NamedNoise("grain", tiling(3, Grain::x)),
        NamedNoise("textons", textons({})),
        NamedNoise("mix", textons({.order = 3, .steps = 3, .channels = 1})),
        NamedNoise("structure", cosines(color, 0.7)), NamedNoise("kernels", kernels(color))})
    for (const Use& use : uses()) {
      const GaussianReader reader(bundle, use.material, use.placement);
      std::vector<GaussianReader> planeReaders;
      for (const MaterialNoise& material : ofPlanes(use.material.contrast))
        planeReaders.emplace_back(bundle, material);
      const MixPlace mix{0.37f, {}};
      double most = 0.0, mostLost = 0.0;
      for (const TriplanarFootprint& at : oracleFootprints(120)) {
        const std::array<Plane, 3> planes = planesAt(at, use);
        GaussianReading error = reader.at(at, mix);
        for (std::size_t k = 0; k < 3; ++k) {
          const GaussianReading own = planeReaders[k].at(planes[k].at, mix);
          error.z -= planes[k].weight * own.z;
          error.lost -= planes[k].weight * planes[k].weight * own.lost;
        }
        most = std::max(most, error.z.cwiseAbs().maxCoeff());
        mostLost = std::max(mostLost, error.lost.cwiseAbs().maxCoeff());
      }
      INFO(name << ", rotation " << use.material.rotation);
      CHECK(most < kTolerance);
      CHECK(mostLost < 0.1 * kTolerance);
    }
}

TEST_CASE("values of quilting are blended about the image's mean, and clamped after the blend") {
  const Bundle bundle = quilting(threeMaterials(kWidth, kHeight, 5));
  const Table& image = bundle.tables[bundle.noises[0].maps[0].as<QuiltingMap>().image];
  const std::vector<float> last = decodeLevel(image, image.mipLevels - 1);
  const Vec3 mean = vectorOf({last[0], last[1], last[2]}).cwiseAbs2();
  bool isClamped = false;
  for (const Use& use : uses()) {
    const Evaluator noise = NoiseEvaluator::create(bundle, use.material, use.placement).value();
    constexpr double kContrast = 0.25; // at which no value of a plane is clamped
    std::vector<Evaluator> planeNoises;
    for (const MaterialNoise& material : ofPlanes(kContrast))
      planeNoises.push_back(NoiseEvaluator::create(bundle, material).value());
    double most = 0.0;
    for (const TriplanarFootprint& at : oracleFootprints(120)) {
      const std::array<Plane, 3> planes = planesAt(at, use);
      Vec3 expected = mean;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto own = planeNoises[k]->evaluate(0, planes[k].at);
        expected += planes[k].weight * use.material.contrast / kContrast *
                    (vectorOf({own[0], own[1], own[2]}) - mean);
      }
      const Vec3 clamped = expected.cwiseMax(0.0).cwiseMin(1.0);
      isClamped = isClamped || clamped != expected;
      const auto found = noise->evaluate(0, at);
      most = std::max(most,
                      (vectorOf({found[0], found[1], found[2]}) - clamped).cwiseAbs().maxCoeff());
    }
    CHECK(most < kTolerance);
  }
  CHECK(isClamped);
}

TEST_CASE("slopes of three planes add up to a gradient in space, with the variance that a slanted "
          "surface shows") {
  const MapExemplar slopes = slopesOf(threeMaterials(kWidth, kHeight, 5));
  for (const auto& [name, bundle] :
       {NamedNoise("tiling", tiling(2, Grain::y)), NamedNoise("textons", textons({.channels = 2})),
        NamedNoise("cosines", cosines(slopes, 0)), NamedNoise("kernels", kernels(slopes)),
        NamedNoise("quilting", quilting(slopes))})
    for (const Use& use : uses()) {
      const Evaluator noise = NoiseEvaluator::create(bundle, use.material, use.placement).value();
      std::vector<Evaluator> planeNoises;
      for (const MaterialNoise& material : ofPlanes(use.material.contrast))
        planeNoises.push_back(NoiseEvaluator::create(bundle, material).value());
      const double c = std::cos(use.material.rotation), s = std::sin(use.material.rotation);
      double most = 0.0;
      for (const TriplanarFootprint& at : oracleFootprints(120)) {
        const std::array<Plane, 3> planes = planesAt(at, use);
        const auto found = noise->evaluate(0, at);
        Vec3 error = vectorOf({found[0], found[1], found[2]});
        double variance = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
          const auto own = planeNoises[k]->evaluate(0, planes[k].at);
          const double r = c * double(own[0]) + s * double(own[1]);
          const double t = c * double(own[1]) - s * double(own[0]);
          error -=
              planes[k].weight * std::array{Vec3(0.0, t, -r), Vec3(r, 0.0, -t), Vec3(r, t, 0.0)}[k];
          variance += planes[k].weight * planes[k].weight * planes[k].seen * double(own[2]);
        }
        most = std::max({most, error.cwiseAbs().maxCoeff(), std::abs(double(found[3]) - variance)});
      }
      INFO(name << ", rotation " << use.material.rotation);
      CHECK(most < kTolerance);
    }
}
