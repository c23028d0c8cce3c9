// SPDX-License-Identifier: MIT
// The renderer as a host of the engine plugin: the noises of a scene's materials on the device.
#pragma once

#include "gpu_objects.h"
#include "noise_changes.h"
#include "scene.h"
#include "shaders/scene_interface.h"

#include <lichen/lichen.h>
#include <lichen/lichen_vulkan.h>

#include <array>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace lichen::renderer {

/// What the shaders must know of a material's noise beside the uniform block.
struct NoiseRoles {
  std::array<int, NOISE_ROLES> map{-1, -1, -1, -1, -1}; ///< of each role; -1 for none
  /// Which component of the ORM map's value is occlusion, roughness, metallic; -1 for none.
  std::array<int, 3> ormComponents{-1, -1, -1};
  std::uint32_t texCoord = 0;
  bool inObjectSpace = false;
  /// What a place relative to the renderer's origin is farther from the noise's, which is a whole
  /// number of tiles from the world's: 0 for a noise that does not lie in the world.
  glm::vec3 fromTileOrigin{0.0f};
};

class NoiseHost {
public:
  /// Throws a Failure: badInput for a bundle that the plugin refuses, environment for a device that
  /// lacks a format. Without noise materials in the scene the plugin is not called.
  NoiseHost(VulkanDevice& device, ObjectOwner& objects, const Scene& scene);

  /// Draws the scene's noises with these changes in place of earlier ones. All that is told below
  /// may be different then. No frame may be in flight. Throws a Failure: usage for a noise that the
  /// bundle does not have.
  void change(VkDevice device, const NoiseChanges& changes);

  /// Draws noises that lie in the world for places relative to `origin`; at first it is the
  /// world's. No frame may be in flight.
  void place(const glm::dvec3& origin);

  /// Whether a material is drawn with a noise: some are not, though they carry the extension.
  [[nodiscard]] bool hasNoise(std::size_t material) const {
    return noises_[material] != LICHEN_NO_NOISE;
  }
  /// Whether some tiling noise that is drawn has another table than a joint one.
  [[nodiscard]] bool hasOtherTables() const { return hasOtherTables_; }
  /// Whether some noise that is drawn is one of tiling, of textons.
  [[nodiscard]] bool hasTilingNoises() const { return hasTilingNoises_; }
  [[nodiscard]] bool hasTextonNoises() const { return hasTextonNoises_; }
  /// Whether some noise that is drawn is mapped onto a surface, without texture coordinates.
  [[nodiscard]] bool hasSurfaceNoises() const { return hasSurfaceNoises_; }
  /// Whether some noise that is drawn is mapped onto three planes, and whether some is otherwise.
  [[nodiscard]] bool hasTriplanarNoises() const { return hasTriplanarNoises_; }
  [[nodiscard]] bool hasOtherMappings() const { return hasOtherMappings_; }
  /// Whether some noise that is drawn is placed in the space of its objects.
  [[nodiscard]] bool hasObjectSpaces() const { return hasObjectSpaces_; }
  /// Whether some texton noise that is drawn is a mix.
  [[nodiscard]] bool hasMixes() const { return hasMixes_; }
  /// Whether some noise that is drawn turns its tiles.
  [[nodiscard]] bool hasTileRotation() const { return hasTileRotation_; }
  [[nodiscard]] VkDescriptorSetLayout setLayout() const { return setLayout_; }
  /// The set of a material; of one without noise, a set of 1 x 1 images.
  [[nodiscard]] VkDescriptorSet set(std::size_t material) const { return sets_[material]; }
  /// Of the bundle's noises, as the file has them; may be empty.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] const NoiseRoles& roles(std::size_t material) const { return roles_[material]; }
  /// Side of the tiles of a noise that lies in space, in its units; 0 for others.
  [[nodiscard]] double tileSide(std::size_t material) const;

  /// What of the materials' noises is not drawn, or coarse where they are placed, one sentence
  /// each.
  [[nodiscard]] std::vector<std::string> notes() const;

private:
  struct Release {
    void operator()(LichenBundle bundle) const { lichenDestroyBundle(bundle); }
    void operator()(LichenVulkanContext context) const { lichenVulkanDestroyContext(context); }
    void operator()(LichenVulkanAssets assets) const { lichenVulkanDestroyAssets(assets); }
  };
  template <class T>
  using Owned = std::unique_ptr<std::remove_pointer_t<T>, Release>;

  void loadBundle(VulkanDevice& device, const Scene& scene);
  void createPlaceholders(VulkanDevice& device, ObjectOwner& objects);
  void readMaterials(const Scene& scene);
  void createSets(VulkanDevice& device, ObjectOwner& objects, std::size_t materials);
  [[nodiscard]] LichenUniformInfo uniformInfo(std::uint32_t material) const;
  [[nodiscard]] LichenMapping mappingOf(const LichenUniformInfo& info) const;
  [[nodiscard]] double tileSide(const LichenUniformInfo& info) const;
  void setTileOrigin(LichenUniformInfo& info);
  void fillUniforms(std::uint32_t material);
  void writeNoiseSet(VkDevice device, std::size_t material) const;
  [[nodiscard]] NoiseRoles rolesOf(std::uint32_t noise, std::uint32_t texCoord);
  [[nodiscard]] std::array<VkDescriptorImageInfo, 2 * NOISE_ROLES>
  imageInfos(std::uint32_t noise, const NoiseRoles& roles) const;

  // In the order in which they depend on one another.
  Owned<LichenBundle> bundle_;
  Owned<LichenVulkanContext> context_;
  Owned<LichenVulkanAssets> assets_;
  DeviceImage placeholder2d_;
  DeviceImage placeholder3d_;
  VkSampler placeholderSampler_ = VK_NULL_HANDLE;
  DeviceBuffer uniforms_;
  VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
  std::vector<std::string> names_;
  std::vector<LichenMaterialProperties> materials_; ///< of the bundle
  std::vector<std::uint32_t> noises_; ///< drawn, of each material; LICHEN_NO_NOISE for none
  std::vector<NoiseRoles> roles_;
  std::vector<VkDescriptorSet> sets_;
  NoiseChanges changes_;
  glm::dvec3 origin_{0.0};
  std::set<std::string> fileNotes_, drawnNotes_, placeNotes_; ///< of what the last call has set
  bool hasOtherTables_ = false;
  bool hasTilingNoises_ = false;
  bool hasTextonNoises_ = false;
  bool hasSurfaceNoises_ = false;
  bool hasTriplanarNoises_ = false;
  bool hasOtherMappings_ = false;
  bool hasMixes_ = false;
  bool hasObjectSpaces_ = false;
  bool hasTileRotation_ = false;
};

} // namespace lichen::renderer
