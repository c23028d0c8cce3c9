// SPDX-License-Identifier: MIT
// The coefficients of a texton from the spectrum that its noise is to have.
#pragma once

#include <lichen/fft.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace lichen::texton {

/// A Gaussian texture of `channels` channels on a periodic domain: white noise convolved with one
/// kernel a channel. channels[c] is the kernel's transform, t_u^ of [GLM17] section 3.1 for an
/// exemplar: all of one size, at least 1, and zero at frequency 0.
struct GaussianModel {
  std::vector<HalfSpectrum> channels;

  [[nodiscard]] int width() const { return channels[0].width; }
  [[nodiscard]] int height() const { return channels[0].height; }
};

/// The model of an image, `channelCount` interleaved values a pixel: the periodic component less
/// its mean over sqrt(width height) [GLM17] section 3.1, [M11].
[[nodiscard]] GaussianModel gaussianModel(std::span<const float> values, int width, int height,
                                          int channelCount);

/// Coefficients of a texton, `width` x `height` of them and a value a channel each:
/// (x, y, c) at (c * height + y) * width + x.
struct TextonCoefficients {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> values;
};

struct FitOptions {
  int width = 0;  ///< coefficients, [1, the model's width]
  int height = 0; ///< coefficients, [1, the model's height]
  int order = 1;  ///< of the interpolating B-spline, [0, 8]
  std::uint32_t seed = 1;
  int projections = 50; ///< of alternatingProjections, >= 1; 50 in [GLM17] section 4.2
  /// Called after each iteration; false ends the fit with what there is.
  std::function<bool()> goOn;
};

/// How the coefficients are found.
enum class FitMethod {
  transportDistance,      ///< least transport distance, from a start of relaxed reflections
  alternatingProjections, ///< [GLM17] algorithm 1 as printed; of order 0, [GLM14] algorithm 2
};

/// How many times a fit calls FitOptions::goOn.
[[nodiscard]] int iterationsOf(const FitOptions& options, FitMethod method);

/// Coefficients whose noise is near the model; by least transport distance their border does not
/// show and none stands out (docs/decisions/019-border-of-textons.md). Same bytes for any number of
/// threads. Time: 100 transforms of a plane for each channel. Throws std::bad_alloc.
[[nodiscard]] TextonCoefficients fitCoefficients(const GaussianModel& model,
                                                 const FitOptions& options, FitMethod method);

/// [GLM17] section 4.4, ALGORITHMS: the root of the transport distance between the two Gaussian
/// textures over the model's variance, over all frequencies but 0. 0 for equal power spectra, 1 for
/// a texton of zeros.
[[nodiscard]] double relativeModelError(const GaussianModel& model,
                                        const TextonCoefficients& coefficients, int order);

} // namespace lichen::texton
