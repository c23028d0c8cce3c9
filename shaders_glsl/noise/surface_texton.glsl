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
vec3 lichenSurfaceTextonSum(LICHEN_IMAGE_2D image, LichenImpacts impacts,
                            LichenSurfaceImpacts surface, LichenMaterial material,
                            LichenNoise noise) {
  vec3 sum = vec3(0.0);
  LichenSurfaceWalk walk = lichenFirstSurfaceImpact(surface, material);
  while (lichenHasImpact(walk, surface)) {
    lichenNextSurfaceImpact(walk, surface, material, noise);
    float weight = walk.isReached ? walk.weight : 0.0;
    sum += weight * lichenTextonAt(image, walk.offset + impacts.middle, impacts, noise);
  }
  return lichenTextonMaterial(material).amplitude * sum;
}

/// How many impacts reach the point.
int lichenSurfaceImpactCount(LichenSurfaceImpacts surface, LichenMaterial material,
                             LichenNoise noise) {
  int count = 0;
  LichenSurfaceWalk walk = lichenFirstSurfaceImpact(surface, material);
  while (lichenHasImpact(walk, surface)) {
    lichenNextSurfaceImpact(walk, surface, material, noise);
    count += walk.isReached ? 1 : 0;
  }
  return count;
}

/// The Gaussian value: mean 1/2, standard deviation 1/6 where nothing is minified.
vec3 lichenSurfaceTextonGaussian(LICHEN_IMAGE_2D image, LichenImpacts impacts,
                                 LichenSurfaceImpacts surface, LichenRetained retained,
                                 LichenMaterial material, LichenNoise noise, LichenMap map) {
  vec3 gain = lichenTextonGain(retained, material);
  // As lichenTextonGaussian has it.
  if (gain == vec3(0.0))
    return vec3(0.5);
  vec3 sum = lichenSurfaceTextonSum(image, impacts, surface, material, noise);
  return 0.5 + gain * map.sumFactor.rgb * sum;
}

/// The value of one map, as lichenValueAt returns it.
vec4 lichenSurfaceTexton(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenImpacts impacts,
                         LichenSurfaceImpacts surface, LichenMaterial material, LichenNoise noise,
                         LichenMap map) {
  LichenMap here = lichenMixedMap(table, impacts, noise, map);
  LichenRetained retained = lichenTextonRetained(table, impacts, noise, map);
  vec3 gaussian =
      lichenSurfaceTextonGaussian(image, impacts, surface, retained, material, noise, here);
  return lichenTextonDecode(gaussian, retained, material, here);
}

#endif
