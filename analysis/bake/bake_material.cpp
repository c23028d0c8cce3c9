// SPDX-License-Identifier: MIT
// Maps of a material -> exemplar -> method -> noise -> judgement.
#include "layered_bake.h"
#include "method_analysis.h"

#include <lichen/layered_noise.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace lichen {
namespace {

/// Whether what repeats in the exemplar decides the method.
bool choosesByStructure(const BakeOptions& options) { return !options.method && !options.layers; }

/// The method before the exemplar is known.
MethodOptions usualMethod(const BakeOptions& options) {
  return options.method.value_or(TilingOptions{});
}

Result<void> checkOptions(const BakeOptions& options, SettingWords words) {
  if (!options.layers)
    return {};
  if (const Method method = methodOf(usualMethod(options)); !isLayerable(method))
    return Error{ErrorKind::usage, fmt::format("{}: layers do not take the method {}; expected {}",
                                               words({"layers", ""}), nameOf(method),
                                               words({"method", layerableMethods()}))};
  return {};
}

/// A bake as it proceeds.
class Bake {
public:
  Bake(const BakeOptions& options, const BakeObserver& observer)
      : options_(options), observer_(observer), method_(usualMethod(options)) {}

  Result<BakedMaterial> of(MaterialSet set) {
    if (Result<void> checked = checkOptions(options_, observer_.words); !checked)
      return checked.error();
    ExemplarOptions preparing = options_.exemplar;
    if (options_.layers) // a part that occurs once may be a layer
      preparing.outliers.keeps = true;
    const bool byStructure = choosesByStructure(options_);
    const bool findsRegularity =
        byStructure || (!options_.layers && std::holds_alternative<QuiltingOptions>(method_));
    Result<PreparedExemplar> prepared =
        prepareExemplar(std::move(set), preparing, findsRegularity, observer_);
    if (!prepared)
      return prepared.error();
    exemplar_ = std::move(prepared).value();
    choose(byStructure);
    for (const std::string& line : exemplar_.set.notes)
      note(line);
    if (Result<void> baked = bake(); !baked)
      return baked.error();
    Result<NoiseJudgement> judged =
        judgeNoise(result_.bundle, *result_.bundle.materials.front(), exemplar_.set.maps,
                   exemplar_.set.periodic, result_.figures.bordersWereKept, observer_.of("judge"));
    if (!judged)
      return judged.error();
    result_.judgement = std::move(judged).value();
    for (const std::string& line : methodNotes_)
      note(line);
    result_.exemplars = std::move(exemplar_.set.maps);
    result_.origins = std::move(exemplar_.origins);
    return std::move(result_);
  }

private:
  void note(const std::string& line) {
    result_.notes.push_back(line);
    if (observer_.note)
      observer_.note(line);
  }

  /// Chooses the method, if the user left that open, and the guide of quilting.
  void choose(bool byStructure) {
    const Regularity& regularity = exemplar_.regularity;
    if (byStructure && regularity.isClear()) {
      method_ = QuiltingOptions{};
      const std::string other = observer_.words({"method", "tiling"});
      note(regularity.repeats()
               ? "the exemplar repeats, so it is baked by quilting, which keeps what repeats; " +
                     other + " scatters it"
               : "outlines hold the exemplar together, so it is baked by quilting, which keeps "
                 "what they enclose; " +
                     other + " blends it");
    }
    if (auto* quilting = std::get_if<QuiltingOptions>(&method_); quilting && !quilting->guide)
      quilting->guide = regularity.guide();
  }

