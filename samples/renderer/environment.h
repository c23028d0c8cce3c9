// SPDX-License-Identifier: MIT
// Image-based lighting: prefilters a panorama for specular and diffuse shading.
#pragma once

#include <lichen/image.h>
#include <lichen/result.h>

#include <glm/glm.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace lichen::renderer {

/// One mip level of a cube map: RGB, six faces of side x side texels in Vulkan's order (+x, -x, +y,
/// -y, +z, -z), each with its top row first.
struct CubeLevel {
  int side = 1;
  std::vector<glm::vec3> texels;
};

inline constexpr int kSpecularLevels = 7;
inline constexpr int kBrdfSide = 32;

struct Environment {
  LinearImage panorama; ///< RGB radiance, latitude-longitude
  /// Level k holds the radiance averaged under the GGX lobe of roughness k / (levels - 1), for a
  /// view direction along the normal [Karis 2013, "split sum"].
  std::vector<CubeLevel> specular;
  CubeLevel diffuse;           ///< irradiance / pi, indexed by the normal
  std::vector<glm::vec4> brdf; ///< environmentBrdf(kBrdfSide)
};

/// Reads a latitude-longitude panorama (EXR, PNG or JPEG) as linear light. Adds notes about the
/// file, such as that it is not twice as wide as high. Errors as readImage().
[[nodiscard]] Result<LinearImage> readPanorama(const std::filesystem::path& path,
                                               std::vector<std::string>& notes);

/// Halves the panorama, averaging 2 x 2 pixels, until neither side exceeds `longestSide` (at least
/// 1).
[[nodiscard]] LinearImage fitInto(LinearImage panorama, int longestSide);

/// Takes linear RGB; a single channel counts as grey and channels after the third are ignored.
[[nodiscard]] Environment prepareEnvironment(const LinearImage& panorama);

/// Scale (x) and bias (y) of F0 for a uniform environment under GGX with Smith visibility. Texel
/// (x, y) of the side x side table is for n.v = (x + 1/2) / side and perceptual roughness (y + 1/2)
/// / side. z is the energy that single scattering loses on a white metal, 1 - scale - bias, at
/// least 0; it is stored separately because half floats near 1 cannot resolve the difference. w is
/// the cosine-weighted mean of z over the row.
[[nodiscard]] std::vector<glm::vec4> environmentBrdf(int side);

/// GGX's alpha for a perceptual roughness, clamped above 0 so that the lobe stays finite. Same
/// function as in shading.glsl.
[[nodiscard]] float alphaOf(float roughness);

} // namespace lichen::renderer
