// SPDX-License-Identifier: MIT
// Devices with and without the optional features of the depth maps' format.
#include "rendered.h"

using namespace lichen;
using namespace lichen::test;

namespace {

/// For its lifetime, limits the depth maps' format to these features and records the filters of
/// depth samplers.
class DepthFormat {
public:
  explicit DepthFormat(VkFormatFeatureFlags features)
      : realProperties_(vkGetPhysicalDeviceFormatProperties), realSampler_(vkCreateSampler) {
    current_ = this;
    features_ = features;
    vkGetPhysicalDeviceFormatProperties = properties;
    vkCreateSampler = sampler;
  }
  ~DepthFormat() {
    vkGetPhysicalDeviceFormatProperties = realProperties_;
    vkCreateSampler = realSampler_;
  }
  DepthFormat(const DepthFormat&) = delete;
  DepthFormat& operator=(const DepthFormat&) = delete;

  /// Filters of the comparison samplers, which only depth maps use.
  [[nodiscard]] const std::vector<VkFilter>& filters() const { return filters_; }

private:
  static void VKAPI_CALL properties(VkPhysicalDevice device, VkFormat format,
                                    VkFormatProperties* target) {
    current_->realProperties_(device, format, target);
    if (format == VK_FORMAT_D32_SFLOAT)
      target->optimalTilingFeatures = current_->features_;
  }
  static VkResult VKAPI_CALL sampler(VkDevice device, const VkSamplerCreateInfo* info,
                                     const VkAllocationCallbacks* callbacks, VkSampler* handle) {
    if (info->compareEnable) {
      current_->filters_.push_back(info->magFilter);
      current_->filters_.push_back(info->minFilter);
    }
    return current_->realSampler_(device, info, callbacks, handle);
  }

  static inline DepthFormat* current_ = nullptr;
  PFN_vkGetPhysicalDeviceFormatProperties realProperties_;
  PFN_vkCreateSampler realSampler_;
  VkFormatFeatureFlags features_ = 0;
  std::vector<VkFilter> filters_;
};

constexpr VkFormatFeatureFlags kDrawnAndSampled =
    VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;

GltfScene litBall() {
  GltfScene scene;
  const std::size_t grey = scene.addMaterial({{"pbrMetallicRoughness", {{"metallicFactor", 0}}}});
  scene.addBall(grey);
  scene.addGround(grey, 4.0f, -1.0f);
  scene.addCamera(5.0f, 0.8f, 1.0f);
  scene.addSun(3.0f);
  return scene;
}

} // namespace

TEST_CASE("shadows are filtered only if the device can filter depth") {
  const renderer::Scene scene = loaded(litBall());
  VulkanDevice& device = testDevice(); // loads the functions
  for (const bool filters : {false, true}) {
    device.messages().clear();
    const DepthFormat format(
        kDrawnAndSampled |
        (filters ? VkFormatFeatureFlags(VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT) : 0));
    CHECK(renderer::renderScene(device, scene, settingsOf(32, 32, 1)).ok());
    CHECK(format.filters() == std::vector(2, filters ? VK_FILTER_LINEAR : VK_FILTER_NEAREST));
    if (!filters)
      CHECK(device.messages().texts() == std::vector<std::string>{});
  }
  device.messages().clear(); // the device itself may lack the filter, like lavapipe
}

TEST_CASE("the error for a device that cannot render to or sample depth names the format") {
  const renderer::Scene scene = loaded(litBall());
  for (const VkFormatFeatureFlagBits only :
       {VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT, VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT}) {
    VulkanDevice& device = testDevice();
    const DepthFormat lesser(only);
    const auto drawn = renderer::renderScene(device, scene, settingsOf(32, 32, 1));
    REQUIRE_FALSE(drawn.ok());
    CHECK(drawn.error().kind == ErrorKind::environment);
    CHECK(drawn.error().message.find("VK_FORMAT_D32_SFLOAT") != std::string::npos);
  }
}
