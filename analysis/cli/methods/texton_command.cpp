// SPDX-License-Identifier: MIT
// Textons: options, bake reports, and descriptions for `inspect`.
#include "texton_command.h"

#include "../progress_line.h"
#include "../table_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kHeading = "Texton";

Accepted<PointProcess> pointProcess() {
  return oneOf<PointProcess>(
      {{"stratified", PointProcess::stratified}, {"poisson", PointProcess::poisson}});
}

// ---- bake ----

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
/// the worst channel, and otherwise what helps. `tiling` says how to use the other method.
std::string closeness(std::string_view textons, const std::vector<double>& channelErrors,
                      const Noise& noise, std::string_view tiling) {
  const auto worst = std::ranges::max_element(channelErrors);
  const std::string name = channelName(noise, std::size_t(worst - channelErrors.begin()));
  const bool close = isClose(channelErrors);
  std::string text = fmt::format("{} {}close to the spectrum, with the colours and "
                                 "outlines of Gaussian noise: the "
                                 "largest model error is {:.2f} ({}); up to {:.2f} is close",
                                 textons, close ? "" : "not ", *worst, name, kCloseError);
  if (!close)
    text += fmt::format("; what helps: {}{}",
                        isSupportWhole(noise.as<TextonShape>()) ? "" : "a larger --support, or ",
                        tiling);
  return text;
}

/// Faults of a texton's fit, compared with the best texton of the exemplar's Gaussian texture. The
/// verdict covers the faults of that texture itself.
std::vector<std::string> qualityNotes(const TextonQuality& quality, const Noise& noise,
                                      double impacts) {
  std::vector<std::string> notes;
  if (!isClose(quality.channelErrors))
    notes.push_back(closeness("the texton is", quality.channelErrors, noise, "--method tiling"));
  if (quality.flatness * kUsualImpacts > kEnoughFlatness * impacts)
    notes.push_back(
        fmt::format("{:g} impacts are few: --impacts {:.0f} makes the values nearly normal",
                    impacts, std::ceil(quality.flatness / kNearlyNormal)));
  return notes;
}

Json asJson(const TextonQuality& quality) {
  Json json{{"modelError", quality.modelError}, {"channelErrors", quality.channelErrors}};
  if (quality.heldOutError)
    json["heldOutError"] = *quality.heldOutError;
  json["flatness"] = quality.flatness;
  json["covarianceError"] = quality.covarianceError;
  return json;
}

class Bake final : public BakeOptions {
public:
  TextonOptions options;
  MaterialNoise material;

  [[nodiscard]] BakeMemory memory() const override { return kTextonMemory; }

  [[nodiscard]] Result<MethodBake> bake(const BakeInput& input) const override {
    TextonOptions texton = options;
    texton.bits = input.bits;
    texton.progress = input.progress;
    Result<TextonBake> baked = bakeTexton(input.name, input.maps, texton);
    if (!baked)
      return baked.error();
    TextonBake& bake = baked.value();
    const auto& shape = bake.noise.as<TextonShape>();
    MethodBake result;
    result.material = material;
    if (std::optional<std::string> line = supportNote(options.support, shape))
      result.notes.push_back(*std::move(line));
    std::ranges::move(qualityNotes(bake.quality, bake.noise, material.impacts),
                      std::back_inserter(result.notes));
    result.json["texton"] = asJson(bake.quality);
    result.facts.emplace_back("Impacts", fmt::format("{:g} per point, {}", material.impacts,
                                                     nameOf(material.pointProcess)));
    result.noise = std::move(bake.noise);
    result.tables = std::move(bake.tables);
    return result;
  }
};

// ---- use of a noise ----

class Use final : public UseOptions {
public:
  std::optional<double> impacts;
  std::optional<PointProcess> points;

  void replace(MaterialNoise& material, EvaluationOptions&) const override {
    material.impacts = impacts.value_or(material.impacts);
    material.pointProcess = points.value_or(material.pointProcess);
  }
};

// ---- inspect ----

/// Approximate fetches of shaders_glsl/noise/texton.glsl: one impact for each cell that a support
/// overlaps, which is sqrt(impacts) cells wide, and four fetches for a cubic spline.
int fetchesOfTexton(const TextonShape& shape, double impacts) {
  constexpr int kCubicFetches = 4;
  const double cells = std::sqrt(impacts) + 1.0;
  return int(std::lround(cells * cells)) * (shape.order == 3 ? kCubicFetches : 1);
}

Json laterSteps(const std::vector<TextonStep>& steps) {
  Json json = Json::array();
  for (const TextonStep& step : steps)
    json.push_back({{"mean", step.mean}, {"covariance", step.covariance}});
  return json;
}

} // namespace

void addTextonOptions(CLI::App& verb, TextonOptions& texton, MaterialNoise& material) {
  addValue(verb, "--support", texton.support,
           wholeNumber(int(kTextonSupportRange.least), int(kTextonSupportRange.most)), "64",
           "Side of the texton in texels; slower variation is lost")
      .group(kHeading);
  addValue(verb, "--order", texton.order, oneOf<int>({{"0", 0}, {"1", 1}, {"3", 3}}), "1",
           "B-spline between texels: 0 nearest, 1 linear, 3 cubic, smooth enough for bumps")
      .group(kHeading);
  addValue(verb, "--impacts", material.impacts, number(kImpactsRange), "30",
           "Mean number of impacts at a point")
      .group(kHeading);
  addValue(verb, "--points", material.pointProcess, pointProcess(), "stratified",
           "One impact per grid cell, or a Poisson process")
      .group(kHeading);
  const Choices<TextonVariance> variances{{"exemplar", TextonVariance::exemplar},
                                          {"periodic", TextonVariance::periodic}};
  addValue(verb, "--variance", texton.variance, oneOf(variances), "exemplar",
           "Contrast of the exemplar, or of its periodic component")
      .group(kHeading);
}

