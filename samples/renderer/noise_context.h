// SPDX-License-Identifier: MIT
// The engine plugin on the renderer's device: what an engine creates once.
#pragma once

#include "failure.h"

#include <lichen/lichen_vulkan.h>
#include <lichen/vulkan_device.h>

#include <memory>
#include <string>
#include <type_traits>

namespace lichen::renderer {

struct ReleaseLichen {
  void operator()(LichenBundle bundle) const { lichenDestroyBundle(bundle); }
  void operator()(LichenVulkanContext context) const { lichenVulkanDestroyContext(context); }
  void operator()(LichenVulkanAssets assets) const { lichenVulkanDestroyAssets(assets); }
};
/// An owned handle of the plugin.
template <class T>
using LichenOwned = std::unique_ptr<std::remove_pointer_t<T>, ReleaseLichen>;

/// A struct of the plugin with its type and size, and zeros.
template <class T>
T lichenStruct(LichenStructureType type) {
  T object;
  LICHEN_INIT(object, type);
  return object;
}

/// Throws a failure of the plugin. `file` names the file if the diagnostic does not.
void checkLichen(LichenResult result, const LichenDiagnostic& diagnostic,
                 const std::string& file = "");
/// The same for queries, which fail only where the renderer has a fault.
void checkLichen(LichenResult result);

class NoiseContext {
public:
  /// Throws a Failure: environment if the device has fewer descriptors than the shaders need.
  explicit NoiseContext(VulkanDevice& device);

  [[nodiscard]] LichenVulkanContext handle() const { return context_.get(); }
  /// The layout of every noise's set.
  [[nodiscard]] VkDescriptorSetLayout setLayout() const { return setLayout_; }

private:
  LichenOwned<LichenVulkanContext> context_;
  VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
};

/// Errors: environment if the fragment shaders' samplers and images exceed the device's limits,
/// which Vulkan lets be as low as 16 of each.
[[nodiscard]] Result<void> fitsDescriptors(const VkPhysicalDeviceLimits& limits);

} // namespace lichen::renderer
