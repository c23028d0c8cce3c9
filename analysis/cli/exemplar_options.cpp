// SPDX-License-Identifier: MIT
// Files and options -> exemplars.
#include "exemplar_options.h"

#include "available_memory.h"

#include <lichen/image_io.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace lichen::cli {
namespace {

/// Describes how map `m` was made. Moves its unflattened original out of `originals`, unless that
/// is empty.
ExemplarOrigin originOf(std::size_t m, const ExemplarOptions& options, const Flattened& flattened,
                        std::size_t filled, const RectifiedPart& part, const MaterialSet& set,
                        std::vector<MapExemplar>& originals) {
  const std::vector<MapExemplar>& maps = set.maps;
  ExemplarOrigin origin;
  if (set.crop)
    origin.steps.emplace_back("cropped");
  if (options.set.size)
    origin.steps.emplace_back("resized");
  const std::vector<MapTarget>& targets = flattened.maps;
  const bool isFlattened = std::ranges::count(targets, maps[m].target) > 0;
  const double period = flattened.periodPixels * maps[m].width / maps.front().width;
  if (isFlattened)
    origin.steps.push_back(fmt::format("without variation slower than {:.0f} pixels", period));
  if (filled > 0)
    origin.steps.push_back(filled == 1 ? "one part filled"
                                       : fmt::format("{} parts filled", filled));
  if (part.corners)
    origin.steps.emplace_back("straightened");
  if (!originals.empty() && (isFlattened || filled > 0 || part.corners))
    origin.original = std::move(originals[m]);
  return origin;
}

/// Returns the pixels per map, if --size or --crop determine them.
std::optional<std::uint64_t> keptPixels(const ExemplarOptions& options) {
  const auto product = [](int a, int b) { return std::uint64_t(a) * std::uint64_t(b); };
  if (options.set.size)
    return product((*options.set.size)[0], (*options.set.size)[1]);
  if (options.crop)
    return product((*options.crop)[2], (*options.crop)[3]);
  return std::nullopt;
}

bool has(std::span<const MapExemplar> maps, MapTarget target) {
  return std::ranges::count(maps, target, &MapExemplar::target) > 0;
}

/// The part of the largest file that was used, unless --size hides how large that is.
std::optional<PhotographPart> photographPart(const ExemplarOptions& options,
                                             const MaterialSet& set) {
  if (set.crop)
    return PhotographPart{double(set.crop->x), double(set.crop->y), double(set.crop->width),
                          double(set.crop->height)};
  if (options.set.size)
    return std::nullopt;
  const auto largest = std::ranges::max_element(
      set.maps, {}, [](const MapExemplar& map) { return double(map.width) * map.height; });
  return PhotographPart{0.0, 0.0, double(largest->width), double(largest->height)};
}

Preparation preparationOf(const ExemplarOptions& options, const MaterialSet& set,
                          const Flattened& flattened, std::vector<FilledPlace> filled,
                          const std::optional<TileCorners>& corners) {
  Preparation made;
  if (set.crop)
    made.crop = {std::uint32_t(set.crop->x), std::uint32_t(set.crop->y),
                 std::uint32_t(set.crop->width), std::uint32_t(set.crop->height)};
  if (options.set.size)
    std::ranges::copy(*options.set.size, made.size.emplace().begin());
  made.isGreenDown =
      options.set.normal == NormalConvention::directX && has(set.maps, MapTarget::normal);
  made.usesAlpha = options.set.alpha == AlphaUse::opacity && has(set.maps, MapTarget::opacity);
  if (set.periodic != Periodic::detect)
    made.periodic = set.periodic == Periodic::yes;
  if (!flattened.maps.empty())
    made.flattenPeriod = flattened.periodPixels;
  made.flattened = flattened.maps;
  made.filled = std::move(filled);
  made.corners = corners;
  return made;
}

} // namespace

Preparation adoptPreparation(Preparation recorded, const CLI::App& verb, ExemplarOptions& options) {
  if (isGiven(verb, "--crop"))
    recorded.crop.reset();
  if (isGiven(verb, "--size"))
    recorded.size.reset();
  recorded.isGreenDown = recorded.isGreenDown && !isGiven(verb, "--normal");
  recorded.usesAlpha = recorded.usesAlpha && !isGiven(verb, "--alpha");
  if (isGiven(verb, "--periodic"))
    recorded.periodic.reset();
  if (isGiven(verb, "--flatten"))
    recorded.flattened.clear();
  else
    options.flattening = {false, recorded.flattenPeriod, recorded.flattened};
  if (isGiven(verb, "--keep-outliers") || isGiven(verb, "--crop") || isGiven(verb, "--size"))
    recorded.filled.clear(); // places in another exemplar
  options.outliers.recorded = recorded.filled;
  if (isGiven(verb, "--rectify") || isGiven(verb, "--crop") || isGiven(verb, "--size"))
    recorded.corners.reset();
  else
    options.rectification.corners = recorded.corners;
  if (recorded.crop)
    std::ranges::copy(*recorded.crop, options.crop.emplace().begin());
  if (recorded.size)
    std::ranges::copy(*recorded.size, options.set.size.emplace().begin());
  if (recorded.isGreenDown)
    options.set.normal = NormalConvention::directX;
  if (recorded.usesAlpha)
    options.set.alpha = AlphaUse::opacity;
  if (recorded.periodic)
    options.set.periodic = *recorded.periodic ? Periodic::yes : Periodic::no;
  return recorded;
}

