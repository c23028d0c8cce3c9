// SPDX-License-Identifier: MIT
// The renderer as a host of the engine plugin: keeps the noises of a scene's materials on the
// device.
#pragma once

#include "gpu_objects.h"
#include "noise_changes.h"
#include "noise_context.h"
#include "scene.h"
#include "uniform_blocks.h"

#include <lichen/lichen.h>
#include <lichen/lichen_vulkan.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace lichen::renderer {

/// What the renderer needs to know of a material's noise besides the plugin's blocks.
struct NoiseUse {
  std::uint32_t texCoord = 0;
  bool inObjectSpace = false;
  /// Vector from the noise's tile origin to the renderer's origin, added to positions relative to
  /// the latter. The tile origin is a whole number of tiles from the world's origin. 0 for a noise
  /// that is not placed in world space.
  glm::vec3 fromTileOrigin{0.0f};
};

/// The plugin's LichenShaderSwitches, as far as the renderer's shaders take them.
struct NoiseSwitches {
  std::uint32_t methods = 0, mappings = 0, roles = 0, features = 0;
  [[nodiscard]] bool operator==(const NoiseSwitches&) const = default;
};

/// What the noises that are rendered use of the shaders.
struct NoiseFeatures {
  NoiseSwitches plain, layered; ///< of materials whose noise has no layers, and of the others
  bool objectSpaces = false;    ///< some noise is placed in object space
  [[nodiscard]] bool operator==(const NoiseFeatures&) const = default;
};

class NoiseHost {
public:
  /// Throws a Failure: badInput if the plugin rejects the bundle; environment if the device lacks a
  /// format. The context must outlive the object.
  NoiseHost(VulkanDevice& device, ObjectOwner& objects, const NoiseContext& context,
            const Scene& scene);

  /// Replaces the changes applied to the scene's noises. The results of all functions below may
  /// change.
  void change(const NoiseChanges& changes);

  /// Sets the point that device positions are relative to, for noises in world space; initially the
  /// world's origin.
  void setOrigin(const glm::dvec3& origin);

  /// Writes the materials' blocks of a frame.
  void fillBlocks() const;

  /// Whether a material renders with a noise. Some materials with the extension do not, for example
  /// for an unknown revision.
  [[nodiscard]] bool hasNoise(std::size_t material) const {
    return materials_[material].parameters.noise != LICHEN_NO_NOISE;
  }
  /// Whether the noise of a material that has one is layered.
  [[nodiscard]] bool isLayered(std::size_t material) const {
    return noises_[materials_[material].parameters.noise].layerCount > 1;
  }
  [[nodiscard]] const NoiseFeatures& features() const { return features_; }
  /// The set of the noise of a material that has one, and the dynamic offset of its block.
  [[nodiscard]] VkDescriptorSet set(std::size_t material) const {
    return sets_[materials_[material].parameters.noise];
  }
  [[nodiscard]] std::uint32_t dynamicOffset(std::size_t material) const {
    return blocks_.offset(material);
  }
  [[nodiscard]] const NoiseUse& use(std::size_t material) const { return materials_[material].use; }
  /// Side of the tiles for all mappings but uv, in the units of the noise's space; 0
  /// otherwise.
  [[nodiscard]] double tileSide(std::size_t material) const;

  /// What is not rendered of the materials' noises, or lacks precision at the current origin; one
  /// sentence each.
  [[nodiscard]] std::vector<std::string> notes() const;

private:
  struct MaterialState {
    LichenMaterialProperties properties{};
    LichenMaterialParameters own{};        ///< of the file
    LichenMaterialParameters parameters{}; ///< with the changes
    LichenPlacement placement{};
    NoiseUse use;
    bool displaces = false; ///< the surface
  };

  void loadBundle(VulkanDevice& device, const NoiseContext& context, const Scene& scene);
  void readNoises();
  void readMaterials(const Scene& scene);
  void createSets(VulkanDevice& device, ObjectOwner& objects);
  [[nodiscard]] LichenMaterialParameters changed(const LichenMaterialParameters& own) const;
  void readUse(MaterialState& material);
  [[nodiscard]] NoiseSwitches switchesOf(bool layered) const;
  void place(std::size_t material);

  // In order of dependency: destroyed last to first.
  LichenOwned<LichenBundle> bundle_;
  LichenOwned<LichenVulkanAssets> assets_;
  UniformBlocks blocks_;                      ///< one for each material
  std::vector<VkDescriptorSet> sets_;         ///< by noise
  std::vector<LichenNoiseProperties> noises_; ///< of the bundle
  std::vector<MaterialState> materials_;      ///< of the scene
  NoiseChanges changes_;
  glm::dvec3 origin_{0.0};
  NoiseFeatures features_;
  /// notes of the file, of the last change() and of the last setOrigin()
  std::set<std::string> fileNotes_, changeNotes_, originNotes_;
};

} // namespace lichen::renderer
