// SPDX-License-Identifier: MIT
// The renderer as a host of the engine plugin: keeps the noises of a scene's materials on the
// device.
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

/// What the shaders need to know about a material's noise besides the uniform block.
struct NoiseRoles {
  /// index of the map of each role; -1 for none
  std::array<int, NOISE_ROLES> map{-1, -1, -1, -1, -1};
  /// Component of the ORM map's value for occlusion, roughness, metallic; -1 for none.
  std::array<int, 3> ormComponents{-1, -1, -1};
  std::uint32_t texCoord = 0;
  bool inObjectSpace = false;
  /// Vector from the noise's tile origin to the renderer's origin, added to positions relative to
  /// the latter. The tile origin is a whole number of tiles from the world's origin. 0 for a noise
  /// that is not placed in world space.
  glm::vec3 fromTileOrigin{0.0f};
};

class NoiseHost {
public:
  /// Throws a Failure: badInput if the plugin rejects the bundle; environment if the device lacks a
  /// format. Does not call the plugin if the scene has no noise materials.
  NoiseHost(VulkanDevice& device, ObjectOwner& objects, const Scene& scene);

  /// Replaces the changes applied to the scene's noises. The results of all functions below may
  /// change. No frame may be in flight. Throws a Failure: usage for a noise that the bundle does
  /// not contain.
  void change(VkDevice device, const NoiseChanges& changes);

  /// Sets the point that device positions are relative to, for noises in world space; initially the
  /// world's origin. No frame may be in flight.
  void setOrigin(const glm::dvec3& origin);

  /// Whether a material renders with a noise. Some materials with the extension do not, for example
  /// for an unknown revision.
  [[nodiscard]] bool hasNoise(std::size_t material) const {
    return noises_[material] != LICHEN_NO_NOISE;
  }
  /// Whether any map of a rendered tiling noise has no inverse table.
  [[nodiscard]] bool hasGaussianOnly() const { return hasGaussianOnly_; }
  /// Whether any of the rendered noises is a tiling noise, or a texton noise.
  [[nodiscard]] bool hasTilingNoises() const { return hasTilingNoises_; }
  [[nodiscard]] bool hasTextonNoises() const { return hasTextonNoises_; }
  /// Whether any of the rendered noises uses surface mapping.
  [[nodiscard]] bool hasSurfaceNoises() const { return hasSurfaceNoises_; }
  /// Whether any of the rendered noises uses triplanar mapping, and whether any uses another
  /// mapping.
  [[nodiscard]] bool hasTriplanarNoises() const { return hasTriplanarNoises_; }
  [[nodiscard]] bool hasOtherMappings() const { return hasOtherMappings_; }
  /// Whether any of the rendered noises is placed in object space.
  [[nodiscard]] bool hasObjectSpaces() const { return hasObjectSpaces_; }
  /// Whether any of the rendered texton noises is a mix.
  [[nodiscard]] bool hasMixes() const { return hasMixes_; }
  /// Whether any of the rendered noises rotates its tiles.
  [[nodiscard]] bool hasTileRotation() const { return hasTileRotation_; }
  [[nodiscard]] VkDescriptorSetLayout setLayout() const { return setLayout_; }
  /// The descriptor set of a material. Without a noise, its images are 1 x 1 placeholders.
  [[nodiscard]] VkDescriptorSet set(std::size_t material) const { return sets_[material]; }
  /// Names of the bundle's noises as stored in the file; may be empty strings.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] const NoiseRoles& roles(std::size_t material) const { return roles_[material]; }
  /// Side of the tiles for triplanar and surface mapping, in the units of the noise's space; 0
  /// otherwise.
  [[nodiscard]] double tileSide(std::size_t material) const;

  /// What is not rendered of the materials' noises, or lacks precision at the current origin; one
  /// sentence each.
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

  // In order of dependency: destroyed last to first.
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
  /// index of the noise that each material renders with, or LICHEN_NO_NOISE
  std::vector<std::uint32_t> noises_;
  std::vector<NoiseRoles> roles_;
  std::vector<VkDescriptorSet> sets_;
  NoiseChanges changes_;
  glm::dvec3 origin_{0.0};
  /// notes of the file, of the last change() and of the last setOrigin()
  std::set<std::string> fileNotes_, changeNotes_, originNotes_;
  bool hasGaussianOnly_ = false;
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
