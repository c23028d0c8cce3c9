// SPDX-License-Identifier: MIT
// Direction and irradiance of the sun, irradiance of the sky -> the sky prepared for shading; see
// sky_cache.h.
#include "sky_cache.h"

#include "sky.h"

#include <utility>

namespace lichen::renderer {
namespace {

constexpr int kPanoramaHeight = 512;

} // namespace

const PreparedSky& SkyCache::under(glm::vec3 towardSun, glm::vec3 sunlight, float irradiance) {
  const Light light{towardSun, sunlight, irradiance};
  if (light_ == light)
    return sky_;
  light_.reset(); // until the new one is whole
  const Sky sky = makeSky(towardSun, sunlight, irradiance, kPanoramaHeight);
  sky_ = {sky.balance, prepareEnvironment(sky.panorama)};
  light_ = light;
  return sky_;
}

} // namespace lichen::renderer
