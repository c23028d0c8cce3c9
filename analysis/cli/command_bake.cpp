// SPDX-License-Identifier: MIT
// lichen bake: photograph -> glTF file with the noise and a preview scene.
#include "bake_report.h"
#include "bake_risks.h"
#include "command.h"
#include "exemplar_options.h"
#include "html_report.h"
#include "methods/method_command.h"
#include "noise_choice.h"
#include "options.h"
#include "srgb_picture.h"
#include "steps_shown.h"

#include <lichen/bake_material.h>
#include <lichen/layers.h>

#include <CLI/App.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <memory>

namespace lichen::cli {
namespace {

/// Clusters of the exemplar's colours, or a picture of labels to read.
using LayersChoice = std::variant<int, std::filesystem::path>;

struct Arguments {
  explicit Arguments(const SharedOptions& options) : shared(options) {}

  const SharedOptions& shared;
  std::vector<std::string> inputs;
  std::string output;
  BakeOptions bake; ///< without what follows
  std::optional<Method> wanted;
  CommonOptions common;
  std::vector<BakeOptionsReader> methods; ///< in the order of Method
  std::optional<LayersChoice> layers;
  const CLI::App* verb = nullptr;
  PreviewShape preview{};
  std::string report;
};

/// "3", or the name of a picture of labels.
Accepted<std::optional<LayersChoice>> layersChoice() {
  const Accepted<int> count = wholeNumber(kFewestLabels, kMostLabels);
  return {
      "N|PICTURE", count.sentence + ", or a picture of as many colours",
      [read = count.read](const std::string& text) -> std::optional<std::optional<LayersChoice>> {
        if (const std::optional<int> clusters = read(text))
          return LayersChoice(*clusters);
        if (text.find_first_not_of("0123456789") == std::string::npos) // also of nothing
          return std::nullopt;
        return LayersChoice(std::filesystem::path(text));
      }};
}

/// The error of an option that only some methods take.
Error foreignTo(const std::optional<Method>& wanted, const std::string& option,
                std::string_view takers) {
  return {ErrorKind::usage,
          fmt::format("{}: belongs to --method {}, {}", option, takers,
                      wanted ? fmt::format("not to {}", nameOf(*wanted)) : "which was not given")};
}

/// Whether no option but --guide decides the method.
bool leavesMethodOpen(const Arguments& arguments) { return !arguments.wanted && !arguments.layers; }

/// The method that the options decide, if they do.
std::optional<Method> methodOf(const Arguments& arguments) {
  const std::optional<double>& guide = arguments.common.guide;
  if (arguments.wanted || (leavesMethodOpen(arguments) && !guide))
    return arguments.wanted;
  return guide.value_or(0.0) > 0.0 ? Method::quilting : Method::tiling;
}

/// Checks that the user gave no options of another method than the chosen one.
Result<void> checkMethodOptions(const Arguments& arguments, Method method) {
  struct Shared {
    const char* option;
    bool (MethodCommand::*isTaken)() const;
  };
  for (const Shared& shared : {Shared{"--spectrum", &MethodCommand::takesSpectrum},
                               Shared{"--impacts", &MethodCommand::takesImpacts},
                               Shared{"--guide", &MethodCommand::takesGuide}}) {
    const bool decidesMethod = shared.isTaken == &MethodCommand::takesGuide && !arguments.wanted;
    if (!isGiven(*arguments.verb, shared.option) || decidesMethod ||
        (commandOf(method).*shared.isTaken)())
      continue;
    std::string takers;
    for (const Method other : allMethods())
      if ((commandOf(other).*shared.isTaken)())
        takers += (takers.empty() ? "" : " or ") + std::string(nameOf(other));
    return foreignTo(arguments.wanted, shared.option, takers);
  }
  if (const std::optional<ForeignOption> foreign = foreignOption(*arguments.verb, method))
    return foreignTo(arguments.wanted, foreign->name, nameOf(foreign->method));
  return {};
}

/// Reads the options of the method, if they decide it. `maps` as BakeOptionsReader has them.
Result<void> setMethod(Arguments& arguments, std::span<const MapExemplar> maps,
                       std::vector<std::string>& notes) {
  const std::optional<Method> method = methodOf(arguments);
  if (!method)
    return {};
  Result<MethodOptions> own = arguments.methods[std::size_t(*method)](maps, notes);
  if (!own)
    return own.error();
  arguments.bake.method = std::move(own).value();
  return {};
}

Result<void> setLayers(Arguments& arguments) {
  if (!arguments.layers)
    return {};
  if (const int* count = std::get_if<int>(&*arguments.layers)) {
    arguments.bake.layers = *count;
    return {};
  }
  const auto& path = std::get<std::filesystem::path>(*arguments.layers);
  Result<SrgbImage> picture = readSrgb(path);
  if (!picture)
    return picture.error();
  arguments.bake.layers = LabelPicture{std::move(picture).value(), path.string()};
  return {};
}

/// Members of the report that only this bake has.
Json figuresOf(const BakedMaterial& baked) {
  Json json = commandOf(baked.bundle.noises.front().method()).figures(baked);
  if (!baked.proportions.empty())
    json["proportions"] = baked.proportions;
  return json;
}

/// Reads the images, and bakes them. Adds notes on options to the bake's own.
Result<BakedMaterial> readAndBake(Arguments& arguments) {
  std::vector<std::string> notes;
  if (leavesMethodOpen(arguments) && arguments.common.guide == kGuideRange.least)
    notes.emplace_back(
        "--guide 0: tiles are placed anywhere, so the noise is baked by tiling; --method "
        "quilting cuts them along outlines");
  if (Result<void> set = setMethod(arguments, {}, notes); !set)
    return set.error();
  if (Result<void> set = setLayers(arguments); !set)
    return set.error();
  Result<MaterialSet> set =
      readMaterial(arguments.inputs, readingOf(arguments.bake), bakeMemoryOf(arguments.bake));
  if (!set)
    return set.error();
  if (std::vector<std::string> again; arguments.common.spectrum)
    if (Result<void> sized = setMethod(arguments, set.value().maps, again); !sized)
      return sized.error();
  StepsShown steps(arguments.shared);
  const BakeObserver observer = steps.observer();
  for (const std::string& line : notes)
    observer.note(line);
  Result<BakedMaterial> baked = bakeMaterial(std::move(set).value(), arguments.bake, observer);
  if (baked)
    baked.value().notes.insert(baked.value().notes.begin(), notes.begin(), notes.end());
  return baked;
}

Result<int> run(Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  if (Result<void> checked =
          checkMethodOptions(arguments, methodOf(arguments).value_or(Method::tiling));
      !checked)
    return checked.error();
  if (Result<void> checked = checkOutput(arguments.output, {".glb", ".gltf"}); !checked)
    return checked.error();
  if (Result<void> checked = checkReportPath(arguments.report); !checked)
    return checked.error();
  arguments.bake.exemplar.keepsOriginals = !arguments.report.empty();
  arguments.bake.material = arguments.common.material;
  Result<BakedMaterial> made = readAndBake(arguments);
  if (!made)
    return made.error();
  BakedMaterial& baked = made.value();
  const Json figures = figuresOf(baked);
  const Result<BundleFile> file =
      withPreviews(std::move(baked.bundle), arguments.preview, "lichen " LICHEN_VERSION);
  if (!file)
    return file.error();
  if (Result<void> written = writeBundle(arguments.output, file.value()); !written)
    return written.error();
  const Bundle& bundle = file.value().bundle;
  const Result<std::vector<std::string>> page = writeHtmlReport(arguments.report,
                                                                {.files = arguments.inputs,
                                                                 .output = arguments.output,
                                                                 .bundle = bundle,
                                                                 .baked = baked,
                                                                 .figures = figures},
                                                                arguments.shared);
  if (!page)
    return page.error();
  const NoiseJudgement& judged = baked.judgement;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  reportBake(arguments.shared, {.output = arguments.output,
                                .bundle = bundle,
                                .notes = baked.notes,
                                .verdict = judged.verdict,
                                .risks = leadingRisks(baked.exemplars, judged.risks),
                                .ofMethod = figures,
                                .seconds = seconds.count()});
  for (const std::string& line : page.value())
    say(arguments.shared, line);
  return kDone;
}

} // namespace

Runner addBake(CLI::App& verb, const SharedOptions& shared) {
  auto arguments = std::make_shared<Arguments>(shared);
  addTexts(verb, "INPUT", arguments->inputs, "...",
           "A photograph, or a folder or files with the maps of a material: PNG, JPEG or EXR")
      .required();
  addText(verb, "-o,--output", arguments->output, "OUT.glb|OUT.gltf", "The bundle").required();
  addValue(verb, "--name", arguments->bake.name, nameText(), "",
           "Name of the noise and its material [default: the input's]");
  addValue(verb, "--seed", arguments->common.material.seed, seedNumber(), "1",
           "Seed of the pattern");
  addValue(verb, "--tile", arguments->bake.tileSizeMetres, number(kTileSizeRange, "metres"), "1",
           "Width of the exemplar in metres, before --rectify: 0.5 for 50 cm");
  addExemplarOptions(verb, arguments->bake.exemplar, ExemplarUse::bake);
  addPreviewShape(verb, arguments->preview);
  addReport(verb, arguments->report);
  Choices<Method> methods;
  for (const Method method : allMethods())
    methods.emplace_back(nameOf(method), method);
  addValue(
      verb, "--method", arguments->wanted, optional(oneOf(methods)), "",
      "tiling keeps the exemplar's histogram; texton makes a Gaussian texture, the smallest on "
      "the GPU; local-random-phase keeps histogram and spectrum, sharp at any magnification; "
      "multiple-kernels does so with few kernels, for painted spectra; quilting keeps bricks, "
      "boards and threads whole [default: quilting if something repeats clearly or has clear "
      "outlines, otherwise tiling]");
  addValue(verb, "--precision", arguments->bake.bits, oneOf<int>({{"8", 8}, {"16", 16}}), "8",
           "Bits per channel of the tables; for textons 16- or 32-bit floats");
  for (const Method method : allMethods())
    arguments->methods.push_back(commandOf(method).addBakeOptions(verb, arguments->common));
  addValue(verb, "--guide", arguments->common.guide, orAuto(number(kGuideRange)), "auto",
           "How closely the noise follows what repeats in the exemplar, such as bricks; 0: not at "
           "all; auto: as clearly as it repeats")
      .group("Quilting and local random phase");
  addValue(
      verb, "--spectrum", arguments->common.spectrum, spectrumChoice(), "",
      "A spectrum in place of the exemplar's, which gives the colours: a picture of amplitudes, "
      "frequency 0 in the middle and a cycle per tile a pixel; or parts with commas between them, "
      "in cycles per tile: ring:FROM:TO, band:LEFT:RIGHT:TOP:BOTTOM, lobe:U:V:RADIUS")
      .group("Local random phase and multiple kernels");
  addValue(verb, "--impacts", arguments->common.material.impacts, number(kImpactsRange), "30",
           "Mean number of impacts at a point, of all kernels; shader time is proportional")
      .group("Texton and multiple kernels");
  addValue(verb, "--layers", arguments->layers, layersChoice(), "",
           "Layers that alternate as in the photograph: of N clusters of its colours, or of a "
           "picture of 2 to 4 colours that says which pixels are which material");
  arguments->verb = &verb;
  verb.footer(kDroppedByOthers);
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
