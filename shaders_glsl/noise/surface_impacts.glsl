// SPDX-License-Identifier: MIT
// The impacts of a texton noise that reach a point of a surface: a point in space and the frame of
// its tangent plane -> a walk over the offsets from the impacts to the point, projected
// onto that plane, and their weights.
// [GLM17] Galerne, Leclaire and Moisan 2017, section 6: points of a process in space, with signs as
// in the plane. They lie in cubes, one in each (stratified) or a Poisson number of mean 1.
// Specified bit for bit in docs/gltf_extension/README.md.
#ifndef LICHEN_SURFACE_IMPACTS_GLSL
#define LICHEN_SURFACE_IMPACTS_GLSL

#include "../interface/lichen_interface.h"
#include "hash.glsl"
#include "impacts.glsl"

/// What all maps of a surface noise share at one point, beside its LichenImpacts.
/// Offsets from an impact to the point have x and y [texels] in the frame of the impact's texton,
/// from the middle of its reach, and the height over the tangent plane, in units of the height
/// where the weight is 0. Cubes are counted from the one that holds the point.
struct LichenSurfaceImpacts {
  vec3 offset; // of the corner of the point's cube
  mat3 axes;   // the offset of an impact at `cube` [cubes] is `offset - cube * axes`
  vec3 radius; // impacts with smaller offsets reach the point
  uvec3 cell;  // the cube that holds the point, modulo 2^32
  vec2 firstColumn, lastColumn; // those of cubes, all along z, that may reach the point
  // The part of a column, along z, in which each component of the offset is in reach: half its
  // length, its middle in the column (0, 0), and how the middle moves from column to column.
  vec3 columnReach, columnMiddle, columnStepX, columnStepY;
};

/// A walk over the cubes, column by column. All of it but the last three members is about the next
/// impact, which may turn out not to exist or not to reach the point. It is small: devices that
/// compute pixels together carry each member through their loops under a mask.
struct LichenSurfaceWalk {
  vec2 column; // from the point's
  uvec2 columnHash;
  float cube, lastCube; // from the point's, along z: the next, and the last of the column
  uint index;           // of the impact in its cube
  bool isReached;       // whether the last impact exists and reaches the point
  vec2 offset;          // from the last impact to the point
  float weight;         // of the last impact, with its sign
};

/// How thick a layer of impacts a point sees. [texels]
float lichenSurfaceThickness(LichenNoise noise) {
  // [GLM17] section 6: r, the side of a square texton; of another that of the square of its area.
  vec2 support =
      lichenTextonCoefficients(noise) + float(int(lichenTextonNoise(noise).order));
  return sqrt(support.x * support.y);
}

/// Impacts that reach `position` [tile widths, relative to the host's integer tile origin], where
/// the exemplar's x and y lie along the unit vectors `right` and `down` of a tangent plane with the
/// normal `outward`. `impacts` are those of a plane at this footprint.
LichenSurfaceImpacts lichenSurfaceImpactsAt(vec3 position, vec3 right, vec3 down, vec3 outward,
                                            LichenImpacts impacts, LichenMaterial material,
                                            LichenNoise noise) {
  LichenSurfaceImpacts surface;
  float side = lichenTextonMaterial(material).surfaceCubeTexels;
  float greatestHeight = 0.5 * lichenSurfaceThickness(noise);
  vec3 scale = vec3(side, side, side / greatestHeight);
  surface.axes = mat3(scale.x * right, scale.y * down, scale.z * outward);
  vec3 grid = position * material.columnsPerTile;
  vec3 cell = floor(grid);
  vec3 inside = grid - cell;
  // 2^28 tiles of 16384 texels have 2^46 cubes: cubes of 0.08 texels, for 1000 impacts of one
  // texel.
  surface.cell = uvec3(lichenLowWord(cell.x), lichenLowWord(cell.y), lichenLowWord(cell.z)) +
                 uvec3(ivec3(material.cellI, material.cellJ, lichenTextonMaterial(material).cellK));
  // The centre of a texton's coefficients lies on its impact.
  vec2 shift = 0.5 * lichenTextonCoefficients(noise) - impacts.middle;
  surface.offset = inside * surface.axes + vec3(shift, 0.0);
  surface.radius = vec3(impacts.radius, 1.0);
  // The impacts in reach lie in a box that is askew among the cubes.
  vec3 middle = inside + (shift.x * right + shift.y * down) / side;
  vec3 reach = surface.radius / scale;
  reach = reach.x * abs(right) + reach.y * abs(down) + reach.z * abs(outward);
  surface.firstColumn = floor(middle.xy - reach.xy);
  surface.lastColumn = floor(middle.xy + reach.xy);
  // Where a column leaves the box through each pair of faces. One that is parallel to a pair counts
  // as slightly slanted.
  const float kLeastSlope = 1.0 / 65536.0;
  vec3 slope = vec3(right.z, down.z, outward.z);
  slope = mix(slope, vec3(kLeastSlope), lessThan(abs(slope), vec3(kLeastSlope)));
  vec3 perOffset = 1.0 / (slope * scale);
  vec3 alongX = vec3(surface.axes[0].x, surface.axes[1].x, surface.axes[2].x);
  vec3 alongY = vec3(surface.axes[0].y, surface.axes[1].y, surface.axes[2].y);
  surface.columnReach = (surface.radius + 0.5 * (abs(alongX) + abs(alongY))) * abs(perOffset);
  surface.columnStepX = -alongX * perOffset;
  surface.columnStepY = -alongY * perOffset;
  surface.columnMiddle =
      surface.offset * perOffset + 0.5 * (surface.columnStepX + surface.columnStepY);
  return surface;
}

