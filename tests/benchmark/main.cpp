// SPDX-License-Identifier: MIT
// lichen-bench prints every measured number next to its target in TARGETS.md.
#include "rows.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

namespace lichen::bench {
namespace {

struct Family {
  const char* name;
  std::vector<Row> (*measure)();
};

constexpr std::array<Family, 14> kFamilies{{{"bake", bakeRows},
                                            {"growth", growthRows},
                                            {"transport", transportRows},
                                            {"synth", synthRows},
                                            {"result", resultRows},
                                            {"view", viewRows},
                                            {"lit", litRows},
                                            {"texton", textonRows},
                                            {"local-random-phase", localRandomPhaseRows},
                                            {"multiple-kernels", multipleKernelsRows},
                                            {"structure", structureRows},
                                            {"quilting", quiltingRows},
                                            {"shader", shaderRows},
                                            {"options", optionRows}}};

const char* verdict(const Row& row) {
  if (row.skipped)
    return "not measured";
  if (row.target == kNoTarget)
    return "no target";
  return row.met() ? "met" : "missed";
}

/// A number with its unit, rounded to the precision of such a measurement.
std::string number(double value, const std::string& unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3g%s%s", value, unit.empty() ? "" : " ", unit.c_str());
  return text;
}

std::string targetOf(const Row& row) {
  return row.target == kNoTarget ? "-" : number(row.target, row.unit);
}

/// The details, then the note.
std::string explanation(const Row& row) {
  std::string all;
  for (const Detail& detail : row.details) {
    char text[64];
    std::snprintf(text, sizeof text, "%.4g %s; ", detail.value, detail.name.c_str());
    all += text;
  }
  return all + row.note;
}

void printText(const char* family, const Row& row) {
  std::printf("%-10s %-68s %10s %10s  %-9s %s\n", family, row.what.c_str(),
              row.skipped ? "-" : number(row.measured, row.unit).c_str(), targetOf(row).c_str(),
              verdict(row), explanation(row).c_str());
  std::fflush(stdout);
}

void printMarkdown(const char* family, const Row& row) {
  std::printf("| %s | %s | %s | %s | %s | %s |\n", family, row.what.c_str(),
              row.skipped ? "-" : number(row.measured, row.unit).c_str(), targetOf(row).c_str(),
              verdict(row), explanation(row).c_str());
  std::fflush(stdout);
}

nlohmann::ordered_json jsonOf(const char* family, const Row& row) {
  nlohmann::ordered_json json{{"family", family}, {"what", row.what}};
  if (!row.skipped)
    json["measured"] = row.measured;
  if (row.target != kNoTarget)
    json["target"] = row.target;
  json["unit"] = row.unit;
  json["verdict"] = verdict(row);
  for (const Detail& detail : row.details)
    json[detail.name] = detail.value;
  json["note"] = row.note;
  return json;
}

} // namespace
} // namespace lichen::bench

int main(int argumentCount, char** arguments) {
  using namespace lichen::bench;
  CLI::App app{"Measures Lichen and prints each number beside its target."};
  bool json = false, markdown = false;
  std::vector<std::string> only;
  int childSide = 0;
  std::vector<std::string> names;
  for (const Family& family : kFamilies)
    names.emplace_back(family.name);
  app.add_flag("--json", json, "Print one JSON object on standard output");
  app.add_flag("--markdown", markdown, "Print the table of docs/benchmarks.md")->excludes("--json");
  app.add_option("--only", only, "Families of rows to measure [default: all]")
      ->check(CLI::IsMember(names));
  app.add_option("--peak-memory-of-bake", childSide)->group(""); // for bakeInChild
  CLI11_PARSE(app, argumentCount, arguments);

  if (childSide > 0) {
    const double seconds = bakeOnce(childSide);
    std::printf("%.6f %.3f\n", seconds, peakMemoryMegabytes());
    return 0;
  }
  nlohmann::ordered_json machine;
  std::string line;
  for (const auto& [what, value] : machineFacts()) {
    machine[what] = value;
    line += (line.empty() ? "" : "; ") + what + ": " + value;
  }
  if (!json)
    std::printf("%s\n\n", line.c_str());
  if (markdown)
    std::puts("| family | what | measured | target | verdict | how |\n|---|---|---|---|---|---|");
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Family& family : kFamilies) {
    if (!only.empty() && std::find(only.begin(), only.end(), family.name) == only.end())
      continue;
    for (const Row& row : family.measure()) {
      if (json)
        rows.push_back(jsonOf(family.name, row));
      else if (markdown)
        printMarkdown(family.name, row);
      else
        printText(family.name, row);
    }
  }
  if (json)
    std::puts(nlohmann::ordered_json{{"machine", machine}, {"rows", rows}}.dump(2).c_str());
  return 0;
}
