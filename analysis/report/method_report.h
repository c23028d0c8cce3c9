// SPDX-License-Identifier: MIT
// What comparison and report ask of a method. Each method implements it in methods/; methods.cpp
// lists them.
#pragma once

#include "data_uri.h"

#include <lichen/json_tree.h>
#include <lichen/noise_comparison.h>
#include <lichen/synthesize.h>

namespace lichen {

/// A result of a noise beside the exemplar that it was made from.
struct ComparedResult {
  const Bundle& bundle;
  const NoiseMap& map;
  const MapExemplar& exemplar;     ///< as large as the map's exemplar
  bool isEnlarged = false;         ///< from a smaller one, to the size of the set's largest map
  const SynthesisOptions& options; ///< of the result
  Progress progress;               ///< of what is synthesized besides
};

class MethodReport {
public:
  virtual ~MethodReport() = default;

  /// Whether all maps of a set have the size of the largest.
  [[nodiscard]] virtual bool enlargesMaps() const = 0;
  /// Pixels that judge() synthesizes.
  [[nodiscard]] virtual double judgedPixels(int exemplarWidth, int exemplarHeight) const = 0;
  /// Adds the measures to a comparison that has its pictures, and pictures of the method's own.
  [[nodiscard]] virtual Result<void> judge(const ComparedResult& result,
                                           NoiseComparison& comparison) const = 0;

  /// Pixels of a map's pictures on the page per pixel of its exemplar's.
  [[nodiscard]] virtual double picturePixels() const = 0;
  /// `title`, `text` and the picture `png` of the image that the shader fetches from, of about as
  /// many pixels as a square of `side`.
  [[nodiscard]] virtual Result<JsonTree> image(const Bundle& bundle, const Noise& noise,
                                               const NoiseMap& map, int side) const = 0;
  /// `picture`, `slices` and `levels` of the table that decodes Gaussian values; null without one.
  [[nodiscard]] virtual Result<JsonTree> table(const Bundle& bundle, const NoiseMap& map,
                                               const MapLook& look) const = 0;
};

[[nodiscard]] const MethodReport& reportOf(Method method);

} // namespace lichen
