// SPDX-License-Identifier: MIT
// Texton noise on a surface: a point in space and the frame of its tangent plane -> the cubes
// around it -> the material's value.
// N(y) = mean + (lambda r / 3)^-1/2 sum_i e_i (1 - 2 |t_i| / r)+ h(y - x_i), lambda points in a
// unit of space, signs e_i, t_i the height of point i over the tangent plane at y, in which h lies.
// [GLM17] Galerne, Leclaire and Moisan 2017, section 6 and proposition 3.
#ifndef LICHEN_SURFACE_TEXTON_GLSL
#define LICHEN_SURFACE_TEXTON_GLSL

#include "surface_cubes.glsl"
#include "texton.glsl"

/// How thick a layer of impacts a point sees. [texels]
float lichenSurfaceThickness(LichenNoise noise) {
  // [GLM17] section 6: r, the side of a square texton; of another that of the square of its area.
  vec2 support = lichenTextonCoefficients(noise) + float(int(lichenTextonNoise(noise).order));
  return sqrt(support.x * support.y);
}

/// The sum over impacts, with mean 0.
vec3 lichenSurfaceTextonSum(LICHEN_IMAGE_2D image, LichenImpacts impacts, LichenSurfaceCubes cubes,
                            LichenMaterial material, LichenNoise noise) {
  vec3 sum = vec3(0.0);
  LichenSurfaceWalk walk = lichenFirstSurfaceImpact(cubes);
  while (lichenHasImpact(walk, cubes)) {
    lichenSurfaceStep(walk, cubes);
    if (walk.isReached)
      sum += walk.weight * lichenTextonAt(image, walk.offset + impacts.middle, impacts, noise);
  }
  return lichenTextonMaterial(material).amplitude * sum;
}

/// How many impacts reach the point.
int lichenSurfaceImpactCount(LichenSurfaceCubes cubes) {
  int count = 0;
  LichenSurfaceWalk walk = lichenFirstSurfaceImpact(cubes);
  while (lichenHasImpact(walk, cubes)) {
    lichenSurfaceStep(walk, cubes);
    count += walk.isReached ? 1 : 0;
  }
  return count;
}

/// The Gaussian value, as lichenTextonGaussian returns it.
vec3 lichenSurfaceTextonGaussian(LICHEN_IMAGE_2D image, LichenSurfaceCubes cubes,
                                 LichenImpacts impacts, LichenRetained retained,
                                 LichenMaterial material, LichenNoise noise, LichenMap map) {
  vec3 gain = lichenTextonGain(retained, material);
  // From so far that nothing is left to see, the mean needs no impacts.
  if (gain == vec3(0.0))
    return vec3(0.5);
  vec3 sum = lichenSurfaceTextonSum(image, impacts, cubes, material, noise);
  return 0.5 + gain * map.sumFactor.rgb * sum;
}

// The seam's functions; see surface_method.glsl. Offsets are in texels, from the middle of the
// reach of an impact's texton.

void lichenSetSurfacePoint(LICHEN_OUT(LichenSurfaceCubes) cubes, vec3 position, mat3 frame,
                           LichenImpacts impacts, LichenMaterial material, LichenNoise noise) {
  LichenTextonMaterial own = lichenTextonMaterial(material);
  float side = own.surfaceCubeTexels;
  float greatestHeight = 0.5 * lichenSurfaceThickness(noise);
  mat3 axes = mat3(side * frame[0], side * frame[1], side / greatestHeight * frame[2]);
  vec3 grid = position * material.columnsPerTile;
  vec3 corner = floor(grid);
  // 2^28 tiles of 16384 texels have 2^46 cubes: cubes of 0.08 texels, for 1000 impacts of one
  // texel.
  uvec3 cell = uvec3(lichenLowWord(corner.x), lichenLowWord(corner.y), lichenLowWord(corner.z)) +
               uvec3(ivec3(material.cellI, material.cellJ, own.cellK));
  // The centre of a texton's coefficients lies on its impact.
  vec2 shift = 0.5 * lichenTextonCoefficients(noise) - impacts.middle;
  bool isPoisson = bool(LICHEN_POISSON_POINTS) && own.pointProcess == uint(LICHEN_POINTS_POISSON);
  cubes = lichenSurfaceCubesAt(grid - corner, cell, axes, vec3(shift, 0.0),
                               vec3(impacts.radius, 1.0), material.seedWord, isPoisson);
}

vec3 lichenSurfaceGaussianAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenSurfaceCubes cubes,
                             LichenImpacts impacts, LichenMaterial material, LichenNoise noise,
                             LichenMap map, LICHEN_OUT(vec3) lost) {
  LichenRetained retained = lichenTextonRetained(table, impacts, noise, map);
  lost = 1.0 - retained.footprint;
  return lichenSurfaceTextonGaussian(image, cubes, impacts, retained, material, noise,
                                     lichenMixedMap(table, impacts, noise, map));
}

vec4 lichenSurfaceValueAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenSurfaceCubes cubes,
                          LichenImpacts impacts, LichenMaterial material, LichenNoise noise,
                          LichenMap map) {
  // Not by the one above, as lichenValueAt.
  LichenMap here = lichenMixedMap(table, impacts, noise, map);
  LichenRetained retained = lichenTextonRetained(table, impacts, noise, map);
  vec3 gaussian =
      lichenSurfaceTextonGaussian(image, cubes, impacts, retained, material, noise, here);
  return lichenTextonDecode(gaussian, retained, material, here);
}

#endif
