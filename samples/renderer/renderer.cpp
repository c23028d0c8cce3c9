// SPDX-License-Identifier: MIT
// Renders one picture with a SceneRenderer and times it.
#include "renderer.h"

#include "failure.h"
#include "scene_renderer.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <new>
#include <optional>

namespace lichen::renderer {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

Result<Picture> renderScene(VulkanDevice& device, const Scene& scene,
                            const RenderSettings& settings) {
  try {
    const Clock::time_point start = Clock::now();
    std::optional<Scene> displaced;
    if (settings.displacement.depth > 0.0f)
      displaced = take(displacedScene(scene, settings.displacement,
                                      {settings.camera, settings.width, settings.height}));
    SceneRenderer renderer(device, displaced ? *displaced : scene, settings);
    Picture picture;
    picture.notes = renderer.notes();
    if (displaced)
      picture.notes.insert(picture.notes.end(),
                           displaced->notes.begin() + std::ptrdiff_t(scene.notes.size()),
                           displaced->notes.end());
    picture.setupSeconds = secondsSince(start);
    std::vector<double> seconds;
    for (std::uint32_t frame = 0; frame < settings.frames; ++frame) {
      const Clock::time_point frameStart = Clock::now();
      renderer.drawFrame(frame);
      seconds.push_back(secondsSince(frameStart));
      if (settings.frameDone)
        settings.frameDone(frame + 1);
    }
    std::sort(seconds.begin(), seconds.end());
    picture.medianFrameSeconds = seconds[seconds.size() / 2];
    picture.pixels = renderer.average(settings.frames);
    return picture;
  } catch (const Failure& failure) {
    return failure.error;
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::resources, scene.name + ": not enough memory to render the scene"};
  }
}

} // namespace lichen::renderer
