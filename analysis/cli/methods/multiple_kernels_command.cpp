// SPDX-License-Identifier: MIT
// Multiple-kernels noise: options, bake reports, and descriptions for `inspect`.
#include "multiple_kernels_command.h"

#include "../table_words.h"
#include "pattern_option.h"

#include <lichen/counted.h>
#include <lichen/multiple_kernels.h>

#include <fmt/format.h>

namespace lichen::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kHeading = "Multiple kernels";
constexpr double kUsualPerturbation = 1.0;

class Bake final : public BakeOptions {
public:
  explicit Bake(const CommonOptions& common) : common_(common) {}

  KernelWindow window = KernelWindow::gabor;
  int kernels = 0;
  double impacts = 0.0;
  double perturb = kUsualPerturbation;
  std::optional<PatternChoice> pattern;
  int repeats = 1;

  /// As tiling needs, and the spectra of all channels.
  [[nodiscard]] BakeMemory memory() const override { return {64.0, 160.0}; }

  [[nodiscard]] Result<MethodBake> bake(const BakeInput& input) const override {
    MultipleKernelsOptions options;
    options.window = window;
    options.kernels = kernels;
    options.impacts = impacts;
    if (Result<void> given = setSpectrum(common_.spectrum, input.maps, options.spectrum); !given)
      return given.error();
    if (pattern) {
      Result<Perturbation> perturbation = perturbationOf(*pattern, perturb, repeats);
      if (!perturbation)
        return perturbation.error();
      options.perturbation = std::move(perturbation).value();
    }
    options.bits = input.bits;
    options.periodic = input.borders;
    options.progress = input.progress;
    Result<MultipleKernelsBake> baked = bakeMultipleKernels(input.name, input.maps, options);
    if (!baked)
      return baked.error();
    MultipleKernelsBake& bake = baked.value();
    const auto& shared = bake.noise.as<MultipleKernelsNoise>();
    MethodBake result;
    result.bordersWereBlended = !bake.exemplarWasPeriodic;
    result.json["kernels"] = shared.kernels;
    for (const SpectrumError& error : bake.spectrumErrors)
      result.json["spectrumErrors"].push_back(
          {{"kernels", error.kernels}, {"decibels", error.decibels}});
    result.json["periodic"] = bake.exemplarWasPeriodic;
    result.facts.emplace_back("Borders", bake.exemplarWasPeriodic ? "fit together" : "blended");
    result.facts.emplace_back("Kernels", kernelWords(shared));
    result.notes.push_back(kernelWords(shared) + ": " + errorWords(bake.spectrumErrors));
    const bool isPicture = pattern && std::holds_alternative<std::filesystem::path>(*pattern);
    if (!pattern && perturb != kUsualPerturbation)
      result.notes.emplace_back("--perturb has no effect without --pattern");
    if (!isPicture && repeats != 1)
      result.notes.emplace_back("--pattern-repeats has no effect without a picture as --pattern");
    result.noise = std::move(bake.noise);
    result.tables = std::move(bake.tables);
    return result;
  }

  /// How far the spectrum is from that asked for, and with fewer kernels.
  static std::string errorWords(const std::vector<SpectrumError>& errors) {
    std::string words =
        fmt::format("their spectrum is {:.2f} dB from that asked for", errors.back().decibels);
    for (std::size_t k = 0; k + 1 < errors.size(); ++k)
      words += fmt::format("{} {} kernels {:.2f} dB", k == 0 ? "; with" : ", with",
                           errors[k].kernels, errors[k].decibels);
    return words;
  }

  static std::string kernelWords(const MultipleKernelsNoise& shared) {
    std::string words =
        fmt::format("{} with the window {}", counted(std::uint64_t(shared.kernels), "kernel"),
                    nameOf(shared.window));
    if (shared.rings > 0)
      words += fmt::format(", {} of them {}", shared.rings, shared.rings == 1 ? "a ring" : "rings");
    if (shared.cosines > 0)
      words +=
          fmt::format(", and a pattern of {}", counted(std::uint64_t(shared.cosines), "cosine"));
    return words;
  }

private:
  const CommonOptions& common_;
};

/// The method has no parameters of a material.
class Use final : public UseOptions {
public:
  void replace(MaterialNoise&, EvaluationOptions&) const override {}
};

} // namespace

