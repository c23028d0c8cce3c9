// SPDX-License-Identifier: MIT
// The chunks (blocks of scan lines, or tiles) that an EXR header promises.
#pragma once

#include "exr_header.h"

namespace lichen {

/// Checks that every chunk of the full-resolution image lies inside the file and holds enough bytes
/// for its pixels. The smaller levels of a mip- or rip-mapped file are neither read nor checked.
[[nodiscard]] Result<void> checkExrChunks(std::span<const std::byte> file, const ExrHeader& header,
                                          const std::string& name);

} // namespace lichen
