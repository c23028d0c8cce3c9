// SPDX-License-Identifier: MIT
// A finished bake -> text or JSON.
#include "bake_report.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace lichen::cli {
namespace {

nlohmann::ordered_json describeMaps(const Bundle& bundle, const Noise& noise) {
  nlohmann::ordered_json maps = nlohmann::ordered_json::array();
  for (const NoiseMap& map : noise.maps) {
    const auto [width, height] = exemplarSize(bundle, noise, map);
    nlohmann::ordered_json channels = nlohmann::ordered_json::array();
    for (const MapChannel channel : map.channels)
      channels.push_back(nameOf(channel));
    maps.push_back({{"target", nameOf(map.target)},
                    {"channels", channels},
                    {"width", width},
                    {"height", height}});
  }
  return maps;
}

} // namespace

void reportBake(const SharedOptions& options, const BakeOutcome& outcome) {
  const Noise& noise = outcome.bundle.noises.front();
  const auto [width, height] = exemplarSize(outcome.bundle, noise, noise.maps.front());
  const std::size_t tableBytes = texelBytes(outcome.bundle);
  if (options.json) {
    nlohmann::ordered_json json{{"output", outcome.output},
                                {"name", noise.name},
                                {"method", nameOf(noise.method())},
                                {"width", width},
                                {"height", height},
                                {"maps", describeMaps(outcome.bundle, noise)},
                                {"tableBytes", tableBytes},
                                {"verdict", jsonOf(outcome.verdict)},
                                {"risks", risksAsJson(outcome.risks)},
                                {"notes", outcome.notes},
                                {"seconds", outcome.seconds}};
    json.update(outcome.ofMethod);
    printLine(toText(json));
    return;
  }
  say(options, verdictLine(outcome.verdict, noise.maps.size() > 1));
  std::string targets;
  for (const NoiseMap& map : noise.maps)
    targets += (targets.empty() ? "" : ", ") + std::string(nameOf(map.target));
  say(options, fmt::format("{}: {}, {} x {}, {} KiB of tables, {:.2f} s", outcome.output, targets,
                           width, height, tableBytes / 1024, outcome.seconds));
}

} // namespace lichen::cli
