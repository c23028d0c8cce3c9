// SPDX-License-Identifier: MIT
// Layered noises at a point: what lichen.glsl evaluates where it declares the descriptors and
// LICHEN_LAYERS is above 1. Images are numbers, and each fetch chooses one. Noises that are not
// layered are drawn too, but only base colour, normals, and occlusion, roughness and metallic, and
// not on surfaces.

// With one method the loops over nodes, layers and roles are unrolled, so that compilers know each
// image. With more the code of a noise is there once: drivers that inline all calls would need
// minutes and gigabytes to compile it for each.
#extension GL_EXT_control_flow_attributes : enable
#if defined(GL_EXT_control_flow_attributes) && (LICHEN_METHODS & (LICHEN_METHODS - 1)) == 0
#define LICHEN_UNROLL [[unroll]]
#else
#define LICHEN_UNROLL
#endif

/// A layered noise at a point: the weights of its layers, and the values of the roles that it may
/// have.
struct LichenLayeredPoint {
  vec4 weights;
  vec4 values[3];
};

/// Where a layered noise is evaluated.
struct LichenLayeredPlace {
  vec2 uv, uvGradientX, uvGradientY;           // of texture coordinates
  vec3 position, gradientX, gradientY, normal; // of other mappings
};

/// The shading point of one layer, or of an index map.
LichenShadingPoint lichenLayerPoint(LichenLayeredPlace at, LichenTriplanarMaterial planes,
                                    LichenNoise noise) {
#if LICHEN_HAS_TRIPLANAR
  if (lichenIsTriplanar(planes.material))
    return lichenPointTriplanarGrad(at.position, at.gradientX, at.gradientY, at.normal, planes,
                                    noise);
#endif
#if LICHEN_HAS_SOLIDS
  if (lichenIsSolid(planes.material))
    return lichenPointSolidGrad(at.position, at.gradientX, at.gradientY, planes.material, noise);
#endif
  return lichenPointUvGrad(at.uv, at.uvGradientX, at.uvGradientY, planes.material, noise);
}

/// The weights of all layers.
vec4 lichenLayerWeightsAt(LichenLayeredPlace at) {
  vec3 above = vec3(0.0);
  LICHEN_UNROLL for (int node = 0; node < LICHEN_LAYERS - 1; ++node) {
    if (uint(node) >= lichenLayers.nodes)
      break;
    LichenShadingPoint shading =
        lichenLayerPoint(at, lichenIndexMaterials[node], lichenIndexNoises[node]);
    int image = LICHEN_FIRST_INDEX + node;
    LichenMap map = lichenIndexMaps[node];
    map.encoding = uint(LICHEN_ENCODING_INDEX);
    vec4 index = lichenValue(image, image, shading, map);
    float share =
        lichenIndexWeight(index, lichenLayers.threshold[node], lichenLayers.softness[node]);
    above = mix(above, vec3(share), equal(ivec3(node), ivec3(0, 1, 2)));
  }
  return lichenLayerWeights(above, lichenLayers);
}

/// Where a layer has the image of a role: layerSlot() in bundle/.
int lichenLayerSlot(int layer, int role) {
  return layer == 0 ? role : (layer == 1 ? role + 3 : (layer == 2 ? (role == 0 ? 2 : 5) : 1));
}

/// The value of the map of a role, as lichenValue.
vec4 lichenLayeredValue(int role, LichenLayeredPlace at, vec4 weights) {
  LichenLayerSum sum = lichenNoLayers();
  LICHEN_UNROLL for (int layer = 0; layer < LICHEN_LAYERS; ++layer) {
    if (uint(layer) >= max(lichenLayers.count, 1u)) // another noise is its only layer
      break;
    float weight = weights[layer];
    LichenNoise noise = lichenNoise;
    LichenTriplanarMaterial planes =
        LichenTriplanarMaterial(lichenMaterial, lichenPlaneY, lichenPlaneZ);
    if (layer > 0) {
      noise = lichenLayerNoises[layer - 1];
      planes = lichenLayerMaterials[layer - 1];
    }
    int slot = lichenLayerSlot(layer, role);
    LichenShadingPoint shading = lichenLayerPoint(at, planes, noise);
    LichenMap map = lichenMaps[slot];
    if (weight > 0.0)
      lichenAddLayer(sum, weight, lichenValue(slot, slot, shading, map),
                     role == LICHEN_NORMAL ? vec4(0.0) : map.mean);
  }
  if (role != LICHEN_NORMAL)
    return max(lichenLayered(sum, vec4(0.0)), 0.0);
  bool inSpace = lichenHasSlopesInSpace(lichenMaterial);
  return lichenLayered(sum, inSpace ? vec4(0.0, 0.0, 0.0, 1.0) : vec4(0.0, 0.0, 1.0, 1.0));
}

/// The point of a material with any mapping.
LichenLayeredPoint lichenLayeredAt(vec2 uv, vec2 uvGradientX, vec2 uvGradientY, vec3 position,
                                   vec3 gradientX, vec3 gradientY, vec3 normal) {
  LichenLayeredPlace at =
      LichenLayeredPlace(uv, uvGradientX, uvGradientY, position, gradientX, gradientY, normal);
  LichenLayeredPoint point;
  point.weights = lichenLayerWeightsAt(at);
  vec4 color = vec4(0.0), slopes = vec4(0.0), orm = vec4(0.0);
  LICHEN_UNROLL for (int role = 0; role < 3; ++role) {
    if ((((lichenNoise.roles & uint(LICHEN_ROLES)) >> uint(role)) & 1u) == 0u)
      continue;
    vec4 value = lichenLayeredValue(role, at, point.weights);
    if (role == LICHEN_BASE_COLOR)
      color = value;
    else if (role == LICHEN_NORMAL)
      slopes = value;
    else
      orm = value;
  }
  point.values = vec4[3](color, slopes, orm);
  return point;
}
