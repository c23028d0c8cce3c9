// SPDX-License-Identifier: MIT
// A map -> the risks of textons -> the one that random phases have.
#include "outline_risks.h"

#include <algorithm>

namespace lichen {

Result<std::vector<Risk>> outlineRisks(const MapExemplar& map, const std::vector<BakeSetting>& more,
                                       const Progress& progress) {
  const int support = std::max(map.width, map.height); // nothing is slower than the tile
  Result<std::vector<Risk>> risks = assessTextonSuitability(map, support, progress);
  if (!risks)
    return risks;
  std::vector<Risk> kept;
  std::ranges::copy_if(risks.value(), std::back_inserter(kept),
                       [](const Risk& risk) { return risk.name == "outlines"; });
  for (Risk& risk : kept)
    if (risk.level != Risk::Level::none)
      risk.settings.insert(risk.settings.begin(), more.begin(), more.end());
  return kept;
}

} // namespace lichen