Result<std::vector<std::vector<Risk>>> assessTextonMaps(std::span<const MapExemplar> maps,
                                                        int support, const SharedOptions& shared,
                                                        int widthTexels) {
  int width = 0, height = 0; // the size at which all maps are fitted
  for (const MapExemplar& map : maps) {
    width = std::max(width, map.width);
    height = std::max(height, map.height);
  }
  if (widthTexels > 0) {
    height = int(std::lround(double(height) * double(widthTexels) / double(width)));
    width = widthTexels;
  }
  ProgressLine line("assess", shared);
  const auto count = double(maps.size());
  std::vector<std::vector<Risk>> risks;
  for (const MapExemplar& map : maps) {
    const auto done = double(risks.size());
    const Progress part = partOf(line.asProgress(), done / count, (done + 1.0) / count);
    Result<std::vector<Risk>> assessed = assessTextonSuitability(map, support, part, width, height);
    if (!assessed)
      return assessed.error();
    risks.push_back(std::move(assessed).value());
  }
  return risks;
}

std::optional<std::string> supportNote(int supportWanted, const TextonShape& shape) {
  const int wanted = supportWanted - shape.order; // in coefficients
  if (wanted <= std::min(shape.coefficientsX, shape.coefficientsY))
    return std::nullopt;
  return fmt::format("--support {}: the exemplar has {} x {} pixels, which limits the texton",
                     supportWanted, shape.texelsPerTileX, shape.texelsPerTileY);
}

std::string qualityNote(const TextonMixQuality& quality, const Noise& noise) {
  constexpr std::string_view kTiling = "lichen bake --method tiling for each input alone";
  constexpr double kUnrelated = std::numbers::sqrt2; // largestStep of textons without correlation
  constexpr double kShownRankError = 0.005;          // rounds to 1 %
  if (quality.modelErrors.size() > 1)
    return fmt::format("{}; neighbours differ by at most {:.2f} (unrelated ones by {:.1f})",
                       closeness("the textons are", quality.channelErrors, noise, kTiling),
                       quality.largestStep, kUnrelated);
  std::string text = closeness("the texton is", quality.channelErrors, noise, kTiling);
  if (quality.rankError >= kShownRankError)
    text += fmt::format("; one texton cannot show {:.0f} % of the deviation between these inputs",
                        100.0 * quality.rankError);
  return text;
}

std::unique_ptr<const BakeOptions> TextonCommand::addBakeOptions(CLI::App& verb,
                                                                 const CommonOptions&) const {
  auto options = std::make_unique<Bake>();
  addTextonOptions(verb, options->options, options->material);
  return options;
}

std::unique_ptr<const UseOptions> TextonCommand::addSynthOptions(CLI::App& verb) const {
  auto options = std::make_unique<Use>();
  addValue(verb, "--impacts", options->impacts, optional(number(kImpactsRange)), "",
           "Mean number of impacts at a point [default: the bundle's]")
      .group(kHeading);
  addValue(verb, "--points", options->points, optional(pointProcess()), "",
           "One impact per grid cell, or a Poisson process [default: the bundle's]")
      .group(kHeading);
  return options;
}

std::unique_ptr<const UseOptions> TextonCommand::addApplyOptions(CLI::App&) const {
  return std::make_unique<Use>();
}

void TextonCommand::describe(const Noise& noise, Json& json) const {
  const auto& shape = noise.as<TextonShape>();
  json["texton"] = {
      {"coefficients", {shape.coefficientsX, shape.coefficientsY}},
      {"order", shape.order},
      {"support", {shape.coefficientsX + shape.order, shape.coefficientsY + shape.order}},
      {"mipLevels", shape.mipLevels},
      {"steps", shape.steps}};
}

std::vector<std::string> TextonCommand::linesOf(const Noise& noise,
                                                const MaterialNoise& use) const {
  const auto& shape = noise.as<TextonShape>();
  std::string text =
      fmt::format("textons of {} x {} texels, order {}, {:g} impacts per point, {}",
                  shape.coefficientsX + shape.order, shape.coefficientsY + shape.order, shape.order,
                  use.impacts, nameOf(use.pointProcess));
  return {text + (shape.steps > 1 ? fmt::format("; {} steps", shape.steps) : "")};
}

void TextonCommand::describe(const Bundle&, const NoiseMap& map, Json& json) const {
  const auto& texton = map.as<TextonMap>();
  json["texton"] = texton.image;
  json["laterSteps"] = laterSteps(texton.laterSteps);
}

std::vector<std::string> TextonCommand::linesOf(const Bundle&, const NoiseMap& map) const {
  const auto& texton = map.as<TextonMap>();
  std::vector<std::string> lines;
  if (!texton.laterSteps.empty())
    lines.push_back("at the last step " + statisticsOf(texton.laterSteps.back().mean,
                                                       texton.laterSteps.back().covariance));
  lines.push_back(fmt::format("texton: table {}", texton.image));
  return lines;
}

int TextonCommand::fetches(const Bundle&, const Noise& noise, const NoiseMap&,
                           const MaterialNoise& use) const {
  return fetchesOfTexton(noise.as<TextonShape>(), use.impacts);
}

const Table& TextonCommand::imageOf(const Bundle& bundle, const NoiseMap& map) const {
  return bundle.tables[map.as<TextonMap>().image];
}

} // namespace lichen::cli
