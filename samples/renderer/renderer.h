// SPDX-License-Identifier: MIT
// Renders a scene to a picture: the average of frames with different subpixel offsets, points on
// the sun and sky directions.
#pragma once

#include "debug_views.h"
#include "displacement.h"
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
  bool toneMap = true;       ///< false: linear light, for EXR
  std::string debugView;     ///< empty, or one of debugViewNames(), which are never tone-mapped
  Displacement displacement;
  std::optional<LinearImage> environment; ///< latitude-longitude; replaces the built-in sky
  SkyCache* skies = nullptr; ///< shared between several pictures; null: the renderer uses its own
  PipelineStore* pipelines = nullptr; ///< shared between pictures of one device, or null
  /// called after each frame with the number of finished frames; may be empty
  std::function<void(std::uint32_t frames)> frameDone;
};

struct Picture {
  LinearImage pixels;             ///< RGB; tone-mapped values are linear display light in [0, 1]
  std::vector<std::string> notes; ///< what was ignored or changed, one sentence each
  double setupSeconds = 0.0;
  double medianFrameSeconds = 0.0;
};

/// Errors: usage for an unknown camera or debug view, or a size beyond the device's limit; badInput
/// for invalid noise data; environment and resources for what the device lacks. Blocks until the
/// device has finished, and frees all its objects but the pipelines of a store in the settings.
[[nodiscard]] Result<Picture> renderScene(VulkanDevice& device, const Scene& scene,
                                          const RenderSettings& settings);

} // namespace lichen::renderer
