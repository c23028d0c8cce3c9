// SPDX-License-Identifier: MIT
// `lichen bake --report`: the HTML page about what it made.
#pragma once

#include "bake_risks.h"
#include "command.h"

#include <lichen/bake_material.h>

#include <string>
#include <vector>

namespace lichen::cli {

/// What the page shows in addition to the bundle.
struct ReportedBake {
  std::vector<std::string> files; ///< of the command line
  std::string output;
  const Bundle& bundle; ///< its first noise is shown, as its one material uses it
  const BakedMaterial& baked;
  const nlohmann::ordered_json& figures; ///< of the method
};

/// Declares --report.
void addReport(CLI::App& verb, std::string& path);

/// Errors: usage for a name without .html or .htm, environment for a folder that does not exist. An
/// empty path, which means no report, is valid.
[[nodiscard]] Result<void> checkReportPath(const std::string& path);

/// Measures the noise, with a progress line, and writes the page. Returns the lines to print: the
/// page, and the targets that the noise misses. Does nothing if `path` is empty.
[[nodiscard]] Result<std::vector<std::string>>
writeHtmlReport(const std::string& path, const ReportedBake& bake, const SharedOptions& options);

} // namespace lichen::cli
