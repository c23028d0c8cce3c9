// SPDX-License-Identifier: MIT
// lichen compare: compares a result or a bundle's noise with the exemplar.
#include "bake_risks.h"
#include "command.h"
#include "exemplar_options.h"
#include "noise_choice.h"
#include "options.h"
#include "progress_line.h"

#include <lichen/apply_noise.h>
#include <lichen/bake_material.h>
#include <lichen/bundle_files.h>
#include <lichen/noise_comparison.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace lichen::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
  explicit Arguments(const SharedOptions& options) : shared(options) {}

  const SharedOptions& shared;
  std::string exemplar;
  std::string result;
  std::string noise;
  std::string map;
  std::optional<double> mix;
  ExemplarOptions asBaked;
  const CLI::App* verb = nullptr;
};

/// The measures of one map.
struct MapMeasures {
  MapTarget map = MapTarget::baseColor;
  std::vector<Measure> measures;
};

Result<ChosenNoise> readBaked(const Arguments& arguments) {
  Result<Bundle> bundle = readBundle(arguments.result);
  if (!bundle)
    return bundle.error();
  const Result<std::size_t> index = findNoise(bundle.value(), arguments.result, arguments.noise);
  if (!index)
    return index.error();
  ChosenNoise baked{arguments.result, std::move(bundle).value(), index.value()};
  if (arguments.mix && !isMix(baked.noise()))
    return notMixed("--mix", baked.noise());
  return baked;
}

/// The exemplar, read as the bake read it.
struct AsBaked {
  MaterialSet set; ///< the maps to compare: one or all
  int width = 0;   ///< pixels of the widest map; height: of the highest
  int height = 0;
};

Result<AsBaked> readAsBaked(const Arguments& arguments) {
  Result<PreparedExemplar> read =
      readExemplar(arguments.exemplar, arguments.asBaked, arguments.shared);
  if (!read)
    return read.error();
  AsBaked baked{std::move(read.value().set), 0, 0};
  std::vector<MapExemplar>& maps = baked.set.maps;
  std::vector<std::string> names;
  for (const MapExemplar& map : maps) {
    names.emplace_back(nameOf(map.target));
    baked.width = std::max(baked.width, map.width);
    baked.height = std::max(baked.height, map.height);
  }
  if (arguments.map.empty())
    return baked;
  const Result<std::size_t> place =
      indexOf(arguments.map, names, "--map ", "map", arguments.exemplar);
  if (!place)
    return place.error();
  maps = {std::move(maps[place.value()])};
  return baked;
}

/// Compares an image with the base colour. Both are converted to the encoding with the greater
/// range. Adds a note if their sizes differ.
Result<std::vector<MapMeasures>> compareImage(const Arguments& arguments, MaterialSet& set) {
  const MapExemplar& exemplar = set.maps.front();
  if (exemplar.target != MapTarget::baseColor)
    return Error{ErrorKind::usage,
                 fmt::format("{}: has no base colour to compare with an image; expected one, or a "
                             "bundle as the result",
                             arguments.exemplar)};
  ExemplarOptions asItIs{.flattening = {}, .outliers = {.keeps = true}, .rectification = {}};
  asItIs.set.cutsFrame = false;
  const Result<PreparedExemplar> result = readExemplar(arguments.result, asItIs, arguments.shared);
  if (!result)
    return result.error();
  const MapExemplar& image = result.value().set.maps.front();
  if (image.target != MapTarget::baseColor)
    return Error{ErrorKind::badInput,
                 fmt::format("{}: has no base colour; expected an image, or a folder with one",
                             arguments.result)};
  if (image.width != exemplar.width || image.height != exemplar.height)
    set.notes.push_back(fmt::format(
        "{} is {} x {} pixels and the exemplar {} x {}; the measures need the same scale in both: "
        "resize the image if the scales differ; the targets are for 4 exemplars a side, as "
        "'compare' makes them of a bundle",
        arguments.result, image.width, image.height, exemplar.width, exemplar.height));
  const ValueEncoding encoding =
      exemplar.encoding == ValueEncoding::log2 ? exemplar.encoding : image.encoding;
  const MapLook look(exemplar, encoding);
  Result<std::vector<Measure>> measures =
      measureResult(look.picture(exemplar), look.picture(image));
  if (!measures)
    return measures.error();
  return std::vector{MapMeasures{exemplar.target, std::move(measures).value()}};
}

