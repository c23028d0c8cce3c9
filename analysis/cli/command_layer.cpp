// SPDX-License-Identifier: MIT
// lichen layer: noises of several bundles -> one noise in which index maps choose between them.
#include "command.h"
#include "methods/spectrum_option.h"
#include "noise_choice.h"
#include "options.h"

#include <lichen/bake_material.h>
#include <lichen/bundle_files.h>
#include <lichen/bundle_merge.h>
#include <lichen/index_map.h>
#include <lichen/layered_noise.h>
#include <lichen/layers.h>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <memory>

namespace lichen::cli {
namespace {

constexpr int kMostPatchCycles = 64; // per tile, of rings and the like in --index
constexpr NumberRange kShareRange{0.01, 1e6};

struct Arguments {
  explicit Arguments(const SharedOptions& options) : shared(options) {}

  const SharedOptions& shared;
  std::vector<std::string> inputs;
  std::string output;
  std::string name;
  std::vector<double> shares;
  std::string index;
  double softness = 0.0;
  PreviewShape preview{};
};

Result<ChosenNoise> readInput(const std::string& text) {
  Result<ChosenNoise> input = chosenNoise(text);
  if (input && input.value().noise().layers)
    return Error{ErrorKind::usage,
                 fmt::format("{}: noise '{}' is layered itself; expected one that is not",
                             input.value().file, input.value().noise().name)};
  return input;
}

Result<void> check(const Arguments& arguments) {
  if (Result<void> checked = checkOutput(arguments.output, {".glb", ".gltf"}); !checked)
    return checked;
  const std::size_t count = arguments.inputs.size();
  if (count < 2 || count > LICHEN_MAX_LAYERS)
    return Error{ErrorKind::usage,
                 fmt::format("BUNDLE: {} given; expected 2 to {}", count, LICHEN_MAX_LAYERS)};
  if (!arguments.shares.empty() && arguments.shares.size() != count)
    return Error{ErrorKind::usage, fmt::format("--shares: {} for {} bundles; expected one each",
                                               arguments.shares.size(), count)};
  return {};
}

/// The index map: a noise of a bundle, or one that has a spectrum.
Result<ChosenNoise> readIndex(const Arguments& arguments, std::span<const BundledNoise> layers) {
  const auto isBundle = [&](const char* extension) {
    const std::string& text = arguments.index;
    return text.ends_with(extension) || text.find(extension + std::string(":")) != text.npos;
  };
  if (isBundle(".glb") || isBundle(".gltf") || isBundle(".lichen"))
    return readInput(arguments.index);
  const auto choice = spectrumChoice().read(arguments.index);
  if (!choice || !*choice)
    return Error{ErrorKind::usage, fmt::format("--index {}: expected {}, or a bundle",
                                               arguments.index, spectrumChoice().sentence)};
  Result<SpectrumPicture> spectrum = spectrumPicture(**choice, kMostPatchCycles);
  if (!spectrum)
    return spectrum.error();
  const Bundle& first = *layers.front().bundle;
  const Noise& noise = first.noises[layers.front().noise];
  const auto [width, height] = exemplarSize(first, noise, noise.maps.front());
  const bool hasSolids = std::ranges::all_of(layers, [](const BundledNoise& layer) {
    return mappingObstacle(*layer.bundle, layer.noise, Mapping::solid).empty();
  });
  Result<Bundle> baked = bakeIndexMap(spectrum.value(), double(width) / height, hasSolids);
  if (!baked)
    return baked.error();
  baked.value().noises[0].tileSizeMetres = noise.tileSizeMetres;
  return ChosenNoise{"--index", std::move(baked).value(), 0};
}

Result<Bundle> layered(const Arguments& arguments) {
  std::vector<ChosenNoise> inputs;
  std::vector<std::string> names;
  for (const std::string& text : arguments.inputs) {
    Result<ChosenNoise> input = readInput(text);
    if (!input)
      return input.error();
    names.push_back(input.value().noise().name);
    inputs.push_back(std::move(input).value());
    const ChosenNoise& first = inputs.front();
    const ChosenNoise& last = inputs.back();
    if (const std::string fault =
            layerFault(first.bundle, first.noise(), last.bundle, last.noise());
        !fault.empty())
      return Error{ErrorKind::usage, last.file + ": " + fault};
  }
  std::vector<BundledNoise> layers;
  for (const ChosenNoise& input : inputs)
    layers.push_back({&input.bundle, input.index});
  const Result<ChosenNoise> index = readIndex(arguments, layers);
  if (!index)
    return index.error();
  const std::vector<BundledNoise> indices(layers.size() - 1,
                                          {&index.value().bundle, index.value().index});
  const std::string name =
      arguments.name.empty() ? fmt::format("{}", fmt::join(names, "-")) : arguments.name;
  const std::vector<double> equal(layers.size(), 1.0 / double(layers.size()));
  const Result<std::vector<LayerNode>> nodes =
      layerChain(arguments.shares.empty() ? equal : arguments.shares, arguments.softness);
  if (!nodes)
    return Error{nodes.error().kind, "--shares: " + nodes.error().message};
  Result<Bundle> bundle = layerNoises(name, layers, indices, nodes.value());
  if (!bundle)
    return bundle;
  // The look is the first noise's, also where its material has a mapping that others do not have.
  MaterialNoise& material = *bundle.value().materials.front();
  material.texCoord = 0;
  if (!mappingObstacle(bundle.value(), 0, material.mapping).empty())
    material.mapping = Mapping::uv;
  return bundle;
}

Result<int> run(const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  if (Result<void> checked = check(arguments); !checked)
    return checked.error();
  Result<Bundle> bundle = layered(arguments);
  if (!bundle)
    return bundle.error();
  const Result<BundleFile> file =
      withPreviews(std::move(bundle).value(), arguments.preview, "lichen " LICHEN_VERSION);
  if (!file)
    return file.error();
  if (Result<void> written = writeBundle(arguments.output, file.value()); !written)
    return written.error();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  const std::string& name = file.value().bundle.noises.front().name;
  if (arguments.shared.json) {
    printLine(toText(nlohmann::ordered_json{{"output", arguments.output},
                                            {"name", name},
                                            {"layers", arguments.inputs.size()},
                                            {"tableBytes", texelBytes(file.value().bundle)},
                                            {"seconds", seconds.count()}}));
    return kDone;
  }
  say(arguments.shared, fmt::format("{}: {}, {} layers, {:.2f} s", arguments.output, name,
                                    arguments.inputs.size(), seconds.count()));
  return kDone;
}

} // namespace

Runner addLayer(CLI::App& verb, const SharedOptions& shared) {
  auto arguments = std::make_shared<Arguments>(shared);
  addTexts(verb, "BUNDLE", arguments->inputs, "...",
           "2 to 4 bundles; append :NAME to choose another noise than the first. All have the same "
           "maps, and tiles of one size and shape")
      .required();
  addText(verb, "-o,--output", arguments->output, "OUT.glb|OUT.gltf", "The bundle").required();
  addValue(verb, "--name", arguments->name, nameText(), "",
           "Name of the noise and its material [default: the layers' names]");
  addValue(verb, "--shares", arguments->shares, numbers(kShareRange, LICHEN_MAX_LAYERS), "",
           "Areas of the layers, relative to each other [default: all the same]");
  addText(verb, "--index", arguments->index, "SPECTRUM|BUNDLE",
          "Where the layers lie: a spectrum, as 'lichen bake' takes, with the frequencies of the "
          "patches, or a noise [default: lobe:0:0:3]");
  addValue(verb, "--softness", arguments->softness, number(kSoftnessRange), "0.1",
           "Width of the transitions, in deviations of the index map");
  addPreviewShape(verb, arguments->preview);
  verb.footer(kDroppedByOthers);
  arguments->index = "lobe:0:0:3";
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
