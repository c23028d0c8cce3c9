// SPDX-License-Identifier: MIT
// Held-back pictures -> what the bake decides about each -> the names of those it misjudges.
#include "held_back_decisions.h"

#include "prepared_exemplar.h"
#include "quilting_held_back_pictures.h"
#include "verdict_held_back_pictures.h"

#include <lichen/noise_verdict.h>
#include <lichen/tiling.h>

#include <tbb/parallel_for.h>

#include <cstdio>
#include <utility>

namespace lichen::test {
namespace {

using exemplars::Random;

/// The verdict of `lichen bake` with its default options. A picture with a risk is not baked: its
/// measures could only make the verdict worse, and only whether it is good counts here.
Verdict verdictOf(const SrgbImage& image) {
  const std::vector<MapExemplar> maps = preparedExemplar(image);
  const bool fit = bordersFit(maps, Periodic::detect);
  const std::vector<Risk> risks = valueOf(assessSuitability(maps.front(), fit));
  const JudgedMap unmeasured{maps.front().target, risks, {}};
  if (Verdict verdict = verdictOn({&unmeasured, 1}, fit); verdict.level != Verdict::Level::good)
    return verdict;
  MethodBake baked = valueOf(bakeTiling("held back", maps, {}));
  Bundle bundle;
  bundle.tables = std::move(baked.tables);
  bundle.noises = {std::move(baked.noise)};
  const auto measures = valueOf(measureNoise(bundle, {}, maps.front()));
  const JudgedMap judged{maps.front().target, risks, measures};
  return verdictOn({&judged, 1}, baked.figures.bordersWereKept);
}

/// Its name and sentence if the verdict is good and the noise is not, or the reverse.
std::string mistakeIn(const Verdict& verdict, const std::string& name, bool isGood) {
  if ((verdict.level == Verdict::Level::good) == isGood)
    return {};
  return name + ": " + sentenceOf(verdict, false);
}

/// A random side, or the given one.
int sideOf(Random& random, int given) {
  return given != 0
             ? given
             : int(random.range(float(kSmallestHeldBackSide), float(kLargestHeldBackSide + 1)));
}

/// "12 knit, noisy (outlines 0.12, strength 0.80)", or nothing if the choice is right.
std::string mistakeInChoice(int index, const HeldBackPicture& picture, bool hasStructure) {
  const Regularity found = regularityOfPrepared(preparedExemplar(picture.image));
  if (found.isClear() == hasStructure)
    return {};
  char numbers[64];
  std::snprintf(numbers, sizeof numbers, " (outlines %.2f, strength %.2f)", found.outlines,
                found.strength);
  return std::to_string(index) + " " + picture.name + numbers;
}

constexpr std::uint32_t kFirstSound = 110001, kFirstFaulty = 120001; // seeds
constexpr int kPerFaultyKind = 8;

std::string ofSound(int index) {
  constexpr auto kConditions = int(kConditionNames.size());
  return mistakeAboutSound(std::size_t(index / kConditions), std::size_t(index % kConditions), 0,
                           kFirstSound + std::uint32_t(index));
}

std::string ofFaulty(int index) {
  return mistakeAboutFaulty(std::size_t(index / kPerFaultyKind), 0,
                            kFirstFaulty + std::uint32_t(index));
}

std::string ofStructure(int index) {
  return mistakeInChoice(index, structuredHeldBack(index), true);
}

std::string ofNoStructure(int index) {
  return mistakeInChoice(index, stochasticHeldBack(index), false);
}

} // namespace

std::string mistakeAboutSound(std::size_t kind, std::size_t condition, int side,
                              std::uint32_t seed) {
  Random random(seed);
  const int pixels = sideOf(random, side);
  const SoundKind& sound = soundKinds()[kind];
  return mistakeIn(verdictOf(photographed(sound.draw, pixels, Condition(condition), random)),
                   std::string(sound.name) + ", " + kConditionNames[condition], true);
}

std::string mistakeAboutFaulty(std::size_t kind, int side, std::uint32_t seed) {
  Random random(seed);
  const int pixels = sideOf(random, side);
  const FaultyKind& faulty = faultyKinds()[kind];
  return mistakeIn(verdictOf(faulty.draw(pixels, random)),
                   std::string(faulty.name) + " of seed " + std::to_string(seed), false);
}

const std::array<HeldBackDecision, 4>& heldBackDecisions() {
  static constexpr std::array<HeldBackDecision, 4> kDecisions{
      {{"a sound material has a good verdict", 120, ofSound},
       {"a faulty picture has no good verdict", 128, ofFaulty},
       {"a picture with a structure is baked by quilting", kStructuredHeldBack, ofStructure},
       {"a picture without a structure is not", kStochasticHeldBack, ofNoStructure}}};
  return kDecisions;
}

const HeldBackDecision& structureIsQuilted() { return heldBackDecisions()[2]; }
const HeldBackDecision& noStructureIsNotQuilted() { return heldBackDecisions()[3]; }

ErrorRate rateOf(const HeldBackDecision& decision) {
  std::vector<std::string> mistakes(static_cast<std::size_t>(decision.pictures));
  tbb::parallel_for(0, decision.pictures, [&](int index) {
    mistakes[std::size_t(index)] = decision.mistakeAbout(index);
  });
  std::erase(mistakes, "");
  return {decision.pictures, std::move(mistakes)};
}

} // namespace lichen::test