std::string describe(const Preparation& preparation) {
  std::vector<std::string> words;
  if (preparation.crop)
    words.push_back(fmt::format("--crop {}", fmt::join(*preparation.crop, ",")));
  if (preparation.size)
    words.push_back(fmt::format("--size {}", fmt::join(*preparation.size, "x")));
  if (preparation.isGreenDown)
    words.emplace_back("--normal dx");
  if (preparation.usesAlpha)
    words.emplace_back("--alpha opacity");
  if (preparation.periodic)
    words.emplace_back(*preparation.periodic ? "--periodic yes" : "--periodic no");
  if (!preparation.flattened.empty())
    words.push_back(fmt::format("--flatten {:.6g}", preparation.flattenPeriod));
  if (!preparation.filled.empty())
    words.push_back(fmt::format("{} part{} filled", preparation.filled.size(),
                                preparation.filled.size() == 1 ? "" : "s"));
  if (preparation.corners) {
    std::vector<double> numbers;
    for (const auto& [x, y] : *preparation.corners)
      numbers.insert(numbers.end(), {x, y});
    words.push_back(fmt::format("--rectify {:.6g}", fmt::join(numbers, ",")));
  }
  return fmt::format("{}", fmt::join(words, " "));
}

void addExemplarOptions(CLI::App& verb, ExemplarOptions& options, ExemplarUse use) {
  const auto add = [&](const std::string& name, auto& value, const auto& accepted,
                       const std::string& preset, const std::string& help) {
    const Option option = addValue(verb, name, value, accepted, preset, help);
    if (use == ExemplarUse::comparison)
      option.shownDefault("as the bundle says" + (preset.empty() ? "" : ", else " + preset));
  };
  add("--crop", options.crop, optional(pixelRectangle(kMaxImageSide)), "",
      "Use only the W x H pixels from column X and row Y on, counted in the largest map; a bake "
      "without it cuts off a frame around the picture");
  add("--size", options.set.size, optional(imageSize(kMaxImageSide)), "",
      "Resample every map to this size, after --crop");
  const Choices<NormalConvention> conventions{{"gl", NormalConvention::openGl},
                                              {"dx", NormalConvention::directX}};
  add("--normal", options.set.normal, oneOf(conventions), "gl",
      "Convention of normal maps whose names do not say: gl (green up) or dx (green down)");
  const Choices<AlphaUse> uses{{"ignore", AlphaUse::ignore}, {"opacity", AlphaUse::opacity}};
  add("--alpha", options.set.alpha, oneOf(uses), "ignore",
      "Ignore the alpha of the base colour, or bake it as opacity");
  add("--flatten", options.flattening, flattening(),
      use == ExemplarUse::comparison ? "none" : "auto",
      "Remove variation slower than PERIOD pixels; auto removes uneven light from the base "
      "colour, if the noise would show it");
  addFlag(
      verb, "--keep-outliers", options.outliers.keeps,
      "Leave what occurs once, such as a leaf, a fold or a stain, instead of filling it from the "
      "rest");
  const bool findsPeriods = use == ExemplarUse::bake;
  add("--rectify", options.rectification, rectification(findsPeriods),
      findsPeriods ? "auto" : "off",
      std::string("Make the part between four corners the tile, after all that is above: X,Y of "
                  "the upper left, upper right, lower right and lower left; choose points that lie "
                  "whole periods apart") +
          (findsPeriods ? "; auto: whole periods of what repeats, in a bake by quilting" : ""));
  const Choices<Periodic> periodic{
      {"auto", Periodic::detect}, {"yes", Periodic::yes}, {"no", Periodic::no}};
  add("--periodic", options.set.periodic, oneOf(periodic), "auto",
      "Whether opposite borders fit together: yes leaves them, no blends them, auto measures");
}

Result<ReadExemplar> readExemplar(const std::vector<std::string>& inputs,
                                  const ExemplarOptions& options, const SharedOptions& shared) {
  MaterialSetOptions reading = options.set;
  if (options.crop) {
    const auto [x, y, width, height] = *options.crop;
    reading.crop = PixelRectangle{x, y, width, height};
  }
  MemoryNeed need(options.bakeMemory, keptPixels(options), availableMemory());
  reading.sizeCheck = [&](const std::filesystem::path& file, int width, int height) {
    return need.add(file.string(), width, height);
  };
  const std::vector<std::filesystem::path> paths(inputs.begin(), inputs.end());
  Result<MaterialSet> set = readMaterialSet(paths, reading);
  if (!set)
    return set.error();
  std::vector<MapExemplar>& maps = set.value().maps;
  std::vector<MapExemplar> originals;
  if (options.keepsOriginals)
    originals = maps;
  const Result<Flattened> flattened =
      applyFlattening(maps, options.flattening, set.value().periodic, shared, set.value().notes);
  if (!flattened)
    return flattened.error();
  Result<std::vector<FilledPlace>> filled =
      applyOutliers(maps, options.outliers, set.value().periodic,
                    photographPart(options, set.value()), shared, set.value().notes);
  if (!filled)
    return filled.error();
  Result<RectifiedPart> part = applyRectification(maps, options.rectification, set.value().periodic,
                                                  options.findsStructure, set.value().notes);
  if (!part)
    return part.error();
  ReadExemplar read{
      std::move(set).value(), {}, {}, part.value().structure, part.value().widthShare};
  for (std::size_t m = 0; m < read.set.maps.size(); ++m)
    read.origins.push_back(originOf(m, options, flattened.value(), filled.value().size(),
                                    part.value(), read.set, originals));
  read.preparation = preparationOf(options, read.set, flattened.value(), std::move(filled).value(),
                                   part.value().corners);
  return read;
}

} // namespace lichen::cli
