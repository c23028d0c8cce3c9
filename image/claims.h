// SPDX-License-Identifier: MIT
// What a file's header or a caller's image claims, checked before anything relies on it, and the
// errors that say so. Text that comes out of a file is made fit for a one-line message.
#pragma once

#include <lichen/image_io.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace lichen {

/// "name: reason" as ErrorKind::badInput.
[[nodiscard]] Error refused(const std::string& name, const std::string& reason);

/// "name: not enough memory to ..." as ErrorKind::resources.
[[nodiscard]] Error outOfMemory(const std::string& name, const char* purpose) noexcept;

/// `text` with everything but printable ASCII replaced by '?', cut to a length that fits a message.
[[nodiscard]] std::string printable(std::string_view text);

/// The most that one byte of a file can become, by its compression.
struct Expansion {
  const char* compression;      ///< as it appears in the message
  std::uint64_t maximumPerByte; ///< decoded bytes from each byte of the file
};

/// Refuses sides outside [1, kMaxImageSide].
[[nodiscard]] Result<void> checkSides(const std::string& name, std::uint64_t width,
                                      std::uint64_t height);

/// What the caller says of the size.
[[nodiscard]] inline Result<void> checkWanted(const SizeCheck& check, std::uint64_t width,
                                              std::uint64_t height) {
  return check ? check(int(width), int(height)) : Result<void>();
}

/// Refuses a claim of `decoded` bytes that a file of `fileBytes` bytes cannot hold.
[[nodiscard]] Result<void> checkExpansion(const std::string& name, std::uint64_t decoded,
                                          std::uint64_t fileBytes, const Expansion& expansion);

/// Refuses to encode an image of other sides, channels outside [1, 4] or a number of values that is
/// not their product (usage), or a NaN or infinite value (badInput). `format` begins the message.
[[nodiscard]] Result<void> checkEncodable(const std::string& format, int width, int height,
                                          int channels, std::span<const float> values);

} // namespace lichen
