// SPDX-License-Identifier: MIT
// lichen bake: photograph -> glTF file with the noise and a preview scene.
#include "bake_report.h"
#include "bake_risks.h"
#include "bake_verdict.h"
#include "command.h"
#include "exemplar_options.h"
#include "html_report.h"
#include "layers_option.h"
#include "methods/method_command.h"
#include "noise_name.h"
#include "options.h"
#include "preview_images.h"
#include "progress_line.h"

#include <lichen/bundle_writer.h>
#include <lichen/layered_noise.h>

#include <CLI/App.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace lichen::cli {
namespace {

struct Arguments {
  explicit Arguments(const SharedOptions& options) : shared(options) {}

  const SharedOptions& shared;
  std::vector<std::string> inputs;
  std::string output;
  std::string name;
  std::uint32_t seed = 0;
  double tileMetres = 0.0;
  ExemplarOptions exemplar;
  std::optional<Method> wanted;
  Method method{}; ///< what was wanted, or chosen
  int bits = 0;    ///< per channel of the tables
  CommonOptions common;
  std::vector<std::unique_ptr<const BakeOptions>> methods; ///< in the order of Method
  LayersOption layers;
  const CLI::App* verb = nullptr;
  PreviewShape preview{};
  std::string report;

  [[nodiscard]] const BakeOptions& optionsOf(Method one) const {
    return *methods[std::size_t(one)];
  }
};

/// The error of an option that only some methods take.
Error foreignTo(Method method, const char* option, bool (MethodCommand::*takes)() const) {
  std::string takers;
  for (const Method other : allMethods())
    if ((commandOf(other).*takes)())
      takers += (takers.empty() ? "" : " and ") + std::string(nameOf(other));
  return {ErrorKind::usage,
          fmt::format("{}: belongs to --method {}, not to {}", option, takers, nameOf(method))};
}

/// Whether no option but --guide decides the method.
bool leavesMethodOpen(const Arguments& arguments) {
  return !arguments.wanted && !arguments.layers.isGiven() && !arguments.common.spectrum &&
         !givenOf(*arguments.verb, commandOf(Method::tiling).heading());
}

/// Whether the method depends on what repeats in the exemplar, which no option decides.
bool choosesByStructure(const Arguments& arguments) {
  return leavesMethodOpen(arguments) && !arguments.common.guide;
}

/// The method before the exemplar is known.
Method usualMethod(const Arguments& arguments) {
  const bool isGuided = arguments.common.guide.value_or(0.0) > 0.0;
  return arguments.wanted.value_or(isGuided ? Method::quilting : Method::tiling);
}

/// What the method needs, or the larger needs if the exemplar decides between tiling and quilting.
BakeMemory memoryOf(const Arguments& arguments) {
  BakeMemory memory = arguments.optionsOf(arguments.method).memory();
  if (choosesByStructure(arguments)) {
    const BakeMemory other = arguments.optionsOf(Method::quilting).memory();
    memory = {std::max(memory.map, other.map), std::max(memory.largest, other.largest)};
  }
  return memory;
}

/// Checks that the user gave no options of another method than the chosen one.
Result<void> checkMethodOptions(const Arguments& arguments) {
  if (!arguments.layers.labels.empty() && arguments.layers.count)
    return Error{ErrorKind::usage, "--layers: given with --labels; expected one of the two"};
  if (arguments.layers.softness && !arguments.layers.isGiven())
    return Error{ErrorKind::usage, "--softness: belongs to --labels and --layers"};
  if (arguments.layers.isGiven() && !isLayerable(arguments.method))
    return Error{ErrorKind::usage,
                 fmt::format("{}: layers do not take the method {}; expected --method {}",
                             arguments.layers.count ? "--layers" : "--labels",
                             nameOf(arguments.method), layerableMethods())};
  const MethodCommand& command = commandOf(arguments.method);
  if (arguments.common.spectrum && !command.takesSpectrum())
    return foreignTo(arguments.method, "--spectrum", &MethodCommand::takesSpectrum);
  if (arguments.wanted && arguments.common.guide && !command.takesGuide())
    return foreignTo(arguments.method, "--guide", &MethodCommand::takesGuide);
  const std::optional<ForeignOption> foreign = foreignOption(*arguments.verb, arguments.method);
  if (!foreign)
    return {};
  return Error{ErrorKind::usage,
               arguments.wanted
                   ? fmt::format("{}: belongs to --method {}, not to {}", foreign->name,
                                 nameOf(foreign->method), nameOf(arguments.method))
                   : fmt::format("{}: belongs to --method {}, which was not given", foreign->name,
                                 nameOf(foreign->method))};
}

/// The notes of a bake: printed as they arise, or part of the JSON report.
class Notes {
public:
  explicit Notes(const SharedOptions& options) : options_(options) {}

