// SPDX-License-Identifier: MIT
// GLFW's callbacks -> WindowEvents.
#include "window.h"

#include "failure.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>

namespace lichen::renderer {
namespace {

/// A Failure with GLFW's reason and what to do.
Failure windowFailure(const std::string& what) {
  const char* reason = nullptr;
  glfwGetError(&reason);
  return {{ErrorKind::environment, what + (reason != nullptr ? std::string(": ") + reason : "") +
                                       "; lichen-render renders to a file without a display"}};
}

} // namespace

struct Window::Callbacks {
  static Window& of(GLFWwindow* window) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
  }

  static void key(GLFWwindow* window, int key, int, int action, int modifiers) {
    if (action == GLFW_RELEASE)
      return;
    const bool shift = (modifiers & GLFW_MOD_SHIFT) != 0;
    if (key == GLFW_KEY_ESCAPE)
      of(window).events_.emplace_back(Key{kEscape, shift});
    else if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z)
      of(window).events_.emplace_back(Key{letterOf(key), shift});
  }

  /// The letter in the user's keyboard layout: GLFW's key codes refer to the US layout.
  static char letterOf(int key) {
    const char* name = glfwGetKeyName(key, 0);
    if (name != nullptr && name[0] >= 'a' && name[0] <= 'z' && name[1] == '\0')
      return char(name[0] - 'a' + 'A');
    return char('A' + (key - GLFW_KEY_A));
  }

  static void cursor(GLFWwindow* window, double x, double y) {
    Window& self = of(window);
    const glm::vec2 position(x, y);
    int width = 0;
    int height = 0;
    glfwGetWindowSize(window, &width, &height);
    const glm::vec2 drag = (position - self.cursor_) / float(std::max(height, 1));
    self.cursor_ = position;
    const auto isDown = [&](int button) {
      return glfwGetMouseButton(window, button) == GLFW_PRESS;
    };
    if (isDown(GLFW_MOUSE_BUTTON_LEFT))
      self.events_.emplace_back(Orbited{drag});
    else if (isDown(GLFW_MOUSE_BUTTON_MIDDLE) || isDown(GLFW_MOUSE_BUTTON_RIGHT))
      self.events_.emplace_back(Panned{drag});
  }

  static void button(GLFWwindow* window, int, int, int) {
    double x = 0.0;
    double y = 0.0;
    glfwGetCursorPos(window, &x, &y);
    of(window).cursor_ = glm::vec2(x, y);
  }

  static void scroll(GLFWwindow* window, double, double y) {
    of(window).events_.emplace_back(Zoomed{float(y)});
  }

  static void refresh(GLFWwindow* window) { of(window).events_.emplace_back(Exposed{}); }
};

Window::Window(std::uint32_t width, std::uint32_t height, const std::string& title) {
  if (glfwInit() != GLFW_TRUE)
    throw windowFailure("no display");
  if (glfwVulkanSupported() != GLFW_TRUE) {
    const Failure failure = windowFailure("Vulkan cannot present to windows on this machine");
    glfwTerminate();
    throw failure;
  }
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  window_ = glfwCreateWindow(int(width), int(height), title.c_str(), nullptr, nullptr);
  if (window_ == nullptr) {
    const Failure failure = windowFailure("cannot open a window");
    glfwTerminate();
    throw failure;
  }
  glfwSetWindowUserPointer(window_, this);
  glfwSetKeyCallback(window_, Callbacks::key);
  glfwSetCursorPosCallback(window_, Callbacks::cursor);
  glfwSetMouseButtonCallback(window_, Callbacks::button);
  glfwSetScrollCallback(window_, Callbacks::scroll);
  glfwSetWindowRefreshCallback(window_, Callbacks::refresh);
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

std::vector<const char*> Window::instanceExtensions() {
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (names == nullptr)
    throw windowFailure("Vulkan cannot present to this display");
  return {names, names + count};
}

bool Window::canPresent(VkInstance instance, VkPhysicalDevice device, std::uint32_t queueFamily) {
  return glfwGetPhysicalDevicePresentationSupport(instance, device, queueFamily) == GLFW_TRUE;
}

VkSurfaceKHR Window::createSurface(VkInstance instance) {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  if (glfwCreateWindowSurface(instance, window_, nullptr, &surface) != VK_SUCCESS)
    throw windowFailure("cannot create a surface for the window");
  return surface;
}

void Window::setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

VkExtent2D Window::size() const {
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return {std::uint32_t(width), std::uint32_t(height)};
}

bool Window::shouldClose() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }

void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

std::vector<WindowEvent> Window::events(double seconds) {
  if (seconds > 0.0)
    glfwWaitEventsTimeout(seconds);
  else
    glfwPollEvents();
  return std::exchange(events_, {});
}

} // namespace lichen::renderer