std::unique_ptr<const BakeOptions>
MultipleKernelsCommand::addBakeOptions(CLI::App& verb, const CommonOptions& common) const {
  auto options = std::make_unique<Bake>(common);
  Choices<KernelWindow> windows;
  for (const KernelWindow window :
       {KernelWindow::gabor, KernelWindow::sinc, KernelWindow::gaussianSinc})
    windows.emplace_back(nameOf(window), window);
  addValue(
      verb, "--kernel", options->window, oneOf(windows), "gabor",
      "Window of the kernels: gabor, fitted in frequency, size, direction and energy, or sinc or "
      "gaussian-sinc for spectra with straight edges")
      .group(kHeading);
  addValue(verb, "--max-kernels", options->kernels,
           wholeNumber(int(kKernelsRange.least), int(kKernelsRange.most)), "8",
           "Most kernels; more follow the spectrum more closely and cost more per pixel")
      .group(kHeading);
  addValue(verb, "--kernel-impacts", options->impacts, number(kImpactsRange), "30",
           "Mean number of impacts at a point, of all kernels; shader time is proportional")
      .group(kHeading);
  addValue(verb, "--pattern", options->pattern, patternChoice(), "",
           "A regular pattern that the noise perturbs: the exemplar's N strongest waves "
           "(cosines:N), a picture that tiles, or parts: wave:U:V[:AMPLITUDE[:PHASE]] or "
           "spline:U:V:VALUE:VALUE..., U and V whole cycles per tile along x and y")
      .group(kHeading);
  addValue(verb, "--pattern-repeats", options->repeats, wholeNumber(1, 64), "1",
           "How often a picture of a pattern lies along each axis of a tile")
      .group(kHeading);
  addValue(
      verb, "--perturb", options->perturb, number(kPerturbationRange), "1",
      "Strength of the noise beside the pattern: 0 leaves the pattern alone (a given one: in the "
      "luminance); colours have the exemplar's covariance")
      .group(kHeading);
  return options;
}

std::unique_ptr<const UseOptions> MultipleKernelsCommand::addSynthOptions(CLI::App&) const {
  return std::make_unique<Use>();
}

std::unique_ptr<const UseOptions> MultipleKernelsCommand::addApplyOptions(CLI::App&) const {
  return std::make_unique<Use>();
}

void MultipleKernelsCommand::describe(const Noise& noise, Json& json) const {
  const auto& shared = noise.as<MultipleKernelsNoise>();
  json["multipleKernels"] = {{"kernels", shared.kernels},
                             {"rings", shared.rings},
                             {"cosines", shared.cosines},
                             {"window", nameOf(shared.window)}};
}

std::vector<std::string> MultipleKernelsCommand::linesOf(const Noise& noise,
                                                         const MaterialNoise&) const {
  return {Bake::kernelWords(noise.as<MultipleKernelsNoise>())};
}

void MultipleKernelsCommand::describe(const Bundle&, const NoiseMap& map, Json& json) const {
  const auto& own = map.as<MultipleKernelsMap>();
  json["kernels"] = own.kernels;
  json["inverseTable"] = own.inverseTable ? Json(*own.inverseTable) : Json();
  json["dimensions"] = own.dimensions;
}

std::vector<std::string> MultipleKernelsCommand::linesOf(const Bundle& bundle,
                                                         const NoiseMap& map) const {
  const auto& own = map.as<MultipleKernelsMap>();
  return {fmt::format("kernels: table {}", own.kernels),
          inverseTableWords(own.inverseTable, own.dimensions, bundle.tables)};
}

int MultipleKernelsCommand::fetches(const Bundle&, const Noise& noise, const NoiseMap& map,
                                    const MaterialNoise&) const {
  const auto& shared = noise.as<MultipleKernelsNoise>();
  return int(kKernelTexels) * shared.kernels + 2 * shared.cosines +
         (map.as<MultipleKernelsMap>().inverseTable ? 1 : 0);
}

const Table& MultipleKernelsCommand::imageOf(const Bundle& bundle, const NoiseMap& map) const {
  return bundle.tables[map.as<MultipleKernelsMap>().kernels];
}

} // namespace lichen::cli
