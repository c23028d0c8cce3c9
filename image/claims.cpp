// SPDX-License-Identifier: MIT
// Checks of claimed sizes, and error messages of image files.
#include "claims.h"

#include <lichen/counted.h>
#include <lichen/image_io.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

constexpr std::size_t kMaxQuotedLength = 120; // keeps a message readable on one line

} // namespace

Error badInput(const std::string& name, const std::string& reason) {
  return {ErrorKind::badInput, name + ": " + reason};
}

Error outOfMemory(const std::string& name, const char* purpose) noexcept {
  return memoryError([&] { return name + ": not enough memory to " + purpose; });
}

std::string printable(std::string_view text) {
  std::string result(text.substr(0, kMaxQuotedLength));
  for (char& c : result)
    if (c < ' ' || c > '~')
      c = '?';
  if (text.size() > kMaxQuotedLength)
    result += "...";
  return result;
}

Result<void> checkSides(const std::string& name, std::uint64_t width, std::uint64_t height) {
  constexpr std::uint64_t kMaxSide = kMaxImageSide;
  if (width >= 1 && height >= 1 && width <= kMaxSide && height <= kMaxSide)
    return {};
  return badInput(name, std::to_string(width) + " x " + std::to_string(height) +
                            " pixels; each side must be 1 to " + std::to_string(kMaxSide));
}

Result<void> checkExpansion(const std::string& name, std::uint64_t decoded, std::uint64_t fileBytes,
                            const Expansion& expansion) {
  if (decoded / expansion.maximumPerByte <= fileBytes)
    return {};
  return badInput(name, "claims " + std::to_string(decoded) + " bytes of pixels in a file of " +
                            counted(fileBytes, "byte") + "; " + expansion.compression +
                            " expands at most " + counted(expansion.maximumPerByte, "time"));
}

Result<void> checkEncodable(const std::string& format, int width, int height, int channels,
                            std::span<const float> values) {
  const auto side = [](int length) { return std::uint64_t(std::max(length, 0)); };
  if (Result<void> sides = checkSides(format, side(width), side(height)); !sides)
    return Error{ErrorKind::usage, sides.error().message};
  if (channels < 1 || channels > 4)
    return Error{ErrorKind::usage,
                 format + ": " + std::to_string(channels) + " channels; expected 1 to 4"};
  const std::size_t expected = std::size_t(width) * std::size_t(height) * std::size_t(channels);
  if (values.size() != expected)
    return Error{ErrorKind::usage, format + ": " + counted(values.size(), "value") +
                                       "; the image's size requires " + std::to_string(expected)};
  const auto bad =
      std::find_if(values.begin(), values.end(), [](float value) { return !std::isfinite(value); });
  if (bad != values.end())
    return badInput(format, "value " + std::to_string(bad - values.begin()) + " is " +
                                std::to_string(*bad) + "; all values must be finite");
  return {};
}

} // namespace lichen
