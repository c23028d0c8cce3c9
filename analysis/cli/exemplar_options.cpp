// SPDX-License-Identifier: MIT
// Files and options -> exemplars.
#include "exemplar_options.h"

#include "bake_risks.h"
#include "options.h"
#include "steps_shown.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace lichen::cli {
namespace {

/// Returns the pixels per map, if --size or --crop determine them.
std::optional<std::uint64_t> keptPixels(const MaterialSetOptions& options) {
  const auto product = [](int a, int b) { return std::uint64_t(a) * std::uint64_t(b); };
  if (options.size)
    return product((*options.size)[0], (*options.size)[1]);
  if (options.crop)
    return product(options.crop->width, options.crop->height);
  return std::nullopt;
}

/// --flatten none|auto|PERIOD.
Accepted<Flattening> flattening() {
  const Accepted<double> period = number(kFlattenPeriodRange);
  return {"none|auto|PERIOD", "none, auto or " + period.sentence,
          [read = period.read](const std::string& text) -> std::optional<Flattening> {
            if (text == "none")
              return Flattening{};
            if (text == "auto")
              return Flattening{true, 0.0, {}};
            const std::optional<double> pixels = read(text);
            return pixels ? std::optional(Flattening{false, *pixels, {}}) : std::nullopt;
          }};
}

Accepted<std::optional<PixelRectangle>> crop() {
  return {
      "X,Y,W,H",
      fmt::format(
          "X,Y,W,H with whole numbers of pixels, X and Y from 0, W and H from 1, at most {}",
          kMaxImageSide),
      [](const std::string& text) -> std::optional<std::optional<PixelRectangle>> {
        const auto part = numbersFrom<4>(text, {0.0, kMaxImageSide});
        if (!part || (*part)[2] < 1.0 || (*part)[3] < 1.0 ||
            std::ranges::any_of(*part, [](double n) { return n != std::floor(n); }))
          return std::nullopt;
        return PixelRectangle{int((*part)[0]), int((*part)[1]), int((*part)[2]), int((*part)[3])};
      }};
}

/// Eight numbers from 0, with commas or spaces between them.
std::optional<TileCorners> cornersFrom(const std::string& text) {
  TileCorners corners{};
  const auto numbers = numbersFrom<2 * std::tuple_size_v<TileCorners>>(
      text, {0.0, std::numeric_limits<double>::max()}, ", ");
  if (!numbers)
    return std::nullopt;
  for (std::size_t k = 0; k < numbers->size(); ++k)
    corners[k / 2][k % 2] = (*numbers)[k];
  return areConvex(corners) ? std::optional(corners) : std::nullopt;
}

/// "off", or "X,Y,X,Y,X,Y,X,Y", the corners, commas or spaces between them; "auto" too if
/// `findsPeriods`.
Accepted<Rectification> rectification(bool findsPeriods) {
  return {findsPeriods ? "auto|off|X,Y,..." : "off|X,Y,...",
          std::string(findsPeriods ? "auto, off" : "off") +
              ", or 8 numbers from 0 with commas between them: X,Y of the upper left, upper right, "
              "lower right and lower left corner, in this order and in pixels; the corners must be "
              "convex",
          [findsPeriods](const std::string& text) -> std::optional<Rectification> {
            if (text == "auto" && findsPeriods)
              return Rectification{true, std::nullopt};
            if (text == "off")
              return Rectification{};
            const std::optional<TileCorners> corners = cornersFrom(text);
            return corners ? std::optional(Rectification{false, corners}) : std::nullopt;
          }};
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
    options.set.crop = {int((*recorded.crop)[0]), int((*recorded.crop)[1]),
                        int((*recorded.crop)[2]), int((*recorded.crop)[3])};
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
  add("--crop", options.set.crop, crop(), "",
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
          (findsPeriods ? "; auto: whole periods, where the bake keeps what repeats" : ""));
  const Choices<Periodic> periodic{
      {"auto", Periodic::detect}, {"yes", Periodic::yes}, {"no", Periodic::no}};
  add("--periodic", options.set.periodic, oneOf(periodic), "auto",
      "Whether opposite borders fit together: yes leaves them, no blends them, auto measures");
}

Result<MaterialSet> readMaterial(const std::vector<std::string>& inputs, MaterialSetOptions reading,
                                 const BakeMemory& memory) {
  MemoryNeed need(memory, keptPixels(reading), availableMemory(), optionOf);
  reading.sizeCheck = [&](const std::filesystem::path& file, int width, int height) {
    return need.add(file.string(), width, height);
  };
  const std::vector<std::filesystem::path> paths(inputs.begin(), inputs.end());
  return readMaterialSet(paths, reading);
}

Result<PreparedExemplar> readExemplar(const std::string& input, const ExemplarOptions& options,
                                      const SharedOptions& shared, const BakeMemory& memory) {
  Result<MaterialSet> set = readMaterial({input}, options.set, memory);
  if (!set)
    return set.error();
  StepsShown steps(shared);
  return prepareExemplar(std::move(set).value(), options, false, steps.observer());
}

} // namespace lichen::cli
