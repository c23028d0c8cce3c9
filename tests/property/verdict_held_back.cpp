// SPDX-License-Identifier: MIT
// The error rates of the verdict that `lichen bake` prints first.
//
// A false alarm is a picture with a good noise whose verdict is not good. A miss is a picture with
// a faulty noise whose verdict is good. Both rates must be below a tenth, at a confidence of 95 %.
// The limits are from other pictures; docs/decisions/035-verdict.md says what these changed.
#include "verdict_held_back_pictures.h"

#include <lichen/flatten.h>
#include <lichen/noise_verdict.h>
#include <lichen/outliers.h>
#include <lichen/tiling.h>

#include <catch2/catch.hpp>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace lichen;
using namespace lichen::test;
using exemplars::Random;

namespace {

template <class Value>
Value valueOf(Result<Value> result) {
  if (!result)
    FAIL(result.error().message);
  return std::move(result).value();
}

/// The steps of `lichen bake` with its default options, apart from the transport.
Verdict verdictOf(const SrgbImage& image) {
  MapExemplar map;
  map.channels = {MapChannel::red, MapChannel::green, MapChannel::blue};
  map.width = image.width;
  map.height = image.height;
  map.values = image.values;
  std::vector<MapExemplar> maps{map};
  valueOf(removeUnevenLight(maps.front(), bordersFit(maps, Periodic::detect)));
  valueOf(fillOutliers(maps, bordersFit(maps, Periodic::detect)));
  TilingOptions options;
  options.transport = TransportEffort::fast;
  TilingBake baked = valueOf(bakeTiling("held back", maps, options));
  Bundle bundle;
  bundle.tables = std::move(baked.tables);
  bundle.noises = {std::move(baked.noise)};
  const auto risks = valueOf(assessNoise(bundle.noises.front(), maps, options.periodic));
  const auto measures = valueOf(measureNoise(bundle, {}, maps.front()));
  const JudgedMap judged{maps.front().target, risks.front(), measures};
  return verdictOn({&judged, 1}, baked.exemplarWasPeriodic);
}

int sideOf(Random& random) {
  return int(random.range(float(kSmallestHeldBackSide), float(kLargestHeldBackSide + 1)));
}

/// Verdicts by kind.
class Tally {
public:
  /// Counts a picture. Its verdict is wrong if it is good and the noise is not, or the reverse.
  void add(const std::string& kind, const std::string& name, const Verdict& verdict, bool isGood) {
    ++pictures_;
    ++levels_[kind][std::size_t(verdict.level)];
    if ((verdict.level == Verdict::Level::good) == isGood)
      return;
    ++wrong_;
    sentences_ += name + ": " + sentenceOf(verdict, false) + "\n";
  }
  [[nodiscard]] int pictures() const { return pictures_; }
  [[nodiscard]] int wrong() const { return wrong_; }

  /// Good, acceptable and unsuitable pictures of each kind, and the wrong sentences.
  [[nodiscard]] std::string report() const {
    std::string lines;
    for (const auto& [kind, counts] : levels_)
      lines += kind + ": " + std::to_string(counts[0]) + " good, " + std::to_string(counts[1]) +
               " acceptable, " + std::to_string(counts[2]) + " unsuitable\n";
    return lines + std::to_string(wrong_) + " of " + std::to_string(pictures_) + " wrong\n" +
           sentences_;
  }

private:
  int pictures_ = 0, wrong_ = 0;
  std::map<std::string, std::array<int, 3>> levels_;
  std::string sentences_;
};

/// The most errors among this many pictures that exclude an error rate of a tenth at a confidence
/// of 95 %: at a rate of a tenth, as few or fewer have a probability of at most 5 %. The bound is
/// that of C. Clopper and E. Pearson, "The use of confidence or fiducial limits", 1934.
int mostErrors(int pictures) {
  constexpr double kRate = 0.1, kDoubt = 0.05;
  double one = 1.0; // the probability of exactly `errors`
  for (int i = 0; i < pictures; ++i)
    one *= 1.0 - kRate;
  double all = 0.0;
  int errors = 0;
  while ((all += one) <= kDoubt) {
    one *= kRate / (1.0 - kRate) * double(pictures - errors) / double(errors + 1);
    ++errors;
  }
  return errors - 1;
}

} // namespace

TEST_CASE("the bound on errors is that of tables") {
  CHECK(mostErrors(28) == -1); // 0.9^28 is 5.2 %
  CHECK(mostErrors(29) == 0);
  CHECK(mostErrors(100) == 4);
  CHECK(mostErrors(120) == 6);
}

TEST_CASE("fewer than a tenth of the held-back materials have a verdict that is not good",
          "[large]") {
  Tally tally;
  std::uint32_t seed = 70000;
  for (const SoundKind& kind : soundKinds())
    for (std::size_t condition = 0; condition < kConditionNames.size(); ++condition) {
      Random random(++seed);
      const int side = sideOf(random);
      const SrgbImage image = photographed(kind.draw, side, Condition(condition), random);
      tally.add(kind.name, std::string(kind.name) + ", " + kConditionNames[condition],
                verdictOf(image), true);
    }
  INFO(tally.report());
  CHECK(tally.pictures() == 120);
  CHECK(tally.wrong() <= mostErrors(tally.pictures()));
}

TEST_CASE("fewer than a tenth of the held-back faulty pictures have a good verdict", "[large]") {
  constexpr int kPicturesPerKind = 8;
  Tally tally;
  std::uint32_t seed = 80000;
  for (const FaultyKind& kind : faultyKinds())
    for (int i = 0; i < kPicturesPerKind; ++i) {
      Random random(++seed);
      const int side = sideOf(random);
      tally.add(kind.name, std::string(kind.name) + " " + std::to_string(i),
                verdictOf(kind.draw(side, random)), false);
    }
  INFO(tally.report());
  CHECK(tally.pictures() == 120);
  CHECK(tally.wrong() <= mostErrors(tally.pictures()));
}
