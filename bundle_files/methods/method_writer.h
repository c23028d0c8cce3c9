// SPDX-License-Identifier: MIT
// How the format writes a method's data. Each method has a MethodWriter, which method_writers.cpp
// lists.
#pragma once

#include <lichen/bundle.h>

#include <nlohmann/json.hpp>

namespace lichen {

/// Both append what MethodReader reads.
struct MethodWriter {
  void (*writeNoise)(const Noise& noise, nlohmann::ordered_json& json);
  void (*writeMap)(const NoiseMap& map, nlohmann::ordered_json& json);
};

[[nodiscard]] const MethodWriter& writerOf(Method method);

} // namespace lichen
