// SPDX-License-Identifier: MIT
// Bakes mixes of exemplars for texton noise: from one to the next, or one texture between all
// [GLM17] section 7.
#pragma once

#include <lichen/texton.h>

#include <span>
#include <string>
#include <vector>

namespace lichen {

/// One of the exemplars that are mixed.
struct MixedExemplar {
  std::string name; ///< for messages
  /// At least one, each within the ranges of MapExemplar, of other targets, in the order of these;
  /// the same targets, channels and encodings in all exemplars.
  std::vector<MapExemplar> maps;
};

/// As many are mixed.
inline constexpr std::size_t kMaxMixedExemplars = 16;
/// Textons from an exemplar to the next, both counted. All steps together are kMaxTextonSteps.
inline constexpr NumberRange kMixStepsRange{2.0, double(kMaxTextonSteps)};

struct TextonMixOptions {
  TextonOptions texton; ///< its fit is TextonFit::transport
  int steps = 21;       ///< from an exemplar to the next, in kMixStepsRange
  /// Where not empty, one texton is made, of the barycentre with these weights: one an exemplar,
  /// none negative, of a positive sum. `steps` is then not used.
  std::vector<double> weights;
};

/// How near the textons are to the textures that they stand for, and to one another.
struct TextonMixQuality {
  std::vector<double> modelErrors; ///< relative model error [GLM17 section 4.4] of each step
  /// Of the steps: the greatest distance of two neighbours' coefficients, over the root of their
  /// mean square. 0 of one texton; 1.4 of two of nothing in common.
  double largestStep = 0.0;
  double rankError = 0.0; ///< with weights: what one texton cannot express, over the deviation
};

/// What a bake made: tables numbered from 0 in the maps of `noise`.
struct TextonMixBake {
  Noise noise; ///< its maps in the order given
  std::vector<Table> tables;
  TextonMixQuality quality;
};

/// Fits textons along the path through the exemplars in their order, or one between all of them.
/// All maps of all exemplars are fitted together, and the same impacts show one exemplar or
/// another. Every exemplar spans the tile's width: one of fewer pixels is refined, without loss;
/// the tile is as high as the highest, whose other texture is endless
/// (docs/decisions/016-mixing.md). Errors: usage for options and numbers of exemplars outside their
/// ranges, or an image of all steps above kMaxTableSide; badInput for exemplars of different maps,
/// for one that no texton can be made of, and where their shapes make a tile of more than
/// kMaxTableSide texels; resources when memory does not suffice, environment when
/// `options.progress` stops it. Thread-safe; runs on all cores, and the same bytes for any number
/// of threads. Time: about one bake for each exemplar.
[[nodiscard]] Result<TextonMixBake> bakeTextonMix(std::string name,
                                                  std::span<const MixedExemplar> exemplars,
                                                  const TextonMixOptions& options);

} // namespace lichen
