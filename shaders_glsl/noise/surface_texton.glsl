// SPDX-License-Identifier: MIT
// Texton noise on a surface: impacts around a point of it -> the material's value. The CPU twin is
// analysis/texton/evaluate.
// N(y) = mean + (lambda r / 3)^-1/2 sum_i e_i (1 - 2 |t_i| / r)+ h(y - x_i), lambda points in a
// unit of space, signs e_i, t_i the height of point i over the tangent plane at y, in which h lies.
// [GLM17] Galerne, Leclaire and Moisan 2017, section 6 and proposition 3.
#ifndef LICHEN_SURFACE_TEXTON_GLSL
#define LICHEN_SURFACE_TEXTON_GLSL

#include "surface_impacts.glsl"
#include "texton.glsl"

/// The sum over impacts, with mean 0.
vec3 lichenSurfaceTextonSum(sampler2D image, LichenImpacts impacts, LichenSurfaceImpacts surface,
                            LichenNoise noise, LichenTexton texton) {
  vec3 sum = vec3(0.0);
  LichenSurfaceWalk walk = lichenFirstSurfaceImpact(surface, noise);
  while (lichenGoesOn(walk, surface)) {
    lichenNextSurfaceImpact(walk, surface, noise, texton);
    float weight = walk.isReached ? walk.weight : 0.0;
    sum += weight * lichenTextonAt(image, walk.place + impacts.middle, impacts, texton);
  }
  return texton.amplitude * sum;
}

/// How many impacts reach the point.
int lichenSurfaceImpactCount(LichenSurfaceImpacts surface, LichenNoise noise,
                             LichenTexton texton) {
  int count = 0;
  LichenSurfaceWalk walk = lichenFirstSurfaceImpact(surface, noise);
  while (lichenGoesOn(walk, surface)) {
    lichenNextSurfaceImpact(walk, surface, noise, texton);
    count += walk.isReached ? 1 : 0;
  }
  return count;
}

/// The Gaussian value: mean 1/2, standard deviation 1/6 where nothing is minified.
vec3 lichenSurfaceTextonGaussian(sampler2D image, LichenImpacts impacts,
                                 LichenSurfaceImpacts surface, LichenKept kept,
                                 LichenNoise noise, LichenMap map, LichenTexton texton) {
  vec3 gain = lichenTextonGain(kept, noise);
  // As lichenTextonGaussian has it.
  if (gain == vec3(0.0))
    return vec3(0.5);
  vec3 sum = lichenSurfaceTextonSum(image, impacts, surface, noise, texton);
  return 0.5 + gain * map.sumFactor.rgb * sum;
}

/// The value of one map, as lichenTexton has it.
vec4 lichenSurfaceTexton(sampler2D image, sampler3D table, LichenImpacts impacts,
                         LichenSurfaceImpacts surface, LichenNoise noise, LichenMap map,
                         LichenTexton texton) {
  LichenMap here = lichenMixedMap(table, impacts, map, texton);
  LichenKept kept = lichenTextonKept(table, impacts, map, texton);
  return lichenTextonDecode(
      lichenSurfaceTextonGaussian(image, impacts, surface, kept, noise, here, texton), kept, noise,
      here);
}

#endif
