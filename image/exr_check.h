// SPDX-License-Identifier: MIT
// Checks an EXR file with OpenEXR's C library before the C++ library decodes it. The C++ library
// allocates the sizes that a header claims before it compares them with the file.
// Source: "OpenEXR File Layout", openexr.com.
#pragma once

#include <lichen/result.h>

#include <cstddef>
#include <span>
#include <string>

namespace lichen {

/// Checks that every attribute and every chunk of the full-resolution image lies inside the file,
/// and that each chunk has enough bytes for its pixels. Ignores the smaller levels of mip- or
/// rip-mapped files, which are never read. Errors: badInput for another version, a multi-part or
/// deep file, an unknown compression, sides outside [1, kMaxImageSide], tiles over 4096 that are
/// larger than the image, a damaged attribute, a missing list of channels or description of tiles,
/// a missing or damaged chunk, and a chunk that cannot expand to its pixels; resources if memory
/// does not suffice.
[[nodiscard]] Result<void> checkExr(std::span<const std::byte> file, const std::string& name);

} // namespace lichen
