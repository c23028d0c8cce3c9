// SPDX-License-Identifier: MIT
// Generated photographs of structured materials, as `lichen bake` makes exemplars of them.
#pragma once

#include <lichen/image.h>

#include <string>
#include <vector>

namespace lichen::bench {

struct StructuredSubject {
  std::string name;     ///< "bond-turned-3"
  std::string material; ///< "bond"
  SrgbImage exemplar;   ///< the part of the photograph that holds whole periods, in even light
  /// The generator's, in the photograph; 0 if the material does not repeat, as cobbles. [pixels]
  double shortestPeriod = 0.0;
  /// The cell of each pixel, as StructuredPicture::cells; empty if the material has none or if the
  /// exemplar is not the whole photograph.
  std::vector<int> cells;
};

/// Those whose structure `lichen bake` finds with a strength above 0.5, of photographs of
/// `sidePixels` a side: all materials of structured.h in five conditions.
[[nodiscard]] std::vector<StructuredSubject> structuredSubjects(int sidePixels);

} // namespace lichen::bench
