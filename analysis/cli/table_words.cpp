// SPDX-License-Identifier: MIT
// Tables and statistics -> text.
#include "table_words.h"

#include <lichen/counted.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lichen::cli {

FormatName formatName(TexelFormat format) {
  switch (format) {
  case TexelFormat::r8Unorm:
    return {"R8", 8};
  case TexelFormat::rg8Unorm:
    return {"RG8", 8};
  case TexelFormat::rgba8Unorm:
    return {"RGBA8", 8};
  case TexelFormat::r16Sfloat:
    return {"R16F", 16};
  case TexelFormat::rg16Sfloat:
    return {"RG16F", 16};
  case TexelFormat::rgba16Sfloat:
    return {"RGBA16F", 16};
  case TexelFormat::r32Sfloat:
    return {"R32F", 32};
  case TexelFormat::rgba32Sfloat:
    break;
  }
  return {"RGBA32F", 32};
}

std::string statisticsOf(const std::vector<double>& mean, const std::vector<double>& covariance) {
  std::vector<double> deviations;
  for (std::size_t c = 0; c < mean.size(); ++c)
    deviations.push_back(std::sqrt(std::max(0.0, covariance[c * (mean.size() + 1)])));
  return fmt::format("mean {:.3f}; deviation {:.3f}", fmt::join(mean, ", "),
                     fmt::join(deviations, ", "));
}

std::string inverseTableWords(std::optional<std::size_t> index, int dimensions,
                              const std::vector<Table>& tables) {
  if (!index)
    return "no inverse table";
  const Table& table = tables[*index];
  std::string cells = std::to_string(table.width);
  for (int axis = 1; axis < dimensions; ++axis)
    cells += fmt::format(" x {}", table.width);
  return fmt::format("inverse table {}: joint, {} cells, {}", *index, cells,
                     counted(table.mipLevels, "level"));
}

} // namespace lichen::cli
