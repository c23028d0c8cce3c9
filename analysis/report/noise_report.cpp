// SPDX-License-Identifier: MIT
// The record of a bake -> the bytes of its page.
#include "map_section.h"
#include "markup.h"

#include <lichen/noise_report.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen {

extern const std::string_view kPageStyle; // page_style.cpp

namespace {

constexpr int kLargestExemplarSide = 512;

/// The pixels of all pictures of a map, in units of the exemplar's: the original, the exemplar,
/// twice, its Gaussian version, and a result of 2 x 2 exemplars.
constexpr double kPicturesOfMap = 8.0;

/// Side of an exemplar's picture: all pictures together have at most kReportPixels.
int exemplarSide(const BakeRecord& record) {
  const double maps = double(std::max<std::size_t>(record.exemplars.size(), 1));
  return std::min(kLargestExemplarSide, int(std::sqrt(kReportPixels / (maps * kPicturesOfMap))));
}

std::string paragraph(std::string_view look, std::string_view text) {
  return element(fmt::format("p class=\"{}\"", look), htmlText(text)) + "\n";
}

/// How many measures meet their targets, and which do not.
std::string targetsLine(const std::vector<MapSection>& maps, const NoiseReport& report) {
  std::string list;
  for (const MapSection& map : maps) {
    std::string names;
    for (const Measure& measure : map.measures)
      if (measure.isMissed())
        names += (names.empty() ? "" : ", ") + std::string(measure.name);
    if (!names.empty())
      list += fmt::format("{}{} of {}", list.empty() ? "" : "; ", names,
                          nameOf(map.shown.exemplar.target));
  }
  if (report.targets == 0)
    return {};
  return list.empty()
             ? paragraph("good",
                         fmt::format("\u2713 All {} measures meet their targets.", report.targets))
             : paragraph("bad", fmt::format("\u2717 {} of {} measures miss their target: {}.",
                                            report.missedTargets.size(), report.targets, list));
}

std::string header(const BakeRecord& record, const std::vector<MapSection>& maps,
                   const NoiseReport& report) {
  std::string lines = paragraph("quiet", "Lichen bake report") +
                      element("h1", htmlText(record.bundle.noises.front().name));
  if (const std::optional<Verdict>& verdict = record.verdict; verdict) {
    constexpr std::array<std::string_view, 3> kLooks{"good", "warn", "bad"};
    const bool severalMaps = record.exemplars.size() > 1;
    lines += paragraph(kLooks[std::size_t(verdict->level)],
                       "Verdict: " + sentenceOf(*verdict, severalMaps, record.words));
  }
  return element("header",
                 lines + targetsLine(maps, report) + element("pre", htmlText(record.command)));
}

/// Names and their values.
std::string factsOf(std::string_view title,
                    const std::vector<std::pair<std::string, std::string>>& facts) {
  std::string list;
  for (const auto& [name, value] : facts)
    list += element("dt", htmlText(name)) + element("dd", htmlText(value));
  return element("section", element("h2", title) + element("dl", list)) + "\n";
}

std::string footer(const BakeRecord& record) {
  std::string notes;
  for (const std::string& note : record.notes)
    notes += element("li", htmlText(note));
  if (!notes.empty())
    notes = element("section", "<h2>Notes</h2>" + element("ul", notes)) + "\n";
  return element("footer", factsOf("The bake", record.facts) + notes);
}

/// The whole page. It loads nothing and runs nothing, and asks the browser to see to that.
std::string page(const BakeRecord& record, const std::vector<MapSection>& maps,
                 const NoiseReport& report) {
  std::string sections;
  for (const MapSection& map : maps)
    sections += map.markup;
  return fmt::format(R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<meta name="color-scheme" content="light dark"/>
<meta http-equiv="Content-Security-Policy"
      content="default-src 'none'; img-src data:; style-src 'unsafe-inline'"/>
<title>{} - bake report</title>
<style>{}</style>
</head>
<body>
{}
<main>
{}</main>
{}
</body>
</html>
)",
                     htmlText(record.bundle.noises.front().name), kPageStyle,
                     header(record, maps, report), sections, footer(record));
}

/// Adds the targets of the maps.
void addTargets(const std::vector<MapSection>& maps, NoiseReport& report) {
  for (const MapSection& map : maps)
    for (const Measure& measure : map.measures) {
      report.targets += measure.value && measure.target ? 1U : 0U;
      if (!measure.isMissed())
        continue;
      const std::string unit = measure.unit.empty() ? "" : " " + std::string(measure.unit);
      report.missedTargets.push_back(fmt::format("{}: {} {:.3g}{} exceeds its target of {:g}{}",
                                                 nameOf(map.shown.exemplar.target), measure.name,
                                                 *measure.value, unit, *measure.target, unit));
    }
}

Result<NoiseReport> encode(const BakeRecord& record, const Progress& progress) {
  const MaterialNoise& material = *record.bundle.materials.front();
  const int side = exemplarSide(record);
  const std::size_t count = record.exemplars.size();
  std::vector<MapSection> maps;
  for (std::size_t m = 0; m < count; ++m) {
    const ShownExemplar shown{record.exemplars[m], record.risks[m], record.origins[m]};
    const double before = double(m) / double(count), after = double(m + 1) / double(count);
    Result<MapSection> map = describeMap(record.bundle, material, shown, record.words, side,
                                         partOf(progress, before, after));
    if (!map)
      return map.error();
    maps.push_back(std::move(map).value());
  }
  NoiseReport report;
  addTargets(maps, report);
  const std::string text = page(record, maps, report);
  const auto bytes = std::as_bytes(std::span(text));
  report.page.assign(bytes.begin(), bytes.end());
  return report;
}

} // namespace

Result<NoiseReport> encodeNoiseReport(const BakeRecord& record, const Progress& progress) {
  return withinMemory([] { return "not enough memory for the report"; },
                      [&] { return encode(record, progress); });
}

} // namespace lichen
