// SPDX-License-Identifier: MIT
// Text for tables and statistics, as `inspect` prints them.
#pragma once

#include <lichen/bundle.h>

#include <string>
#include <vector>

namespace lichen::cli {

struct FormatName {
  const char* name;
  int bits; ///< per channel
};
[[nodiscard]] FormatName formatName(TexelFormat format);

/// "mean 0.310, 0.360; deviation 0.140, 0.130".
[[nodiscard]] std::string statisticsOf(const std::vector<double>& mean,
                                       const std::vector<double>& covariance);

} // namespace lichen::cli
