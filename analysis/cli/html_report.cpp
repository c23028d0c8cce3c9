// SPDX-License-Identifier: MIT
// A bake -> a BakeRecord -> the HTML file.
#include "html_report.h"

#include "options.h"
#include "progress_line.h"

#include <lichen/files.h>
#include <lichen/noise_report.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace lichen::cli {
namespace {

std::vector<std::pair<std::string, std::string>> reportedFacts(const ReportedBake& bake) {
  constexpr double kBytesPerKib = 1024.0;
  const Noise& noise = bake.bundle.noises.front();
  const MaterialNoise& material = *bake.bundle.materials.front();
  std::vector<std::pair<std::string, std::string>> facts{
      {"Exemplar", fmt::format("{}", fmt::join(bake.files, ", "))},
      {"Bundle", bake.output},
      {"Method",
       fmt::format("{}, revision {}", nameOf(noise.method()), revisionOf(noise.method()))},
      {"Seed", std::to_string(material.seed)},
      {"Width", fmt::format("{:g} m", noise.tileSizeMetres)}};
  for (const auto& [name, value] : bake.figures.items())
    facts.emplace_back(name, wordsOf(value));
  facts.emplace_back("Tables", fmt::format("{:.0f} KiB on the GPU",
                                           double(texelBytes(bake.bundle)) / kBytesPerKib));
  facts.emplace_back("Version", "lichen " LICHEN_VERSION);
  return facts;
}

} // namespace

void addReport(CLI::App& verb, std::string& path) {
  addText(verb, "--report", path, "OUT.html",
          "Also write a page with pictures, measures and charts of the noise; takes 5 to 30 s per "
          "map");
}

Result<void> checkReportPath(const std::string& path) {
  return path.empty() ? Result<void>() : checkOutput(path, {".html", ".htm"});
}

Result<std::vector<std::string>> writeHtmlReport(const std::string& path, const ReportedBake& bake,
                                                 const SharedOptions& options) {
  if (path.empty())
    return std::vector<std::string>{};
  ProgressLine progress("report", options);
  const BakeRecord record{.bundle = bake.bundle,
                          .exemplars = bake.baked.exemplars,
                          .risks = bake.baked.judgement.risks,
                          .origins = bake.baked.origins,
                          .verdict = bake.baked.judgement.verdict,
                          .words = optionOf,
                          .command = options.commandLine,
                          .facts = reportedFacts(bake),
                          .notes = bake.baked.notes};
  const Result<NoiseReport> report = encodeNoiseReport(record, progress.asProgress());
  if (!report)
    return report.error();
  if (Result<void> written = replaceFile(path, report.value().page); !written)
    return written.error();
  const std::vector<std::string>& missed = report.value().missedTargets;
  const std::size_t targets = report.value().targets;
  std::vector<std::string> lines{path + ": report"};
  if (targets > 0)
    lines.front() +=
        missed.empty() ? std::string("; the noise meets all targets")
                       : fmt::format("; the noise misses {} of {} targets", missed.size(), targets);
  for (const std::string& line : missed)
    lines.push_back("  " + line);
  return lines;
}

} // namespace lichen::cli
