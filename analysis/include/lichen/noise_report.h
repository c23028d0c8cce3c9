// SPDX-License-Identifier: MIT
// The report of a bake: one HTML page with pictures, measures and charts, for a person to judge by.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/progress.h>
#include <lichen/suitability.h>

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lichen {

/// What was done to a photograph's map until it was baked.
struct ExemplarOrigin {
  std::vector<std::string> steps;      ///< such as "cropped", in their order
  std::optional<MapExemplar> original; ///< before it was flattened; nothing where it was not
};

/// A bake that is done, as the caller knows it. Texts may hold anything; what is not UTF-8 is
/// replaced. What is referred to outlives the call.
struct BakeRecord {
  const Bundle& bundle;                   ///< of one noise and one material
  std::span<const MapExemplar> exemplars; ///< of every map that is to be shown
  /// What assessSuitability() says of each exemplar, in their order.
  std::span<const std::vector<Risk>> risks;
  std::span<const ExemplarOrigin> origins; ///< of each exemplar
  std::string command;                     ///< the line that made it
  /// Name and value, such as {"Version", "0.1.0"}, shown in order.
  std::vector<std::pair<std::string, std::string>> facts;
  /// What took how many seconds; the report adds its own making and the sum.
  std::vector<std::pair<std::string, double>> timings;
  std::vector<std::string> notes;
};

/// The bytes of a page that needs no other file and no network. Pictures are at most 512 pixels an
/// exemplar and smaller where there are many maps, so that the page of one map stays below 8 MiB
/// and that of six below 16. Synthesizes and measures as compareNoise() does, so that it takes
/// seconds. Errors: as compareNoise().
[[nodiscard]] Result<std::vector<std::byte>> encodeNoiseReport(const BakeRecord& record,
                                                               const Progress& progress = {});

} // namespace lichen
