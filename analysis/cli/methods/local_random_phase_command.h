// SPDX-License-Identifier: MIT
// Local random-phase noise on the command line.
#pragma once

#include "method_command.h"

namespace lichen::cli {

class LocalRandomPhaseCommand final : public MethodCommand {
public:
  [[nodiscard]] std::string heading() const override { return "Local random phase"; }
  [[nodiscard]] bool takesSpectrum() const override { return true; }
  [[nodiscard]] bool takesGuide() const override { return true; }
  [[nodiscard]] std::string optionsFor(Mapping) const override { return "with --structure 0"; }
  [[nodiscard]] std::unique_ptr<const BakeOptions>
  addBakeOptions(CLI::App& verb, const CommonOptions& common) const override;
  [[nodiscard]] std::unique_ptr<const UseOptions> addSynthOptions(CLI::App& verb) const override;
  [[nodiscard]] std::unique_ptr<const UseOptions> addApplyOptions(CLI::App& verb) const override;
  void describe(const Noise& noise, nlohmann::ordered_json& json) const override;
  [[nodiscard]] std::vector<std::string> linesOf(const Noise& noise,
                                                 const MaterialNoise& use) const override;
  void describe(const Bundle& bundle, const NoiseMap& map,
                nlohmann::ordered_json& json) const override;
  [[nodiscard]] std::vector<std::string> linesOf(const Bundle& bundle,
                                                 const NoiseMap& map) const override;
  [[nodiscard]] bool hasRows(const Noise& noise) const override;
  [[nodiscard]] int fetches(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
                            const MaterialNoise& use) const override;
  [[nodiscard]] bool fetchesVary() const override { return false; }
  [[nodiscard]] const Table& imageOf(const Bundle& bundle, const NoiseMap& map) const override;
};

} // namespace lichen::cli
