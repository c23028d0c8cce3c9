// SPDX-License-Identifier: MIT
// The report of a bake: one HTML page with pictures, measures and charts, for people to judge it.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/noise_verdict.h>
#include <lichen/progress.h>
#include <lichen/suitability.h>

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lichen {

/// The steps from a photograph's map to the exemplar that was baked.
struct ExemplarOrigin {
  std::vector<std::string> steps;      ///< for example "cropped", in order
  std::optional<MapExemplar> original; ///< before all steps but crop and size; empty if none
};

/// A finished bake, as the caller knows it. Texts may hold any bytes; invalid UTF-8 is
/// replaced. The objects referred to must outlive the call.
struct BakeRecord {
  const Bundle& bundle; ///< the first noise is shown, and the first material's use of it
  std::span<const MapExemplar> exemplars; ///< every map to show
  /// The result of assessNoise() for each exemplar, in the same order.
  std::span<const std::vector<Risk>> risks;
  std::span<const ExemplarOrigin> origins; ///< one per exemplar
  std::optional<Verdict> verdict{};        ///< the page begins with it
  SettingWords words = plainWords;         ///< for settings that help against a risk
  std::string command;                     ///< the command line
  /// Pairs of name and value, for example {"Version", "0.1.0"}, shown in order.
  std::vector<std::pair<std::string, std::string>> facts;
  std::vector<std::string> notes;
};

/// The most pixels of all pictures of a page.
inline constexpr double kReportPixels = 3.5e6;

/// The page, and the targets that the noise misses.
struct NoiseReport {
  std::vector<std::byte> page; ///< an HTML file
  std::size_t targets = 0;     ///< how many measures have a target
  /// One line per missed target: "baseColor: color_distance 0.00412 exceeds its target of 0.003".
  std::vector<std::string> missedTargets;
};

/// Returns a page that needs no other file and no network. An exemplar's picture has at most 512^2
/// pixels, and fewer if there are many maps, because all pictures together have at most
/// kReportPixels. A pixel takes at most 4 bytes, so the page stays below 14 MiB (about 7 MiB for
/// photographs). Synthesizes and measures as compareNoise() does, which takes seconds. Errors: as
/// compareNoise() and synthesize().
[[nodiscard]] Result<NoiseReport> encodeNoiseReport(const BakeRecord& record,
                                                    const Progress& progress = {});

} // namespace lichen
