// SPDX-License-Identifier: MIT
// A bake's outcome -> text or JSON.
#include "bake_report.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace lichen::cli {
namespace {

int dimensionsOf(const Table& gaussian) {
  return std::min(3, channelCount(gaussian.format)); // a fourth is unused
}

/// How the map's Gaussian values become its own.
const char* tableKind(const NoiseMap& map) {
  if (!map.inverseTable)
    return "none";
  return map.tableOffset.empty() ? "joint" : "separable";
}

nlohmann::ordered_json asJson(const PrecisionLoss& loss) {
  nlohmann::ordered_json json{
      {"mean", loss.mean}, {"variance", loss.variance}, {"colorDistance", loss.colorDistance}};
  if (loss.roundTrip)
    json["roundTrip"] = *loss.roundTrip;
  return json;
}

} // namespace

void reportBake(const SharedOptions& options, const BakeOutcome& outcome) {
  const Noise& noise = outcome.bundle.noises.front();
  const Table& gaussian = outcome.bundle.tables[noise.maps.front().gaussian];
  std::size_t tableBytes = 0;
  for (const Table& table : outcome.bundle.tables)
    tableBytes += table.texels.size();
  if (options.json) {
    nlohmann::ordered_json maps = nlohmann::ordered_json::array();
    for (const NoiseMap& map : noise.maps) {
      const Table& image = outcome.bundle.tables[map.gaussian];
      nlohmann::ordered_json channels = nlohmann::ordered_json::array();
      for (const MapChannel channel : map.channels)
        channels.push_back(nameOf(channel));
      maps.push_back({{"target", nameOf(map.target)},
                      {"channels", channels},
                      {"width", image.width},
                      {"height", image.height},
                      {"dimensions", dimensionsOf(image)}});
    }
    const nlohmann::ordered_json json{{"output", outcome.output},
                                      {"name", noise.name},
                                      {"method", noise.method},
                                      {"width", gaussian.width},
                                      {"height", gaussian.height},
                                      {"dimensions", dimensionsOf(gaussian)},
                                      {"maps", maps},
                                      {"periodic", outcome.exemplarWasPeriodic},
                                      {"table", tableKind(noise.maps.front())},
                                      {"tableBytes", tableBytes},
                                      {"precisionLoss", asJson(outcome.precisionLoss)},
                                      {"risks", risksAsJson(outcome.risks)},
                                      {"notes", outcome.notes},
                                      {"seconds", outcome.seconds}};
    printLine(toText(json));
    return;
  }
  std::string targets;
  for (const NoiseMap& map : noise.maps)
    targets += (targets.empty() ? "" : ", ") + std::string(nameOf(map.target));
  say(options, fmt::format("{}: {}, {} x {}, {} KiB of tables, {:.2f} s", outcome.output, targets,
                           gaussian.width, gaussian.height, tableBytes / 1024, outcome.seconds));
}

} // namespace lichen::cli
