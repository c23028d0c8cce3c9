// SPDX-License-Identifier: MIT
// lichen bake: a photograph to a glTF with the noise and a scene to look at it.
#include "command.h"
#include "exemplar.h"
#include "options.h"
#include "progress_line.h"

#include <lichen/bundle_writer.h>
#include <lichen/precision_loss.h>
#include <lichen/synthesize.h>
#include <lichen/tiling.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <memory>

namespace lichen::cli {
namespace {

/// Exemplars along a side of the preview image: enough that its repetition is not the exemplar's.
constexpr int kTilesPerPreview = 2;

struct Arguments {
  explicit Arguments(const SharedOptions& options) : shared(options) {}

  const SharedOptions& shared;
  std::string input;
  std::string output;
  std::string method;
  std::string name;
  std::uint32_t seed = 0;
  double tileMetres = 0.0;
  TilingOptions tiling;
  PreviewShape preview{};
};

Result<MapExemplar> readExemplar(const std::string& input, std::vector<std::string>& notes) {
  std::error_code ignored;
  if (std::filesystem::is_directory(input, ignored))
    return Error{ErrorKind::badInput,
                 input +
                     ": a folder; one image file is accepted, such as the base colour of a set"};
  const Result<ImageFile> image = readImage(input);
  if (!image)
    return image.error();
  return baseColorExemplar(image.value(), notes);
}

/// Bytes that are not UTF-8, of which names in JSON consist, become underscores.
std::string asUtf8(const std::string& text) {
  constexpr std::string_view kReplacement = "\xEF\xBF\xBD"; // U+FFFD, as toText() puts it
  std::string valid = nlohmann::json::parse(toText(text));
  if (valid == text)
    return text;
  for (std::size_t at; (at = valid.find(kReplacement)) != std::string::npos;)
    valid.replace(at, kReplacement.size(), "_");
  return valid;
}

Accepted<std::string> nameText() {
  return {"NAME", "UTF-8 text", [](const std::string& text) {
            return asUtf8(text) == text ? std::optional(text) : std::nullopt;
          }};
}

Result<BundleFile> makeBundleFile(const Arguments& arguments, TilingBake bake) {
  BundleFile file;
  file.shape = arguments.preview;
  file.generator = "lichen " LICHEN_VERSION;
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

/// How the map's Gaussian values become colours.
const char* tableKind(const NoiseMap& map) {
  if (!map.inverseTable)
    return "none";
  return map.tableOffset.empty() ? "joint" : "separable";
}

nlohmann::ordered_json toJson(const PrecisionLoss& loss) {
  nlohmann::ordered_json json{
      {"mean", loss.mean}, {"variance", loss.variance}, {"colorDistance", loss.colorDistance}};
  if (loss.roundTrip)
    json["roundTrip"] = *loss.roundTrip;
  return json;
}

void report(const Arguments& arguments, const BundleFile& file, bool periodic,
            const PrecisionLoss& loss, const std::vector<std::string>& notes, double seconds) {
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
                                      {"table", tableKind(noise.maps.front())},
                                      {"tableBytes", tableBytes},
                                      {"precisionLoss", toJson(loss)},
                                      {"notes", notes},
                                      {"seconds", seconds}};
    printLine(toText(json));
    return;
  }
  say(arguments.shared, fmt::format("{}: {} x {}, {} KiB of tables, {:.2f} s", arguments.output,
                                    gaussian.width, gaussian.height, tableBytes / 1024, seconds));
}

Result<int> run(const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  if (Result<void> checked = checkOutput(arguments.output, {".glb", ".gltf"}); !checked)
    return checked.error();
  std::vector<std::string> notes;
  const auto printNotes = [&](std::size_t first) { // in JSON they are part of the report
    for (std::size_t n = first; n < notes.size() && !arguments.shared.json; ++n)
      note(arguments.shared, notes[n]);
  };
  const Result<MapExemplar> exemplar = readExemplar(arguments.input, notes);
  if (!exemplar)
    return exemplar.error();
  printNotes(0); // before the work: the user may rather have another photograph
  const std::size_t printed = notes.size();

  ProgressLine progress("bake", arguments.shared);
  TilingOptions options = arguments.tiling;
  options.progress = [&](double fraction) {
    progress.show(fraction);
    return true;
  };
  const std::string name = arguments.name.empty()
                               ? asUtf8(std::filesystem::path(arguments.input).stem().string())
                               : arguments.name;
  Result<TilingBake> bake = bakeTiling(name, {&exemplar.value(), 1}, options);
  if (!bake)
    return bake.error();
  const bool periodic = bake.value().exemplarWasPeriodic;
  for (const TransportBound& bound : bake.value().transportBounds)
    notes.push_back(fmt::format("the colours are matched within {:.3f} % of the optimum, certified",
                                100.0 * bound.excess()));
  if (!periodic && arguments.tiling.periodic == Periodic::detect)
    notes.push_back("the exemplar's borders do not fit together; they were blended");
  const Result<BundleFile> file = makeBundleFile(arguments, std::move(bake).value());
  if (!file)
    return file.error();
  if (Result<void> written = writeBundle(arguments.output, file.value()); !written)
    return written.error();
  progress.erase();
  printNotes(printed);
  Result<PrecisionLoss> loss = PrecisionLoss{};
  if (arguments.shared.json)
    loss = precisionLoss(file.value().bundle, 0, 0, exemplar.value(), periodic);
  if (!loss)
    return loss.error();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  report(arguments, file.value(), periodic, loss.value(), notes, seconds.count());
  return kDone;
}

} // namespace

