// SPDX-License-Identifier: MIT
// Textons on the command line: options, bake reports, and descriptions for `inspect`.
#include "method_command.h"
#include "texton_options.h"

#include <cmath>
#include <memory>

namespace lichen::cli {
namespace {

constexpr const char* kHeading = "Texton";

Accepted<PointProcess> pointProcess() {
  return oneOf<PointProcess>(
      {{"stratified", PointProcess::stratified}, {"poisson", PointProcess::poisson}});
}

Json asJson(const TextonQuality& quality) {
  return {{"modelError", quality.modelError},
          {"channelErrors", quality.channelErrors},
          {"flatness", quality.flatness},
          {"covarianceError", quality.covarianceError}};
}

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

class TextonCommand final : public MethodCommand {
  std::string heading() const override { return kHeading; }
  bool takesImpacts() const override { return true; }

  BakeOptionsReader addBakeOptions(CLI::App& verb, CommonOptions& common) const override {
    auto options = std::make_shared<TextonOptions>();
    addTextonOptions(verb, *options, common.material);
    return [options](std::span<const MapExemplar>, std::vector<std::string>&) {
      return MethodOptions(*options);
    };
  }

  UseOptions addUseOptions(CLI::App& verb) const override {
    struct Use {
      std::optional<double> impacts;
      std::optional<PointProcess> points;
    };
    auto options = std::make_shared<Use>();
    addValue(verb, "--impacts", options->impacts, optional(number(kImpactsRange)), "",
             "Mean number of impacts at a point [default: the bundle's]")
        .group(kHeading);
    addValue(verb, "--points", options->points, optional(pointProcess()), "",
             "One impact per grid cell, or a Poisson process [default: the bundle's]")
        .group(kHeading);
    return [options](MaterialNoise& material) {
      material.impacts = options->impacts.value_or(material.impacts);
      material.pointProcess = options->points.value_or(material.pointProcess);
    };
  }

  Json figures(const BakedMaterial& baked) const override {
    return Json{{"texton", asJson(baked.figures.quality)}};
  }

  void describe(const Noise& noise, Json& json) const override {
    const auto& shape = noise.as<TextonShape>();
    json["texton"] = {
        {"coefficients", {shape.coefficientsX, shape.coefficientsY}},
        {"order", shape.order},
        {"support", {shape.coefficientsX + shape.order, shape.coefficientsY + shape.order}},
        {"mipLevels", shape.mipLevels},
        {"steps", shape.steps}};
  }

  void describe(const NoiseMap& map, Json& json) const override {
    const auto& texton = map.as<TextonMap>();
    json["texton"] = texton.image;
    json["laterSteps"] = laterSteps(texton.laterSteps);
  }

  int fetches(const Noise& noise, const NoiseMap&, const MaterialNoise& use) const override {
    return fetchesOfTexton(noise.as<TextonShape>(), use.impacts);
  }
};

} // namespace

void addTextonOptions(CLI::App& verb, TextonOptions& texton, MaterialNoise& material) {
  addValue(verb, "--support", texton.support,
           wholeNumber(int(kTextonSupportRange.least), int(kTextonSupportRange.most)), "64",
           "Side of the texton in texels; slower variation is lost")
      .group(kHeading);
  addValue(verb, "--order", texton.order, oneOf<int>({{"0", 0}, {"1", 1}, {"3", 3}}), "1",
           "B-spline between texels: 0 nearest, 1 linear, 3 cubic, smooth enough for bumps")
      .group(kHeading);
  addValue(verb, "--points", material.pointProcess, pointProcess(), "stratified",
           "One impact per grid cell, or a Poisson process")
      .group(kHeading);
}

const MethodCommand& textonCommand() {
  static const TextonCommand command;
  return command;
}

} // namespace lichen::cli
