// SPDX-License-Identifier: MIT
// A texton noise evaluated twice: on a device, through the plugin and a pass, and by its CPU twin.
#pragma once

#include "plugin_host.h"
#include "shared_device.h"
#include "synthetic_texton.h"

#include <lichen/texton_evaluate.h>

#include <catch2/catch.hpp>

#include <string>

namespace lichen::test {

/// Its destructor checks that the device reported no message.
struct TextonTwins {
  /// `pass` is a file name in shaders_glsl/passes.
  TextonTwins(const std::string& pass, std::span<const std::byte> glb)
      : bundle(parseBundle(glb, "synthetic").value()), host(sharedContext(), glb),
        twin(TextonEvaluator::create(bundle, 0).value()), committed(committedShader(pass)) {}
  TextonTwins(const std::string& pass, const SyntheticTexton& texton)
      : TextonTwins(pass, syntheticTextonGlb(texton)) {}
  ~TextonTwins() { CHECK(device->messages().texts() == std::vector<std::string>{}); }
  TextonTwins(const TextonTwins&) = delete;
  TextonTwins& operator=(const TextonTwins&) = delete;

  /// Runs the pass at these points; `quantity` uses the pass's numbering.
  template <class AnyPoint>
  [[nodiscard]] std::vector<std::array<float, 4>> shader(int quantity, const MaterialUse& use,
                                                         const std::vector<AnyPoint>& points) {
    return host.evaluate(committed, quantity, use, points);
  }

  VulkanDevice* const device = sharedDevice();
  const Bundle bundle;
  PluginHost host; ///< and the block of the last shader()
  const TextonEvaluator twin;
  const std::vector<std::uint32_t> committed; ///< the pass
};

} // namespace lichen::test
