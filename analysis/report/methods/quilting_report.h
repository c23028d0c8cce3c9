// SPDX-License-Identifier: MIT
// How the report judges quilting and shows its data.
#pragma once

#include "method_report.h"

namespace lichen {

class QuiltingReport final : public MethodReport {
public:
  [[nodiscard]] Result<std::vector<Risk>> assess(const AssessedMap& assessed,
                                                 const Progress& progress) const override;
  [[nodiscard]] bool enlargesMaps() const override { return false; }
  [[nodiscard]] Result<void> measure(const ComparedResult& result,
                                     NoiseComparison& comparison) const override;
  [[nodiscard]] double picturePixels() const override;
  [[nodiscard]] Result<nlohmann::ordered_json> image(const Bundle& bundle, const Noise& noise,
                                                     const NoiseMap& map, double mixWeight,
                                                     int side) const override;
  [[nodiscard]] Result<nlohmann::ordered_json>
  furtherImages(const Bundle& bundle, const Noise& noise, const NoiseMap& map, const MapLook& look,
                int side) const override;
  [[nodiscard]] Result<nlohmann::ordered_json> table(const Bundle& bundle, const NoiseMap& map,
                                                     const MapLook& look) const override;
};

} // namespace lichen
