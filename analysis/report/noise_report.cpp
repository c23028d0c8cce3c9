// SPDX-License-Identifier: MIT
// The record of a bake or a mix -> the bytes of its page.
#include "map_section.h"
#include "method_report.h"
#include "mix_section.h"
#include "report_page.h"

#include <lichen/noise_report.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kLargestExemplarSide = 512;

/// Time of a step between the inputs of a mix over that of an input's section: the texels that both
/// evaluate of exemplars of 512 x 512.
constexpr double kStepOverInput = 0.25;

/// Whether the noise should look like each of its inputs at some weight. One texture between all
/// inputs should look like none of them, so it is not compared with them.
bool showsInputs(const BakeRecord& record) { return !record.mix || record.mix->weights.empty(); }

/// Side of an exemplar's picture: all pictures together have at most kReportPixels.
int exemplarSide(const BakeRecord& record, Method method) {
  const double inputs = showsInputs(record) ? double(record.inputs.size()) : 0.0;
  const double between = record.mix ? double(mixPictures(record)) : 0.0;
  const double maps = double(std::max<std::size_t>(record.inputs.front().exemplars.size(), 1));
  const double pictures = maps * (inputs * reportOf(method).picturePixels() + between);
  return std::min(kLargestExemplarSide, int(std::sqrt(kReportPixels / pictures)));
}

/// Escapes "<", so that the JSON cannot contain the end of its script element.
std::string scriptSafe(const std::string& json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json)
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  return safe;
}

struct Sections {
  Json maps = Json::array();  ///< describeMap() of the maps of each input
  Json mixes = Json::array(); ///< describeMix() of each map
};

/// The level and the sentence, or null.
Json describeVerdict(const BakeRecord& record) {
  if (!record.verdict)
    return {};
  const bool severalMaps = record.inputs.front().exemplars.size() > 1;
  return {{"level", nameOf(record.verdict->level)},
          {"sentence", sentenceOf(*record.verdict, severalMaps, record.words)}};
}

/// `reportSeconds`: the time that describing the maps took.
Json describe(const BakeRecord& record, Sections sections, double reportSeconds) {
  Json timings = Json::array();
  double all = reportSeconds;
  const auto addTiming = [&](std::string_view name, double seconds) {
    timings.push_back({{"name", name}, {"seconds", seconds}});
  };
  for (const auto& [name, seconds] : record.timings) {
    addTiming(name, seconds);
    all += seconds;
  }
  addTiming("Measures and pictures of this page", reportSeconds);
  addTiming("In all", all);
  return {{"kind", record.mix ? "mix" : "bake"},
          {"name", record.bundle.noises.front().name},
          {"command", record.command},
          {"verdict", describeVerdict(record)},
          {"facts", record.facts},
          {"timings", timings},
          {"notes", record.notes},
          {"maps", std::move(sections.maps)},
          {"mixes", std::move(sections.mixes)}};
}

std::vector<std::byte> pageWith(const std::string& data) {
  const std::size_t at = kReportPage.find(kReportDataMark);
  std::string page(kReportPage.substr(0, at));
  page += data;
  page += kReportPage.substr(at + kReportDataMark.size());
  const auto bytes = std::as_bytes(std::span(page));
  return {bytes.begin(), bytes.end()};
}

/// Adds the sections of all maps of an input.
Result<void> addInput(const BakeRecord& record, std::size_t i, int side, const Progress& progress,
                      Json& maps) {
  const ReportedInput& input = record.inputs[i];
  const std::size_t inputs = record.inputs.size(), count = input.exemplars.size();
  MaterialNoise material = *record.bundle.materials.front();
  if (inputs > 1)
    material.mix = {.source = MixSource::constant, .weight = double(i) / double(inputs - 1)};
  for (std::size_t m = 0; m < count; ++m) {
    const ShownExemplar shown{input.exemplars[m], input.risks[m], input.origins[m]};
    const double before = double(m) / double(count), after = double(m + 1) / double(count);
    Result<Json> map = describeMap(record.bundle, material, shown, record.words, side,
                                   partOf(progress, before, after));
    if (!map)
      return map.error();
    map.value()["input"] = inputs > 1 ? Json(input.name) : Json();
    maps.push_back(std::move(map).value());
  }
  return {};
}

/// Adds the sections on what lies between the inputs.
Result<void> addMixes(const BakeRecord& record, int side, const Progress& progress, Json& mixes) {
  const std::size_t count = record.inputs.front().exemplars.size();
  for (std::size_t m = 0; m < count; ++m) {
    const double before = double(m) / double(count), after = double(m + 1) / double(count);
    Result<Json> mix = describeMix(record, m, side, partOf(progress, before, after));
    if (!mix)
      return mix.error();
    mixes.push_back(std::move(mix).value());
  }
  return {};
}

/// Adds the targets of the maps in `maps`, the result of describeMap() for each.
void addTargets(const Json& maps, NoiseReport& report) {
  for (const Json& map : maps)
    for (const Json& measure : map.at("measures")) {
      const Json& met = measure.at("met");
      report.targets += met.is_null() ? 0U : 1U;
      if (met != false)
        continue;
      const auto words = [&](const char* member) { return measure.at(member).get<std::string>(); };
      const std::string unit = words("unit").empty() ? "" : " " + words("unit");
      const Json& input = map.at("input");
      report.missedTargets.push_back(fmt::format(
          "{}{}: {} {:.3g}{} exceeds its target of {:g}{}",
          input.is_null() ? "" : input.get<std::string>() + ", ",
          map.at("target").get<std::string>(), words("name"), measure.at("value").get<double>(),
          unit, measure.at("target").get<double>(), unit));
    }
}

Result<NoiseReport> encode(const BakeRecord& record, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const MaterialNoise& material = *record.bundle.materials.front();
  const int side = exemplarSide(record, record.bundle.noises[material.noise].method());
  Sections sections;
  const std::size_t inputs = showsInputs(record) ? record.inputs.size() : 0;
  const double between = record.mix ? kStepOverInput * double(mixPictures(record)) / 2.0 : 0.0;
  const double share = between / (between + double(inputs));
  if (record.mix)
    if (Result<void> added = addMixes(record, side, partOf(progress, 0.0, share), sections.mixes);
        !added)
      return added.error();
  for (std::size_t i = 0; i < inputs; ++i) {
    const auto reached = [&](std::size_t done) {
      return share + (1.0 - share) * double(done) / double(inputs);
    };
    const Progress part = partOf(progress, reached(i), reached(i + 1));
    if (Result<void> added = addInput(record, i, side, part, sections.maps); !added)
      return added.error();
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  NoiseReport report;
  addTargets(sections.maps, report);
  const std::string data = describe(record, std::move(sections), taken.count())
                               .dump(-1, ' ', false, Json::error_handler_t::replace);
  report.page = pageWith(scriptSafe(data));
  return report;
}

} // namespace

Result<NoiseReport> encodeNoiseReport(const BakeRecord& record, const Progress& progress) {
  return withinMemory([] { return "not enough memory for the report"; },
                      [&] { return encode(record, progress); });
}

} // namespace lichen
