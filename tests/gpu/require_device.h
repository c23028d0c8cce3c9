// SPDX-License-Identifier: MIT
// A validated device for a test, or the end of the program with the exit code that CTest takes as
// "skipped" on a machine where no Vulkan device exists.
#pragma once

#include "frozen_constants.h"

#include <lichen/vulkan_device.h>

#include <cstdio>
#include <cstdlib>
#include <memory>

namespace lichen::test {

/// SKIP_RETURN_CODE of the GPU tests.
inline constexpr int kSkipped = 77;

inline std::unique_ptr<VulkanDevice> requireDevice() {
  VulkanDeviceOptions options;
  options.validation = true;
  if (const char* choice = std::getenv("LICHEN_TEST_DEVICE"))
    options.choice = choice;
  auto device = VulkanDevice::create(options);
  if (device) {
    freezeConstants();
    return std::move(device).value();
  }
  std::fprintf(stderr, "%s\n", device.error().message.c_str());
  const bool noDevice = device.error().kind == ErrorKind::environment &&
                        device.error().message.find("no Vulkan device") == 0;
  std::exit(noDevice ? kSkipped : EXIT_FAILURE);
}

} // namespace lichen::test
