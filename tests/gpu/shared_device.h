// SPDX-License-Identifier: MIT
// One device for all tests of a program, and one plugin context on it: to make pipelines takes
// longer than most tests.
#pragma once

#include "plugin_host.h"
#include "require_device.h"

namespace lichen::test {

/// As requireDevice(), without messages from earlier tests.
inline VulkanDevice* sharedDevice() {
  static const std::unique_ptr<VulkanDevice> device = requireDevice();
  device->messages().clear();
  return device.get();
}

inline PluginContext& sharedContext() {
  static PluginContext context(*sharedDevice());
  return context;
}

} // namespace lichen::test
