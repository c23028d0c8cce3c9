// SPDX-License-Identifier: MIT
// Map -> OKLab, a space in which distances are near to those that people see.
#pragma once

#include <lichen/exemplar.h>

#include <array>
#include <vector>

namespace lichen::layers {

/// Lightness, green to red, blue to yellow.
using Lab = std::array<float, 3>;

/// [O20]: OKLab of red, green and blue light. Light may exceed 1.
[[nodiscard]] Lab oklab(float red, float green, float blue);

/// The colour of each pixel. Maps with fewer than three channels repeat the last one. Throws
/// std::bad_alloc.
[[nodiscard]] std::vector<Lab> oklabOf(const MapExemplar& map);

} // namespace lichen::layers
