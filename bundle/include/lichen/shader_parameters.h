// SPDX-License-Identifier: MIT
// The uniform structs of the shader library, filled from a bundle: what the engine plugin uploads
// and what the CPU twin evaluates.
#pragma once

#include <lichen/bundle.h>
#include <lichen/lattice.h>

#include <array>
#include <cstdint>
#include <lichen_interface.h>

namespace lichen {

/// The constants of one map. `map` indexes `noise.maps`, whose table indices must be valid.
[[nodiscard]] shader::LichenMap shaderMap(const Bundle& bundle, const Noise& noise,
                                          std::size_t map);

/// The table of a map of a mix, with `laterSteps`, which the shader has at the binding of an
/// inverse table. Throws std::bad_alloc.
[[nodiscard]] Table mixTable(const NoiseMap& map);

/// The twin of lichenDecodeGaussian (shaders_glsl/noise/tiling_decode.glsl): the decoded value of a
/// map with LICHEN_DECODING_GAUSSIAN at a Gaussian value. Of the variance of each stored channel
/// `lostVariance`, at least 0 and above 1 where contrast is, is missing: the mean over what is
/// missing, for sRGB within 0.0005.
[[nodiscard]] std::array<float, 4> decodedGaussian(const shader::LichenMap& map,
                                                   const std::array<float, 3>& gaussian,
                                                   const std::array<float, 3>& lostVariance);
/// The twin of lichenDecodeRows, clamped as lichenDecodeSeparable does: what the tables of a map
/// with LICHEN_DECODING_SEPARABLE give -> the decoded value.
[[nodiscard]] std::array<float, 4> decodedSeparable(const shader::LichenMap& map,
                                                    const std::array<float, 3>& along);

/// Where and how a material's noise is evaluated.
struct Placement {
  /// Whole tiles added to every coordinate; |.| up to 2^40. Where one is not 0, its period is
  /// whole.
  std::int64_t tileOriginX = 0;
  std::int64_t tileOriginY = 0;
  /// Of triplanar and surface noise, whose origins are in space, in tiles as high as wide.
  std::int64_t tileOriginZ = 0;
  bool periodic = false;     ///< repeat after periodTilesX x periodTilesY tiles; of Mapping::uv
  double periodTilesX = 0.0; ///< at least about half a tile; whole texels, for an exact seam
  double periodTilesY = 0.0;
  double maxAnisotropy = 1.0; ///< of the sampler that fetches the Gaussian images
};

/// How many times as many impacts a point of a surface sees as one of a plane: many count little.
/// The excess kurtosis of a sum with the weights of [GLM17] section 6 is 9/5 that of a plain one.
inline constexpr double kSurfaceImpacts = 2.0;

/// The plane of latticeSeed() for noise on surfaces: 0 is uv, 0 to 2 are triplanar's.
inline constexpr std::uint32_t kSurfacePlane = 3;

/// The parameters of `material`, whose noise index must be valid.
[[nodiscard]] shader::LichenNoise shaderNoise(const Bundle& bundle, const MaterialNoise& material,
                                              const Placement& placement);

/// The constants of a texton noise, as `material` uses it at `placement`; zeros for tiling.
[[nodiscard]] shader::LichenTexton shaderTexton(const Bundle& bundle, const MaterialNoise& material,
                                                const Placement& placement);

} // namespace lichen
