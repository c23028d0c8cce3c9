// SPDX-License-Identifier: MIT
// A scene on a Vulkan device -> a picture: the average of frames that differ in where in the pixel
// they look, in the point of the sun that they are lit from, and in the parts of the sky that they
// find unhidden.
#pragma once

#include "debug_views.h"
#include "framing.h"
#include "scene.h"
#include "sky_cache.h"

#include <lichen/image.h>
#include <lichen/vulkan_device.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lichen::renderer {

class PipelineStore;

struct RenderSettings {
  std::uint32_t width = 1280;
  std::uint32_t height = 720;
  std::uint32_t frames = 16; ///< at least 1
  std::string camera;        ///< see chooseCamera()
  float exposureEv = 0.0f;   ///< stops
  bool toneMap = true;       ///< false: light as it is, for EXR
  std::string debugView;     ///< empty, or one of debugViewNames(); those are never tone-mapped
  std::optional<LinearImage> environment; ///< latitude-longitude; replaces the built-in sky
  SkyCache* skies = nullptr; ///< the caller's, for several pictures; null: each makes its own
  PipelineStore* pipelines = nullptr;                  ///< likewise, of the same device
  std::function<void(std::uint32_t frames)> frameDone; ///< called with how many are done, or empty
};

struct Picture {
  LinearImage pixels;             ///< RGB; tone-mapped values are the light of a display, in [0, 1]
  std::vector<std::string> notes; ///< what was left out or changed, one sentence each
  double setupSeconds = 0.0;
  double medianFrameSeconds = 0.0;
};

/// Errors: usage for a camera or view that does not exist or a size beyond the device's; badInput
/// for the scene's noise; environment and resources for what the device lacks. Waits for the
/// device; leaves nothing on it but the pipelines of a store that the settings have.
[[nodiscard]] Result<Picture> renderScene(VulkanDevice& device, const Scene& scene,
                                          const RenderSettings& settings);

} // namespace lichen::renderer
