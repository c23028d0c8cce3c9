// SPDX-License-Identifier: MIT
// The format of multiple-kernels noise [MKN12].
#pragma once

#include "methods/method_format.h"

namespace lichen {

class MultipleKernelsFormat final : public MethodFormat {
public:
  [[nodiscard]] std::string_view name() const override { return "multiple-kernels"; }
  [[nodiscard]] int revision() const override { return 1; }
  [[nodiscard]] bool fits(Mapping mapping) const override;
  [[nodiscard]] std::string_view obstacle(const Noise& noise, Mapping mapping) const override;
  [[nodiscard]] std::string_view obstacle(const shader::LichenNoise& noise,
                                          Mapping mapping) const override;
  [[nodiscard]] std::span<const std::string_view> tableMembers() const override;
  [[nodiscard]] MethodNoise readNoise(ObjectReader& reader, FindingList& findings) const override;
  [[nodiscard]] MethodMap readMap(ObjectReader& reader, const Noise& noise, const NoiseMap& map,
                                  const Tables& tables, FindingList& findings) const override;
  void writeNoise(const Noise& noise, nlohmann::ordered_json& json) const override;
  void writeMap(const NoiseMap& map, nlohmann::ordered_json& json) const override;
  [[nodiscard]] std::array<std::uint32_t, 2> exemplarSize(const Bundle& bundle, const Noise& noise,
                                                          const NoiseMap& map) const override;
  [[nodiscard]] std::array<std::uint32_t, 2> tileSize(const Bundle& bundle,
                                                      const Noise& noise) const override;
  [[nodiscard]] Lattice cells(const shader::LichenNoise& noise, const MaterialNoise& material,
                              const Placement& placement) const override;
  [[nodiscard]] std::array<std::int64_t, 2>
  originStep(const shader::LichenNoise& noise, const MaterialNoise& material) const override;
  [[nodiscard]] std::array<std::int32_t, 2> cellOf(const shader::LichenNoise& noise,
                                                   const MaterialNoise& material,
                                                   std::int64_t tileX,
                                                   std::int64_t tileY) const override;
  void setMap(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
              shader::LichenMap& constants) const override;
  void setNoise(const Bundle& bundle, const Noise& noise,
                shader::LichenNoise& constants) const override;
  void setMaterial(const shader::LichenNoise& noise, const MaterialNoise& material,
                   const Placement& placement, shader::LichenMaterial& constants) const override;
};

} // namespace lichen