  void add(std::string line) { lines_.push_back(std::move(line)); }
  /// Prints the notes that were added since the last call.
  void say() {
    for (; said_ < lines_.size(); ++said_)
      if (!options_.json)
        note(options_, lines_[said_]);
  }
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

private:
  const SharedOptions& options_;
  std::vector<std::string> lines_;
  std::size_t said_ = 0;
};

/// The exemplar as it will be baked.
struct Exemplar {
  std::string name;
  std::vector<MapExemplar> maps;
  Periodic borders{};                  ///< from --periodic, or decided before resampling
  std::vector<ExemplarOrigin> origins; ///< one per map
  Preparation preparation;
  double widthShare = 1.0; ///< as in ReadExemplar
};

/// Also chooses the method, if the user left that to it.
Result<Exemplar> readAndChoose(Arguments& arguments, Notes& notes) {
  if (!arguments.layers.labels.empty())
    arguments.exemplar.set.cutsFrame = false; // the labels are of the whole picture
  const bool byStructure = choosesByStructure(arguments);
  arguments.exemplar.findsStructure =
      !arguments.layers.isGiven() && (byStructure || arguments.method == Method::quilting);
  Result<ReadExemplar> read = readExemplar(arguments.inputs, arguments.exemplar, arguments.shared);
  if (!read)
    return read.error();
  MaterialSet& set = read.value().set;
  const Structure& structure = read.value().structure;
  if (leavesMethodOpen(arguments) && arguments.common.guide == kGuideRange.least)
    notes.add("--guide 0: tiles are placed anywhere, so the noise is baked by tiling; --method "
              "quilting cuts them along outlines");
  if (byStructure && structure.isClear()) {
    arguments.method = Method::quilting;
    notes.add(structure.repeats()
                  ? "the exemplar repeats, so it is baked by quilting, which keeps what repeats; "
                    "--method tiling scatters it"
                  : "outlines hold the exemplar together, so it is baked by quilting, which keeps "
                    "what they enclose; --method tiling blends it");
  }
  if (arguments.method == Method::quilting && !arguments.common.guide)
    arguments.common.guide = structure.guide();
  for (std::string& line : set.notes)
    notes.add(std::move(line));
  return Exemplar{arguments.name.empty() ? asUtf8(set.name) : arguments.name,
                  std::move(set.maps),
                  set.periodic,
                  std::move(read.value().origins),
                  std::move(read.value().preparation),
                  read.value().widthShare};
}

/// A finished noise, noise 0 of the bundle, with what the method reports of it, and the verdict.
struct JudgedBake {
  LayeredBake baked;
  BakeVerdict judged;
};

/// Bakes, and judges what it baked.
Result<JudgedBake> bakeNoise(const Arguments& arguments, const Exemplar& exemplar, Notes& notes) {
  ProgressLine progress("bake", arguments.shared);
  const auto bake = [&](std::span<const MapExemplar> maps) {
    return arguments.optionsOf(arguments.method)
        .bake({exemplar.name, maps, exemplar.borders, arguments.bits, progress.asProgress()});
  };
  LayeredBake result;
  if (arguments.layers.isGiven()) {
    Result<LayeredBake> layered = bakeLayers(arguments.layers, exemplar.name, exemplar.maps, bake);
    if (!layered)
      return layered.error();
    result = std::move(layered).value();
  } else {
    Result<MethodBake> baked = bake(exemplar.maps);
    if (!baked)
      return baked.error();
    result.about = std::move(baked).value();
    result.bundle.noises.push_back(std::move(result.about.noise));
    result.bundle.tables = std::move(result.about.tables);
  }
  progress.erase();
  for (Noise& noise : result.bundle.noises)
    noise.tileSizeMetres =
        std::max(kTileSizeRange.least, arguments.tileMetres * exemplar.widthShare);
  result.bundle.noises.front().preparation = exemplar.preparation;
  result.about.material.seed = arguments.seed;
  result.bundle.materialNames = {result.bundle.noises.front().name};
  result.bundle.materials = {result.about.material};
  if (arguments.exemplar.set.periodic == Periodic::detect && result.about.bordersWereBlended)
    notes.add(fmt::format("the exemplar's borders do not fit together; the bake {} them",
                          result.about.borderTreatment));
  Result<BakeVerdict> judged =
      judgeNoise(result.bundle, *result.bundle.materials.front(), exemplar.maps, exemplar.borders,
                 !result.about.bordersWereBlended, arguments.shared);
  if (!judged)
    return judged.error();
  return JudgedBake{std::move(result), std::move(judged).value()};
}

Result<BundleFile> makeBundleFile(const Arguments& arguments, LayeredBake& bake) {
  BundleFile file;
  file.shape = arguments.preview;
  file.generator = "lichen " LICHEN_VERSION;
  file.bundle = std::move(bake.bundle);
  Result<PreviewImages> previews = previewImages(file.bundle, bake.about.material);
  if (!previews)
    return previews.error();
  file.previews.push_back(std::move(previews).value());
  return file;
}

/// Writes the page of --report and returns the lines to print about it; nothing without --report.
Result<std::vector<std::string>> writeReport(const Arguments& arguments, const Exemplar& exemplar,
                                             const JudgedBake& bake, const Bundle& bundle,
                                             const Notes& notes, StepTimes& times) {
  const ReportedInput input{.name = exemplar.name,
                            .exemplars = exemplar.maps,
                            .risks = bake.judged.assessed,
                            .origins = exemplar.origins};
  Result<std::vector<std::string>> lines = writeHtmlReport(arguments.report,
                                                           {.files = arguments.inputs,
                                                            .output = arguments.output,
                                                            .bundle = bundle,
                                                            .inputs = {&input, 1},
                                                            .verdict = bake.judged.verdict,
                                                            .facts = bake.baked.about.facts,
                                                            .notes = notes.lines(),
                                                            .timings = times.steps()},
                                                           arguments.shared);
  if (!arguments.report.empty())
    times.end("Report");
  return lines;
}

Result<int> run(Arguments& arguments) {
  StepTimes times;
  arguments.method = usualMethod(arguments);
  if (Result<void> checked = checkMethodOptions(arguments); !checked)
    return checked.error();
  if (Result<void> checked = checkOutput(arguments.output, {".glb", ".gltf"}); !checked)
    return checked.error();
  if (Result<void> checked = checkReportPath(arguments.report); !checked)
    return checked.error();
  arguments.exemplar.keepsOriginals = !arguments.report.empty();
  arguments.exemplar.bakeMemory = memoryOf(arguments);
  if (arguments.layers.isGiven()) // a part that occurs once may be a layer
    arguments.exemplar.outliers.keeps = true;
  Notes notes(arguments.shared);
  Result<Exemplar> read = readAndChoose(arguments, notes);
  if (!read)
    return read.error();
  const Exemplar& exemplar = read.value();
  notes.say(); // before the work: the user may prefer another photograph
  times.end("Reading and preparing the images");

  Result<JudgedBake> made = bakeNoise(arguments, exemplar, notes);
  if (!made)
    return made.error();
  times.end("Baking and judging the noise");
  MethodBake& bake = made.value().baked.about;
  for (const std::string& line : bake.notes)
    notes.add(line);
  const Result<BundleFile> file = makeBundleFile(arguments, made.value().baked);
  if (!file)
    return file.error();
  const Bundle& bundle = file.value().bundle;
  if (arguments.shared.json && !arguments.layers.isGiven()) {
    const Result<nlohmann::ordered_json> measured =
        arguments.optionsOf(arguments.method).measure(bundle, exemplar.maps, bake);
    if (!measured)
      return measured.error();
    bake.json.update(measured.value());
  }
  if (Result<void> written = writeBundle(arguments.output, file.value()); !written)
    return written.error();
  notes.say();
  times.end("Preview and bundle");

  const Result<std::vector<std::string>> page =
      writeReport(arguments, exemplar, made.value(), bundle, notes, times);
  if (!page)
    return page.error();
  const BakeVerdict& judged = made.value().judged;
  reportBake(arguments.shared, {.output = arguments.output,
                                .bundle = bundle,
                                .notes = notes.lines(),
                                .verdict = judged.verdict,
                                .risks = leadingRisks(exemplar.maps, judged.assessed),
                                .ofMethod = bake.json,
                                .seconds = times.sum()});
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
  addValue(verb, "--name", arguments->name, nameText(), "",
           "Name of the noise and its material [default: the input's]");
  addValue(verb, "--seed", arguments->seed, seedNumber(), "1", "Seed of the pattern");
  addValue(verb, "--tile", arguments->tileMetres, number(kTileSizeRange, "metres"), "1",
           "Width of the exemplar in metres, before --rectify: 0.5 for 50 cm");
  addExemplarOptions(verb, arguments->exemplar, ExemplarUse::bake);
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
  addValue(verb, "--precision", arguments->bits, oneOf<int>({{"8", 8}, {"16", 16}}), "8",
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
  addLayersOption(verb, arguments->layers);
  arguments->verb = &verb;
  verb.footer(kDroppedByOthers);
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
