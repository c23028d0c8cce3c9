// SPDX-License-Identifier: MIT
// One device for all tests of a program, and the compute pipelines of their noises on it: to make
// these takes longer than most tests.
#pragma once

#include "compute_run.h"
#include "require_device.h"

namespace lichen::test {

/// As requireDevice(), without messages from earlier tests.
inline VulkanDevice* sharedDevice() {
  static const std::unique_ptr<VulkanDevice> device = requireDevice();
  device->messages().clear();
  return device.get();
}

inline ComputePipelines& sharedPipelines() {
  static ComputePipelines pipelines(sharedDevice()->device());
  return pipelines;
}

} // namespace lichen::test
