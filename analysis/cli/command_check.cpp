// SPDX-License-Identifier: MIT
// lichen check: validates our extension: its schema, index ranges, table headers and sizes.
#include "command.h"
#include "options.h"

#include <lichen/bundle_files.h>
#include <lichen/counted.h>
#include <lichen/escaped.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace lichen::cli {
namespace {

struct Arguments {
  explicit Arguments(const SharedOptions& options) : shared(options) {}

  const SharedOptions& shared;
  std::string bundle;
};

const char* severityName(Finding::Severity severity) {
  return severity == Finding::Severity::error ? "error" : "warning";
}

Result<int> run(const Arguments& arguments) {
  const Result<std::vector<Finding>> findings = checkBundle(arguments.bundle);
  if (!findings)
    return findings.error();
  std::size_t errors = 0;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Finding& finding : findings.value()) {
    const bool isError = finding.severity == Finding::Severity::error;
    errors += isError ? 1 : 0;
    list.push_back({{"severity", severityName(finding.severity)},
                    {"code", finding.code},
                    {"pointer", finding.pointer},
                    {"message", finding.message}});
    if (!arguments.shared.json && (isError || !arguments.shared.quiet))
      printLine(
          escaped(fmt::format("{}: {} [{}] at {}", severityName(finding.severity), finding.message,
                              finding.code, finding.pointer.empty() ? "/" : finding.pointer)));
  }
  if (arguments.shared.json) {
    const nlohmann::ordered_json report{{"file", arguments.bundle},
                                        {"errors", errors},
                                        {"warnings", findings.value().size() - errors},
                                        {"findings", list}};
    printLine(toText(report));
  }
  say(arguments.shared, fmt::format("{}: {}, {}", arguments.bundle, counted(errors, "error"),
                                    counted(findings.value().size() - errors, "warning")));
  return errors == 0 ? kDone : kFound;
}

} // namespace

Runner addCheck(CLI::App& verb, const SharedOptions& shared) {
  auto arguments = std::make_shared<Arguments>(shared);
  addText(verb, "BUNDLE", arguments->bundle, "", "A .glb, .gltf or .lichen").required();
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
