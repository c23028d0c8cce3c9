// SPDX-License-Identifier: MIT
// --report of `lichen bake`: the HTML page beside the bundle.
#pragma once

#include "command.h"

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/noise_report.h>
#include <lichen/suitability.h>

#include <chrono>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace lichen::cli {

/// What the steps of a bake take.
class StepTimes {
public:
  /// Ends the step that began where the last one ended.
  void end(const std::string& step);
  [[nodiscard]] const std::vector<std::pair<std::string, double>>& steps() const { return steps_; }
  [[nodiscard]] double sum() const; ///< seconds

private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::vector<std::pair<std::string, double>> steps_;
};

/// What the page tells of a bake besides the bundle.
struct ReportedBake {
  std::vector<std::string> inputs;
  std::string output;
  const Bundle& bundle; ///< of one noise and one material
  std::span<const MapExemplar> exemplars;
  std::span<const std::vector<Risk>> risks;                   ///< of each exemplar
  std::span<const ExemplarOrigin> origins;                    ///< the same
  std::span<const std::pair<std::string, std::string>> facts; ///< of the method
  std::vector<std::string> notes;
  std::vector<std::pair<std::string, double>> timings; ///< of StepTimes
};

/// Refuses a name without .html, or in a folder that is absent; not the empty one, for no report.
[[nodiscard]] Result<void> checkReportPath(const std::string& path);

/// Measures the noise, shows how far that is, and writes the page; nothing for an empty path.
[[nodiscard]] Result<void> writeHtmlReport(const std::string& path, const ReportedBake& bake,
                                           const SharedOptions& options);

} // namespace lichen::cli
