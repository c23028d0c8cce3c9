// SPDX-License-Identifier: MIT
// lichen bake: a photograph to a glTF with the noise and a scene to look at it.
#include "command.h"
#include "exemplar.h"

#include <lichen/bundle_writer.h>
#include <lichen/synthesize.h>
#include <lichen/tiling.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>

namespace lichen::cli {
namespace {

/// Exemplars along a side of the preview image: enough that its repetition is not the exemplar's.
constexpr int kTilesPerPreview = 2;

/// What README.md recommends at most.
constexpr int kPlentyOfPixels = 1024;

struct Arguments {
  SharedOptions shared;
  std::string input;
  std::string output;
  std::string method = "tiling";
  std::string name;
  std::uint32_t seed = 1;
  double tileMetres = 1.0;
  TilingOptions tiling;
  PreviewShape preview = PreviewShape::sphere;
};

Result<void> checkInput(const std::filesystem::path& input) {
  std::error_code ignored;
  if (std::filesystem::is_directory(input, ignored))
    return Error{ErrorKind::badInput,
                 fmt::format("{}: a folder; one image file is accepted, such as its base colour",
                             input.string())};
  return {};
}

Result<BundleFile> makeBundleFile(const Arguments& arguments, TilingBake bake) {
  BundleFile file;
  file.shape = arguments.preview;
  file.generator = fmt::format("lichen {}", kVersion);
  bake.noise.tileSizeMetres = arguments.tileMetres;
  MaterialNoise material;
  material.seed = arguments.seed;
  file.bundle.tables = std::move(bake.tables);
  file.bundle.materialNames = {bake.noise.name};
  file.bundle.noises = {std::move(bake.noise)};
  file.bundle.materials = {material};

  const Result<LinearImage> preview =
      synthesizePreview(file.bundle, 0, MapTarget::baseColor, arguments.seed, kTilesPerPreview);
  if (!preview)
    return preview.error();
  Result<std::vector<std::byte>> png = encodePng(toSrgb(preview.value()), 8);
  if (!png)
    return png.error();
  PreviewImages images;
  images.baseColor = std::move(png).value();
  images.tilesPerImage = kTilesPerPreview;
  file.previews.push_back(std::move(images));
  return file;
}

void report(const Arguments& arguments, const BundleFile& file, bool periodic,
            const std::vector<std::string>& notes, double seconds) {
  const Noise& noise = file.bundle.noises.front();
  const Table& gaussian = file.bundle.tables[noise.maps.front().gaussian];
  std::size_t tableBytes = 0;
  for (const Table& table : file.bundle.tables)
    tableBytes += table.texels.size();
  if (arguments.shared.json) {
    const nlohmann::ordered_json json{{"output", arguments.output},
                                      {"name", noise.name},
                                      {"method", noise.method},
                                      {"width", gaussian.width},
                                      {"height", gaussian.height},
                                      {"dimensions", std::min(3, channelCount(gaussian.format))},
                                      {"periodic", periodic},
                                      {"tableBytes", tableBytes},
                                      {"notes", notes},
                                      {"seconds", seconds}};
    fmt::print("{}\n", toText(json));
    return;
  }
  for (const std::string& line : notes)
    note(arguments.shared, line);
  say(arguments.shared, fmt::format("{}: {} x {}, {} KiB of tables, {:.2f} s", arguments.output,
                                    gaussian.width, gaussian.height, tableBytes / 1024, seconds));
}

Result<int> run(const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  if (Result<void> checked = checkOutput(arguments.output, {".glb", ".gltf"}); !checked)
    return checked.error();
  if (Result<void> checked = checkInput(arguments.input); !checked)
    return checked.error();
  const Result<ImageFile> image = readImage(arguments.input);
  if (!image)
    return image.error();
  std::vector<std::string> notes;
  const MapExemplar exemplar = baseColorExemplar(image.value(), notes);
  // Before the work, which takes minutes: the user may rather shrink the photograph.
  if (std::max(exemplar.width, exemplar.height) > kPlentyOfPixels)
    note(
        arguments.shared,
        fmt::format("{} x {} pixels take long to bake and much memory to use; 256 to {} a side are "
                    "plenty",
                    exemplar.width, exemplar.height, kPlentyOfPixels));
  const std::string name = arguments.name.empty()
                               ? std::filesystem::path(arguments.input).stem().string()
                               : arguments.name;
  Result<TilingBake> bake = bakeTiling(name, {&exemplar, 1}, arguments.tiling);
  if (!bake)
    return bake.error();
  const bool periodic = bake.value().exemplarWasPeriodic;
  if (!periodic)
    notes.push_back("the exemplar's borders do not fit together; they were blended");
  const Result<BundleFile> file = makeBundleFile(arguments, std::move(bake).value());
  if (!file)
    return file.error();
  if (Result<void> written = writeBundle(arguments.output, file.value()); !written)
    return written.error();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  report(arguments, file.value(), periodic, notes, seconds.count());
  return kDone;
}

} // namespace

Runner addBake(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* verb = app.add_subcommand("bake", "Turn a photograph of a material into noise");
  verb->add_option("INPUT", arguments->input, "An image: PNG, JPEG or EXR")->required();
  verb->add_option("-o,--output", arguments->output, "OUT.glb or OUT.gltf")->required();
  verb->add_option("--method", arguments->method, "The noise method")
      ->check(CLI::IsMember({"tiling"}))
      ->capture_default_str();
  verb->add_option("--name", arguments->name, "Name of noise and material; the file's by default");
  verb->add_option("--seed", arguments->seed, "Seed of the material's pattern")
      ->capture_default_str();
  verb->add_option("--tile", arguments->tileMetres, "Width of the exemplar in metres")
      ->check(numberIn(1e-6, 1e6))
      ->capture_default_str();
  const std::map<std::string, Periodic> periodic{
      {"auto", Periodic::detect}, {"yes", Periodic::yes}, {"no", Periodic::no}};
  verb->add_option("--periodic", arguments->tiling.periodic,
                   "Whether the exemplar's borders fit together: auto, yes or no")
      ->transform(CLI::CheckedTransformer(periodic));
  const std::map<std::string, TransportEffort> efforts{{"fast", TransportEffort::fast},
                                                       {"default", TransportEffort::standard},
                                                       {"exact", TransportEffort::exact}};
  verb->add_option("--transport", arguments->tiling.transport,
                   "How near to optimal colours are matched: fast, default or exact")
      ->transform(CLI::CheckedTransformer(efforts));
  verb->add_option("--precision", arguments->tiling.bits, "Bits per channel of the tables")
      ->check(CLI::IsMember({8, 16}))
      ->capture_default_str();
  const std::map<std::string, PreviewShape> shapes{{"sphere", PreviewShape::sphere},
                                                   {"plane", PreviewShape::plane},
                                                   {"none", PreviewShape::none}};
  verb->add_option("--preview", arguments->preview, "The scene: sphere, plane or none")
      ->transform(CLI::CheckedTransformer(shapes));
  addSharedOptions(*verb, arguments->shared);
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