  Result<void> bake() {
    const std::string name = options_.name.empty() ? asUtf8(exemplar_.set.name) : options_.name;
    const Progress progress = observer_.of("bake");
    const auto bakeMaps = [&](std::span<const MapExemplar> maps) {
      return analysisOf(methodOf(method_))
          .bake(method_, {name, maps, exemplar_.set.periodic, options_.bits, options_.material,
                          observer_.words, progress});
    };
    MethodBake about;
    if (options_.layers) {
      Result<LayeredBake> layered = bakeLayers(*options_.layers, name, exemplar_.set.maps,
                                               options_.material, observer_.words, bakeMaps);
      if (!layered)
        return layered.error();
      result_.bundle = std::move(layered.value().bundle);
      result_.proportions = std::move(layered.value().proportions);
      about = std::move(layered.value().about);
    } else {
      Result<MethodBake> baked = bakeMaps(exemplar_.set.maps);
      if (!baked)
        return baked.error();
      about = std::move(baked).value();
      result_.bundle.noises.push_back(std::move(about.noise));
      result_.bundle.tables = std::move(about.tables);
      result_.bundle.materials = {options_.material};
      result_.bundle.materialNames = {name};
    }
    for (Noise& noise : result_.bundle.noises)
      noise.tileSizeMetres =
          std::max(kTileSizeRange.least, options_.tileSizeMetres * exemplar_.widthShare);
    result_.bundle.noises.front().preparation = exemplar_.preparation;
    result_.figures = std::move(about.figures);
    if (options_.exemplar.set.periodic == Periodic::detect && !result_.figures.bordersWereKept)
      note(fmt::format("the exemplar's borders do not fit together; the bake {} them",
                       about.borderTreatment));
    methodNotes_ = std::move(about.notes);
    return {};
  }

  const BakeOptions& options_;
  const BakeObserver& observer_;
  MethodOptions method_;
  PreparedExemplar exemplar_;
  BakedMaterial result_;
  std::vector<std::string> methodNotes_;
};

} // namespace

std::string asUtf8(const std::string& text) {
  constexpr std::string_view kReplacement = "\xEF\xBF\xBD"; // U+FFFD, which dump() inserts
  std::string valid = nlohmann::json::parse(
      nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  if (valid == text)
    return text;
  for (std::size_t at; (at = valid.find(kReplacement)) != std::string::npos;)
    valid.replace(at, kReplacement.size(), "_");
  return valid;
}

MaterialSetOptions readingOf(const BakeOptions& options) {
  MaterialSetOptions reading = options.exemplar.set;
  if (options.layers && std::holds_alternative<LabelPicture>(*options.layers))
    reading.cutsFrame = false; // the labels are of the whole picture
  return reading;
}

BakeMemory bakeMemoryOf(const MethodOptions& options) {
  return analysisOf(methodOf(options)).memory(options);
}

BakeMemory bakeMemoryOf(const BakeOptions& options) {
  const BakeMemory usual = bakeMemoryOf(usualMethod(options));
  if (!choosesByStructure(options))
    return usual;
  const BakeMemory other = bakeMemoryOf(MethodOptions(QuiltingOptions{}));
  return {std::max(usual.map, other.map), std::max(usual.largest, other.largest)};
}

Result<NoiseJudgement> judgeNoise(const Bundle& bundle, const MaterialNoise& material,
                                  std::span<const MapExemplar> maps, Periodic borders,
                                  bool bordersWereKept, const Progress& progress) {
  constexpr double kAssessment = 0.6; // share of the processor time, for the progress
  Result<std::vector<std::vector<Risk>>> risks =
      assessNoise(bundle.noises[material.noise], maps, borders, partOf(progress, 0.0, kAssessment));
  if (!risks)
    return risks.error();
  Result<std::vector<Measure>> measures =
      measureNoise(bundle, material, maps.front(), partOf(progress, kAssessment, 1.0));
  if (!measures)
    return measures.error();
  NoiseJudgement judged{std::move(risks).value(), std::move(measures).value(), {}};
  std::vector<JudgedMap> all;
  for (std::size_t m = 0; m < maps.size(); ++m)
    all.push_back(
        {maps[m].target, judged.risks[m],
         m == 0 ? std::span<const Measure>(judged.measures) : std::span<const Measure>()});
  judged.verdict = verdictOn(all, bordersWereKept);
  return judged;
}

Result<BakedMaterial> bakeMaterial(MaterialSet set, const BakeOptions& options,
                                   const BakeObserver& observer) {
  return withinMemory([] { return "not enough memory to bake the material"; },
                      [&] { return Bake(options, observer).of(std::move(set)); });
}

Result<BakedMaterial> bakeMaterial(std::vector<Photograph> photographs, const BakeOptions& options,
                                   const BakeObserver& observer) {
  Result<MaterialSet> set = materialSetOf(std::move(photographs), readingOf(options));
  if (!set)
    return set.error();
  return bakeMaterial(std::move(set).value(), options, observer);
}

} // namespace lichen
