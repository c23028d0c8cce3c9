// SPDX-License-Identifier: MIT
// Small changes to a glTF file, the same for the same random numbers: bytes anywhere, and values
// of its JSON, which bytes alone hardly reach.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <random>
#include <vector>

namespace lichen::fuzz {

using Bytes = std::vector<std::byte>;
using Random = std::mt19937_64; // the standard fixes its sequence, not that of distributions

[[nodiscard]] std::size_t below(Random& random, std::size_t limit);

/// Flips a bit, writes an edge of the 32-bit integers, cuts the file off or removes a few bytes.
void mutateBytes(Bytes& file, Random& random);

/// Replaces, removes or repeats a value of the document, or copies one over another.
void mutateJson(nlohmann::json& root, Random& random);

} // namespace lichen::fuzz
