// SPDX-License-Identifier: MIT
// A bake's record -> the bytes of its page.
#include "map_section.h"
#include "report_page.h"

#include <lichen/noise_report.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

/// Pixels of a map's pictures per pixel of its exemplar's: itself, the Gaussian image and a result
/// of two by two.
constexpr double kPicturePixels = 6.0;
/// In all, of at most 4 bytes each in base64: a page below 14 MiB, and about half that for
/// photographs, which compress.
constexpr double kMostPixels = 3.5e6;
constexpr int kLargestExemplarSide = 512;

int exemplarSide(std::size_t maps) {
  const double pixels = kMostPixels / (kPicturePixels * double(std::max<std::size_t>(maps, 1)));
  return std::min(kLargestExemplarSide, int(std::sqrt(pixels)));
}

/// Inside a script element nothing may look like its end: "<" is written as an escape.
std::string scriptSafe(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text)
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  return safe;
}

Json describe(const BakeRecord& record, Json maps) {
  Json facts = Json::array(), timings = Json::array();
  for (const auto& [name, value] : record.facts)
    facts.push_back({name, value});
  for (const auto& [name, seconds] : record.timings)
    timings.push_back({{"name", name}, {"seconds", seconds}});
  return {{"name", record.bundle.noises.front().name},
          {"command", record.command},
          {"facts", facts},
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

} // namespace

Result<std::vector<std::byte>> encodeNoiseReport(const BakeRecord& record,
                                                 const Progress& progress) {
  return withinMemory([] { return "not enough memory for the report"; },
                      [&]() -> Result<std::vector<std::byte>> {
                        const std::size_t count = record.exemplars.size();
                        const std::uint32_t seed = record.bundle.materials.front()->seed;
                        Json maps = Json::array();
                        for (std::size_t m = 0; m < count; ++m) {
                          const Progress part = [&](double fraction) {
                            return !progress || progress((double(m) + fraction) / double(count));
                          };
                          Result<Json> map =
                              describeMap(record.bundle, seed, record.exemplars[m],
                                          record.exemplarWasPeriodic, exemplarSide(count), part);
                          if (!map)
                            return map.error();
                          maps.push_back(std::move(map).value());
                        }
                        return pageWith(scriptSafe(describe(record, std::move(maps))));
                      });
}

} // namespace lichen
