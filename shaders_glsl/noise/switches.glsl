// SPDX-License-Identifier: MIT
// The methods, mappings and features that a shader has: literals and constants that a host defines
// before the include (README.md, Switches), and what follows from them for a noise and a material.
// lichen.glsl needs them before it declares images, and library.glsl includes them again.
#ifndef LICHEN_SWITCHES_GLSL
#define LICHEN_SWITCHES_GLSL

// The layers that a noise may have; 1 where no noise is layered. A literal.
#ifndef LICHEN_LAYERS
#define LICHEN_LAYERS 1
#endif
// Bit m: the method m (LICHEN_METHOD_...) is compiled. A literal. Quilting needs
// LICHEN_SAMPLE_CELLS and LICHEN_TILE_OFFSET (interface/fetch.glsl).
#ifndef LICHEN_METHODS
#if defined(LICHEN_SAMPLE_CELLS) || defined(LICHEN_SET) && LICHEN_LAYERS == 1
#define LICHEN_METHODS 31
#else
#define LICHEN_METHODS 15
#endif
#endif
// Bit m: the mapping m (LICHEN_MAPPING_... of the plugin) is compiled: texture coordinates,
// triplanar, surface, solid. A literal.
#ifndef LICHEN_MAPPINGS
#if defined(LICHEN_SET) && LICHEN_LAYERS > 1
#define LICHEN_MAPPINGS 11 // no surfaces
#else
#define LICHEN_MAPPINGS 15
#endif
#endif
#define LICHEN_HAS_TRIPLANAR ((LICHEN_MAPPINGS & 2) != 0)
#define LICHEN_HAS_SURFACES ((LICHEN_MAPPINGS & 4) != 0 && (LICHEN_METHODS & 10) != 0)
#define LICHEN_HAS_SOLIDS ((LICHEN_MAPPINGS & 8) != 0 && (LICHEN_METHODS & 12) != 0)

// Bits LICHEN_FEATURE_...: what some noise or material has. Others are then silently wrong. A
// literal, or the host's specialization constant; some drivers take longer to drop the code of such
// a constant than to compile the rest.
#ifndef LICHEN_FEATURES
#define LICHEN_FEATURES 0xFFFFFFFFu
#endif
#define LICHEN_USES(feature) ((uint(LICHEN_FEATURES) & (feature)) != 0u)

/// Whether a noise has this method; known at compile time where there is only one, or not this.
bool lichenHasMethod(int method, LichenNoise noise) {
  uint used = uint(LICHEN_FEATURES) & uint(LICHEN_METHODS);
  uint bit = 1u << uint(method);
  return used == bit || ((used & bit) != 0u && noise.method == uint(method));
}

/// Whether the material has this mapping, LICHEN_FEATURE_UV and so on; known at compile time where
/// there is only one, or not this.
bool lichenHasMapping(uint mapping, LichenMaterial material) {
  uint used = uint(LICHEN_FEATURES) & uint(LICHEN_MAPPINGS) * LICHEN_FEATURE_UV;
  return used == mapping || ((used & mapping) != 0u && material.mapping == mapping);
}

bool lichenIsTriplanar(LichenMaterial material) {
  return lichenHasMapping(LICHEN_FEATURE_TRIPLANAR, material);
}

bool lichenIsSurface(LichenMaterial material) {
  bool hasSurfaces = LICHEN_HAS_SURFACES;
  return hasSurfaces && lichenHasMapping(LICHEN_FEATURE_SURFACE, material);
}

bool lichenIsSolid(LichenMaterial material) {
  bool hasSolids = LICHEN_HAS_SOLIDS;
  return hasSolids && lichenHasMapping(LICHEN_FEATURE_SOLID, material);
}

/// Whether slopes are a gradient in space, for lichenNormalFromGradient.
bool lichenHasSlopesInSpace(LichenMaterial material) {
  return lichenIsTriplanar(material) || lichenIsSolid(material);
}

/// Whether the cells repeat; known at compile time where none do.
bool lichenIsPeriodic(LichenMaterial material) {
  return LICHEN_USES(LICHEN_FEATURE_PERIOD) && material.periodRows != 0;
}

#endif
