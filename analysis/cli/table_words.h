// SPDX-License-Identifier: MIT
// Text for tables and statistics, as `inspect` prints them.
#pragma once

#include <lichen/bundle.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lichen::cli {

struct FormatName {
  const char* name;
  int bits; ///< per channel
};
[[nodiscard]] FormatName formatName(TexelFormat format);

/// "inverse table 1: joint, 32 x 32 x 32 cells, 5 levels"; "no inverse table" for an absent index.
[[nodiscard]] std::string inverseTableWords(std::optional<std::size_t> index, int dimensions,
                                            const std::vector<Table>& tables);

/// "mean 0.310, 0.360; deviation 0.140, 0.130".
[[nodiscard]] std::string statisticsOf(const std::vector<double>& mean,
                                       const std::vector<double>& covariance);

} // namespace lichen::cli
