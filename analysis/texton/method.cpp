// SPDX-License-Identifier: MIT
// Textons as one of the methods of a bake, and what a bake or a mix says of their quality.
#include "method_analysis.h"

#include <lichen/texton_mix.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen {
namespace {

/// Relative model error ([GLM14] eq. 5) of one channel up to which a texton is close. A texton with
/// the exact spectrum of a material, compared with one picture of it, has
/// sqrt(2 - sqrt(pi)) = 0.477, because the moduli of a picture's spectrum vary like the moduli of
/// complex normal numbers. A texton whose amplitudes are wrong by a fraction D of the standard
/// deviation has sqrt(2 - sqrt(pi) + sqrt(pi) / 2 D^2). This is D = 1/2. Several channels together
/// have more, because a picture's cross-spectra vary too. Six materials of 512 x 512 pixels have
/// 0.50 to 0.63 at a support of 64, but for two slow height maps, 0.68 and 0.88.
constexpr double kCloseError = 0.67;

/// With at most this excess kurtosis the number of impacts is sufficient: the largest flatness that
/// a fit should have, divided by the number of impacts that the papers and this project use.
constexpr double kEnoughFlatness = 4.0;
constexpr double kUsualImpacts = 30.0;
/// The excess kurtosis of that many impacts of a normally distributed texton.
constexpr double kNearlyNormal = 3.0 / kUsualImpacts;

bool isSupportWhole(const TextonShape& shape) {
  return shape.coefficientsX + shape.order >= shape.texelsPerTileX &&
         shape.coefficientsY + shape.order >= shape.texelsPerTileY;
}

/// "height", or, of a map with several channels, "red of baseColor".
std::string channelName(const Noise& noise, std::size_t channel) {
  for (const NoiseMap& map : noise.maps) {
    const std::size_t channels = map.channels.size();
    if (channel < channels)
      return channels == 1
                 ? std::string(nameOf(map.target))
                 : fmt::format("{} of {}", nameOf(map.channels[channel]), nameOf(map.target));
    channel -= channels;
  }
  return {};
}

bool isClose(const std::vector<double>& channelErrors) {
  return *std::ranges::max_element(channelErrors) <= kCloseError;
}

/// Says whether `textons` ("the texton is", "the textons are") close to the exemplar's spectra, by
/// the worst channel, and otherwise what helps. `instead` says how to use tiling.
std::string closeness(std::string_view textons, const std::vector<double>& channelErrors,
                      const Noise& noise, SettingWords words, std::string_view instead) {
  const auto worst = std::ranges::max_element(channelErrors);
  const std::string name = channelName(noise, std::size_t(worst - channelErrors.begin()));
  const bool close = isClose(channelErrors);
  std::string text = fmt::format("{} {}close to the spectrum, with the colours and "
                                 "outlines of Gaussian noise: the "
                                 "largest model error is {:.2f} ({}); up to {:.2f} is close",
                                 textons, close ? "" : "not ", *worst, name, kCloseError);
  if (!close)
    text += fmt::format("; what helps: {}{}",
                        isSupportWhole(noise.as<TextonShape>())
                            ? ""
                            : "a larger " + words({"support", ""}) + ", or ",
                        instead);
  return text;
}

/// Faults of a texton's fit, compared with the best texton of the exemplar's Gaussian texture. The
/// verdict covers the faults of that texture itself.
void noteQuality(const MethodInput& input, MethodBake& bake) {
  const TextonQuality& quality = bake.figures.quality;
  if (!isClose(quality.channelErrors))
    bake.notes.push_back(closeness("the texton is", quality.channelErrors, bake.noise, input.words,
                                   input.words({"method", "tiling"})));
  const double impacts = input.material.impacts;
  if (quality.flatness * kUsualImpacts > kEnoughFlatness * impacts)
    bake.notes.push_back(fmt::format(
        "{:g} impacts are few: {} makes the values nearly normal", impacts,
        input.words(
            {"impacts", fmt::format("{:.0f}", std::ceil(quality.flatness / kNearlyNormal))})));
}

/// Measured: 90 to 101 bytes per pixel for one map of 512 to 2048 pixels a side, 275 for four maps
/// of 1024 pixels a side.
BakeMemory memory(const MethodOptions&) { return {60.0, 40.0}; }

Result<MethodBake> bake(const MethodOptions& options, const MethodInput& input) {
  const auto own = optionsFor<TextonOptions>(options, input);
  Result<MethodBake> baked = bakeTexton(input.name, input.maps, own);
  if (!baked)
    return baked;
  MethodBake& result = baked.value();
  if (std::optional<std::string> line =
          supportNote(own.support, result.noise.as<TextonShape>(), input.words))
    result.notes.push_back(*std::move(line));
  noteQuality(input, result);
  return baked;
}

} // namespace

const MethodAnalysis kTextonAnalysis{memory, bake};

std::optional<std::string> supportNote(int supportWanted, const TextonShape& shape,
                                       SettingWords words) {
  const int wanted = supportWanted - shape.order; // in coefficients
  if (wanted <= std::min(shape.coefficientsX, shape.coefficientsY))
    return std::nullopt;
  return fmt::format("{}: the exemplar has {} x {} pixels, which limits the texton",
                     words({"support", std::to_string(supportWanted)}), shape.texelsPerTileX,
                     shape.texelsPerTileY);
}

std::string mixNote(const TextonMixQuality& quality, const Noise& noise, SettingWords words,
                    std::string_view instead) {
  constexpr double kUnrelated = std::numbers::sqrt2; // largestStep of textons without correlation
  constexpr double kShownRankError = 0.005;          // rounds to 1 %
  if (quality.modelErrors.size() > 1)
    return fmt::format("{}; neighbours differ by at most {:.2f} (unrelated ones by {:.1f})",
                       closeness("the textons are", quality.channelErrors, noise, words, instead),
                       quality.largestStep, kUnrelated);
  std::string text = closeness("the texton is", quality.channelErrors, noise, words, instead);
  if (quality.rankError >= kShownRankError)
    text += fmt::format("; one texton cannot show {:.0f} % of the deviation between these inputs",
                        100.0 * quality.rankError);
  return text;
}

Result<std::vector<std::vector<Risk>>> assessMixed(std::span<const MapExemplar> maps, int support,
                                                   int widthTexels, const Progress& progress) {
  int width = 0, height = 0;
  for (const MapExemplar& map : maps) {
    width = std::max(width, map.width);
    height = std::max(height, map.height);
  }
  height = int(std::lround(double(height) * double(widthTexels) / double(width)));
  const auto count = double(maps.size());
  std::vector<std::vector<Risk>> risks;
  for (const MapExemplar& map : maps) {
    const auto done = double(risks.size());
    Result<std::vector<Risk>> assessed = assessTextonSuitability(
        map, support, partOf(progress, done / count, (done + 1.0) / count), widthTexels, height);
    if (!assessed)
      return assessed.error();
    risks.push_back(std::move(assessed).value());
  }
  return risks;
}

} // namespace lichen
