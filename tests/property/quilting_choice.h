// SPDX-License-Identifier: MIT
// How often `lichen bake` without --method chooses quilting wrongly, over the pictures of
// quilting_held_back.h.
//
// NOTHING MAY BE TUNED WITH THESE PICTURES: no threshold of the choice may change because of what
// they show, or their rates say nothing about other pictures. After a change for other reasons they
// are drawn again with new seeds; docs/decisions/012-quilting.md has the rates of all draws.
#pragma once

#include "error_rate.h"

namespace lichen::test {

/// Pictures with a structure that are not baked by quilting.
[[nodiscard]] ErrorRate quiltingMisses();

/// Pictures without a structure that are.
[[nodiscard]] ErrorRate quiltingFalseAlarms();

} // namespace lichen::test