Runner addBake(CLI::App& verb, const SharedOptions& shared) {
  auto arguments = std::make_shared<Arguments>(shared);
  addText(verb, "INPUT", arguments->input, "", "The photograph: PNG, JPEG or EXR")->required();
  addText(verb, "-o,--output", arguments->output, "OUT.glb|OUT.gltf", "The bundle")->required();
  addValue(verb, "--method", arguments->method, oneOf<std::string>({{"tiling", "tiling"}}),
           "tiling", "The noise method");
  addValue(verb, "--name", arguments->name, nameText(), "",
           "Name of noise and material [default: the input's]");
  addValue(verb, "--seed", arguments->seed, seedNumber(), "1", "Seed of the material's pattern");
  addValue(verb, "--tile", arguments->tileMetres, number(kTileSizeRange), "1",
           "Width of the exemplar in metres");
  const Choices<Periodic> periodic{
      {"auto", Periodic::detect}, {"yes", Periodic::yes}, {"no", Periodic::no}};
  addValue(verb, "--periodic", arguments->tiling.periodic, oneOf(periodic), "auto",
           "Whether the exemplar's opposite borders fit together");
  const Choices<TransportEffort> efforts{{"fast", TransportEffort::fast},
                                         {"default", TransportEffort::standard},
                                         {"exact", TransportEffort::exact}};
  addValue(verb, "--transport", arguments->tiling.transport, oneOf(efforts), "default",
           "How near to optimal colours are matched");
  const Choices<LookupTable> luts{{"joint", LookupTable::joint},
                                  {"separable", LookupTable::separable}};
  addValue(verb, "--lut", arguments->tiling.lut, oneOf(luts), "joint",
           "One table of all colours, or a small one for each axis of colour");
  const Choices<GaussianOnly> gaussian{
      {"auto", GaussianOnly::detect}, {"yes", GaussianOnly::yes}, {"no", GaussianOnly::no}};
  addValue(verb, "--gaussian", arguments->tiling.gaussian, oneOf(gaussian), "auto",
           "Whether the exemplar's values are Gaussian, and need no table");
  addValue(verb, "--precision", arguments->tiling.bits, oneOf<int>({{"8", 8}, {"16", 16}}), "8",
           "Bits per channel of the tables");
  const Choices<PreviewShape> shapes{{"sphere", PreviewShape::sphere},
                                     {"plane", PreviewShape::plane},
                                     {"none", PreviewShape::none}};
  addValue(verb, "--preview", arguments->preview, oneOf(shapes), "sphere",
           "The scene around the material");
  return [arguments] { return run(*arguments); };
}

} // namespace lichen::cli
