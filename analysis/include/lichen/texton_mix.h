// SPDX-License-Identifier: MIT
// Bakes mixes of exemplars for texton noise, [GLM17] section 7: a path from each exemplar to the
// next, or one barycentre of all.
#pragma once

#include <lichen/suitability.h>
#include <lichen/texton.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lichen {

/// One exemplar of a mix.
struct MixedExemplar {
  std::string name; ///< for messages
  /// At least one map, each within the ranges of MapExemplar, with different targets in the order
  /// of MapTarget. All exemplars have the same targets, channels and encodings.
  std::vector<MapExemplar> maps;
};

/// The maximum number of exemplars in a mix.
inline constexpr std::size_t kMaxMixedExemplars = 16;
/// Textons from an exemplar to the next, including both. kMaxTextonSteps also limits all steps
/// together.
inline constexpr NumberRange kMixStepsRange{2.0, double(kMaxTextonSteps)};

struct TextonMixOptions {
  TextonOptions texton;
  int steps = 21; ///< textons from an exemplar to the next, in kMixStepsRange
  /// If not empty, the bake makes one texton, the barycentre with these weights: one per exemplar,
  /// none negative, with a positive sum. `steps` is then ignored.
  std::vector<double> weights;
};

/// How close the textons are to the textures that they approximate, and to one another.
struct TextonMixQuality {
  std::vector<double> modelErrors;   ///< relative model error [GLM14] eq. 5 of each step
  std::vector<double> channelErrors; ///< of each channel alone, the largest of all steps
  /// The largest distance between the coefficients of two adjacent steps, relative to the root of
  /// their mean square. 0 for one texton; 1.4 for two that have nothing in common.
  double largestStep = 0.0;
  double rankError = 0.0; ///< with weights: what one texton cannot express, over the deviation
};

/// The result of a bake. The maps of `noise` number its tables from 0.
struct TextonMixBake {
  Noise noise; ///< maps in the order given
  std::vector<Table> tables;
  TextonMixQuality quality;
};

/// Fits textons along the path through the exemplars in order, or one barycentre of all. All maps
/// of all exemplars are fitted together, so the same impacts can show any exemplar. Every exemplar
/// spans the tile's width; one with fewer pixels is refined without loss. The tile is as high as
/// the highest exemplar; the textures of the others are endless (docs/decisions/008-textons.md).
/// Errors: usage for options or numbers of exemplars out of range, or an image of all steps above
/// kMaxTableSide; badInput for exemplars with different maps, for one that no texton can represent,
/// or if their shapes need a tile of more than kMaxTableSide texels; resources if memory runs out;
/// environment if `options.progress` stops it. Thread-safe; runs on all cores; same bytes for any
/// number of threads. Takes about as long as one bake per exemplar.
[[nodiscard]] Result<TextonMixBake> bakeTextonMix(std::string name,
                                                  std::span<const MixedExemplar> exemplars,
                                                  const TextonMixOptions& options);

/// The risks of each map of one exemplar of a mix, in the order of assessTextonSuitability(). The
/// noise has `widthTexels` texels across the width of the maps.
[[nodiscard]] Result<std::vector<std::vector<Risk>>> assessMixed(std::span<const MapExemplar> maps,
                                                                 int support, int widthTexels,
                                                                 const Progress& progress = {});

/// Says whether the textons of a mix are close to their Gaussian textures and to each other, in one
/// sentence. `instead` says how to bake the exemplars by tiling, which may help.
[[nodiscard]] std::string mixNote(const TextonMixQuality& quality, const Noise& noise,
                                  SettingWords words, std::string_view instead);

/// A sentence if the exemplar is smaller than the support that a bake or a mix asked for.
[[nodiscard]] std::optional<std::string> supportNote(int supportWanted, const TextonShape& shape,
                                                     SettingWords words);

} // namespace lichen
