// SPDX-License-Identifier: MIT
// Time in which the engine plugin reads and checks a bundle.
#include "benchmark_noises.h"
#include "exemplars.h"
#include "rows.h"

#include <lichen/lichen.h>

#include <stdexcept>
#include <string>

namespace lichen::bench {
namespace {

using Bytes = std::vector<std::byte>;

/// Median of some loads, in milliseconds.
double loadMilliseconds(const Bytes& file) {
  constexpr int kRuns = 51;
  LichenParseInfo info;
  LICHEN_INIT(info, LICHEN_STRUCTURE_PARSE_INFO);
  info.headerVersion = LICHEN_HEADER_VERSION;
  info.bytes = file.data();
  info.byteCount = file.size();
  return 1e3 * medianSeconds(kRuns, [&] {
           LichenBundle bundle = nullptr;
           if (lichenParseBundle(&info, &bundle, nullptr) != LICHEN_SUCCESS)
             throw std::runtime_error("the plugin refuses a bundle of this benchmark");
           lichenDestroyBundle(bundle);
         });
}

void appendRows(std::vector<Row>& rows, const std::string& what, const Bytes& glb) {
  rows.push_back({what,
                  loadMilliseconds(glb),
                  kNoTarget,
                  "ms",
                  "",
                  false,
                  {{"KB", double(glb.size()) / 1000.0}}});
}

} // namespace

std::vector<Row> loadRows() {
  std::vector<Row> rows;
  appendRows(rows, "tiling of one map", tilingGlb(GaussianOnly::no));
  appendRows(rows, "texton that reaches 64 texels", textonGlb());
  for (const MaterialSet& set : photographedSets())
    appendRows(rows, set.name, setGlb(set.maps));
  return rows;
}

} // namespace lichen::bench
