// SPDX-License-Identifier: MIT
// Checks the chunks (blocks of scan lines, or tiles) that an EXR header announces.
#pragma once

#include "exr_header.h"

namespace lichen {

/// Checks that every chunk of the full-resolution image lies inside the file and has enough bytes
/// for its pixels. Ignores the smaller levels of mip- or rip-mapped files, which are never read.
[[nodiscard]] Result<void> checkExrChunks(std::span<const std::byte> file, const ExrHeader& header,
                                          const std::string& name);

} // namespace lichen
