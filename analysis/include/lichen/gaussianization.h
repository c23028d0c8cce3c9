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

/// How close to the optimum the optimal transport gets: its largest cost above the optimum,
/// measured on the exemplars of docs/decisions/004-transport.md.
enum class TransportEffort {
  fast,     ///< 0.4 %; for previews
  standard, ///< 0.1 %; for production
};

struct GaussianizationOptions {
  Periodic periodic = Periodic::detect;
  int bits = 8; ///< 8 or 16 per channel of the tables
  TransportEffort transport = TransportEffort::standard;
  GaussianOnly gaussian = GaussianOnly::detect;
  Progress progress; ///< empty: no reports
};

} // namespace lichen
