// SPDX-License-Identifier: MIT
// Light from all directions, prepared for shading: what the rough and the matte see of a panorama.
#pragma once

#include <lichen/image.h>
#include <lichen/result.h>

#include <glm/glm.hpp>

#include <filesystem>
#include <vector>

namespace lichen::renderer {

/// One mip level of a cube map: RGB, six faces of side x side texels in Vulkan's order (+x, -x, +y,
/// -y, +z, -z), rows top first.
struct CubeLevel {
  int side = 1;
  std::vector<glm::vec3> texels;
};

inline constexpr int kSpecularLevels = 7;
inline constexpr int kBrdfSide = 32;

struct Environment {
  LinearImage panorama; ///< RGB radiance, latitude-longitude
  /// Level k holds the radiance averaged under the GGX lobe of roughness k / (levels - 1) seen
  /// along its axis [Karis 2013, "split sum"].
  std::vector<CubeLevel> specular;
  CubeLevel diffuse;           ///< irradiance / pi by normal
  std::vector<glm::vec4> brdf; ///< environmentBrdf(kBrdfSide)
};

/// A latitude-longitude panorama as light: EXR, PNG or JPEG. Errors as readImage().
[[nodiscard]] Result<LinearImage> readPanorama(const std::filesystem::path& path);

/// Halved, by averages of 2 x 2 pixels, until no side is longer than `longestSide`, at least 1.
[[nodiscard]] LinearImage fitted(LinearImage panorama, int longestSide);

/// The panorama's pixels are linear RGB (more channels are ignored, a single one is grey).
[[nodiscard]] Environment prepareEnvironment(const LinearImage& panorama);

/// Scale and bias of F0 for light from a uniform environment under GGX and Smith: texel (x, y) of a
/// side x side table is for n.v = (x + 1/2) / side and perceptual roughness (y + 1/2) / side. z is
/// what single scattering loses of a white metal, 1 - scale - bias, at least 0 and by itself since
/// half floats near 1 would not tell it; w is its mean over a row, weighted with the cosine.
[[nodiscard]] std::vector<glm::vec4> environmentBrdf(int side);

/// GGX's alpha of a perceptual roughness, kept from 0 so that the lobe stays finite. The shaders
/// have the same function.
[[nodiscard]] float alphaOf(float roughness);

} // namespace lichen::renderer
