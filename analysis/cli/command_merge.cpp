// SPDX-License-Identifier: MIT
// lichen merge: combines the noises of several bundles in one, with a preview scene.
#include "command.h"
#include "options.h"
#include "progress_line.h"

#include <lichen/bake_material.h>
#include <lichen/bundle_files.h>
#include <lichen/bundle_merge.h>
#include <lichen/counted.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <memory>

namespace lichen::cli {
namespace {

struct Arguments {
  explicit Arguments(const SharedOptions& options) : shared(options) {}

  const SharedOptions& shared;
  std::vector<std::string> inputs;
  std::string output;
  PreviewShape preview{};
};

Result<MergedBundle> readAndMerge(const std::vector<std::string>& paths) {
  std::vector<NamedBundle> inputs;
  for (const std::string& path : paths) {
    Result<Bundle> bundle = readBundle(path);
    if (!bundle)
      return bundle.error();
    inputs.push_back({path, std::move(bundle).value()});
  }
  return mergeBundles(inputs);
}

/// Checks that the preview's meshes have the texture coordinates that the materials use.
Result<void> checkTexCoords(const Bundle& bundle, PreviewShape shape) {
  for (std::size_t m = 0; m < bundle.materials.size() && shape != PreviewShape::none; ++m)
    if (const int texCoord = bundle.materials[m]->texCoord; texCoord != 0)
      return Error{
          ErrorKind::usage,
          fmt::format("material '{}' uses texture coordinates {}, and the preview scene has only "
                      "0; use --preview none",
                      bundle.materialNames[m], texCoord)};
  return {};
}

void report(const Arguments& arguments, const MergedBundle& merged, double seconds) {
  const Bundle& bundle = merged.bundle;
  std::vector<std::string> names;
  for (const Noise& noise : bundle.noises)
    names.push_back(noise.name);
  if (arguments.shared.json) {
    const nlohmann::ordered_json json{{"output", arguments.output},
                                      {"noises", names},
                                      {"tables", bundle.tables.size()},
                                      {"notes", merged.notes},
                                      {"seconds", seconds}};
    printLine(toText(json));
    return;
  }
  say(arguments.shared,
      fmt::format("{}: {}; {}, {:.2f} s", arguments.output, fmt::join(names, ", "),
                  counted(bundle.tables.size(), "table"), seconds));
}

Result<int> run(const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  if (Result<void> checked = checkOutput(arguments.output, {".glb", ".gltf"}); !checked)
    return checked.error();
  Result<MergedBundle> merged = readAndMerge(arguments.inputs);
  if (!merged)
    return merged.error();
  if (Result<void> checked = checkTexCoords(merged.value().bundle, arguments.preview); !checked)
    return checked.error();
  ProgressLine progress("merge", arguments.shared);
  const Result<BundleFile> file = withPreviews(merged.value().bundle, arguments.preview,
                                               "lichen " LICHEN_VERSION, progress.asProgress());
  if (!file)
    return file.error();
  if (Result<void> written = writeBundle(arguments.output, file.value()); !written)
    return written.error();
  progress.erase();
  for (const std::string& text : merged.value().notes)
    note(arguments.shared, text);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  report(arguments, merged.value(), seconds.count());
  return kDone;
}

} // namespace

Runner addMerge(CLI::App& verb, const SharedOptions& shared) {
  auto arguments = std::make_shared<Arguments>(shared);
  addTexts(verb, "BUNDLE", arguments->inputs, "...", "Bundles, .glb or .gltf").required();
  addText(verb, "-o,--output", arguments->output, "OUT.glb|OUT.gltf", "The bundle with all noises")
      .required();
  addPreviewShape(verb, arguments->preview);
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
