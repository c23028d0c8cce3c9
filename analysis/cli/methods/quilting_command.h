// SPDX-License-Identifier: MIT
// Quilting on the command line.
#pragma once

#include "method_command.h"

namespace lichen::cli {

class QuiltingCommand final : public MethodCommand {
public:
  [[nodiscard]] std::string heading() const override { return "Quilting"; }
  [[nodiscard]] bool takesGuide() const override { return true; }
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
  [[nodiscard]] int fetches(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
                            const MaterialNoise& use) const override;
  [[nodiscard]] int sharedFetches() const override;
  [[nodiscard]] bool fetchesVary() const override { return false; }
  [[nodiscard]] bool hasRows(const Noise& noise) const override;
  [[nodiscard]] const Table& imageOf(const Bundle& bundle, const NoiseMap& map) const override;
};

} // namespace lichen::cli