/// Adds a note if an exemplar differs in size from the one that the map was baked from. Methods
/// that enlarge maps bake all of them at the size of the largest map.
void noteOtherSize(AsBaked& exemplar, const Bundle& bundle, const Noise& noise) {
  for (const MapExemplar& map : exemplar.set.maps) {
    const std::optional<std::size_t> place = findMap(noise, map.target);
    if (!place)
      continue; // compareNoise() reports the error
    const bool isEnlarged = enlargesMaps(noise.method());
    const int hasWidth = isEnlarged ? exemplar.width : map.width;
    const int hasHeight = isEnlarged ? exemplar.height : map.height;
    const auto [width, height] = exemplarSize(bundle, noise, noise.maps[*place]);
    if (int(width) == hasWidth && int(height) == hasHeight)
      continue;
    exemplar.set.notes.push_back(
        fmt::format("{}the exemplar is {} x {}, but was {} x {} when it was baked; give the "
                    "photograph that was baked, or the --crop and --size of the bake",
                    isEnlarged ? "" : std::string(nameOf(map.target)) + ": ", hasWidth, hasHeight,
                    width, height));
    if (isEnlarged)
      return;
  }
}

/// The verdict on a bundle's noise, as `bake` gives it: from the measures of a small result.
Result<Verdict> verdictOf(const ChosenNoise& baked, const MaterialSet& set,
                          const SharedOptions& shared) {
  ProgressLine line("judge", shared);
  Result<NoiseJudgement> judged =
      judgeNoise(baked.bundle, materialOf(baked.bundle, baked.index), set.maps, set.periodic,
                 bordersFit(set.maps, set.periodic), line.asProgress());
  if (!judged)
    return judged.error();
  return std::move(judged).value().verdict;
}

Result<std::vector<MapMeasures>> compareBundle(const Arguments& arguments, const ChosenNoise& baked,
                                               AsBaked& exemplar) {
  MaterialNoise material = materialOf(baked.bundle, baked.index);
  material.mix = {.weight = arguments.mix.value_or(0.0)};
  noteOtherSize(exemplar, baked.bundle, baked.noise());
  ProgressLine progress("compare", arguments.shared);
  std::vector<MapMeasures> all;
  for (const MapExemplar& map : exemplar.set.maps) {
    const auto maps = double(exemplar.set.maps.size());
    const Progress part =
        partOf(progress.asProgress(), double(all.size()) / maps, double(all.size() + 1) / maps);
    Result<NoiseComparison> comparison = compareNoise(baked.bundle, material, map, part);
    if (!comparison)
      return Error{comparison.error().kind, arguments.result + ": " + comparison.error().message};
    all.push_back({map.target, std::move(comparison.value().measures)});
  }
  return all;
}

/// Returns a row of the table: name, value, target, verdict and remark.
std::string lineOf(const Measure& measure, std::size_t nameWidth) {
  const std::string unit = measure.unit.empty() ? "" : " " + std::string(measure.unit);
  std::string line = fmt::format("{:<{}}  ", measure.name, nameWidth);
  if (!measure.value)
    return line + "not measured: " + measure.remark;
  line += fmt::format("{:<12}", fmt::format("{:.3g}{}", *measure.value, unit));
  if (measure.target)
    line += fmt::format("  target {:<6}  {:<6}", fmt::format("{:g}{}", *measure.target, unit),
                        measure.isMissed() ? "MISSED" : "met");
  if (!measure.remark.empty())
    line += "  " + measure.remark;
  return line.substr(0, line.find_last_not_of(' ') + 1);
}

/// The verdict in words. If it is good and a target is missed, also why the exit code is 1.
std::string wordsOf(const Verdict& verdict, const std::vector<MapMeasures>& maps) {
  std::ptrdiff_t missed = 0;
  for (const MapMeasures& map : maps)
    missed += std::ranges::count_if(map.measures, &Measure::isMissed);
  const std::string line = verdictLine(verdict, maps.size() > 1);
  if (verdict.level != Verdict::Level::good || missed == 0)
    return line;
  return fmt::format("{}; exit code 1, as {}: targets are stricter than the verdict", line,
                     missed == 1 ? "a target is missed"
                                 : fmt::format("{} targets are missed", missed));
}

/// A missing value or target is null; `met` is null if either is missing.
Json jsonOfMeasure(MapTarget map, const Measure& measure) {
  const auto orNull = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json();
  };
  return {{"map", nameOf(map)},
          {"name", measure.name},
          {"meaning", measure.meaning},
          {"unit", measure.unit},
          {"value", orNull(measure.value)},
          {"target", orNull(measure.target)},
          {"met", measure.value && measure.target ? Json(!measure.isMissed()) : Json()},
          {"remark", measure.remark}};
}

