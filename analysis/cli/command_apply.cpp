// SPDX-License-Identifier: MIT
// lichen apply: adds a noise to materials of an existing scene.
#include "bake_risks.h"
#include "command.h"
#include "methods/method_command.h"
#include "noise_choice.h"
#include "options.h"
#include "steps_shown.h"

#include <lichen/apply_noise.h>
#include <lichen/counted.h>
#include <lichen/layered_noise.h>
#include <lichen/shader_parameters.h>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
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
  Mapping mapping{};
  std::optional<NoiseSpace> space;
  std::optional<double> scale;
  std::optional<double> rotationDegrees;
  std::optional<std::uint32_t> seed;
  std::optional<double> contrast;
  std::optional<double> planeSharpness;
  std::vector<UseOptions> methods; ///< in the order of Method
  const CLI::App* verb = nullptr;
  ApplyOptions apply; ///< without how the materials use the noise
  std::string output;
};

/// Returns the parameters of the bundle's first material that uses the noise, since the user has
/// seen the noise with them; the options override them.
MaterialNoise parametersOf(const Bundle& bundle, std::size_t noise, const Arguments& arguments) {
  MaterialNoise use = materialOf(bundle, noise);
  use.mapping = arguments.mapping;
  use.space = arguments.space.value_or(isInSpace(use.mapping) ? use.space : NoiseSpace::world);
  use.texCoord = 0;
  use.scale = arguments.scale.value_or(use.scale);
  if (arguments.rotationDegrees)
    use.rotation = *arguments.rotationDegrees * kRadiansPerDegree;
  use.seed = arguments.seed.value_or(use.seed);
  use.contrast = arguments.contrast.value_or(use.contrast);
  use.planeSharpness = arguments.planeSharpness.value_or(use.planeSharpness);
  arguments.methods[std::size_t(bundle.noises[noise].method())](use);
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

nlohmann::ordered_json asJson(std::span<const MeshFrames> frames) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const MeshFrames& mesh : frames) {
    Json singularities = Json::array();
    for (const FrameSingularity& singularity : mesh.singularities)
      singularities.push_back({{"position", singularity.position}, {"index", singularity.index}});
    Json components = Json::array();
    for (const FieldComponent& component : mesh.components)
      components.push_back({{"triangles", component.triangles},
                            {"closed", component.isClosed},
                            {"eulerCharacteristic", component.eulerCharacteristic},
                            {"singularities", component.singularities}});
    list.push_back({{"mesh", mesh.mesh},
                    {"triangles", mesh.triangles},
                    {"newNormals", mesh.hasNewNormals},
                    {"components", components},
                    {"singularities", singularities}});
  }
  return list;
}

