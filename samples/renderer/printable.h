// SPDX-License-Identifier: MIT
// Text from a file or a user, made safe for a message.
#pragma once

#include <cstddef>
#include <string>

namespace lichen::renderer {

/// `text` in escaped() form. Text beyond `maxLength` bytes is cut at a UTF-8 character and ends in
/// "...".
[[nodiscard]] std::string printable(const std::string& text, std::size_t maxLength = 60);

} // namespace lichen::renderer
