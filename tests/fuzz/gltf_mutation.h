// SPDX-License-Identifier: MIT
// Small deterministic mutations of a glTF file: bytes anywhere, and JSON values, which mutated
// bytes rarely reach.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <random>
#include <vector>

namespace lichen::fuzz {

using Bytes = std::vector<std::byte>;
using Random = std::mt19937_64; // the standard defines its sequence, but not those of distributions

[[nodiscard]] std::size_t below(Random& random, std::size_t limit);

/// Flips a bit, writes a 32-bit edge value, truncates the file or removes a few bytes.
void mutateBytes(Bytes& file, Random& random);

/// Replaces, removes or repeats a JSON value, or copies one over another.
void mutateJson(nlohmann::json& root, Random& random);

} // namespace lichen::fuzz
