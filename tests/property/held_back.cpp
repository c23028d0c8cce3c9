// SPDX-License-Identifier: MIT
// The error rates of the decisions that `lichen bake` makes: the verdict that it prints first, and
// the choice between tiling and quilting. Each must be below a tenth, at a confidence of 95 %, over
// pictures of these kinds in equal shares, of 176 to 208 pixels; a smaller group at 512 pixels
// bounds the verdict's less closely. held_back_decisions.h says why no threshold may be chosen with
// them, verdict_held_back_pictures.h what in the verdict depends on earlier pictures of these
// kinds.
#include "held_back_decisions.h"
#include "verdict_held_back_pictures.h"

#include <catch2/catch.hpp>

using namespace lichen::test;

namespace {

std::string reportOf(const ErrorRate& rate) {
  std::string lines = std::to_string(rate.wrong.size()) + " of " + std::to_string(rate.pictures) +
                      " wrong, rate at most " + std::to_string(rate.upperBound()) + "\n";
  for (const std::string& name : rate.wrong)
    lines += name + "\n";
  return lines;
}

} // namespace

TEST_CASE("fewer than a tenth of the held-back pictures are judged wrongly", "[large]") {
  for (const HeldBackDecision& decision : heldBackDecisions())
    DYNAMIC_SECTION(decision.expected) {
      const ErrorRate rate = rateOf(decision);
      INFO(reportOf(rate));
      CHECK(rate.upperBound() < 0.1);
    }
}

// With one error each, four and sixteen pictures bound the rates only to 76 and 27 %. A material
// takes some seconds, so only every third is here, each under another condition.
TEST_CASE(
    "of the held-back pictures of 512 pixels at most one material and one fault are misjudged",
    "[large]") {
  constexpr int kSide = 512;
  std::uint32_t seed = 130000;
  ErrorRate sound, faulty;
  for (std::size_t k = 0; k < soundKinds().size(); k += 3)
    sound.wrong.push_back(mistakeAboutSound(k, k % kConditionNames.size(), kSide, ++seed));
  for (std::size_t k = 0; k < faultyKinds().size(); ++k)
    faulty.wrong.push_back(mistakeAboutFaulty(k, kSide, ++seed));
  for (ErrorRate* const rate : {&sound, &faulty}) {
    rate->pictures = int(rate->wrong.size());
    std::erase(rate->wrong, "");
    INFO(reportOf(*rate));
    CHECK(rate->wrong.size() <= 1);
  }
}
