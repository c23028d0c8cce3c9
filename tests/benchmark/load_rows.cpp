// SPDX-License-Identifier: MIT
// Time in which the engine plugin reads and checks a bundle: as glTF, and cooked.
#include "benchmark_noises.h"
#include "exemplars.h"
#include "rows.h"

#include <lichen/bundle_writer.h>
#include <lichen/lichen.h>

#include <stdexcept>
#include <string>

namespace lichen::bench {
namespace {

using Bytes = std::vector<std::byte>;

/// Median of some loads, in milliseconds.
double loadMilliseconds(const Bytes& file, bool inPlace) {
  constexpr int kRuns = 51;
  LichenParseInfo info;
  LICHEN_INIT(info, LICHEN_STRUCTURE_PARSE_INFO);
  info.headerVersion = LICHEN_HEADER_VERSION;
  info.bytes = file.data();
  info.byteCount = file.size();
  info.bytesStay = inPlace ? 1 : 0;
  return 1e3 * medianSeconds(kRuns, [&] {
           LichenBundle bundle = nullptr;
           if (lichenParseBundle(&info, &bundle, nullptr) != LICHEN_SUCCESS)
             throw std::runtime_error("the plugin refuses a bundle of this benchmark");
           lichenDestroyBundle(bundle);
         });
}

void appendRows(std::vector<Row>& rows, const std::string& what, const Bytes& glb) {
  const Bytes cooked = cookBundle(parseBundle(glb, what).value());
  const auto row = [&](const std::string& how, const Bytes& file, bool inPlace) {
    rows.push_back({what + ", " + how,
                    loadMilliseconds(file, inPlace),
                    kNoTarget,
                    "ms",
                    "",
                    false,
                    {{"KB", double(file.size()) / 1000.0}}});
  };
  row(".glb", glb, false);
  row("cooked, copied", cooked, false);
  row("cooked, in place", cooked, true);
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
