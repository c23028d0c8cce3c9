// SPDX-License-Identifier: MIT
// A bake's outcome -> text or JSON.
#include "bake_report.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace lichen::cli {
namespace {

/// Of the values that are stored for a map.
int dimensionsOf(const Bundle& bundle, const Noise& noise, const NoiseMap& map) {
  if (noise.method() == Method::texton)
    return int(map.channels.size());
  return std::min(
      3, channelCount(bundle.tables[map.as<TilingMap>().gaussian].format)); // a fourth is unused
}

nlohmann::ordered_json asJson(const PrecisionLoss& loss) {
  nlohmann::ordered_json json{
      {"mean", loss.mean}, {"variance", loss.variance}, {"colorDistance", loss.colorDistance}};
  if (loss.roundTrip)
    json["roundTrip"] = *loss.roundTrip;
  return json;
}

nlohmann::ordered_json asJson(const TextonQuality& quality) {
  nlohmann::ordered_json json{{"modelError", quality.modelError},
                              {"channelErrors", quality.channelErrors}};
  if (quality.heldOutError)
    json["heldOutError"] = *quality.heldOutError;
  json["flatness"] = quality.flatness;
  json["covarianceError"] = quality.covarianceError;
  return json;
}

/// The worst of each map's bounds: with borders that are blended it has two.
std::vector<MapTransportBound> worstBounds(std::span<const MapTransportBound> bounds) {
  std::vector<MapTransportBound> worst;
  for (const MapTransportBound& bound : bounds)
    if (worst.empty() || worst.back().map != bound.map)
      worst.push_back(bound);
    else if (bound.excess() > worst.back().excess())
      worst.back() = bound;
  return worst;
}

/// Whether the map's values were moved before they were matched.
bool isMoved(MapTarget map, std::span<const MapTransportBound> bounds) {
  return std::any_of(bounds.begin(), bounds.end(), [map](const MapTransportBound& bound) {
    return bound.map == map && bound.costOfUnmoved;
  });
}

nlohmann::ordered_json asJson(std::span<const MapTransportBound> bounds) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const MapTransportBound& bound : worstBounds(bounds))
    json.push_back({{"map", nameOf(bound.map)},
                    {"excess", bound.excess()},
                    {"moved", isMoved(bound.map, bounds)},
                    {"byConstruction", bound.isSorted}});
  return json;
}

} // namespace

std::vector<std::string> certificateNotes(std::span<const MapTransportBound> bounds) {
  std::vector<std::string> notes;
  for (const MapTransportBound& bound : worstBounds(bounds))
    notes.push_back(
        bound.isSorted
            ? fmt::format(
                  "the values of {} have one dimension and are sorted, which is the optimum",
                  nameOf(bound.map))
            : fmt::format(
                  "the values of {}{} are matched within {:.3f} % of the optimum, certified",
                  nameOf(bound.map),
                  isMoved(bound.map, bounds) ? ", moved to go with the other maps," : "",
                  100.0 * bound.excess()));
  return notes;
}

void reportBake(const SharedOptions& options, const BakeOutcome& outcome) {
  const Noise& noise = outcome.bundle.noises.front();
  const NoiseMap& first = noise.maps.front();
  const auto [width, height] = exemplarSize(outcome.bundle, noise, first);
  const std::size_t tableBytes = texelBytes(outcome.bundle);
  if (options.json) {
    nlohmann::ordered_json maps = nlohmann::ordered_json::array();
    for (const NoiseMap& map : noise.maps) {
      const auto [mapWidth, mapHeight] = exemplarSize(outcome.bundle, noise, map);
      nlohmann::ordered_json channels = nlohmann::ordered_json::array();
      for (const MapChannel channel : map.channels)
        channels.push_back(nameOf(channel));
      maps.push_back({{"target", nameOf(map.target)},
                      {"channels", channels},
                      {"width", mapWidth},
                      {"height", mapHeight},
                      {"dimensions", dimensionsOf(outcome.bundle, noise, map)}});
    }
    nlohmann::ordered_json json{
        {"output", outcome.output},
        {"name", noise.name},
        {"method", nameOf(noise.method())},
        {"width", width},
        {"height", height},
        {"dimensions", dimensionsOf(outcome.bundle, noise, first)},
        {"maps", maps},
        {"periodic", outcome.exemplarWasPeriodic},
        {"table", nameOf(noise.method() == Method::tiling ? tableKindOf(first.as<TilingMap>())
                                                          : TableKind::none)},
        {"tableBytes", tableBytes},
        {"transport", asJson(outcome.transportBounds)},
        {"risks", risksAsJson(outcome.risks)},
        {"notes", outcome.notes},
        {"seconds", outcome.seconds}};
    if (outcome.precisionLoss)
      json["precisionLoss"] = asJson(*outcome.precisionLoss);
    if (outcome.texton)
      json["texton"] = asJson(*outcome.texton);
    printLine(toText(json));
    return;
  }
  std::string targets;
  for (const NoiseMap& map : noise.maps)
    targets += (targets.empty() ? "" : ", ") + std::string(nameOf(map.target));
  say(options, fmt::format("{}: {}, {} x {}, {} KiB of tables, {:.2f} s", outcome.output, targets,
                           width, height, tableBytes / 1024, outcome.seconds));
}

} // namespace lichen::cli
