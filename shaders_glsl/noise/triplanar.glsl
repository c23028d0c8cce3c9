// SPDX-License-Identifier: MIT
// A noise in three planes, blended as one: a point in space and the weights of the planes -> the
// material's value. The planes are blended before they are decoded, with the variance of one, so
// that one inverse table gives the exemplar's histogram everywhere.
// [HN18] Heitz and Neyret 2018, section 4.3 and figure 16; slopes as volume gradients, [M20]
// Mikkelsen 2020. Specified in docs/gltf_extension/README.md.

#if LICHEN_HAS_TRIPLANAR
/// What all maps of a triplanar noise share at one point.
struct LichenTriplanar {
  vec3 position;             // [metres]
  vec3 gradientX, gradientY; // [metres / pixel]
  vec3 normal;               // of unit length
  vec3 weights;              // of the planes that look along x, y, z; their squares sum to 1
  ivec3 order;               // axes of the planes, the greatest weight first
  int count;                 // of planes whose weight is above 0, [1, 3]
  LichenTriplanarMaterial planes;
};

/// The noise in one plane at one point.
struct LichenPlanePoint {
  int axis; // along which the plane looks: 0 x, 1 y, 2 z
  float weight;
  LichenPoint point;
};

/// The material in one plane, as on texture coordinates.
LichenMaterial lichenMaterialOfPlane(int axis, LichenTriplanarMaterial planes) {
  LichenMaterial material = planes.material;
  if (axis == 0)
    return material;
  material.cellI = axis == 1 ? planes.planeY.cellI : planes.planeZ.cellI;
  material.cellJ = axis == 1 ? planes.planeY.cellJ : planes.planeZ.cellJ;
  material.offsetX = axis == 1 ? planes.planeY.offsetX : planes.planeZ.offsetX;
  material.offsetY = axis == 1 ? planes.planeY.offsetY : planes.planeZ.offsetY;
  material.seedWord = axis == 1 ? planes.planeY.seedWord : planes.planeZ.seedWord;
  return material;
}

/// Along the right and the down of the plane across an axis, viewed from the axis's end.
vec2 lichenOntoPlane(vec3 v, int axis) {
  return axis == 0 ? vec2(-v.z, -v.y) : (axis == 1 ? v.xz : vec2(v.x, -v.y));
}

/// Slopes in the exemplar of that plane -> the gradient in space of the height that it shows.
vec3 lichenSlopesToSpace(vec2 slopes, int axis, LichenMaterial material) {
  vec2 s = lichenSlopesToUv(slopes, material); // to the right and up
  return axis == 0 ? vec3(0.0, s.y, -s.x) : (axis == 1 ? vec3(s.x, 0.0, -s.y) : vec3(s, 0.0));
}

/// The point in the plane of this rank. Each map computes it anew: shared by all maps, the three
/// would take a GPU's registers, and a detour through memory on llvmpipe.
LichenPlanePoint lichenPlanePoint(LichenTriplanar at, int rank, LichenPoint point,
                                  LichenNoise noise) {
  int axis = rank == 0 ? at.order.x : (rank == 1 ? at.order.y : at.order.z);
  LichenMaterial own = lichenMaterialOfPlane(axis, at.planes);
  // Texels are square in space.
  vec2 tilesPerUnit = vec2(1.0, noise.tileAspect) / noise.tileSizeMetres;
  vec2 tile = vec2(own.offsetX, own.offsetY) +
              tilesPerUnit * lichenUvToTile(lichenOntoPlane(at.position, axis), own);
  vec2 tileX = tilesPerUnit * lichenUvToTile(lichenOntoPlane(at.gradientX, axis), own);
  vec2 tileY = tilesPerUnit * lichenUvToTile(lichenOntoPlane(at.gradientY, axis), own);
  LichenPlanePoint plane = LichenPlanePoint(axis, lichenChosen(at.weights, axis),
                                            lichenPointAt(tile, tileX, tileY, own, noise));
  lichenSetMix(plane.point, lichenMixWeightAt(point), vec2(0.0));
  return plane;
}

/// What the decoded slopes of one plane add to the gradient in space, and in w to the variance of a
/// slope lost to filtering.
vec4 lichenPlaneSlopes(vec3 slopes, LichenPlanePoint plane, vec3 normal, LichenMaterial material) {
  // The variance is the same along all axes of the plane. On the surface it stays across the slant,
  // and is cosine^2 times as much along it: this is the average.
  float cosine = lichenChosen(normal, plane.axis);
  float projected = 0.5 + 0.5 * cosine * cosine;
  return vec4(plane.weight * lichenSlopesToSpace(slopes.xy, plane.axis, material),
              plane.weight * plane.weight * projected * slopes.z);
}

/// The Gaussian value of a map, as lichenMapAt has it, of all planes that count. `point` is what
/// the planes share.
LichenGaussian lichenTriplanarGaussian(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table,
                                       LichenTriplanar at, LichenPoint point, LichenNoise noise,
                                       LichenMap map) {
  LichenGaussian sum = LichenGaussian(vec3(0.5), vec3(0.0), 0.0);
  // Pixels of different planes share the steps of the loop, and devices that run both sides of a
  // branch leave it when no pixel has another plane. It is tested at both ends: only at its
  // beginning, such devices would run it once more for no pixel, and only at its end, Mesa 22.3's
  // lavapipe gives some pixels what others have.
  int rank = 0;
  while (rank < at.count) {
    LichenPlanePoint plane = lichenPlanePoint(at, rank, point, noise);
    // [HN18] eq. 8, the squares of the weights summing to 1: planes are independent noises of one
    // distribution.
    LichenGaussian gaussian =
        lichenGaussianAt(image, table, plane.point, at.planes.material, noise, map);
    sum.value += plane.weight * (gaussian.value - 0.5);
    sum.lost += plane.weight * plane.weight * gaussian.lost;
    ++rank;
    if (rank >= at.count)
      break;
  }
  return sum;
}

/// The gradient in space of the height that slopes are of, and in w the variance of a slope
/// lost to filtering. Slopes are decoded plane by plane: a joint table knows them as they lie in
/// the exemplar, and slopes of three planes point in other directions.
vec4 lichenTriplanarSlopes(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, LichenTriplanar at,
                           LichenPoint point, LichenNoise noise, LichenMap map) {
  vec4 sum = vec4(0.0);
  int rank = 0; // as above
  while (rank < at.count) {
    LichenPlanePoint plane = lichenPlanePoint(at, rank, point, noise);
    vec4 slopes = lichenValueAt(image, table, plane.point, at.planes.material, noise, map);
    sum += lichenPlaneSlopes(slopes.xyz, plane, at.normal, at.planes.material);
    ++rank;
    if (rank >= at.count)
      break;
  }
  return sum;
}
#endif
