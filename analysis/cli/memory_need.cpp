// SPDX-License-Identifier: MIT
// Pixels -> bytes, as measured; see memory_need.h.
#include "memory_need.h"

#include <fmt/format.h>

#include <algorithm>

namespace lichen::cli {
namespace {

/// Bytes a pixel of what is made of an exemplar.
struct Share {
  double map;     ///< of each map
  double largest; ///< and once, of the largest map
};

// Peaks of `lichen bake`, measured beside the program's own 25 MB: of one map of 512, 1024 and 2048
// pixels a side 139 to 148 bytes a pixel with tiling and 90 to 101 with textons, of four maps of
// 1024 together 238 and 275; of one of 8192 with tiling 161 (docs/benchmarks.md).
constexpr Share kTiling{32.0, 128.0};
constexpr Share kTextons{60.0, 40.0};
constexpr double kRead = 28.0; ///< likewise of a file, its bytes and its pixels as floats

Share shareOf(ExemplarUse use) {
  switch (use) {
  case ExemplarUse::tiling:
    return kTiling;
  case ExemplarUse::textons:
    return kTextons;
  case ExemplarUse::comparison:
    break;
  }
  return {};
}

} // namespace

Result<void> MemoryNeed::add(const std::string& name, int width, int height) {
  const std::uint64_t pixels = std::uint64_t(width) * std::uint64_t(height);
  const std::uint64_t kept = keptPixels_.value_or(pixels);
  read_ += pixels;
  kept_ += kept;
  largestKept_ = std::max(largestKept_, kept);
  const Share share = shareOf(use_);
  const double needed = std::max(kRead * double(read_),
                                 share.map * double(kept_) + share.largest * double(largestKept_));
  if (!available_ || needed <= double(*available_))
    return {};
  constexpr double kGiga = 1e9;
  return Error{ErrorKind::resources,
               fmt::format("{}: {} x {} pixels need about {:.1f} GB of memory{}, and {:.1f} GB are "
                           "available; --crop or --size makes them fewer",
                           name, width, height, needed / kGiga,
                           read_ > pixels ? " with the images before" : "",
                           double(*available_) / kGiga)};
}

} // namespace lichen::cli
