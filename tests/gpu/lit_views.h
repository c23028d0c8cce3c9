// SPDX-License-Identifier: MIT
// Compares pictures of a lit plane of a noise material with the same pictures supersampled, at any
// distance. Bundle, distance, direction of view -> errors of the luminance.
#pragma once

#include "pipelines.h"
#include "renderer.h"
#include "scene.h"

#include <lichen/bundle_writer.h>
#include <lichen/vulkan_device.h>

#include <cstdint>
#include <vector>

namespace lichen::test {

/// A direction from which a level plane is seen, in degrees.
struct Viewpoint {
  double elevation = 90.0; ///< above the plane
  double azimuth = 0.0;    ///< from +z toward +x
};

/// Opposite to the built-in sun, at its height: a mirror reflects the sun to the camera.
[[nodiscard]] Viewpoint towardSun();
/// The built-in sun is behind the camera, which is 30 degrees above the plane.
[[nodiscard]] Viewpoint awayFromSun();

/// Averages a map that repeats over 5 x 5 texels, twice. Its details become larger than texels, so
/// that interpolation between texels, which a supersampled picture shows, does not flatten them.
/// Row-major, `side` x `side` texels of `channels` values.
[[nodiscard]] std::vector<float> smoothed(std::vector<float> values, int side, int channels);

/// What lights the plane: the built-in sun and sky, or one of them alone.
enum class LitBy { both, sun, sky };

/// Luminances (Rec. 709 weights, of light before tone mapping) of a frame with one sample per pixel
/// and of its supersampled reference.
struct LitError {
  double meanError = 0.0; ///< of the frame's mean, relative to the reference's
  /// Root mean square difference of the frame's pixels from the reference's, relative to the
  /// reference's mean.
  double pixelError = 0.0;
  /// The same for one unfiltered sample per pixel: the noise of aliasing, without any filter.
  double aliasing = 0.0;
};

/// A level plane whose only material is a bundle's, under the built-in sun and sky. The
/// samples of a reference are at most half a texel apart, so that the noise's own filter has
/// nothing to do there.
class LitPlane {
public:
  /// `file`: one noise and one material with texture coordinates and exemplars of `texels` texels a
  /// side. The factors multiply the noise's values. Throws std::runtime_error.
  LitPlane(VulkanDevice& device, const BundleFile& file, int texels, double roughnessFactor,
           double metallicFactor);

  /// An orthographic picture whose pixels are `texelsPerPixel` wide, and longer by the slant of the
  /// view. At most `side` pixels a side, fewer where the reference would have more than
  /// kReferenceSide samples a side. Throws std::runtime_error.
  [[nodiscard]] LitError seen(double texelsPerPixel, const Viewpoint& from, std::uint32_t side,
                              LitBy light = LitBy::both);

  /// Limits the memory and time of a reference: 2048 x 2048 pixels take 48 MiB, and 64 MiB on the
  /// device.
  static constexpr std::uint32_t kReferenceSide = 2048;

private:
  [[nodiscard]] LinearImage picture(double halfSide, const Viewpoint& from, std::uint32_t side,
                                    LitBy light);

  VulkanDevice& device_;
  renderer::SkyCache skies_;
  renderer::PipelineStore pipelines_;
  renderer::Scene scene_;
  int texels_;
};

} // namespace lichen::test
