// SPDX-License-Identifier: MIT
// Pixels -> bytes, by measured factors.
#include <lichen/bake_memory.h>

#include <fmt/format.h>

#include <algorithm>

namespace lichen {
namespace {

/// Bytes per pixel of a file while it is read: the file's bytes and the pixels as floats. Measured
/// at the peak of `lichen bake`, without the program's own 25 MB.
constexpr double kRead = 28.0;

} // namespace

Result<void> MemoryNeed::add(const std::string& name, int width, int height) {
  const std::uint64_t pixels = std::uint64_t(width) * std::uint64_t(height);
  const std::uint64_t kept = keptPixels_.value_or(pixels);
  read_ += pixels;
  kept_ += kept;
  largestKept_ = std::max(largestKept_, kept);
  const double needed = std::max(kRead * double(read_),
                                 bake_.map * double(kept_) + bake_.largest * double(largestKept_));
  if (!available_ || needed <= double(*available_))
    return {};
  constexpr double kGiga = 1e9;
  const bool isEnlarged = kept > pixels;
  const std::string size = words_({"size", ""});
  return Error{
      ErrorKind::resources,
      fmt::format("{}: {} x {} pixels{} need about {:.1f} GB of memory{}, and {:.1f} GB are "
                  "available; use {}",
                  name, width, height, isEnlarged ? ", enlarged by " + size + "," : "",
                  needed / kGiga, read_ > pixels ? " with the images before them" : "",
                  double(*available_) / kGiga,
                  isEnlarged ? "a smaller " + size : words_({"crop", ""}) + " or " + size)};
}

} // namespace lichen
