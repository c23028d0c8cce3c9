// SPDX-License-Identifier: MIT
// Sun direction and irradiance, sky irradiance -> prefiltered sky; see sky_cache.h.
#include "sky_cache.h"

#include "sky.h"

#include <utility>

namespace lichen::renderer {
namespace {

constexpr int kPanoramaHeight = 512;

} // namespace

const PreparedSky& SkyCache::prepare(glm::vec3 towardSun, glm::vec3 sunlight, float irradiance) {
  const Light light{towardSun, sunlight, irradiance};
  if (light_ == light)
    return sky_;
  light_.reset(); // no valid entry if the preparation throws
  const Sky sky = makeSky(towardSun, sunlight, irradiance, kPanoramaHeight);
  sky_ = {sky.balance, prepareEnvironment(sky.panorama)};
  light_ = light;
  return sky_;
}

} // namespace lichen::renderer