/// Sets what a walk knows of its column.
void lichenEnterColumn(inout LichenSurfaceWalk walk, LichenSurfaceImpacts surface,
                       LichenMaterial material) {
  vec3 middle = surface.columnMiddle + walk.column.x * surface.columnStepX +
                walk.column.y * surface.columnStepY;
  vec3 low = middle - surface.columnReach;
  vec3 high = middle + surface.columnReach;
  // A column out of reach still has one cube. Its impacts do not reach the point.
  walk.cube = floor(max(low.x, max(low.y, low.z)));
  walk.lastCube = floor(min(high.x, min(high.y, high.z)));
  uvec2 cell = surface.cell.xy + uvec2(ivec2(walk.column));
  walk.columnHash = lichenPcg3d(uvec3(cell, material.seedWord)).xy;
}

/// A walk before its first impact.
LichenSurfaceWalk lichenFirstSurfaceImpact(LichenSurfaceImpacts surface, LichenMaterial material) {
  LichenSurfaceWalk walk;
  walk.column = surface.firstColumn;
  walk.index = 0u;
  walk.isReached = false;
  walk.offset = vec2(0.0);
  walk.weight = 0.0;
  lichenEnterColumn(walk, surface, material);
  return walk;
}

/// To the next column, row by row.
void lichenNextColumn(inout LichenSurfaceWalk walk, LichenSurfaceImpacts surface,
                      LichenMaterial material) {
  walk.column.x += 1.0;
  if (walk.column.x > surface.lastColumn.x)
    walk.column = vec2(surface.firstColumn.x, walk.column.y + 1.0);
  lichenEnterColumn(walk, surface, material);
}

/// Where an impact lies in its cube, [0, 1).
vec3 lichenImpactInCube(uint word) {
  // 10 bits each, below the sign, and the middle of what they tell apart.
  const float kStep = 1.0 / 1024.0;
  return (vec3(ivec3(uvec3(word >> 21u, word >> 11u, word >> 1u) & 1023u)) + 0.5) * kStep;
}

/// One step of a walk.
void lichenSurfaceStep(inout LichenSurfaceWalk walk, LichenSurfaceImpacts surface,
                       LichenMaterial material, LichenNoise noise) {
  bool isPoisson = bool(LICHEN_POISSON_POINTS) &&
                   lichenTextonMaterial(material).pointProcess == uint(LICHEN_POINTS_POISSON);
  uint cell = surface.cell.z + uint(int(walk.cube));
  uint word = lichenPcg(walk.columnHash.x + cell);
  uint count = 1u;
  if (isPoisson) {
    word = lichenPcg(word + walk.index);
    count = lichenPoissonCount(lichenPcg(walk.columnHash.y + cell));
  }
  vec3 impact = vec3(walk.column, walk.cube) + lichenImpactInCube(word);
  vec3 offset = surface.offset - impact * surface.axes;
  walk.offset = offset.xy;
  // [GLM17] section 6: less and less of what is far from the tangent plane.
  float weight = 1.0 - abs(offset.z);
  walk.weight = (word & 0x80000000u) != 0u ? -weight : weight;
  walk.isReached = walk.index < count && all(lessThan(abs(offset), surface.radius));
  ++walk.index;
  if (!isPoisson || walk.index >= count) {
    walk.index = 0u;
    walk.cube += 1.0;
    if (walk.cube > walk.lastCube)
      lichenNextColumn(walk, surface, material);
  }
}

/// Whether a walk has not come to the end of its cubes.
bool lichenHasImpact(LichenSurfaceWalk walk, LichenSurfaceImpacts surface) {
  return walk.column.y <= surface.lastColumn.y;
}

/// Advances to the next impact in reach, or to the end. Pixels that are computed together mostly
/// agree on it, so few fetches are wasted.
void lichenNextSurfaceImpact(inout LichenSurfaceWalk walk, LichenSurfaceImpacts surface,
                             LichenMaterial material, LichenNoise noise) {
  // No do-while: Mesa 22.3's lavapipe runs one wrong that is inside another loop.
  walk.isReached = false;
  while (!walk.isReached && lichenHasImpact(walk, surface))
    lichenSurfaceStep(walk, surface, material, noise);
}

#endif
