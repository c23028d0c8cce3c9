// SPDX-License-Identifier: MIT
// Maps -> the risks of textons -> the one that random phases have.
#include "outline_risks.h"

#include <algorithm>

namespace lichen::cli {

Result<std::vector<std::vector<Risk>>> outlineRisks(std::span<const MapExemplar> maps,
                                                    const SharedOptions& shared,
                                                    const std::vector<BakeSetting>& more) {
  return assessEach(
      maps, shared,
      [&](const MapExemplar& map, const Progress& progress) -> Result<std::vector<Risk>> {
        const int support = std::max(map.width, map.height); // nothing is slower than the tile
        Result<std::vector<Risk>> risks = assessTextonSuitability(map, support, progress);
        if (!risks)
          return risks;
        std::vector<Risk> kept;
        std::copy_if(risks.value().begin(), risks.value().end(), std::back_inserter(kept),
                     [](const Risk& risk) { return risk.name == "outlines"; });
        for (Risk& risk : kept)
          if (risk.level != Risk::Level::none)
            risk.settings.insert(risk.settings.end(), more.begin(), more.end());
        return kept;
      });
}

} // namespace lichen::cli
