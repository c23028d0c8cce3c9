// SPDX-License-Identifier: MIT
// lichen synth: an image of a noise, from the bundle alone.
#include "command.h"

#include <lichen/image_io.h>
#include <lichen/synthesize.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <map>
#include <memory>

namespace lichen::cli {
namespace {

struct Arguments {
  SharedOptions shared;
  std::string bundle;
  std::string output;
  std::string noise;
  std::string map = "baseColor";
  std::string size = "1024x1024";
  std::string origin = "0,0";
  SynthesisOptions synthesis;
};

Result<std::size_t> noiseIndex(const Bundle& bundle, const Arguments& arguments) {
  if (arguments.noise.empty())
    return std::size_t(0);
  std::string names;
  for (std::size_t n = 0; n < bundle.noises.size(); ++n) {
    if (bundle.noises[n].name == arguments.noise)
      return n;
    names += (names.empty() ? "" : ", ") + bundle.noises[n].name;
  }
  return Error{ErrorKind::usage,
               fmt::format("--noise {}: {} has {}", arguments.noise, arguments.bundle, names)};
}

Result<void> resolve(const Bundle& bundle, Arguments& arguments) {
  if (bundle.noises.empty())
    return Error{ErrorKind::badInput, arguments.bundle + ": has no noise"};
  const Result<std::size_t> index = noiseIndex(bundle, arguments);
  if (!index)
    return index.error();
  const std::optional<MapTarget> target = mapTargetFrom(arguments.map);
  if (!target)
    return Error{ErrorKind::usage,
                 fmt::format("--map {}: baseColor, normal, occlusionRoughnessMetallic, emissive, "
                             "height or opacity is accepted",
                             arguments.map)};
  const Result<std::array<int, 2>> size = parseSize(arguments.size);
  if (!size)
    return size.error();
  const Result<std::array<double, 2>> origin = parsePair("--origin", arguments.origin);
  if (!origin)
    return origin.error();
  arguments.synthesis.noise = index.value();
  arguments.synthesis.map = *target;
  arguments.synthesis.width = size.value()[0];
  arguments.synthesis.height = size.value()[1];
  arguments.synthesis.origin = origin.value();
  return {};
}

Result<int> run(Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  if (Result<void> checked = checkOutput(arguments.output, {".png", ".exr"}); !checked)
    return checked.error();
  const Result<Bundle> bundle = readBundle(arguments.bundle);
  if (!bundle)
    return bundle.error();
  if (Result<void> resolved = resolve(bundle.value(), arguments); !resolved)
    return resolved.error();
  const Result<LinearImage> image = synthesize(bundle.value(), arguments.synthesis);
  if (!image)
    return image.error();
  if (Result<void> written = writeImage(arguments.output, image.value()); !written)
    return written.error();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (arguments.shared.json) {
    const nlohmann::ordered_json report{{"output", arguments.output},
                                        {"width", arguments.synthesis.width},
                                        {"height", arguments.synthesis.height},
                                        {"seconds", seconds.count()}};
    fmt::print("{}\n", toText(report));
  }
  say(arguments.shared,
      fmt::format("{}: {} x {}, {:.2f} s", arguments.output, arguments.synthesis.width,
                  arguments.synthesis.height, seconds.count()));
  return kDone;
}

} // namespace

Runner addSynth(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* verb = app.add_subcommand("synth", "Make an image of a noise, without a GPU");
  verb->add_option("BUNDLE", arguments->bundle, "A .glb or .gltf made by 'lichen bake'")
      ->required();
  verb->add_option("-o,--output", arguments->output, "OUT.png or OUT.exr")->required();
  verb->add_option("--noise", arguments->noise, "Name of the noise; the first one by default");
  verb->add_option("--map", arguments->map, "Which map")->capture_default_str();
  verb->add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  verb->add_option("--texels-per-tile", arguments->synthesis.texelsPerTile,
                   "Pixels across one exemplar; its own texels by default")
      ->check(numberIn(0x1p-10, 0x1p24));
  verb->add_option("--origin", arguments->origin,
                   "X,Y of the top left corner in tiles; large integer parts are exact")
      ->capture_default_str();
  verb->add_option("--seed", arguments->synthesis.seed, "Another seed, another pattern")
      ->capture_default_str();
  verb->add_flag("--tileable", arguments->synthesis.tileable,
                 "Opposite borders of the image continue each other");
  verb->add_option("--sharpness", arguments->synthesis.blendSharpness,
                   "Exponent of the blend weights")
      ->check(numberIn(0.25, 16.0))
      ->capture_default_str();
  verb->add_option("--contrast", arguments->synthesis.contrast, "Scale of the variation")
      ->check(numberIn(0.0, 4.0))
      ->capture_default_str();
  const std::map<std::string, BlendOperator> operators{
      {"histogram", BlendOperator::histogramPreserving},
      {"variance", BlendOperator::variancePreserving},
      {"linear", BlendOperator::linear}};
  verb->add_option("--blend", arguments->synthesis.blend,
                   "histogram (the method), or variance or linear for comparison")
      ->transform(CLI::CheckedTransformer(operators));
  addSharedOptions(*verb, arguments->shared);
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
