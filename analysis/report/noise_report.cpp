// SPDX-License-Identifier: MIT
// A bake's record -> the bytes of its page.
#include "map_section.h"
#include "method_report.h"
#include "report_page.h"

#include <lichen/noise_report.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

/// Pixels of all pictures, at most 4 bytes each in base64. The page stays below 14 MiB, and about
/// half of that for photographs, which compress.
constexpr double kMostPixels = 3.5e6;
constexpr int kLargestExemplarSide = 512;

int exemplarSide(std::size_t maps, Method method) {
  const double perPixel = reportOf(method).picturePixels();
  const double pixels = kMostPixels / (perPixel * double(std::max<std::size_t>(maps, 1)));
  return std::min(kLargestExemplarSide, int(std::sqrt(pixels)));
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

/// `reportSeconds`: the time that describing the maps took.
Json describe(const BakeRecord& record, Json maps, double reportSeconds) {
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
  return {{"name", record.bundle.noises.front().name},
          {"command", record.command},
          {"facts", record.facts},
          {"timings", timings},
          {"notes", record.notes},
          {"maps", std::move(maps)}};
}

std::vector<std::byte> pageWith(const std::string& data) {
  const std::size_t at = kReportPage.find(kReportDataMark);
  std::string page(kReportPage.substr(0, at));
  page += data;
  page += kReportPage.substr(at + kReportDataMark.size());
  const auto bytes = std::as_bytes(std::span(page));
  return {bytes.begin(), bytes.end()};
}

Result<std::vector<std::byte>> encode(const BakeRecord& record, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const std::size_t count = record.exemplars.size();
  const MaterialNoise& material = *record.bundle.materials.front();
  const int side = exemplarSide(count, record.bundle.noises[material.noise].method());
  Json maps = Json::array();
  for (std::size_t m = 0; m < count; ++m) {
    const ShownExemplar shown{record.exemplars[m], record.risks[m], record.origins[m]};
    Result<Json> map =
        describeMap(record.bundle, material, shown, side,
                    partOf(progress, double(m) / double(count), double(m + 1) / double(count)));
    if (!map)
      return map.error();
    maps.push_back(std::move(map).value());
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  const std::string data = describe(record, std::move(maps), taken.count())
                               .dump(-1, ' ', false, Json::error_handler_t::replace);
  return pageWith(scriptSafe(data));
}

} // namespace

Result<std::vector<std::byte>> encodeNoiseReport(const BakeRecord& record,
                                                 const Progress& progress) {
  return withinMemory([] { return "not enough memory for the report"; },
                      [&] { return encode(record, progress); });
}

} // namespace lichen
