// SPDX-License-Identifier: MIT
// Bindings that start at 7: the shader is compiled with LICHEN_FIRST_BINDING 7.
#include "plugin_host.h"
#include "require_device.h"
#include "synthetic_noise.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <tiling_maps.comp.rebound.h>

using namespace lichen;
using namespace lichen::test;

TEST_CASE("bindings may start at another number: the values match the oracle") {
  constexpr std::array<SyntheticMap, 3> kMaps{{{3, 32, 32}, {2, 16, 16}, {1, 32, 32}}};
  const auto device = requireDevice();
  const std::vector<std::byte> glb = syntheticGlb(kMaps);
  const Bundle bundle = parseBundle(glb, "synthetic").value();
  LichenVulkanInfo info = defaultVulkanInfo(*device);
  info.firstBinding = 7;
  PluginHost host(*device, glb, info);
  std::vector<Point> points(200);
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] = {{float(k) * 0.013f, float(k) * -0.007f}, {0.02f, 0.0f}, {0.0f, 0.05f}, {}};
  const auto values = host.evaluate(tiling_maps_comp_rebound, 0, host.use(), points, kMaps.size());
  for (std::size_t m = 0; m < kMaps.size(); ++m) {
    const TilingReference reference(bundle, m);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto expected = reference.evaluate(points[k], host.material());
      for (std::size_t c = 0; c < 3; ++c)
        REQUIRE(std::abs(double(values[k * kMaps.size() + m][c]) - expected.value[c]) <
                1.0 / 255.0);
    }
  }
  CHECK(device->messages().texts() == std::vector<std::string>{});
}
