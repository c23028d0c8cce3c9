// SPDX-License-Identifier: MIT
// Text from a file or a user, fit for a message.
#pragma once

#include <cstddef>
#include <string>

namespace lichen::renderer {

/// `text` on one line: control characters replaced, cut to `maxLength` bytes.
[[nodiscard]] inline std::string printable(const std::string& text, std::size_t maxLength = 60) {
  std::string line = text.substr(0, maxLength);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      c = '?';
  return text.size() > maxLength ? line + "..." : line;
}

} // namespace lichen::renderer
