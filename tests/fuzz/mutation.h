// SPDX-License-Identifier: MIT
// Small deterministic mutations of a file: bytes anywhere, and JSON values of glTF, which mutated
// bytes rarely reach; and the program that replays them.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <functional>
#include <random>
#include <span>
#include <vector>

namespace lichen::fuzz {

using Bytes = std::vector<std::byte>;
using Random = std::mt19937_64; // the standard defines its sequence, but no distribution's

[[nodiscard]] std::size_t below(Random& random, std::size_t limit);

/// Flips a bit, overwrites an integer with an edge value, truncates the file, replaces its end with
/// another file's, or removes or repeats a block.
void mutateBytes(Bytes& file, const std::vector<Bytes>& files, Random& random);

/// Replaces, removes or repeats a JSON value, or copies one over another.
void mutateJson(nlohmann::json& root, Random& random);

/// The main() of a replay. With the arguments CASES SEED, and perhaps a FOLDER of files on which
/// the reader once failed, runs those and `CASES` of `mutated` through the fuzzer's entry point.
/// With `corpus FOLDER`, writes the seeds as a corpus for libFuzzer.
int replay(std::span<char* const> arguments, const std::vector<Bytes>& seeds,
           const std::function<Bytes(Random&)>& mutated);

} // namespace lichen::fuzz
