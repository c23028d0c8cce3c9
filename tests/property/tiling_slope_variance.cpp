// SPDX-License-Identifier: MIT
// The variance of slopes that a slope map's table stores beside the slopes.
#include "baked_exemplar.h"
#include "bundle_of.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <evaluation/method_evaluator.h>
#include <gaussian/level_means.h>
#include <gaussian/mip_chain.h>
#include <gaussian/prefilter.h>
#include <gaussian/table_lookup.h>
#include <random>
#include <transport/random.h>

using namespace lichen;
using namespace lichen::test;
using namespace lichen::gaussian;

namespace {

/// Slopes of three kinds of ground, far from Gaussian; on a line if `flatAcross`.
MapExemplar slopes(bool flatAcross = false) {
  const MapExemplar colours = threeMaterials(96, 96, 21);
  MapExemplar map;
  map.target = MapTarget::normal;
  map.channels = {MapChannel::slopeX, MapChannel::slopeY};
  map.encoding = ValueEncoding::slope;
  map.width = colours.width;
  map.height = colours.height;
  for (std::size_t i = 0; i < colours.values.size(); i += 3)
    map.values.insert(map.values.end(), {2.0f * colours.values[i] - 1.0f,
                                         flatAcross ? 0.25f : 2.0f * colours.values[i + 2] - 0.5f});
  return map;
}

struct SlopeTable {
  InverseTable table;
  std::vector<exemplar::ChannelMatrix> lost;
  std::vector<InverseTable> levels;
  Table gaussian;
  std::vector<float> losses;
};

/// `shuffled`: puts the pixels of the Gaussian image in random order, so that its mips are
/// Gaussian.
SlopeTable slopeTable(const MapExemplar& map, bool shuffled) {
  Baked b = baked(map);
  SlopeTable result;
  result.table = fitInverseTable(b.gaussian, b.points, map.values, 2, {});
  for (std::size_t i = b.gaussian.image.size(); shuffled && i-- > 1;)
    std::swap(b.gaussian.image[i], b.gaussian.image[transport::randomBits(3, i) % (i + 1)]);
  result.gaussian = gaussianTable(b.gaussian, 16);
  result.lost = lostVariance(result.gaussian, b.gaussian.dimensions);
  result.losses = fetchLosses(result.gaussian);
  result.levels = prefilteredLevels(result.table, result.lost, false);
  restoreLevelMeans(result.levels, false, result.gaussian, result.losses);
  appendSlopeVariance(result.levels, result.table, result.gaussian, result.lost, result.losses);
  return result;
}

} // namespace

TEST_CASE("the third channel of a slope table is the variance that a fetch loses", "[large]") {
  const SlopeTable t = slopeTable(slopes(), true);
  const double whole = interpolatedMoments(t.table).covariance.trace() / 2.0;
  std::mt19937 random(5);
  std::normal_distribution<double> deviate;
  constexpr int kSamples = 1000;
  for (const int k : {1, 2, 3, 4}) {
    const TableLookup<2> level(t.levels[std::size_t(k)]);
    for (const auto& [x, y] : {std::array{0.0, 0.0}, {-0.7, 0.4}, {1.1, 0.9}}) { // in deviations
      const double keptX = retainedAmplitude(k) * x / 6.0, keptY = retainedAmplitude(k) * y / 6.0;
      double sum[2] = {}, squares[2] = {};
      for (int s = 0; s < kSamples; ++s) {
        // White noise loses equally along all directions.
        const double lost = std::sqrt(levelLoss(k)) / 6.0;
        const std::array<double, 3> g{0.5 + keptX + lost * deviate(random),
                                      0.5 + keptY + lost * deviate(random), 0.0};
        for (int c = 0; c < 2; ++c) {
          const double value = slowLookup(t.table, g, c);
          sum[c] += value / kSamples;
          squares[c] += value * value / kSamples;
        }
      }
      const double variance = 0.5 * (squares[0] - sum[0] * sum[0] + squares[1] - sum[1] * sum[1]);
      INFO("level " << k << " at " << x << ", " << y << ", whole variance " << whole);
      // For values in two or three clusters, a variance over 1000 samples has a smaller standard
      // error than for a Gaussian, 4.5 %. The limit is two of these for the whole; parts have less.
      CHECK(double(level({float(0.5 + keptX), float(0.5 + keptY), 0.0f})[2]) ==
            Approx(variance).margin(0.1 * whole));
    }
  }
}

