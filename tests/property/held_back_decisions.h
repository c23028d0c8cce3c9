// SPDX-License-Identifier: MIT
// How often `lichen bake` decides wrongly about held-back pictures, of which the right decision is
// known: whether it judges their noise as good, and whether it bakes them by quilting.
//
// NOTHING MAY BE TUNED WITH THESE PICTURES: no threshold may change because of what they show, or
// their rates say nothing about other pictures. After a change for other reasons they are drawn
// again with new seeds; docs/decisions/007-verdicts.md and 012-quilting.md have the rates of all
// draws.
#pragma once

#include "error_rate.h"

#include <array>

namespace lichen::test {

struct HeldBackDecision {
  const char* expected; ///< "a sound material has a good verdict"
  int pictures = 0;
  /// The name of the picture with this index and what was decided, or nothing if that is right.
  std::string (*mistakeAbout)(int index) = nullptr;
};

[[nodiscard]] const std::array<HeldBackDecision, 4>& heldBackDecisions();
[[nodiscard]] const HeldBackDecision& structureIsQuilted();
[[nodiscard]] const HeldBackDecision& noStructureIsNotQuilted();

/// Takes some ten seconds to minutes. Errors are thrown as std::runtime_error.
[[nodiscard]] ErrorRate rateOf(const HeldBackDecision& decision);

/// The mistake about a picture of this side in place of its own; see mistakeAbout().
[[nodiscard]] std::string mistakeAboutSound(std::size_t kind, std::size_t condition, int side,
                                            std::uint32_t seed);
[[nodiscard]] std::string mistakeAboutFaulty(std::size_t kind, int side, std::uint32_t seed);

} // namespace lichen::test
