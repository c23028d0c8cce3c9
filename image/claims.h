// SPDX-License-Identifier: MIT
// Checks of the sizes that a file's header or a caller's image claims, before anything relies on
// them, and the resulting errors. Text from files is sanitised for one-line messages.
#pragma once

#include <lichen/image_io.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace lichen {

/// An Error "name: reason" of kind badInput.
[[nodiscard]] Error badInput(const std::string& name, const std::string& reason);

/// An Error "name: not enough memory to ..." of kind resources.
[[nodiscard]] Error outOfMemory(const std::string& name, const char* purpose) noexcept;

/// `text` with everything except printable ASCII replaced by '?', truncated for a message.
[[nodiscard]] std::string printable(std::string_view text);

/// The maximum expansion of a compression.
struct Expansion {
  const char* compression;      ///< name for messages
  std::uint64_t maximumPerByte; ///< decoded bytes per byte of the file
};

/// badInput if a side is outside [1, kMaxImageSide].
[[nodiscard]] Result<void> checkSides(const std::string& name, std::uint64_t width,
                                      std::uint64_t height);

/// Calls the caller's check of the size, if there is one.
[[nodiscard]] inline Result<void> checkWanted(const SizeCheck& check, std::uint64_t width,
                                              std::uint64_t height) {
  return check ? check(int(width), int(height)) : Result<void>();
}

/// badInput if `fileBytes` bytes cannot expand to `decoded` bytes.
[[nodiscard]] Result<void> checkExpansion(const std::string& name, std::uint64_t decoded,
                                          std::uint64_t fileBytes, const Expansion& expansion);

/// Checks an image before encoding: usage for invalid sides, channels outside [1, 4] or a number of
/// values that is not their product; badInput for NaN or infinity. Messages start with `format`.
[[nodiscard]] Result<void> checkEncodable(const std::string& format, int width, int height,
                                          int channels, std::span<const float> values);

} // namespace lichen
