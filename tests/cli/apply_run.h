// SPDX-License-Identifier: MIT
// Runs `lichen apply` on scenes and noises that it writes.
#pragma once

#include "command_run.h"

#include <nlohmann/json.hpp>

#include <string>
#include <tiny_scene.h>

namespace lichen::cli_test {

inline constexpr const char* kExtension = "LICHEN_materials_exemplar_noise";

[[nodiscard]] Ended apply(const Workplace& workplace, const std::string& scene,
                          const std::string& noise, const std::string& material,
                          const Arguments& more = {}, const std::string& output = "out.glb");

/// Runs `lichen apply`, requires that `lichen check` accepts the result, and returns its document.
[[nodiscard]] nlohmann::json applied(const Workplace& workplace, const std::string& scene,
                                     const std::string& noise, const std::string& material,
                                     const Arguments& more = {},
                                     const std::string& output = "out.glb");

[[nodiscard]] std::string writeScene(const Workplace& workplace, const example::TinyScene& scene);

[[nodiscard]] std::string writeTexton(const Workplace& workplace);

} // namespace lichen::cli_test
