// SPDX-License-Identifier: MIT
// Exemplar -> a bundle of each method -> a table, and a page with pictures.
#include "compare_methods.h"

#include "method_choice.h"
#include "progress_line.h"

#include <lichen/files.h>
#include <lichen/judgement_json.h>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace lichen::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kBytesPerKib = 1024.0;

std::string cellOf(const Measure& measure) {
  return measure.value ? fmt::format("{:.3g}", *measure.value) : "-";
}

std::vector<std::string> linesOf(const std::vector<MethodRow>& rows) {
  constexpr const char* kRow = "{:<20}{:>15}{:>16}{:>23}{:>22}{:>17}{:>10}{:>15}{:>9}";
  const std::vector<Measure>& measures = rows.front().measures; // those of measureResult()
  std::vector<std::string> lines{fmt::format(kRow, "", "look_distance", measures[0].name,
                                             measures[1].name, measures[2].name, measures[3].name,
                                             "GPU KiB", "plain fetches", "bake s")};
  for (const MethodRow& row : rows)
    lines.push_back(fmt::format(
        kRow, nameOf(row.method), fmt::format("{:.4f}", row.distance), cellOf(row.measures[0]),
        cellOf(row.measures[1]), cellOf(row.measures[2]), cellOf(row.measures[3]),
        fmt::format("{:.0f}", double(row.gpuBytes) / kBytesPerKib),
        fmt::format("{:.0f}", row.plainFetches), fmt::format("{:.1f}", row.bakeSeconds)));
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

} // namespace

Result<int> compareMethods(const ComparedExemplar& exemplar, const std::string& report,
                           const SharedOptions& shared) {
  // The methods' own defaults, as `bake` has them.
  CLI::App defaults;
  const CommonOptions common;
  MethodOptions methods;
  for (const Method method : allMethods())
    methods.push_back(commandOf(method).addBakeOptions(defaults, common));
  ProgressLine progress("compare", shared);
  constexpr double kBakes = 0.4; // of the time
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  const Result<std::vector<MethodTrial>> trials =
      tryMethods(exemplar.map, exemplar.borders, methods, kNoLimit,
                 partOf(progress.asProgress(), 0.0, kBakes));
  if (!trials)
    return trials.error();
  const Result<MethodSheet> sheet = makeMethodSheet(exemplar.path, exemplar.map, trials.value(),
                                                    partOf(progress.asProgress(), kBakes, 1.0));
  if (!sheet)
    return sheet.error();
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
