// SPDX-License-Identifier: MIT
// Puts a noise on materials of an existing glTF scene: what `lichen apply` does between reading and
// writing the scene.
#pragma once

#include <lichen/exemplar_preparation.h>
#include <lichen/gltf_scene.h>
#include <lichen/surface_frames.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen {

/// The source of a material's mix weight: at most one. Without any, it is the source of
/// ApplyOptions::use, unless that is a texture, which belongs to another file.
struct MixOptions {
  std::optional<double> weight;
  std::optional<std::array<double, 4>> direction; ///< u, v of the start, then of the end
  std::string texture; ///< name of a PNG or JPEG, or the index of a texture in the scene
  std::optional<int> colorSet;
  std::optional<int> channel; ///< of the texture or the colours

  [[nodiscard]] bool isGiven() const {
    return weight || direction || !texture.empty() || colorSet || channel;
  }
};

struct ApplyOptions {
  std::vector<std::string> materials; ///< names or indices, or "all" alone
  MaterialNoise use;                  ///< how the materials use the noise; its noise is ignored
  std::optional<Vector3> grain; ///< surface: an axis of each mesh that the exemplar's rows follow
  MixOptions mix;
  bool setsFactors = false; ///< whether the factors that multiply the noise become 1
};

/// What was done to the scene.
struct NoiseOnScene {
  AppliedNoise noise;
  std::vector<std::string> materials; ///< titles of those that have the noise
  std::vector<MeshFrames> frames; ///< that were added, for surfaces
  std::vector<std::string> notes; ///< for the user, one sentence each
};

/// Adds noise `noise` of the bundle to the materials. Where all are chosen, those that cannot have
/// it are skipped, with a note. Adds the tangent frames that surfaces need, and removes material
/// extensions that would hide the noise. The step of `observer` is "apply"; it hears no notes.
/// Errors: usage for a noise or materials that are not there, and options that exclude each other
/// or do not fit the noise; badInput for a scene without materials, for meshes that lack what the
/// mapping or the mix needs, and for an unusable mask; as addSurfaceFrames() and
/// GltfScene::applyNoise(). After an error the scene may be partly changed: do not write it.
[[nodiscard]] Result<NoiseOnScene> applyNoise(GltfScene& scene, const Bundle& bundle,
                                              std::size_t noise, const ApplyOptions& options,
                                              const BakeObserver& observer = {});

/// The usage error of an option of mixes, for a noise that is none.
[[nodiscard]] Error notMixed(const std::string& option, const Noise& noise);

} // namespace lichen
