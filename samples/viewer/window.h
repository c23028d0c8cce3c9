// SPDX-License-Identifier: MIT
// A desktop window and its input events.
#pragma once

#include "controls.h"

#include <glm/glm.hpp>
#include <volk.h>

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

struct GLFWwindow;

namespace lichen::renderer {

struct Orbited {
  glm::vec2 drag{0.0f}; ///< see OrbitCamera
};
struct Panned {
  glm::vec2 drag{0.0f};
};
struct Zoomed {
  float steps = 0.0f;
};
/// The window's content must be presented again.
struct Exposed {};

using WindowEvent = std::variant<Key, Orbited, Panned, Zoomed, Exposed>;

/// Only one may exist at a time, on main()'s thread. Functions throw a Failure: environment if
/// there is no display or it cannot be presented to.
class Window {
public:
  Window(std::uint32_t width, std::uint32_t height, const std::string& title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Instance extensions that a surface requires.
  [[nodiscard]] static std::vector<const char*> instanceExtensions();
  [[nodiscard]] static bool canPresent(VkInstance instance, VkPhysicalDevice device,
                                       std::uint32_t queueFamily);
  /// The caller must destroy the surface before the window.
  [[nodiscard]] VkSurfaceKHR createSurface(VkInstance instance);

  void setTitle(const std::string& title);
  /// Framebuffer size in pixels; 0 x 0 while minimised.
  [[nodiscard]] VkExtent2D size() const;
  [[nodiscard]] bool shouldClose() const;
  void close();
  /// Events since the last call. With `seconds` > 0, waits at most that long for an event.
  [[nodiscard]] std::vector<WindowEvent> events(double seconds);

private:
  struct Callbacks;

  GLFWwindow* window_ = nullptr;
  std::vector<WindowEvent> events_;
  glm::vec2 cursor_{0.0f};
};

} // namespace lichen::renderer
