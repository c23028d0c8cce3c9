// SPDX-License-Identifier: MIT
// The steps of `lichen bake` before the noise, in its order.
#include "prepared_exemplar.h"

#include "base_color.h"

#include <lichen/exemplar_repair.h>

#include <exemplar/frame.h>
#include <exemplar/resample.h>
#include <stdexcept>

namespace lichen::test {

std::vector<MapExemplar> preparedExemplar(const SrgbImage& photograph) {
  std::vector<MapExemplar> maps{baseColor(photograph)};
  if (const auto inside = exemplar::insideOfFrame(maps.front()))
    maps.front() = exemplar::cropped(maps.front(), *inside);
  (void)valueOf(removeUnevenLight(maps.front(), bordersFit(maps, Periodic::detect)));
  (void)valueOf(fillOutliers(maps, bordersFit(maps, Periodic::detect)));
  return maps;
}

Regularity regularityOfPrepared(const std::vector<MapExemplar>& exemplar) {
  return valueOf(regularityOf(exemplar, Periodic::detect));
}

std::vector<MapExemplar> wholePeriodsOf(std::vector<MapExemplar> exemplar,
                                        const Regularity& regularity) {
  if (regularity.wholePeriods)
    if (Result<void> made = rectify(exemplar, *regularity.wholePeriods); !made)
      throw std::runtime_error(made.error().message);
  return exemplar;
}

} // namespace lichen::test
