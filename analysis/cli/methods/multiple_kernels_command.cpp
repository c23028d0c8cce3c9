// SPDX-License-Identifier: MIT
// Multiple-kernels noise on the command line: options, bake reports, and descriptions for
// `inspect`.
#include "method_command.h"
#include "multiple_kernels_pattern.h"

#include <memory>

namespace lichen::cli {
namespace {

constexpr const char* kHeading = "Multiple kernels";
constexpr double kUsualPerturbation = 1.0;

/// The options of a bake.
struct Given {
  MultipleKernelsOptions own;
  double perturb = kUsualPerturbation;
  std::optional<PatternChoice> pattern;

  Result<MethodOptions> read(const CommonOptions& common, std::span<const MapExemplar> maps,
                             std::vector<std::string>& notes) const {
    MultipleKernelsOptions options = own;
    options.impacts = common.material.impacts;
    if (Result<void> given = setSpectrum(common.spectrum, maps, options.spectrum); !given)
      return given.error();
    if (pattern) {
      Result<Perturbation> perturbation = perturbationOf(*pattern, perturb);
      if (!perturbation)
        return perturbation.error();
      options.perturbation = std::move(perturbation).value();
    } else if (perturb != kUsualPerturbation) {
      notes.emplace_back("--perturb has no effect without --pattern");
    }
    return MethodOptions(std::move(options));
  }
};

class MultipleKernelsCommand final : public MethodCommand {
  std::string heading() const override { return kHeading; }
  bool takesSpectrum() const override { return true; }
  bool takesImpacts() const override { return true; }
  std::string optionsFor(Mapping mapping) const override {
    return mapping == Mapping::solid ? "with --kernel gabor, without --pattern"
                                     : "without --pattern";
  }

  BakeOptionsReader addBakeOptions(CLI::App& verb, CommonOptions& common) const override {
    auto options = std::make_shared<Given>();
    Choices<KernelWindow> windows;
    for (const KernelWindow window :
         {KernelWindow::gabor, KernelWindow::sinc, KernelWindow::gaussianSinc})
      windows.emplace_back(nameOf(window), window);
    addValue(
        verb, "--kernel", options->own.window, oneOf(windows), "gabor",
        "Window of the kernels: gabor, fitted in frequency, size, direction and energy, or sinc or "
        "gaussian-sinc for spectra with straight edges")
        .group(kHeading);
    addValue(verb, "--max-kernels", options->own.kernels,
             wholeNumber(int(kKernelsRange.least), int(kKernelsRange.most)), "8",
             "Most kernels; more follow the spectrum more closely and cost more per pixel")
        .group(kHeading);
    addValue(verb, "--pattern", options->pattern, patternChoice(), "",
             "A regular pattern that the noise perturbs: the exemplar's N strongest waves "
             "(cosines:N), a picture that tiles, N times along each axis of a tile with :N, or "
             "parts: wave:U:V[:AMPLITUDE[:PHASE]] or spline:U:V:VALUE:VALUE..., U and V whole "
             "cycles per tile along x and y")
        .group(kHeading);
    addValue(
        verb, "--perturb", options->perturb, number(kPerturbationRange), "1",
        "Strength of the noise beside the pattern: 0 leaves the pattern alone (a given one: in the "
        "luminance); colours have the exemplar's covariance")
        .group(kHeading);
    return [options, &common](std::span<const MapExemplar> maps, std::vector<std::string>& notes) {
      return options->read(common, maps, notes);
    };
  }

  Json figures(const BakedMaterial& baked) const override {
    Json json{{"kernels", baked.bundle.noises.front().as<MultipleKernelsNoise>().kernels}};
    for (const SpectrumError& error : baked.figures.spectrumErrors)
      json["spectrumErrors"].push_back({{"kernels", error.kernels}, {"decibels", error.decibels}});
    json["periodic"] = baked.figures.bordersWereKept;
    return json;
  }

  void describe(const Noise& noise, Json& json) const override {
    const auto& shared = noise.as<MultipleKernelsNoise>();
    json["multipleKernels"] = {{"kernels", shared.kernels},
                               {"rings", shared.rings},
                               {"cosines", shared.cosines},
                               {"window", nameOf(shared.window)}};
  }

  void describe(const NoiseMap& map, Json& json) const override {
    const auto& own = map.as<MultipleKernelsMap>();
    json["kernels"] = own.kernels;
    json["inverseTable"] = own.inverseTable ? Json(*own.inverseTable) : Json();
    json["dimensions"] = own.dimensions;
  }

  int fetches(const Noise& noise, const NoiseMap& map, const MaterialNoise&) const override {
    const auto& shared = noise.as<MultipleKernelsNoise>();
    return int(kKernelTexels) * shared.kernels + 2 * shared.cosines +
           (map.as<MultipleKernelsMap>().inverseTable ? 1 : 0);
  }
};

} // namespace

const MethodCommand& multipleKernelsCommand() {
  static const MultipleKernelsCommand command;
  return command;
}

} // namespace lichen::cli
