// SPDX-License-Identifier: MIT
// Points evaluated together against each alone: the same source over scalars of four points and of
// one.
#include "bundle_of.h"
#include "example_exemplar.h"
#include "synthetic_noise.h"

#include <lichen/local_random_phase.h>

#include <catch2/catch.hpp>

#include <evaluation/method_evaluator.h>
#include <random>
#include <string>
#include <vector>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr int kSide = 64;
constexpr std::size_t kPoints = 259; // no multiple of any number of lanes

struct Use {
  std::string name;
  const Bundle* bundle;
  MaterialNoise material;
};

const Bundle& tiling() {
  static const Bundle bundle = syntheticBundle(std::vector<SyntheticMap>{{}}).bundle;
  return bundle;
}

/// The noise of a height map, in whose pairs of amplitudes the first is 0 where the second is a
/// phase.
const Bundle& cosines(double structure) {
  const auto baked = [](double share) {
    const MapExemplar colors = threeMaterials(kSide, kSide, 11);
    MapExemplar map = colors;
    map.target = MapTarget::height;
    map.channels = {MapChannel::height};
    map.encoding = ValueEncoding::linear;
    map.values.clear();
    for (std::size_t k = 0; k < colors.values.size(); k += colors.channels.size())
      map.values.push_back(colors.values[k]);
    LocalRandomPhaseOptions options;
    options.structure = share;
    return bundleOf(bakeLocalRandomPhase("x", {&map, 1}, options));
  };
  static const Bundle plain = baked(0.0), half = baked(0.5);
  return structure == 0.0 ? plain : half;
}

std::vector<Use> uses() {
  MaterialNoise sharp, rotated;
  sharp.blendSharpness = 3.0;
  sharp.contrast = 1.5;
  rotated.tileRotation = 4;
  return {{"tiling", &tiling(), {}},
          {"tiling, sharp", &tiling(), sharp},
          {"tiling, rotated tiles", &tiling(), rotated},
          {"cosines", &cosines(0.0), {}},
          {"cosines and a structure", &cosines(0.5), {}}};
}

/// Points of one footprint [texels], or each of its own up to that.
std::vector<PlanePoint> randomPoints(float texels, bool alike) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> place(-40.0f, 40.0f), share(-1.0f, 1.0f);
  const auto side = [&] { return texels / kSide * (alike ? 1.0f : share(random)); };
  std::vector<PlanePoint> points(kPoints);
  for (PlanePoint& point : points)
    point.at = {{place(random), place(random)}, {side(), 0.0f}, {0.0f, side()}};
  return points;
}

/// How many of the points are evaluated together.
std::size_t together(const Use& use, WideEvaluation& evaluate,
                     const std::vector<PlanePoint>& points) {
  const Bundle& bundle = *use.bundle;
  const NoiseMap& map = bundle.noises[0].maps[0];
  const Alpha alpha = bundle.noises[0].method() == Method::tiling ? Alpha::lastChannel : Alpha::one;
  const RepeatingImage image(bundle.tables[imageTableOf(map)], alpha);
  const ClampedVolume table(bundle.tables[*decodingTableOf(map)]);
  const auto noise = shaderNoise(bundle, 0);
  const auto material = shaderMaterial(bundle, use.material, {}).material;
  const auto constants = shaderMap(bundle, bundle.noises[0], 0);
  std::vector<NoiseEvaluator::Value> values(points.size());
  return evaluate({noise, material, constants, image, table, false}, points, values);
}

} // namespace

TEST_CASE("points evaluated together have the values that each has alone") {
  Placement placement, periodic;
  placement.tileOriginX = std::int64_t(1) << 38;
  periodic.periodic = true;
  periodic.periodTilesX = periodic.periodTilesY = 2.0;
  for (const Use& use : uses())
    for (const Placement& where : {placement, periodic})
      for (const float texels : {0.0f, 0.7f, 1.0f, 9.0f})
        for (const bool alike : {false, true}) {
          INFO(use.name << ", period " << where.periodTilesX << ", footprint " << texels);
          const auto evaluator = NoiseEvaluator::create(*use.bundle, use.material, where);
          REQUIRE(evaluator);
          const std::vector<PlanePoint> points = randomPoints(texels, alike);
          std::vector<NoiseEvaluator::Value> values(points.size());
          evaluator.value()->evaluate(0, points, values);
          std::size_t different = 0;
          for (std::size_t k = 0; k < points.size(); ++k)
            if (values[k] != evaluator.value()->evaluate(0, points[k].at))
              ++different;
          CHECK(different == 0);
        }
}

TEST_CASE("points of one footprint are evaluated together, all but a rest") {
  const std::vector<PlanePoint> points = randomPoints(1.0f, true);
  const std::vector<Use> all = uses();
  CHECK(together(all[0], tilingWide, points) == kPoints - 3);
  CHECK(together(all[1], tilingWide, points) == kPoints - 3);
  CHECK(together(all[3], localRandomPhaseWide, points) == kPoints - 3);
}

TEST_CASE("points that take different branches are left to be evaluated one by one") {
  const std::vector<PlanePoint> points = randomPoints(1.0f, true);
  CHECK(together(uses()[2], tilingWide, points) < kPoints / 2);
}
