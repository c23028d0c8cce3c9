// SPDX-License-Identifier: MIT
// lichen apply: adds a noise to materials of an existing scene.
#include "apply_extensions.h"
#include "apply_factors.h"
#include "apply_frames.h"
#include "apply_materials.h"
#include "apply_meshes.h"
#include "apply_mix.h"
#include "apply_textures.h"
#include "apply_tiles.h"
#include "command.h"
#include "methods/method_command.h"
#include "noise_choice.h"
#include "options.h"

#include <lichen/layered_noise.h>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <memory>
#include <numbers>

namespace lichen::cli {
namespace {

constexpr NumberRange kDegreesRange{-360.0, 360.0};
constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

struct Arguments {
  explicit Arguments(const SharedOptions& options) : shared(options) {}

  const SharedOptions& shared;
  std::string scene;
  std::string noise;
  std::vector<std::string> materials;
  Mapping mapping{};
  std::optional<NoiseSpace> space;
  std::optional<double> scale;
  std::optional<double> rotationDegrees;
  std::optional<std::uint32_t> seed;
  std::optional<double> contrast;
  std::optional<double> planeSharpness;
  std::vector<UseOptions> methods; ///< in the order of Method
  const CLI::App* verb = nullptr;
  std::optional<Vector3> grain;
  bool setsFactors = false;
  MixOptions mix;
  std::string output;
};

/// The result, for the report.
struct Outcome {
  AppliedNoise noise;
  std::vector<std::string> materials;
  std::vector<MaterialTile> tiles;
  std::vector<MeshFrames> frames;
  std::vector<std::string> notes;
};

/// Returns the parameters of the bundle's first material that uses the noise, since the user has
/// seen the noise with them; the options override them.
MaterialNoise parametersOf(const Bundle& bundle, std::size_t noise, const Arguments& arguments) {
  MaterialNoise use;
  for (const std::optional<MaterialNoise>& material : bundle.materials)
    if (material && material->noise == noise) {
      use = *material;
      break;
    }
  use.mapping = arguments.mapping;
  use.space = arguments.space.value_or(isInSpace(use.mapping) ? use.space : NoiseSpace::world);
  use.texCoord = 0;
  use.scale = arguments.scale.value_or(use.scale);
  if (arguments.rotationDegrees)
    use.rotation = *arguments.rotationDegrees * kRadiansPerDegree;
  use.seed = arguments.seed.value_or(use.seed);
  use.contrast = arguments.contrast.value_or(use.contrast);
  use.planeSharpness = arguments.planeSharpness.value_or(use.planeSharpness);
  EvaluationOptions none; // a material stores none
  arguments.methods[std::size_t(bundle.noises[noise].method())](use, none);
  return use;
}

/// Checks that the noise supports the mapping.
Result<void> checkMapping(const Noise& noise, Mapping mapping) {
  if (mappingFits(noise.method(), mapping)) {
    const std::string_view obstacle = mappingObstacle(noise, mapping);
    if (obstacle.empty())
      return {};
    return Error{ErrorKind::usage,
                 fmt::format("--mapping {}: noise '{}' does not support it: {}; bake it {}",
                             nameOf(mapping), noise.name, obstacle,
                             commandOf(noise.method()).optionsFor(mapping))};
  }
  std::vector<std::string> mappings, methods;
  for (const Mapping each : {Mapping::uv, Mapping::triplanar, Mapping::surface, Mapping::solid})
    if (mappingFits(noise.method(), each))
      mappings.emplace_back(nameOf(each));
  for (const Method each : allMethods())
    if (mappingFits(each, mapping))
      methods.push_back("--method " + std::string(nameOf(each)));
  return Error{
      ErrorKind::usage,
      fmt::format("--mapping {}: noise '{}' is of the method {}, which does not support it; "
                  "use {}{}",
                  nameOf(mapping), noise.name, nameOf(noise.method()), alternatives(mappings),
                  methods.empty() ? std::string()
                                  : ", or a noise that is baked with " + alternatives(methods))};
}

/// Checks that --space and --plane-sharpness fit the mapping.
Result<void> checkMappingOptions(const Arguments& arguments) {
  if (arguments.space && !isInSpace(arguments.mapping))
    return Error{
        ErrorKind::usage,
        fmt::format("--space {}: belongs to --mapping triplanar, surface or solid, not to {}",
                    nameOf(*arguments.space), nameOf(arguments.mapping))};
  if (arguments.planeSharpness && arguments.mapping != Mapping::triplanar)
    return Error{ErrorKind::usage,
                 fmt::format("--plane-sharpness: belongs to --mapping triplanar, not to {}",
                             nameOf(arguments.mapping))};
  return {};
}

/// Checks that the user gave no options of another method than the noise's.
Result<void> checkMethodOptions(const Arguments& arguments, const Noise& noise) {
  const std::optional<ForeignOption> foreign = foreignOption(*arguments.verb, noise.method());
  if (!foreign)
    return {};
  return Error{ErrorKind::usage,
               fmt::format("{}: belongs to the method {}; noise '{}' is of the method {}; bake it "
                           "with --method {}",
                           foreign->name, nameOf(foreign->method), noise.name,
                           nameOf(noise.method()), nameOf(foreign->method))};
}

/// Adds a note if the noise is renamed in the scene.
void noteName(const std::string& scene, const std::string& name, const AppliedNoise& applied,
              std::vector<std::string>& notes) {
  if (applied.name == name)
    return;
  notes.push_back(
      fmt::format("{}: noise '{}' {} '{}'", scene, name,
                  applied.isNew ? "is renamed, since the name is taken, to" : "is already there as",
                  applied.name));
}

void report(const Arguments& arguments, const Outcome& outcome, double seconds) {
  if (arguments.shared.json) {
    const nlohmann::ordered_json json{{"output", arguments.output},
                                      {"noise", outcome.noise.name},
                                      {"newTables", outcome.noise.newTables},
                                      {"materials", outcome.materials},
                                      {"tiles", asJson(outcome.tiles)},
                                      {"frames", asJson(outcome.frames)},
                                      {"notes", outcome.notes},
                                      {"seconds", seconds}};
    printLine(toText(json));
    return;
  }
  for (const std::string& text : outcome.notes)
    note(arguments.shared, text);
  say(arguments.shared,
      fmt::format("{}: {} on {}; {} new table{}, {:.2f} s", arguments.output, outcome.noise.name,
                  shortList(outcome.materials), outcome.noise.newTables,
                  outcome.noise.newTables == 1 ? "" : "s", seconds));
  for (const std::string& line : linesOn(outcome.tiles))
    say(arguments.shared, line);
}

/// Returns the materials that have, or can be given, what the mapping needs.
Result<std::vector<std::size_t>> suitableMaterials(const GltfScene& scene,
                                                   const ChosenMaterials& chosen,
                                                   const Noise& noise, const MaterialNoise& use,
                                                   std::vector<std::string>& notes) {
  switch (use.mapping) {
  case Mapping::uv:
    return materialsWith(fmt::format("TEXCOORD_{}", use.texCoord), scene, chosen, "--mapping uv",
                         "--mapping triplanar", notes);
  case Mapping::surface:
    return materialsWithFrames(scene, chosen, findMap(noise, MapTarget::normal).has_value(), notes);
  default:
    return chosen.indices;
  }
}

struct ChosenNoise {
  Bundle bundle;
  std::size_t index = 0; ///< index of the noise in its bundle
};

/// Returns the noise that the user named, after checking that its method supports the options.
Result<ChosenNoise> chooseNoise(const Arguments& arguments) {
  const auto [file, name] = splitNoise(arguments.noise);
  if (name.empty() && file.size() < arguments.noise.size())
    return Error{ErrorKind::usage,
                 fmt::format("--noise {}: the name after the colon is empty; expected {} or "
                             "{}:NAME",
                             arguments.noise, file, file)};
  Result<Bundle> bundle = readBundle(file);
  if (!bundle)
    return bundle.error();
  const Result<std::size_t> index = findNoise(bundle.value(), file, name);
  if (!index)
    return index.error();
  const Noise& noise = bundle.value().noises[index.value()];
  if (Result<void> fits = checkMapping(noise, arguments.mapping); !fits)
    return fits.error();
  if (const std::string obstacle =
          mappingObstacle(bundle.value(), index.value(), arguments.mapping);
      !obstacle.empty()) // of another layer
    return Error{ErrorKind::usage,
                 fmt::format("--mapping {}: {}", nameOf(arguments.mapping), obstacle)};
  if (Result<void> fits = checkMethodOptions(arguments, noise); !fits)
    return fits.error();
  return ChosenNoise{std::move(bundle).value(), index.value()};
}

/// Notes on unexpected changes to the look of the noise.
std::vector<std::string> notesOnLook(const Arguments& arguments, const GltfScene& scene,
                                     std::span<const std::size_t> materials, const Noise& noise) {
  std::vector<std::string> notes = notesOnFactors(scene, materials, noise, arguments.setsFactors);
  for (std::string& text : notesOnTextures(scene, materials, noise))
    notes.push_back(std::move(text));
  return notes;
}

Result<Outcome> apply(const Arguments& arguments) {
  const Result<ChosenNoise> noiseChosen = chooseNoise(arguments);
  if (!noiseChosen)
    return noiseChosen.error();
  const auto& [bundle, index] = noiseChosen.value();
  const Noise& noise = bundle.noises[index];
  Result<GltfScene> opened = GltfScene::open(arguments.scene);
  if (!opened)
    return opened.error();
  GltfScene& scene = opened.value();
  Outcome outcome;
  const Result<ChosenMaterials> chosen = findMaterials(scene, arguments.materials);
  if (!chosen)
    return chosen.error();
  MaterialNoise use = parametersOf(bundle, index, arguments);
  if (!takesTileRotation(bundle, index, use.tileRotation))
    return Error{ErrorKind::usage,
                 fmt::format("--tile-rotation {}: the tiles of the noise '{}' are not square; "
                             "expected none or 2",
                             use.tileRotation, noise.name)};
  Result<std::vector<std::size_t>> suitable =
      suitableMaterials(scene, chosen.value(), noise, use, outcome.notes);
  if (!suitable)
    return suitable.error();
  const Result<ChosenMix> mix =
      chosenMix(arguments.mix, noise, use, {std::move(suitable).value(), chosen.value().areAll},
                scene, outcome.notes);
  if (!mix)
    return mix.error();
  use.mix = mix.value().weight;
  const std::vector<std::size_t>& materials = mix.value().materials;
  // Frames for `surface` read the same vertices and report their own errors.
  if (use.mapping != Mapping::surface)
    if (Result<void> sound = checkMeshes(scene, materials, outcome.notes); !sound)
      return sound.error();
  Result<AddedFrames> frames =
      addFrames(scene, materials, noise, use.mapping, arguments.grain, arguments.shared);
  if (!frames)
    return frames.error();
  outcome.frames = std::move(frames.value().meshes);
  Result<AppliedNoise> applied = scene.applyNoise(bundle, index, use, materials);
  if (!applied)
    return applied.error();
  outcome.noise = std::move(applied).value();
  if (arguments.setsFactors)
    setFactorsToOne(scene, materials, noise);
  removeCompetingExtensions(scene, materials, noise, outcome.notes);
  leaveReplacedImages(scene, materials, noise, use.mix, outcome.notes);
  outcome.tiles = measuredTiles(scene, materials, noise, use, outcome.notes);
  if (Result<void> written = scene.write(arguments.output); !written)
    return written.error();
  noteName(arguments.scene, noise.name, outcome.noise, outcome.notes);
  for (const std::size_t material : materials)
    outcome.materials.push_back(scene.materialTitle(material));
  for (std::string& text : notesOnLook(arguments, scene, materials, noise))
    outcome.notes.push_back(std::move(text));
  outcome.notes.insert(outcome.notes.end(), frames.value().notes.begin(),
                       frames.value().notes.end());
  return outcome;
}

Result<int> run(const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  if (Result<void> checked = checkOutput(arguments.output, {".glb", ".gltf"}); !checked)
    return checked.error();
  if (Result<void> checked = checkMappingOptions(arguments); !checked)
    return checked.error();
  const Result<Outcome> outcome = apply(arguments);
  if (!outcome)
    return outcome.error();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  report(arguments, outcome.value(), seconds.count());
  return kDone;
}

} // namespace

Runner addApply(CLI::App& verb, const SharedOptions& shared) {
  auto arguments = std::make_shared<Arguments>(shared);
  addText(verb, "SCENE", arguments->scene, "", "Any .glb or .gltf").required();
  addText(verb, "--noise", arguments->noise, "BUNDLE[:NAME]",
          "A bundle, and after a colon the name of one of its noises [default: the first]")
      .required();
  addTexts(verb, "--material", arguments->materials, "NAME|INDEX|all",
           "Name or index of a material that gets the noise; repeat it for more; or all")
      .required();
  const Choices<Mapping> mappings{{"uv", Mapping::uv},
                                  {"triplanar", Mapping::triplanar},
                                  {"surface", Mapping::surface},
                                  {"solid", Mapping::solid}};
  addValue(verb, "--mapping", arguments->mapping, oneOf(mappings), "uv",
           "Where the noise lies: in texture coordinates, on three planes, on the surface itself, "
           "or in space, as a block that the surface cuts");
  const Choices<NoiseSpace> spaces{{"world", NoiseSpace::world}, {"object", NoiseSpace::object}};
  addValue(verb, "--space", arguments->space, optional(oneOf(spaces)), "",
           "triplanar, surface, solid: one pattern continues from mesh to mesh (world), or it "
           "moves with "
           "each object (object) [default: the bundle's]");
  addValue(
      verb, "--scale", arguments->scale, optional(number(kScaleRange)), "",
      "Size of one exemplar. uv: in texture-coordinate units; else: in multiples of its own width "
      "[default: the bundle's]");
  addValue(verb, "--rotation", arguments->rotationDegrees,
           optional(number(kDegreesRange, "degrees")), "",
           "Rotation in degrees, in the sense of KHR_texture_transform [default: the bundle's]");
  addValue(verb, "--seed", arguments->seed, optional(seedNumber()), "",
           "Seed of the pattern [default: the bundle's]");
  addValue(verb, "--contrast", arguments->contrast, optional(number(kContrastRange)), "",
           "Factor of the variation [default: the bundle's]");
  addValue(verb, "--plane-sharpness", arguments->planeSharpness,
           optional(number(kPlaneSharpnessRange)), "",
           "triplanar: exponent of the plane weights [default: the bundle's]");
  addFrameOptions(verb, arguments->grain);
  addValue(verb, "--factors", arguments->setsFactors, oneOf<bool>({{"keep", false}, {"one", true}}),
           "keep",
           "Factors that multiply the noise, such as baseColorFactor: keep them or set them to 1");
  addText(verb, "-o,--output", arguments->output, "OUT.glb|OUT.gltf", "The scene with the noise")
      .required();
  addMixOptions(verb, arguments->mix);
  for (const Method method : allMethods())
    arguments->methods.push_back(commandOf(method).addApplyOptions(verb));
  arguments->verb = &verb;
  verb.footer(kDroppedByOthers);
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
