// SPDX-License-Identifier: MIT
// A noise on texture coordinates: where it is evaluated, and how its slopes become normals.
// uv (float2) and its screen-space gradients -> LichenShadingPoint; slopes (float2) -> normal in
// tangent space; their variance lost to filtering -> roughness.

/// The shading point at `uv` with explicit gradients: usable in compute and in non-uniform control
/// flow.
LichenShadingPoint lichenPointUvGrad(vec2 uv, vec2 uvGradientX, vec2 uvGradientY,
                                     LichenMaterial material, LichenNoise noise) {
  vec2 position = vec2(material.offsetX, material.offsetY) + lichenUvToTile(uv, material);
  LichenShadingPoint shading;
  shading.material = material;
  shading.noise = noise;
  shading.point = lichenPointAt(position, lichenUvToTile(uvGradientX, material),
                                lichenUvToTile(uvGradientY, material), material, noise);
  lichenSetMix(shading.point, lichenMixWeight(uv, material), lichenMixGradient(material));
  return shading;
}

/// The value of a map's first channel and its derivatives along x and y of tile space [1 / tile],
/// for bumps of a height: differences over a texel of the footprint. The weight of a mix and its
/// derivatives are those that lichenSetMix takes.
vec3 lichenGradientAt(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, vec2 position, vec2 gradientX,
                      vec2 gradientY, float mixWeight, vec2 mixGradient, LichenMaterial material,
                      LichenNoise noise, LichenMap map) {
  vec2 texels = vec2(noise.tileTexelsX, noise.tileTexelsY);
  float level = lichenSharpLevel(lichenFootprintLevel(gradientX * texels, gradientY * texels));
  vec2 halfTexel = 0.5 * exp2(level) / texels;
  vec3 gradient = vec3(0.0);
  for (int k = 0; k < 5; ++k) { // the point, then half a texel to each side
    vec2 side = vec2(float(int(k == 1) - int(k == 2)), float(int(k == 3) - int(k == 4)));
    vec2 away = side * halfTexel;
    LichenPoint point = lichenPointAt(position + away, gradientX, gradientY, material, noise);
    lichenSetMix(point, mixWeight + dot(mixGradient, away), mixGradient);
    float value = lichenValueAt(image, table, point, material, noise, map).x;
    gradient += value * vec3(float(int(k == 0)), 0.5 * side / halfTexel);
  }
  return gradient;
}

/// The same at `uv`, with the material's weight of a mix.
vec3 lichenGradientUvGrad(LICHEN_IMAGE_2D image, LICHEN_IMAGE_3D table, vec2 uv, vec2 uvGradientX,
                          vec2 uvGradientY, LichenMaterial material, LichenNoise noise,
                          LichenMap map) {
  return lichenGradientAt(
      image, table, vec2(material.offsetX, material.offsetY) + lichenUvToTile(uv, material),
      lichenUvToTile(uvGradientX, material), lichenUvToTile(uvGradientY, material),
      lichenMixWeight(uv, material), lichenMixGradient(material), material, noise, map);
}

/// The unit tangent-space normal of slopes (-nx/nz, -ny/nz).
vec3 lichenNormalFromSlopes(vec2 slopes) { return normalize(vec3(-slopes, 1.0)); }

/// The perceptual roughness of a microfacet surface whose slopes vary by `slopeVariance`, along
/// each axis, where the footprint does not show it: a slope map's z, times the square of what
/// multiplies the slopes. Neither rotation nor scale of the texture coordinates changes it.
float lichenRoughness(float roughness, float slopeVariance) {
  // [OB10] section 3, [TK19] eq. 3: a facet's slopes have the variance alpha^2 / 2 along each axis
  // (of GGX, the Beckmann's that it stands for), and variances add.
  float alpha = roughness * roughness;
  return sqrt(sqrt(min(1.0, alpha * alpha + 2.0 * max(0.0, slopeVariance))));
}

// The weight of a mix of textons from a mask; lichenSetMix takes it from elsewhere. The library
// fetches no mask, since each host binds images in its own way.

/// Half the size of a texton [tiles].
vec2 lichenImpactReach(LichenNoise noise) {
  return 0.5 * lichenTextonCoefficients(noise) / vec2(noise.tileTexelsX, noise.tileTexelsY);
}

/// Where a mask is fetched beside the point itself: at its texture coordinates plus and minus each
/// column, which lie along x and y of tile space. The columns of `uvGradients` are the screen-space
/// gradients of those coordinates, of `tileGradients` the tile coordinate's.
mat2 lichenMaskReach(mat2 uvGradients, mat2 tileGradients, LichenNoise noise) {
  // As wide as the impacts lie: differences of neighbouring texels would jump at the mask's texels,
  // and what lies between two of them is often as wide as a texton.
  float area = determinant(tileGradients);
  mat2 uvPerTile = area != 0.0 ? uvGradients * inverse(tileGradients) : mat2(0.0);
  vec2 reach = lichenImpactReach(noise);
  return mat2(reach.x * uvPerTile[0], reach.y * uvPerTile[1]);
}

/// From a mask: its value at the point, and for each column of lichenMaskReach the value at plus
/// the column less that at minus the column.
void lichenMixByMask(LICHEN_INOUT(LichenPoint) point, float weight, vec2 differences,
                     LichenNoise noise) {
  lichenSetMix(point, weight, differences / (2.0 * lichenImpactReach(noise)));
}
