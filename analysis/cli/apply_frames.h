// SPDX-License-Identifier: MIT
// `lichen apply --mapping surface`: the option --grain, and the tangent frames it gives to meshes.
#pragma once

#include "command.h"

#include <lichen/bundle.h>
#include <lichen/surface_frames.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen::cli {

void addFrameOptions(CLI::App& verb, std::optional<Vector3>& grain);

/// The meshes that received frames, and notes on them and on what the frames change.
struct AddedFrames {
  std::vector<MeshFrames> meshes;
  std::vector<std::string> notes;
};

/// Adds the tangent frames that `surface` needs to the meshes that use one of the materials; any
/// other mapping needs none. Errors: usage for a grain with another mapping; the errors of
/// addSurfaceFrames().
[[nodiscard]] Result<AddedFrames>
addFrames(GltfScene& scene, std::span<const std::size_t> materials, const Noise& noise,
          Mapping mapping, const std::optional<Vector3>& grain, const SharedOptions& shared);

[[nodiscard]] nlohmann::ordered_json asJson(std::span<const MeshFrames> frames);

} // namespace lichen::cli
