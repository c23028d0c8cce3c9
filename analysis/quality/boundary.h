// SPDX-License-Identifier: MIT
// What every measure does at the public boundary: refuse unusable images, and let no exception
// escape.
#pragma once

#include <lichen/counted.h>
#include <lichen/image.h>
#include <lichen/result.h>

#include <algorithm>
#include <optional>
#include <string>

namespace lichen {

/// Colour channels without alpha: 1 or 3.
inline int colorChannels(const SrgbImage& image) { return image.channels >= 3 ? 3 : 1; }

inline int shorterSide(const SrgbImage& image) { return std::min(image.width, image.height); }

inline std::string describe(const SrgbImage& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height) + " with " +
         counted(std::size_t(image.channels), "channel");
}

/// Why a measure cannot use this image, or nothing if it can.
inline std::optional<Error> refusal(const SrgbImage& image, const char* role, int shortestSide) {
  const bool hasPixels = image.width >= 1 && image.height >= 1 && image.channels >= 1 &&
                         image.channels <= 4 &&
                         image.values.size() == image.pixelCount() * std::size_t(image.channels);
  if (!hasPixels)
    return Error{ErrorKind::badInput, std::string(role) + " is " + describe(image) +
                                          "; expected pixels with 1 to 4 channels"};
  if (shorterSide(image) >= shortestSide)
    return std::nullopt;
  return Error{ErrorKind::badInput, std::string(role) + " is " + std::to_string(image.width) +
                                        " x " + std::to_string(image.height) +
                                        "; expected sides of at least " +
                                        std::to_string(shortestSide) + " pixels"};
}

/// The same for an exemplar and its result.
inline std::optional<Error> refusal(const SrgbImage& exemplar, const SrgbImage& result,
                                    int shortestSide) {
  if (auto error = refusal(exemplar, "the exemplar", shortestSide))
    return error;
  if (auto error = refusal(result, "the result", shortestSide))
    return error;
  if (colorChannels(exemplar) == colorChannels(result))
    return std::nullopt;
  return Error{ErrorKind::badInput, "the exemplar is " + describe(exemplar) + " and the result " +
                                        describe(result) +
                                        "; expected both grey or both in colour"};
}

/// The message when a measure runs out of memory.
inline const char* exhausted() { return "memory exhausted while measuring; try a smaller result"; }

} // namespace lichen
