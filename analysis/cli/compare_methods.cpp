// SPDX-License-Identifier: MIT
// Exemplar -> a bundle of each method -> a table, and a page with pictures.
#include "compare_methods.h"

#include "method_choice.h"
#include "progress_line.h"

#include <lichen/files.h>
#include <lichen/judgement_json.h>
#include <lichen/quality.h>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace lichen::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kBytesPerKib = 1024.0;

std::string cellOf(const Measure& measure) {
  return measure.value ? fmt::format("{:.3g}", *measure.value) : "-";
}

std::vector<std::string> linesOf(const std::vector<MethodRow>& rows) {
  constexpr const char *kName = "{:<20}", *kNumber = "{:>15}", *kMeasure = "{:>23}";
  std::string head = fmt::format(kName, "") + fmt::format(kNumber, "look_distance");
  for (const Measure& measure : rows.front().measures)
    head += fmt::format(kMeasure, measure.name);
  for (const char* name : {"GPU KiB", "plain fetches", "bake s"})
    head += fmt::format(kNumber, name);
  std::vector<std::string> lines{head};
  for (const MethodRow& row : rows) {
    std::string line = fmt::format(kName, nameOf(row.method)) +
                       fmt::format(kNumber, fmt::format("{:.4f}", row.distance));
    for (const Measure& measure : row.measures)
      line += fmt::format(kMeasure, cellOf(measure));
    line += fmt::format(kNumber, fmt::format("{:.0f}", double(row.gpuBytes) / kBytesPerKib)) +
            fmt::format(kNumber, fmt::format("{:.0f}", row.plainFetches)) +
            fmt::format(kNumber, fmt::format("{:.1f}", row.bakeSeconds));
    lines.push_back(std::move(line));
  }
  return lines;
}

Json jsonOf(const MethodRow& row) {
  Json measures = Json::array();
  for (const Measure& measure : row.measures)
    measures.push_back(lichen::jsonOf(measure));
  return {{"method", nameOf(row.method)},
          {"lookDistance", row.distance},
          {"measures", measures},
          {"gpuBytes", row.gpuBytes},
          {"plainFetches", row.plainFetches},
          {"bakeSeconds", row.bakeSeconds}};
}

/// The methods' own defaults, as `bake` has them.
MethodOptions defaultOptions(const CommonOptions& common) {
  CLI::App verb;
  MethodOptions methods;
  for (const Method method : allMethods())
    methods.push_back(commandOf(method).addBakeOptions(verb, common));
  return methods;
}

} // namespace

BakeMemory memoryOfMethods() {
  const CommonOptions common;
  return largestMemory(defaultOptions(common));
}

Result<int> compareMethods(const ComparedExemplar& exemplar, const std::string& report,
                           const SharedOptions& shared) {
  if (std::min(exemplar.map.width, exemplar.map.height) < kLeastLookSide)
    return Error{ErrorKind::badInput,
                 fmt::format("{}: {} x {} pixels are too few to compare methods; at least {} x {} "
                             "are needed",
                             exemplar.path, exemplar.map.width, exemplar.map.height, kLeastLookSide,
                             kLeastLookSide)};
  const CommonOptions common;
  const MethodOptions methods = defaultOptions(common);
  ProgressLine progress("compare", shared);
  constexpr double kBakes = 0.4; // of the time
  const Result<std::vector<MethodTrial>> trials =
      tryMethods(exemplar.map, exemplar.borders, methods, allMethods(),
                 partOf(progress.asProgress(), 0.0, kBakes));
  if (!trials)
    return trials.error();
  const Result<MethodSheet> sheet = makeMethodSheet(exemplar.path, exemplar.map, trials.value(),
                                                    partOf(progress.asProgress(), kBakes, 1.0));
  if (!sheet)
    return Error{sheet.error().kind, exemplar.path + ": " + sheet.error().message};
  if (!report.empty())
    if (Result<void> written = replaceFile(report, sheet.value().page); !written)
      return written.error();
  progress.erase();
  if (shared.json) {
    Json rows = Json::array();
    for (const MethodRow& row : sheet.value().rows)
      rows.push_back(jsonOf(row));
    printLine(
        toText(Json{{"exemplar", exemplar.path}, {"methods", rows}, {"notes", exemplar.notes}}));
    return kDone;
  }
  for (const std::string& text : exemplar.notes)
    note(shared, text);
  for (const std::string& line : linesOf(sheet.value().rows))
    say(shared, line);
  if (!report.empty())
    say(shared, report + ": the same with pictures");
  return kDone;
}

} // namespace lichen::cli