void report(const Arguments& arguments, const std::vector<MapMeasures>& maps,
            const std::optional<Verdict>& verdict, const std::vector<std::string>& notes) {
  for (const std::string& text : notes)
    note(arguments.shared, text);
  if (verdict)
    say(arguments.shared, wordsOf(*verdict, maps));
  Json list = Json::array();
  const std::string indent = maps.size() > 1 ? "  " : "";
  std::size_t nameWidth = 0;
  for (const MapMeasures& map : maps)
    for (const Measure& measure : map.measures)
      nameWidth = std::max(nameWidth, measure.name.size());
  for (const auto& [map, measures] : maps) {
    if (maps.size() > 1)
      say(arguments.shared, std::string(nameOf(map)));
    for (const Measure& measure : measures) {
      list.push_back(jsonOfMeasure(map, measure));
      say(arguments.shared, indent + lineOf(measure, nameWidth));
    }
  }
  if (arguments.shared.json)
    printLine(toText(Json{{"exemplar", arguments.exemplar},
                          {"result", arguments.result},
                          {"verdict", verdict ? jsonOf(*verdict) : Json()},
                          {"measures", list},
                          {"notes", notes}}));
}

/// A mix records nothing of its exemplars, so they are prepared by the defaults of `lichen mix`.
void prepareAsMix(Arguments& arguments) {
  arguments.asBaked.set.cutsFrame = true;
  arguments.asBaked.outliers.recorded.reset();
  if (!isGiven(*arguments.verb, "--flatten"))
    arguments.asBaked.flattening = {true, 0.0, {}};
}

Result<int> run(Arguments& arguments) {
  arguments.asBaked.set.cutsFrame = false;
  arguments.asBaked.outliers.recorded.emplace();
  if (!arguments.noise.empty() && !namesBundle(arguments.result))
    return Error{ErrorKind::usage, fmt::format("--noise {}: {} is an image; expected a bundle",
                                               arguments.noise, arguments.result)};
  if (arguments.mix && !namesBundle(arguments.result))
    return Error{ErrorKind::usage, fmt::format("--mix {:g}: {} is an image; expected a bundle",
                                               *arguments.mix, arguments.result)};
  if (namesBundle(arguments.exemplar))
    return Error{ErrorKind::usage,
                 fmt::format("{}: is a bundle; expected a photograph or a folder, then the result",
                             arguments.exemplar)};
  std::optional<ChosenNoise> baked;
  std::string adopted;
  if (namesBundle(arguments.result)) {
    Result<ChosenNoise> read = readBaked(arguments);
    if (!read)
      return read.error();
    baked = std::move(read).value();
    if (isMix(baked->noise()))
      prepareAsMix(arguments);
    else
      adopted = describe(
          adoptPreparation(baked->noise().preparation, *arguments.verb, arguments.asBaked));
  }
  Result<AsBaked> exemplar = readAsBaked(arguments);
  if (!exemplar && adopted.empty())
    return exemplar.error();
  if (!exemplar)
    return Error{exemplar.error().kind,
                 fmt::format("{}; {} was baked with {}: give the photograph that was baked, or "
                             "other options",
                             exemplar.error().message, arguments.result, adopted)};
  if (!adopted.empty())
    exemplar.value().set.notes.insert(exemplar.value().set.notes.begin(),
                                      "as the bundle was baked: " + adopted);
  const MaterialSet& set = exemplar.value().set;
  const Result<std::vector<MapMeasures>> maps =
      baked ? compareBundle(arguments, *baked, exemplar.value())
            : compareImage(arguments, exemplar.value().set);
  if (!maps)
    return maps.error();
  std::optional<Verdict> verdict;
  if (baked && !isMix(baked->noise())) {
    const Result<Verdict> judged = verdictOf(*baked, set, arguments.shared);
    if (!judged)
      return judged.error();
    verdict = judged.value();
  }
  report(arguments, maps.value(), verdict, set.notes);
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
      .required();
  addText(verb, "RESULT|BUNDLE", arguments->result, "",
          "An image made from it, or a .glb or .gltf with its noise")
      .required();
  addText(verb, "--noise", arguments->noise, "NAME",
          "Name of the bundle's noise [default: the first]");
  addText(verb, "--map", arguments->map, "MAP",
          "One of the exemplar's maps, such as normal [default: all]");
  addValue(verb, "--mix", arguments->mix, optional(number(kMixWeightRange)), "",
           "Weight of a mix at which to measure: 0 for the first input, 1 for the last [default: "
           "0]");
  addExemplarOptions(verb, arguments->asBaked, ExemplarUse::comparison);
  arguments->verb = &verb;
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
