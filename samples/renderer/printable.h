// SPDX-License-Identifier: MIT
// Text from a file or a user, fit for a message.
#pragma once

#include <cstddef>
#include <string>

namespace lichen::renderer {

/// escaped() of `text`, of a longer text its first `maxLength` bytes, down to a whole character of
/// UTF-8.
[[nodiscard]] std::string printable(const std::string& text, std::size_t maxLength = 60);

} // namespace lichen::renderer