void report(const Arguments& arguments, const NoiseOnScene& outcome, double seconds) {
  if (arguments.shared.json) {
    const nlohmann::ordered_json json{{"output", arguments.output},
                                      {"noise", outcome.noise.name},
                                      {"newTables", outcome.noise.newTables},
                                      {"materials", outcome.materials},
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
}

/// Returns the noise that the user named, after checking that its method supports the options.
Result<ChosenNoise> chooseNoise(const Arguments& arguments) {
  Result<ChosenNoise> chosen = chosenNoise(arguments.noise);
  if (!chosen)
    return chosen;
  const Noise& noise = chosen.value().noise();
  if (Result<void> fits = checkMapping(noise, arguments.mapping); !fits)
    return fits.error();
  if (Result<void> fits = checkMethodOptions(arguments, noise); !fits)
    return fits.error();
  return chosen;
}

/// Reads the noise and the scene, and writes the scene with it.
Result<NoiseOnScene> apply(Arguments& arguments) {
  const Result<ChosenNoise> chosen = chooseNoise(arguments);
  if (!chosen)
    return chosen.error();
  const auto& [file, bundle, index] = chosen.value();
  Result<GltfScene> scene = GltfScene::open(arguments.scene);
  if (!scene)
    return scene.error();
  arguments.apply.use = parametersOf(bundle, index, arguments);
  StepsShown steps(arguments.shared);
  Result<NoiseOnScene> applied =
      applyNoise(scene.value(), bundle, index, arguments.apply, steps.observer());
  if (!applied)
    return applied;
  if (Result<void> written = scene.value().write(arguments.output); !written)
    return written.error();
  return applied;
}

Result<int> run(Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  if (Result<void> checked = checkOutput(arguments.output, {".glb", ".gltf"}); !checked)
    return checked.error();
  if (Result<void> checked = checkMappingOptions(arguments); !checked)
    return checked.error();
  const Result<NoiseOnScene> outcome = apply(arguments);
  if (!outcome)
    return outcome.error();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  report(arguments, outcome.value(), seconds.count());
  return kDone;
}

/// X,Y,Z, not the zero vector.
Accepted<Vector3> axis() {
  constexpr double kMost = 1e6; // only the ratios of the components matter
  return {"X,Y,Z", fmt::format("X,Y,Z with numbers from {} to {}, not all 0", -kMost, kMost),
          [](const std::string& text) -> std::optional<Vector3> {
            const auto values = numbersFrom<3>(text, {-kMost, kMost});
            if (!values)
              return std::nullopt;
            const Vector3 axis{float((*values)[0]), float((*values)[1]), float((*values)[2])};
            return axis == Vector3{} ? std::nullopt : std::optional(axis);
          }};
}

Accepted<std::array<double, 4>> twoPlaces() {
  return {"U0,V0,U1,V1",
          fmt::format("U0,V0,U1,V1 with numbers from {} to {}, two places {:f} or more apart",
                      kMixPlaceRange.least, kMixPlaceRange.most, kLeastMixLength),
          [](const std::string& text) -> std::optional<std::array<double, 4>> {
            const auto places = numbersFrom<4>(text, kMixPlaceRange);
            const bool areApart =
                places && std::hypot((*places)[2] - (*places)[0], (*places)[3] - (*places)[1]) >=
                              kLeastMixLength;
            return areApart ? places : std::nullopt;
          }};
}

constexpr int kMostColorSet = 15;

void addMixOptions(CLI::App& verb, MixOptions& options) {
  constexpr const char* kGroup = "Mix";
  addValue(verb, "--mix", options.weight, optional(number(kMixWeightRange)), "",
           "Weight of a mix everywhere: 0 the first input, 1 the last [default: the bundle's]")
      .group(kGroup);
  addValue(verb, "--mix-direction", options.direction, optional(twoPlaces()), "",
           "Texture coordinates at which the weight is 0, and at which it is 1")
      .group(kGroup);
  addText(verb, "--mix-texture", options.texture, "IMAGE|INDEX",
          "Mask of the weight: a PNG or JPEG, or the index of a texture of the scene")
      .group(kGroup);
  addValue(verb, "--mix-vertex-color", options.colorSet, optional(wholeNumber(0, kMostColorSet)),
           "", "N of the vertex colours COLOR_N, which hold the weight")
      .group(kGroup);
  const Choices<int> channels{{"red", 0}, {"green", 1}, {"blue", 2}, {"alpha", 3}};
  addValue(verb, "--mix-channel", options.channel, optional(oneOf(channels)), "",
           "Channel of the mask or the colours [default: red]")
      .group(kGroup);
}

} // namespace

Runner addApply(CLI::App& verb, const SharedOptions& shared) {
  auto arguments = std::make_shared<Arguments>(shared);
  addText(verb, "SCENE", arguments->scene, "", "Any .glb or .gltf").required();
  addText(verb, "--noise", arguments->noise, "BUNDLE[:NAME]",
          "A bundle, and after a colon the name of one of its noises [default: the first]")
      .required();
  addTexts(verb, "--material", arguments->apply.materials, "NAME|INDEX|all",
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
  addValue(
      verb, "--grain", arguments->apply.grain, optional(axis()), "",
      "surface: an axis in the space of each mesh that the exemplar's rows follow [default: the "
      "smoothest directions]");
  addValue(verb, "--factors", arguments->apply.setsFactors,
           oneOf<bool>({{"keep", false}, {"one", true}}), "keep",
           "Factors that multiply the noise, such as baseColorFactor: keep them or set them to 1");
  addText(verb, "-o,--output", arguments->output, "OUT.glb|OUT.gltf", "The scene with the noise")
      .required();
  addMixOptions(verb, arguments->apply.mix);
  for (const Method method : allMethods())
    arguments->methods.push_back(commandOf(method).addUseOptions(verb));
  arguments->verb = &verb;
  verb.footer(kDroppedByOthers);
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
