// SPDX-License-Identifier: MIT
// The frames of --mapping surface: the option that steers them, and what is said of them.
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

/// The meshes that were given a frame, and notes on those and on what they change.
struct AddedFrames {
  std::vector<MeshFrames> meshes;
  std::vector<std::string> notes;
};

/// Gives the meshes that have one of the materials what the mapping of a noise needs: nothing but
/// for `surface`. Errors: usage for a grain with another mapping; those of addSurfaceFrames().
[[nodiscard]] Result<AddedFrames>
addFrames(GltfScene& scene, std::span<const std::size_t> materials, const Noise& noise,
          Mapping mapping, const std::optional<Vector3>& grain, const SharedOptions& shared);

[[nodiscard]] nlohmann::ordered_json asJson(std::span<const MeshFrames> frames);

} // namespace lichen::cli
