// SPDX-License-Identifier: MIT
// Tables and statistics -> text.
#include "table_words.h"

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

} // namespace lichen::cli
