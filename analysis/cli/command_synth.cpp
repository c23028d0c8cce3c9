// SPDX-License-Identifier: MIT
// lichen synth: bundle -> image of a noise, or all textures of a material.
#include "command.h"
#include "methods/method_command.h"
#include "noise_choice.h"
#include "options.h"
#include "progress_line.h"

#include <lichen/apply_noise.h>
#include <lichen/bundle_files.h>
#include <lichen/files.h>
#include <lichen/image_io.h>
#include <lichen/shader_parameters.h>
#include <lichen/texture_files.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <system_error>

namespace lichen::cli {
namespace {

struct Arguments {
  explicit Arguments(const SharedOptions& options) : shared(options) {}

  const SharedOptions& shared;
  std::string bundle;
  std::string output;
  std::string noise;
  std::string map;
  std::array<int, 2> size{};
  // These override the material's values.
  std::optional<std::uint32_t> seed;
  std::optional<double> contrast;
  std::optional<std::array<double, 2>> mix;
  std::vector<UseOptions> methods; ///< in the order of Method
  SynthesisOptions synthesis;
  bool allMaps = false;
  // For --all-maps; absent where not given.
  std::optional<Importer> importer;
  std::optional<GreenAxis> green;
  std::optional<TextureFormat> format;
  const CLI::App* verb = nullptr;
};

/// "0.3", or "0,1" for weights from left to right.
Accepted<std::array<double, 2>> mixWeights() {
  return {"W|W0,W1", "a weight from 0 to 1, or two with a comma between them",
          [](const std::string& text) -> std::optional<std::array<double, 2>> {
            const auto weights = numbersFrom(text, kMixWeightRange, 1, 2);
            if (!weights)
              return std::nullopt;
            return std::array{weights->front(), weights->back()};
          }};
}

/// Finds the noise and the map that the user named, and the pattern parameters.
Result<void> resolve(const Bundle& bundle, Arguments& arguments) {
  const Result<std::size_t> noise = findNoise(bundle, arguments.bundle, arguments.noise);
  if (!noise)
    return noise.error();
  const Noise& chosen = bundle.noises[noise.value()];
  std::vector<std::string> maps;
  for (const NoiseMap& map : chosen.maps)
    maps.emplace_back(nameOf(map.target));
  const Result<std::size_t> map =
      indexOf(arguments.map, maps, "--map ", "map", fmt::format("noise '{}'", chosen.name));
  if (!map)
    return map.error();
  if (const auto foreign = foreignOption(*arguments.verb, chosen.method()))
    return Error{ErrorKind::usage,
                 fmt::format("{}: belongs to the method {}; noise '{}' of {} is of the method {}; "
                             "bake it with --method {}",
                             foreign->name, nameOf(foreign->method), chosen.name, arguments.bundle,
                             nameOf(chosen.method()), nameOf(foreign->method))};
  SynthesisOptions& synthesis = arguments.synthesis;
  synthesis.map = chosen.maps[map.value()].target;
  synthesis.material = materialOf(bundle, noise.value());
  if (arguments.allMaps && synthesis.texelsPerTile == 0.0) // alike for all maps
    synthesis.texelsPerTile = double(shaderNoise(bundle, noise.value()).tileTexelsX);
  MaterialNoise& material = synthesis.material;
  material.seed = arguments.seed.value_or(material.seed);
  material.contrast = arguments.contrast.value_or(material.contrast);
  arguments.methods[std::size_t(chosen.method())](material);
  if (arguments.mix && !isMix(chosen))
    return notMixed("--mix", chosen);
  constexpr std::array<double, 2> kFullPath{0.0, 1.0}, kMiddle{0.5, 0.5};
  synthesis.mix = arguments.mix.value_or(synthesis.tileable ? kMiddle : kFullPath);
  return {};
}

/// Writes the map as a core texture stores it.
Result<void> writeMap(const Arguments& arguments, const Bundle& bundle, LinearImage values) {
  const std::filesystem::path output = arguments.output;
  const Noise& noise = bundle.noises[arguments.synthesis.material.noise];
  const MapTarget target = arguments.synthesis.map;
  LinearImage texture =
      coreTexture(noise.maps[*findMap(noise, target)], std::move(values)); // the synthesized map
  if (output.extension() == ".exr")
    return writeImage(output, texture);
  const Result<std::vector<std::byte>> png = encodeCoreTexture(target, std::move(texture));
  return png ? replaceFile(output, png.value()) : Result<void>(png.error());
}

/// A note if the picture repeats, and rows of the noise break where it does.
std::vector<std::string> notesOf(const Bundle& bundle, const SynthesisOptions& synthesis) {
  const Noise& noise = bundle.noises[synthesis.material.noise];
  if (!synthesis.tileable || !commandOf(noise.method()).hasRows(noise))
    return {};
  const auto [across, down] =
      pixelsPerTile(bundle, synthesis.material.noise, noise.maps[*findMap(noise, synthesis.map)],
                    synthesis.texelsPerTile);
  const auto whole = [](int pixels, double perTile) { // the nearest whole number of exemplars
    return std::lround(std::max(1.0, std::round(pixels / perTile)) * perTile);
  };
  const long width = whole(synthesis.width, across), height = whole(synthesis.height, down);
  if (width == synthesis.width && height == synthesis.height)
    return {};
  return {fmt::format("{:.4g} x {:.4g} exemplars break the rows of what repeats; whole numbers of "
                      "them keep the rows: --size {}x{}",
                      synthesis.width / across, synthesis.height / down, width, height)};
}

/// Writes the textures of all maps into the folder. Returns the names of the files.
Result<std::vector<std::string>> writeAllMaps(const Arguments& arguments, const Bundle& bundle) {
  const std::filesystem::path folder = arguments.output;
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  if (code)
    return Error{ErrorKind::environment, fmt::format("{}: could not create the folder: {}",
                                                     arguments.output, code.message())};
  const TextureStyle style{arguments.importer.value_or(Importer::blender), arguments.green,
                           arguments.format.value_or(TextureFormat::png)};
  std::vector<std::string> names;
  const auto write = [&](const TextureFile& file) {
    names.push_back(file.name);
    return replaceFile(folder / file.name, file.bytes);
  };
  if (Result<void> made = makeTextures(bundle, arguments.synthesis, style, write); !made)
    return made.error();
  return names;
}

/// Checks the options of one map and of all maps against each other, and the output.
Result<void> checkOptions(const Arguments& arguments) {
  if (!arguments.allMaps) {
    const bool isOfAll = arguments.importer || arguments.green || arguments.format;
    if (isOfAll)
      return Error{ErrorKind::usage, "--for, --green and --format: need --all-maps"};
    return checkOutput(arguments.output, {".png", ".exr"});
  }
  const std::filesystem::path extension = std::filesystem::path(arguments.output).extension();
  if (extension == ".png" || extension == ".exr")
    return Error{ErrorKind::usage,
                 fmt::format("{}: --all-maps writes a folder; give its name, without {}",
                             arguments.output, extension.string())};
  if (!arguments.map.empty())
    return Error{ErrorKind::usage, "--map: --all-maps writes every map; leave out one of the two"};
  return {};
}

Result<std::vector<std::string>> write(const Arguments& arguments, const Bundle& bundle) {
  if (arguments.allMaps)
    return writeAllMaps(arguments, bundle);
  Result<LinearImage> image = synthesize(bundle, arguments.synthesis);
  if (!image)
    return image.error();
  if (Result<void> written = writeMap(arguments, bundle, std::move(image).value()); !written)
    return written.error();
  return std::vector<std::string>{};
}

Result<int> run(Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  if (Result<void> checked = checkOptions(arguments); !checked)
    return checked.error();
  const Result<Bundle> bundle = readBundle(arguments.bundle);
  if (!bundle)
    return bundle.error();
  arguments.synthesis.width = arguments.size[0];
  arguments.synthesis.height = arguments.size[1];
  if (Result<void> resolved = resolve(bundle.value(), arguments); !resolved)
    return resolved.error();
  ProgressLine progress("synth", arguments.shared);
  arguments.synthesis.progress = progress.asProgress();
  const Result<std::vector<std::string>> files = write(arguments, bundle.value());
  if (!files)
    return files.error();
  progress.erase();
  std::vector<std::string> notes = notesOf(bundle.value(), arguments.synthesis);
  if (arguments.allMaps && !arguments.synthesis.tileable)
    notes.emplace_back("the textures do not repeat at their borders; add --tileable");
  for (const std::string& line : notes)
    note(arguments.shared, line);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (arguments.shared.json) {
    nlohmann::ordered_json report{
        {"output", arguments.output},           {"width", arguments.synthesis.width},
        {"height", arguments.synthesis.height}, {"seed", arguments.synthesis.material.seed},
        {"seconds", seconds.count()},           {"notes", notes}};
    if (arguments.allMaps)
      report["files"] = files.value();
    printLine(toText(report));
  }
  for (const std::string& name : files.value())
    say(arguments.shared, (std::filesystem::path(arguments.output) / name).string());
  say(arguments.shared,
      fmt::format("{}: {} x {}, {:.2f} s", arguments.output, arguments.synthesis.width,
                  arguments.synthesis.height, seconds.count()));
  return kDone;
}

} // namespace

Runner addSynth(CLI::App& verb, const SharedOptions& shared) {
  auto arguments = std::make_shared<Arguments>(shared);
  SynthesisOptions& synthesis = arguments->synthesis;
  addText(verb, "BUNDLE", arguments->bundle, "", "A .glb, .gltf or .lichen with a noise")
      .required();
  addText(verb, "-o,--output", arguments->output, "OUT.png|OUT.exr|FOLDER",
          "The image; with --all-maps the folder, created if it does not exist")
      .required();
  addText(verb, "--noise", arguments->noise, "NAME", "Name of the noise [default: the first]");
  addText(
      verb, "--map", arguments->map, "MAP",
      "baseColor, normal, occlusionRoughnessMetallic, emissive, height or opacity [default: the "
      "first that the noise has]");
  addFlag(verb, "--all-maps", arguments->allMaps, "Write the textures of all maps of the noise");
  addValue(verb, "--for", arguments->importer,
           optional(oneOf<Importer>({{"blender", Importer::blender},
                                     {"godot", Importer::godot},
                                     {"unity", Importer::unity},
                                     {"unreal", Importer::unreal}})),
           "", "With --all-maps: the program whose names and packing to use [default: blender]");
  addValue(verb, "--green", arguments->green,
           optional(oneOf<GreenAxis>({{"up", GreenAxis::up}, {"down", GreenAxis::down}})), "",
           "With --all-maps: where green points in normal maps, up (OpenGL) or down (DirectX) "
           "[default: the program's]");
  addValue(
      verb, "--format", arguments->format,
      optional(oneOf<TextureFormat>({{"png", TextureFormat::png}, {"exr", TextureFormat::exr}})),
      "", "With --all-maps: png or exr [default: png]");
  addValue(verb, "--size", arguments->size, imageSize(kMaxImageSide), "1024x1024",
           "Image size in pixels");
  addValue(verb, "--texels-per-tile", synthesis.texelsPerTile, number(kTexelsPerTileRange), "",
           "Pixels across one tile [default: the exemplar's width]");
  addValue(verb, "--origin", synthesis.origin, coordinates(kOriginRange), "0,0",
           "Top left corner in tiles, exact up to 2^40");
  addValue(verb, "--seed", arguments->seed, optional(seedNumber()), "",
           "Seed of the pattern [default: the bundle's]");
  addFlag(verb, "--tileable", synthesis.tileable,
          "Make opposite borders of the image continue each other");
  addValue(verb, "--mix", arguments->mix, optional(mixWeights()), "",
           "Weight of a mix everywhere, or at the left and right borders, 0 to 1 [default: 0,1; "
           "tileable 0.5]");
  addValue(verb, "--contrast", arguments->contrast, optional(number(kContrastRange)), "",
           "Factor of the variation [default: the bundle's]");
  for (const Method method : allMethods())
    arguments->methods.push_back(commandOf(method).addUseOptions(verb));
  arguments->verb = &verb;
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
