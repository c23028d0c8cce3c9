// SPDX-License-Identifier: MIT
// lichen mix: photographs -> glTF file with a noise that blends from one to the next.
#include "bake_risks.h"
#include "command.h"
#include "exemplar_options.h"
#include "methods/texton_options.h"
#include "noise_choice.h"
#include "options.h"
#include "progress_line.h"

#include <lichen/bake_material.h>
#include <lichen/layered_noise.h>
#include <lichen/texton_mix.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <memory>

namespace lichen::cli {
namespace {

/// The heading of the options that --weights excludes.
constexpr const char* kPathGroup = "Steps";
/// Larger than any useful weight: at 10^6 to 1 the smaller one is invisible.
constexpr NumberRange kWeightRange{0.0, 1e6};

struct Arguments {
  explicit Arguments(const SharedOptions& options) : shared(options) {}

  const SharedOptions& shared;
  std::vector<std::string> inputs;
  std::string output;
  std::string name;
  std::uint32_t seed = 0;
  double tileMetres = 0.0;
  ExemplarOptions exemplar;
  TextonMixOptions mix;
  MaterialNoise material;
  PreviewShape preview{};
  const CLI::App* verb = nullptr;
};

/// The images, and what is known about them.
struct Inputs {
  std::vector<MixedExemplar> exemplars;
  std::vector<std::string> names; ///< without folder and extension
  std::vector<std::string> notes;
};

Result<void> check(const Arguments& arguments) {
  if (Result<void> checked = checkOutput(arguments.output, {".glb", ".gltf"}); !checked)
    return checked;
  const std::size_t count = arguments.inputs.size();
  if (count < 2 || count > kMaxMixedExemplars)
    return Error{ErrorKind::usage,
                 fmt::format("INPUT: {} given; expected 2 to {} photographs or folders; 'lichen "
                             "bake' turns one into noise",
                             count, kMaxMixedExemplars)};
  for (const std::string& input : arguments.inputs)
    if (namesBundle(input))
      return Error{ErrorKind::usage,
                   fmt::format("{}: is a bundle; expected photographs or folders, which 'lichen "
                               "mix' turns into textons; 'lichen layer' combines bundles of the "
                               "methods {}",
                               input, layerableMethods())};
  const std::vector<double>& weights = arguments.mix.weights;
  if (weights.empty())
    return {};
  if (const auto given = givenOf(*arguments.verb, kPathGroup))
    return Error{ErrorKind::usage,
                 *given + ": given with --weights, which makes one texton; expected one of the "
                          "two"};
  if (weights.size() != count)
    return Error{
        ErrorKind::usage,
        fmt::format("--weights: {} for {} inputs; expected one per input", weights.size(), count)};
  if (std::all_of(weights.begin(), weights.end(), [](double weight) { return weight == 0.0; }))
    return Error{ErrorKind::usage, "--weights: all are 0; expected a sum above 0"};
  return {};
}

Result<Inputs> readInputs(const Arguments& arguments) {
  Inputs inputs;
  for (const std::string& path : arguments.inputs) {
    Result<PreparedExemplar> read = readExemplar(path, arguments.exemplar, arguments.shared,
                                                 bakeMemoryOf(MethodOptions(TextonOptions{})));
    if (!read)
      return read.error();
    MaterialSet& set = read.value().set;
    for (const std::string& line : set.notes)
      inputs.notes.push_back(path + ": " + line);
    inputs.names.push_back(set.name);
    inputs.exemplars.push_back({path, std::move(set.maps)});
  }
  return inputs;
}

/// An option of `lichen mix`, which always makes textons, or `lichen bake` with its --method.
std::string mixOptionOf(const BakeSetting& setting) {
  const std::string option = optionOf(setting);
  return setting.name == "method" ? "lichen bake " + option + " for this input alone" : option;
}

/// Assesses the inputs, and adds notes on those for which texton noise looks wrong.
Result<void> judge(const Arguments& arguments, Inputs& inputs) {
  int widest = 0; // the other inputs are refined to this width
  for (const MixedExemplar& exemplar : inputs.exemplars)
    for (const MapExemplar& map : exemplar.maps)
      widest = std::max(widest, map.width);
  for (const MixedExemplar& exemplar : inputs.exemplars) {
    ProgressLine progress("assess", arguments.shared);
    Result<std::vector<std::vector<Risk>>> assessed =
        assessMixed(exemplar.maps, arguments.mix.texton.support, widest, progress.asProgress());
    if (!assessed)
      return assessed.error();
    const std::vector<MapRisk> risks = leadingRisks(exemplar.maps, assessed.value());
    for (const std::string& line : riskNotes(risks, exemplar.maps.size() > 1, mixOptionOf))
      inputs.notes.push_back(exemplar.name + ": " + line);
  }
  return {};
}

/// Returns "moss-rock", or the value of --name.
std::string nameOfMix(const Arguments& arguments, const std::vector<std::string>& names) {
  return arguments.name.empty() ? asUtf8(fmt::format("{}", fmt::join(names, "-"))) : arguments.name;
}

Bundle bundleOf(const Arguments& arguments, TextonMixBake bake) {
  // Texture coordinates visible on the ball and on the ground in front of it; the centre of the
  // ball has 0.5.
  constexpr std::array<double, 2> kPreviewStart{-1.0, 0.0};
  constexpr std::array<double, 2> kPreviewEnd{2.0, 0.0};
  bake.noise.tileSizeMetres = arguments.tileMetres;
  MaterialNoise material = arguments.material;
  material.seed = arguments.seed;
  if (isMix(bake.noise))
    material.mix = {.source = MixSource::direction, .start = kPreviewStart, .end = kPreviewEnd};
  Bundle bundle;
  bundle.tables = std::move(bake.tables);
  bundle.materialNames = {bake.noise.name};
  bundle.noises = {std::move(bake.noise)};
  bundle.materials = {material};
  return bundle;
}

void report(const Arguments& arguments, const Bundle& bundle, const TextonMixQuality& quality,
            const std::vector<std::string>& notes, double seconds) {
  const Noise& noise = bundle.noises.front();
  const TextonShape& shape = noise.as<TextonShape>();
  std::vector<std::string> targets;
  for (const NoiseMap& map : noise.maps)
    targets.emplace_back(nameOf(map.target));
  if (arguments.shared.json) {
    const nlohmann::ordered_json json{{"output", arguments.output},
                                      {"name", noise.name},
                                      {"inputs", arguments.inputs},
                                      {"maps", targets},
                                      {"width", shape.texelsPerTileX},
                                      {"height", shape.texelsPerTileY},
                                      {"steps", shape.steps},
                                      {"modelErrors", quality.modelErrors},
                                      {"channelErrors", quality.channelErrors},
                                      {"largestStep", quality.largestStep},
                                      {"rankError", quality.rankError},
                                      {"tableBytes", texelBytes(bundle)},
                                      {"notes", notes},
                                      {"seconds", seconds}};
    printLine(toText(json));
    return;
  }
  constexpr std::size_t kKibi = 1024;
  say(arguments.shared,
      fmt::format("{}: {}, {} x {}, {} {}, {} KiB of tables, {:.2f} s", arguments.output,
                  fmt::join(targets, ", "), shape.texelsPerTileX, shape.texelsPerTileY, shape.steps,
                  shape.steps == 1 ? "texton" : "textons", texelBytes(bundle) / kKibi, seconds));
}

Result<int> run(Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  if (Result<void> checked = check(arguments); !checked)
    return checked.error();
  Result<Inputs> inputs = readInputs(arguments);
  if (!inputs)
    return inputs.error();
  if (Result<void> judged = judge(arguments, inputs.value()); !judged)
    return judged.error();
  std::vector<std::string> notes = std::move(inputs.value().notes);
  ProgressLine progress("mix", arguments.shared);
  arguments.mix.texton.progress = progress.asProgress();
  Result<TextonMixBake> baked = bakeTextonMix(nameOfMix(arguments, inputs.value().names),
                                              inputs.value().exemplars, arguments.mix);
  if (!baked)
    return baked.error();
  const TextonMixQuality quality = std::move(baked.value().quality);
  const TextonShape shape = baked.value().noise.as<TextonShape>();
  if (std::optional<std::string> line =
          supportNote(arguments.mix.texton.support, shape, mixOptionOf))
    notes.push_back(std::move(*line));
  notes.push_back(mixNote(quality, baked.value().noise, mixOptionOf,
                          "lichen bake --method tiling for each input alone"));
  const Result<BundleFile> file = withPreviews(bundleOf(arguments, std::move(baked).value()),
                                               arguments.preview, "lichen " LICHEN_VERSION);
  if (!file)
    return file.error();
  if (Result<void> written = writeBundle(arguments.output, file.value()); !written)
    return written.error();
  progress.erase();
  for (const std::string& line : notes)
    note(arguments.shared, line);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  report(arguments, file.value().bundle, quality, notes, seconds.count());
  return kDone;
}

} // namespace

Runner addMix(CLI::App& verb, const SharedOptions& shared) {
  auto arguments = std::make_shared<Arguments>(shared);
  addTexts(verb, "INPUT", arguments->inputs, "...",
           "Photographs, or folders with the same maps of several materials: PNG, JPEG or EXR")
      .required();
  addText(verb, "-o,--output", arguments->output, "OUT.glb|OUT.gltf", "The bundle").required();
  addValue(verb, "--steps", arguments->mix.steps,
           wholeNumber(int(kMixStepsRange.least), int(kMixStepsRange.most)), "21",
           "Textons from each input to the next, including both ends")
      .group(kPathGroup);
  addValue(verb, "--weights", arguments->mix.weights, numbers(kWeightRange, kMaxMixedExemplars), "",
           "Make one texture between all inputs instead, with these shares");
  addValue(verb, "--name", arguments->name, nameText(), "",
           "Name of the noise and its material [default: the inputs']");
  addValue(verb, "--seed", arguments->seed, seedNumber(), "1", "Seed of the pattern");
  addValue(verb, "--tile", arguments->tileMetres, number(kTileSizeRange, "metres"), "1",
           "Width of the exemplars in metres: 0.5 for 50 cm");
  addExemplarOptions(verb, arguments->exemplar, ExemplarUse::mix);
  addPreviewShape(verb, arguments->preview);
  addValue(verb, "--precision", arguments->mix.texton.bits, oneOf<int>({{"8", 8}, {"16", 16}}), "8",
           "8: textons of 16-bit floats; 16: of 32-bit floats");
  addValue(verb, "--impacts", arguments->material.impacts, number(kImpactsRange), "30",
           "Mean number of impacts at a point; shader time is proportional");
  addTextonOptions(verb, arguments->mix.texton, arguments->material);
  arguments->verb = &verb;
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
