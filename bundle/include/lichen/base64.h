// SPDX-License-Identifier: MIT
// Bytes <-> base64, the text of data URIs. Source: RFC 4648, section 4.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lichen {

/// Returns the padded base64 text of `bytes`. Throws std::bad_alloc.
[[nodiscard]] std::string encodeBase64(std::span<const std::byte> bytes);

/// Decodes base64 with or without padding. Returns nothing for another character, such as
/// whitespace, or an impossible length. Throws std::bad_alloc.
[[nodiscard]] std::optional<std::vector<std::byte>> decodeBase64(std::string_view text);

} // namespace lichen
