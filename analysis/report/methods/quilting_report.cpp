// SPDX-License-Identifier: MIT
// A quilting noise and its exemplar -> measures, and a picture of the cells.
#include "quilting_report.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace lichen {

using Json = nlohmann::ordered_json;

Result<std::vector<Risk>> QuiltingReport::assess(const AssessedMap&, const Progress&) const {
  return std::vector<Risk>();
}

Result<void> QuiltingReport::measure(const ComparedResult&, NoiseComparison& comparison) const {
  Result<std::vector<Measure>> measures = measureResult(comparison.exemplar, comparison.result);
  if (!measures)
    return measures.error();
  comparison.measures = std::move(measures).value();
  return {};
}

/// The pictures: the exemplar, the exemplar before flattening, a result of 2 x 2 exemplars, and the
/// cells.
double QuiltingReport::picturePixels() const { return 7.0; }

Result<Json> QuiltingReport::image(const Bundle& bundle, const Noise&, const NoiseMap& map, double,
                                   int side) const {
  const Table& table = bundle.tables[map.as<QuiltingMap>().cells];
  std::uint32_t level = 0;
  const auto extent = [&](std::uint32_t whole) { return std::max(1u, whole >> level); };
  while (level + 1 < table.mipLevels &&
         double(extent(table.width)) * extent(table.height) > double(side) * side)
    ++level;
  const std::vector<float> texels = decodeLevel(table, level);
  LinearImage image(int(extent(table.width)), int(extent(table.height)), 2);
  for (std::size_t i = 0; i < image.pixelCount(); ++i)
    std::copy_n(&texels[i * 4], 2, &image.values[i * 2]);
  Result<Json> shown = pictureJson(twoAsRedGreen(std::move(image)));
  if (!shown)
    return shown;
  shown.value()["title"] = "Cells";
  shown.value()["text"] = "The way from each texel to the centre of its cell: red to the right, "
                          "green down. Tiles are cut along the outlines of cells.";
  return shown;
}

Result<Json> QuiltingReport::table(const Bundle&, const NoiseMap&, const MapLook&) const {
  return Json();
}

} // namespace lichen
