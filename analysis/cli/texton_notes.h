// SPDX-License-Identifier: MIT
// What is said of textons when they are made: how near they are, whether that will do, and what is
// to be raised where it will not.
#pragma once

#include <lichen/bundle.h>
#include <lichen/texton.h>
#include <lichen/texton_mix.h>

#include <optional>
#include <string>

namespace lichen::cli {

/// That the exemplar is smaller than the support that was asked for.
[[nodiscard]] std::optional<std::string> supportNote(int supportWanted, const TextonShape& shape);

/// How near a texton is to the exemplar's Gaussian texture, and how `impacts` of it are to a normal
/// distribution.
[[nodiscard]] std::string qualityNote(const TextonQuality& quality, const TextonShape& shape,
                                      double impacts);

/// The same of the textons of a mix, and how near they are to each other.
[[nodiscard]] std::string qualityNote(const TextonMixQuality& quality, const TextonShape& shape);

} // namespace lichen::cli
