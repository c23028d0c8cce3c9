// SPDX-License-Identifier: MIT
// The verdict on a noise: what counts, in which order, and in which words.
#include <lichen/noise_verdict.h>

#include <catch2/catch.hpp>

#include <array>
#include <utility>
#include <vector>

using namespace lichen;

namespace {

Risk risk(std::string_view name, double score, Risk::Level level) {
  return {name, score, level, "it shows " + std::string(name), {{"flatten", "64"}}, "even light"};
}

Measure measure(std::string_view name, double value) { return {name, "", "", value, 0.0, {}}; }

Verdict on(const std::vector<Risk>& risks, const std::vector<Measure>& measures,
           bool bordersWereKept = true) {
  const JudgedMap map{MapTarget::baseColor, risks, measures};
  return verdictOn({&map, 1}, bordersWereKept);
}

} // namespace

TEST_CASE("a measure counts from where viewers see it, and only if it has a target") {
  using Limits = std::array<double, 2>;
  for (const auto& [name, limits] : {std::pair{kColorDistanceName, Limits{0.006, 0.02}},
                                     std::pair{kAutocovarianceErrorName, Limits{0.2, 0.35}},
                                     std::pair{kSeamVisibilityName, Limits{1.25, 1.6}},
                                     std::pair{kCutMismatchName, Limits{1.0, 2.0}}}) {
    INFO(name);
    CHECK(on({}, {measure(name, 0.99 * limits[0])}).level == Verdict::Level::good);
    CHECK(on({}, {measure(name, 1.01 * limits[0])}).level == Verdict::Level::acceptable);
    CHECK(on({}, {measure(name, 1.01 * limits[1])}).level == Verdict::Level::unsuitable);
    Measure without = measure(name, 1.01 * limits[1]);
    without.target.reset();
    CHECK(on({}, {without}).level == Verdict::Level::good);
  }
  for (const std::string_view name : {kSpectrumDistanceName, kLatticeVisibilityName})
    CHECK(on({}, {measure(name, 9.0)}).level == Verdict::Level::good);
}

TEST_CASE("the worst fault makes the verdict, and at one level a risk comes before a measure") {
  const Risk mild = risk("structure", 0.4, Risk::Level::mild);
  const Risk milder = risk("cloudiness", 0.35, Risk::Level::mild);
  const Measure tint = measure(kColorDistanceName, 0.015); // acceptable, with a score above both
  CHECK(on({milder, mild}, {tint}).worst.name == "structure");
  CHECK(on({milder, mild}, {measure(kColorDistanceName, 0.03)}).worst.name == kColorDistanceName);
  CHECK(on({risk("clipping", 0.1, Risk::Level::none)}, {}).level == Verdict::Level::good);

  const std::vector<Risk> severe{risk("structure", 0.9, Risk::Level::severe)};
  const std::vector<Risk> mildOnly{mild};
  const std::array maps{JudgedMap{MapTarget::baseColor, mildOnly, {}},
                        JudgedMap{MapTarget::normal, severe, {}}};
  const Verdict verdict = verdictOn(maps, true);
  CHECK(verdict.level == Verdict::Level::unsuitable);
  CHECK(verdict.map == MapTarget::normal);
}

TEST_CASE("the sentence has the fault and one remedy") {
  const Verdict verdict = on({risk("cloudiness", 0.5, Risk::Level::mild)}, {});
  CHECK(sentenceOf(verdict, false) == "acceptable: it shows cloudiness; what helps: flatten 64");
  CHECK(sentenceOf(verdict, true) ==
        "acceptable: baseColor: it shows cloudiness; what helps: flatten 64");
  CHECK(sentenceOf(Verdict{}, true) == "good");
  const std::vector<Measure> seams{measure(kSeamVisibilityName, 1.4)};
  CHECK_THAT(sentenceOf(on({}, seams, true), false), Catch::EndsWith("what helps: periodic no"));
  CHECK_THAT(sentenceOf(on({}, seams, false), false),
             Catch::EndsWith("what helps: an image that tiles"));
}
