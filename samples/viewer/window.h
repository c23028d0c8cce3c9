// SPDX-License-Identifier: MIT
// A window of the desktop, and what its user does in it.
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

struct Turned {
  glm::vec2 drag{0.0f}; ///< see OrbitCamera
};
struct Panned {
  glm::vec2 drag{0.0f};
};
struct Zoomed {
  float steps = 0.0f;
};
/// The window's content is lost.
struct Exposed {};

using WindowEvent = std::variant<Key, Turned, Panned, Zoomed, Exposed>;

/// One at a time, on the thread of main(). Functions throw a Failure: environment where there is no
/// display or it cannot be presented to.
class Window {
public:
  Window(std::uint32_t width, std::uint32_t height, const std::string& title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Instance extensions that a surface needs.
  [[nodiscard]] static std::vector<const char*> instanceExtensions();
  [[nodiscard]] static bool canPresent(VkInstance instance, VkPhysicalDevice device,
                                       std::uint32_t queueFamily);
  /// The caller's to destroy, before the window.
  [[nodiscard]] VkSurfaceKHR createSurface(VkInstance instance);

  void setTitle(const std::string& title);
  /// In pixels; 0 x 0 while it is minimised.
  [[nodiscard]] VkExtent2D size() const;
  [[nodiscard]] bool shouldClose() const;
  void close();
  /// What has happened since the last call; with `seconds` > 0 it waits that long for something.
  [[nodiscard]] std::vector<WindowEvent> events(double seconds);

private:
  struct Callbacks;

  GLFWwindow* window_ = nullptr;
  std::vector<WindowEvent> events_;
  glm::vec2 cursor_{0.0f};
};

} // namespace lichen::renderer
