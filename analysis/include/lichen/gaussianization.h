// SPDX-License-Identifier: MIT
// How a bake Gaussianizes the maps of an exemplar and fits their inverse tables: [HN18] section 4.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/progress.h>

namespace lichen {

/// Whether maps with Gaussian stored values omit the inverse table.
enum class GaussianOnly {
  detect, ///< test each map (docs/decisions/002-inverse-tables.md)
  yes,    ///< all maps omit it; values that are not Gaussian get another histogram
  no
};

struct GaussianizationOptions {
  Periodic periodic = Periodic::detect;
  int bits = 8; ///< 8 or 16 per channel of the tables
  GaussianOnly gaussian = GaussianOnly::detect;
  Progress progress; ///< empty: no reports
};

} // namespace lichen
