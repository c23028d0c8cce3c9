// SPDX-License-Identifier: MIT
// Multiple-kernels noise: options, bake reports, and descriptions for `inspect`.
#include "multiple_kernels_command.h"

#include "../table_words.h"
#include "outline_risks.h"

#include <lichen/counted.h>
#include <lichen/multiple_kernels.h>

#include <fmt/format.h>

namespace lichen::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kHeading = "Multiple kernels";

class Bake final : public BakeOptions {
public:
  explicit Bake(const CommonOptions& common) : common_(common) {}

  KernelWindow window = KernelWindow::gabor;
  int kernels = 0;
  double impacts = 0.0;

  [[nodiscard]] Result<std::vector<std::vector<Risk>>>
  assess(std::span<const MapExemplar> maps, Periodic, const SharedOptions& shared) const override {
    if (common_.spectrum) // nobody expects outlines
      return std::vector<std::vector<Risk>>(maps.size());
    return outlineRisks(maps, shared, {});
  }

  /// As tiling needs, and the spectra of all channels.
  [[nodiscard]] BakeMemory memory() const override { return {64.0, 160.0}; }

  [[nodiscard]] double plainFetches() const override {
    constexpr double kPerImpact = 2.9;
    return kPerImpact * impacts;
  }

  [[nodiscard]] Result<MethodBake> bake(const BakeInput& input) const override {
    MultipleKernelsOptions options;
    options.window = window;
    options.kernels = kernels;
    options.impacts = impacts;
    if (Result<void> given = setSpectrum(common_.spectrum, input.maps, options.spectrum); !given)
      return given.error();
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
    result.json["spectrumErrorDb"] = bake.spectrumErrorDb;
    result.json["periodic"] = bake.exemplarWasPeriodic;
    result.facts.emplace_back("Borders", bake.exemplarWasPeriodic ? "fit together" : "blended");
    result.facts.emplace_back("Kernels", kernelWords(shared));
    result.notes.push_back(fmt::format("{}: their spectrum is {:.1f} dB from that asked for",
                                       kernelWords(shared), bake.spectrumErrorDb));
    result.noise = std::move(bake.noise);
    result.tables = std::move(bake.tables);
    return result;
  }

  static std::string kernelWords(const MultipleKernelsNoise& shared) {
    std::string words =
        fmt::format("{} with the window {}", counted(std::uint64_t(shared.kernels), "kernel"),
                    nameOf(shared.window));
    if (shared.rings > 0)
      words += fmt::format(", {} of them {}", shared.rings, shared.rings == 1 ? "a ring" : "rings");
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
      "Window of the kernels: gabor, which is fitted in all ways, or sinc or gaussian-sinc for "
      "spectra with straight edges")
      .group(kHeading);
  addValue(verb, "--max-kernels", options->kernels,
           wholeNumber(int(kKernelsRange.least), int(kKernelsRange.most)), "8",
           "Most kernels; more follow the spectrum more closely and cost more per pixel")
      .group(kHeading);
  addValue(verb, "--kernel-impacts", options->impacts, number(kImpactsRange), "30",
           "Mean number of impacts at a point, of all kernels; shader time is proportional")
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
  json["multipleKernels"] = {
      {"kernels", shared.kernels}, {"rings", shared.rings}, {"window", nameOf(shared.window)}};
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
  return int(kKernelTexels) * noise.as<MultipleKernelsNoise>().kernels +
         (map.as<MultipleKernelsMap>().inverseTable ? 1 : 0);
}

const Table& MultipleKernelsCommand::imageOf(const Bundle& bundle, const NoiseMap& map) const {
  return bundle.tables[map.as<MultipleKernelsMap>().kernels];
}

} // namespace lichen::cli