TEST_CASE("visible and lost variance also sum up over mips that are not Gaussian") {
  for (const bool flatAcross : {false, true}) {
    const SlopeTable t = slopeTable(slopes(flatAcross), false);
    const double whole = interpolatedMoments(t.table).covariance.trace() / 2.0;
    for (int k = 1; k < int(t.levels.size()); ++k) {
      const FetchMoments f =
          fetchMoments(t.levels[std::size_t(k)], k, RepeatingImage(t.gaussian), t.losses);
      const double shown =
          0.5 * (f.square[0] - f.mean[0] * f.mean[0] + f.square[1] - f.mean[1] * f.mean[1]);
      INFO("level " << k << (flatAcross ? ", on a line" : ""));
      CHECK(shown + f.mean[2] == Approx(whole).epsilon(1e-4));
    }
  }
}

namespace {

/// A view of a slope noise.
struct View {
  double shown = 0.0, hidden = 0.0; // variances
};

/// Draws a baked noise of slopes at any distance.
class SlopeViews {
public:
  explicit SlopeViews(MapExemplar map, const TilingOptions& options = {}) : map_(std::move(map)) {
    bundle_ = test::bundleOf(bakeTiling("slopes", {&map_, 1}, options));
    evaluator_ = methodEvaluator(bundle_, 0);
  }

  [[nodiscard]] View at(double texelsPerPixel, double contrast = 1.0) const {
    MaterialNoise use;
    use.contrast = contrast;
    const shader::LichenTriplanarMaterial material = shaderMaterial(bundle_, use, Placement{});
    constexpr int kPlaces = 4000;
    double sum[3] = {}, squares[2] = {};
    TileFootprint at;
    at.dx[0] = at.dy[1] = float(texelsPerPixel / map_.width);
    for (int k = 0; k < kPlaces; ++k) {
      at.position = {0.0137f * float(k), 0.0291f * float(k)};
      const auto value = evaluator_->evaluate(0, material, at);
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += double(value[c]) / kPlaces;
      for (std::size_t c = 0; c < 2; ++c)
        squares[c] += double(value[c]) * double(value[c]) / kPlaces;
    }
    return {0.5 * (squares[0] - sum[0] * sum[0] + squares[1] - sum[1] * sum[1]), sum[2]};
  }

private:
  MapExemplar map_;
  Bundle bundle_;
  std::shared_ptr<const MethodEvaluator> evaluator_;
};

} // namespace

TEST_CASE("interpolation hides no slopes, and distance moves variance from slopes to roughness") {
  const SlopeViews views(slopes());
  const View magnified = views.at(0.25);
  for (const double texels : {0.001, 0.25, 1.0})
    CHECK(views.at(texels).hidden < 1e-6 * magnified.shown);
  for (const double texels : {2.0, 3.0, 4.0, 8.0, 16.0, 768.0}) {
    const View view = views.at(texels);
    INFO(texels << " texels a pixel: shown " << view.shown << ", hidden " << view.hidden
                << "; magnified " << magnified.shown);
    // The standard error of such a variance is at most 2 % (sqrt(2 / 4000)). The rest is the loss
    // between mip levels, which is not linear: up to a sixth between one level and two.
    CHECK(view.shown + view.hidden == Approx(magnified.shown).epsilon(0.2));
  }
  CHECK(views.at(768.0).shown < 0.01 * magnified.shown);
}
