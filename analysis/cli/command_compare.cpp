// SPDX-License-Identifier: MIT
// lichen compare: a result, or a bundle's noise, against its exemplar.
#include "command.h"
#include "noise_choice.h"
#include "options.h"
#include "progress_line.h"

#include <lichen/material_set.h>
#include <lichen/noise_comparison.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>

namespace lichen::cli {
namespace {

struct Arguments {
  explicit Arguments(const SharedOptions& options) : shared(options) {}

  const SharedOptions& shared;
  std::string exemplar;
  std::string result;
  std::string noise;
  std::string map;
};

/// The measures of one map.
struct MapMeasures {
  MapTarget map = MapTarget::baseColor;
  std::vector<Measure> measures;
};

bool isBundle(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& letter : extension)
    letter = char(std::tolower(static_cast<unsigned char>(letter)));
  return extension == ".glb" || extension == ".gltf";
}

Result<std::vector<MapExemplar>> readMaps(const std::string& path) {
  const std::filesystem::path input = path;
  Result<MaterialSet> set = readMaterialSet({&input, 1}, {});
  if (!set)
    return set.error();
  return std::move(set).value().maps;
}

/// Of an exemplar's maps the one that was asked for, or all.
Result<std::vector<MapExemplar>> readExemplar(const Arguments& arguments) {
  Result<std::vector<MapExemplar>> maps = readMaps(arguments.exemplar);
  if (!maps || arguments.map.empty())
    return maps;
  std::vector<std::string> names;
  for (const MapExemplar& map : maps.value())
    names.emplace_back(nameOf(map.target));
  const Result<std::size_t> place = placeOf(arguments.map, names, "--map", arguments.exemplar);
  if (!place)
    return place.error();
  return std::vector{std::move(maps).value()[place.value()]};
}

/// An image is the base colour. Both are shown in the encoding of the one with more range.
Result<std::vector<MapMeasures>> compareImage(const Arguments& arguments,
                                              const std::vector<MapExemplar>& exemplars) {
  const MapExemplar& exemplar = exemplars.front();
  if (exemplar.target != MapTarget::baseColor)
    return Error{ErrorKind::usage,
                 fmt::format("{}: has no base colour; an image is compared with that, the other "
                             "maps with a bundle",
                             arguments.exemplar)};
  const Result<std::vector<MapExemplar>> result = readMaps(arguments.result);
  if (!result)
    return result.error();
  if (result.value().front().target != MapTarget::baseColor)
    return Error{ErrorKind::badInput,
                 fmt::format("{}: has no base colour; an image or a folder with one is accepted",
                             arguments.result)};
  const ValueEncoding encoding = exemplar.encoding == ValueEncoding::log2
                                     ? exemplar.encoding
                                     : result.value().front().encoding;
  const MapLook look(exemplar, encoding);
  Result<std::vector<Measure>> measures =
      measureResult(look.picture(exemplar), look.picture(result.value().front()));
  if (!measures)
    return measures.error();
  return std::vector{MapMeasures{exemplar.target, std::move(measures).value()}};
}

Result<std::vector<MapMeasures>> compareBundle(const Arguments& arguments,
                                               const std::vector<MapExemplar>& exemplars) {
  const Result<Bundle> bundle = readBundle(arguments.result);
  if (!bundle)
    return bundle.error();
  const Result<std::size_t> noise = findNoise(bundle.value(), arguments.result, arguments.noise);
  if (!noise)
    return noise.error();
  const std::uint32_t seed = seedOf(bundle.value(), noise.value());
  ProgressLine progress("compare", arguments.shared);
  std::vector<MapMeasures> all;
  for (const MapExemplar& exemplar : exemplars) {
    const Progress show = [&](double fraction) {
      progress.show((double(all.size()) + fraction) / double(exemplars.size()));
      return true;
    };
    Result<NoiseComparison> comparison =
        compareNoise(bundle.value(), noise.value(), seed, exemplar, show);
    if (!comparison)
      return Error{comparison.error().kind, arguments.result + ": " + comparison.error().message};
    all.push_back({exemplar.target, std::move(comparison).value().measures});
  }
  return all;
}

std::string lineOf(const Measure& measure) {
  const std::string unit = measure.unit.empty() ? "" : " " + std::string(measure.unit);
  std::string line = fmt::format("{:<20} ", measure.name);
  if (measure.value)
    line += fmt::format("{:>7.3g}{:<3}", *measure.value, unit);
  if (measure.value && measure.target)
    line +=
        fmt::format("  {} {:g}{}", measure.isMissed() ? "MISSED:" : "met:", *measure.target, unit);
  if (!measure.remark.empty())
    line += (measure.value ? "; " : "not measured: ") + measure.remark;
  return line.substr(0, line.find_last_not_of(' ') + 1);
}

nlohmann::ordered_json orNull(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

/// Nothing where there is no value or no target.
nlohmann::ordered_json metOrNull(const Measure& measure) {
  return measure.value && measure.target ? nlohmann::ordered_json(!measure.isMissed())
                                         : nlohmann::ordered_json();
}

void report(const Arguments& arguments, const std::vector<MapMeasures>& maps) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [map, measures] : maps) {
    if (maps.size() > 1)
      say(arguments.shared, std::string(nameOf(map)));
    for (const Measure& measure : measures) {
      list.push_back({{"map", nameOf(map)},
                      {"name", measure.name},
                      {"value", orNull(measure.value)},
                      {"target", orNull(measure.target)},
                      {"unit", measure.unit},
                      {"met", metOrNull(measure)},
                      {"remark", measure.remark}});
      say(arguments.shared, (maps.size() > 1 ? "  " : "") + lineOf(measure));
    }
  }
  if (arguments.shared.json)
    printLine(toText(nlohmann::ordered_json{
        {"exemplar", arguments.exemplar}, {"result", arguments.result}, {"measures", list}}));
}

Result<int> run(const Arguments& arguments) {
  if (!arguments.noise.empty() && !isBundle(arguments.result))
    return Error{ErrorKind::usage, fmt::format("--noise {}: {} is an image; a bundle has noises",
                                               arguments.noise, arguments.result)};
  const Result<std::vector<MapExemplar>> exemplars = readExemplar(arguments);
  if (!exemplars)
    return exemplars.error();
  const Result<std::vector<MapMeasures>> maps = isBundle(arguments.result)
                                                    ? compareBundle(arguments, exemplars.value())
                                                    : compareImage(arguments, exemplars.value());
  if (!maps)
    return maps.error();
  report(arguments, maps.value());
  for (const MapMeasures& map : maps.value())
    if (std::any_of(map.measures.begin(), map.measures.end(),
                    [](const Measure& measure) { return measure.isMissed(); }))
      return kFound;
  return kDone;
}

} // namespace

Runner addCompare(CLI::App& verb, const SharedOptions& shared) {
  auto arguments = std::make_shared<Arguments>(shared);
  addText(verb, "EXEMPLAR", arguments->exemplar, "",
          "The photograph, or a folder with the maps of a material")
      ->required();
  addText(verb, "RESULT", arguments->result, "|BUNDLE",
          "An image made from it, or a .glb or .gltf of which one is made")
      ->required();
  addText(verb, "--noise", arguments->noise, "NAME",
          "Which noise of the bundle [default: the first]");
  addText(verb, "--map", arguments->map, "MAP",
          "Which map of the exemplar, such as normal [default: all]");
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
