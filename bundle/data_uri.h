// SPDX-License-Identifier: MIT
// Data URIs -> bytes. Sources: RFC 2397; base64: RFC 4648, section 4.
#pragma once

#include <lichen/result.h>

#include <cstddef>
#include <vector>

namespace lichen {

[[nodiscard]] bool isDataUri(const std::string& uri);

/// The bytes of a data URI in base64, with or without padding. Errors: badInput for other data,
/// base64 with another character, such as whitespace, or of an impossible length. Throws
/// std::bad_alloc.
[[nodiscard]] Result<std::vector<std::byte>> readDataUri(const std::string& uri);

} // namespace lichen
