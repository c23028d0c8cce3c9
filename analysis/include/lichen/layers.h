// SPDX-License-Identifier: MIT
// Splits an exemplar into the materials that a label for each pixel tells apart, and models where
// the materials lie by Gaussian fields with thresholds. [MKN12] section 5, multi-layered textures.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/image.h>
#include <lichen/result.h>
#include <lichen/spectrum_picture.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lichen {

inline constexpr int kFewestLabels = 2, kMostLabels = 4;
inline constexpr double kLeastLabelShare = 0.01; ///< of the pixels, for each label

/// A label for each pixel: pixel (x, y) has labels[y * width + x], in [0, count). It belongs to the
/// maps of an exemplar whatever their sizes: both cover the same tile.
struct LabelImage {
  int width = 0, height = 0; ///< pixels, [1, 16384]
  int count = 0;             ///< [kFewestLabels, kMostLabels]
  std::vector<std::uint8_t> labels;
};

/// Reads labels from a painted picture: each colour is a label, by ascending luminance. A picture
/// with more than kMostLabels colours, such as a JPEG or one with smooth edges, has those that fill
/// areas and differ by more than 40 of 255 in a channel; each pixel takes the nearest. Ignores
/// alpha. `name` starts the messages. Errors: badInput for fewer than kFewestLabels or more than
/// kMostLabels colours with at least kLeastLabelShare of the pixels; resources if memory runs out.
/// O(N log N) in the number of pixels.
[[nodiscard]] Result<LabelImage> labelsFromPicture(const SrgbImage& picture,
                                                   const std::string& name);

/// Finds `count` colours by k-means [AV07] in OKLab [O20], and labels each pixel with the nearest,
/// by ascending lightness. Colours are smoothed first, and labels take the majority of their
/// surroundings, so that labels form regions. Deterministic. Errors: usage for another count than
/// kFewestLabels to kMostLabels or a map outside its ranges; badInput for fewer colours than
/// `count`, or if a label has less than kLeastLabelShare of the pixels; resources if memory runs
/// out. O(N) in the number of pixels.
[[nodiscard]] Result<LabelImage> clusterLabels(const MapExemplar& baseColor, int count);

/// How clearly labels separate the colours of a map, in [0, 1]: for the two labels that are least
/// separate, one minus the number of colours midway between their means over the number near the
/// rarer mean. 0 if as many lie midway, as for a single cluster cut in two; 1 if none do. The map's
/// colours are smoothed as in clusterLabels(). Throws std::bad_alloc. O(N).
[[nodiscard]] double labelSeparation(const MapExemplar& baseColor, const LabelImage& labels);

/// The exemplar of one label's material: each map as it is inside the label, and filled elsewhere
/// with copies of the label's regions. Copies are blended as tiles are [HN18], with the mean and
/// variance of the label; all maps take the same copies, and these repeat with the tile, so that
/// borders that match still do. Pixels within 3.5 pixels of other labels are replaced too, as they
/// show both materials; fewer where the label is thin. Filled values lie within the range of the
/// label's values. `label` is in [0, labels.count) and has pixels; maps may differ in size, and
/// each is within the ranges of MapExemplar. Throws std::bad_alloc. Parallel; same bytes for any
/// number of threads. O(N) in the number of values.
[[nodiscard]] std::vector<MapExemplar> exemplarsOfLabel(std::span<const MapExemplar> maps,
                                                        const LabelImage& labels, int label);

/// Splits a region in two where a Gaussian field exceeds a threshold.
struct LayerSplit {
  double proportion = 0.5; ///< of the region that lies above the threshold, in (0, 1)
  /// The spectrum of the field, whose variance is 1: the squares of the amplitudes sum to 1. It
  /// ends at a quarter of the label image's frequencies and at 128 cycles per tile.
  SpectrumPicture spectrum;
  /// Labels, or, as nodes, other splits, which come later in their vector. `below` has the darker
  /// mean colour.
  LayerSide below, above;
};

/// Models where labels lie: a binary tree of labels.count - 1 splits, the first of which is the
/// root. Labels of similar mean colour in `map`, usually the base colour, are split last. The
/// spectrum of a split belongs to the Gaussian field that, cut at the threshold of the proportion,
/// has the autocovariance of the labels inside the region [T91]. Throws std::bad_alloc.
/// O(N log N) in the number of pixels.
[[nodiscard]] std::vector<LayerSplit> splitLayers(const MapExemplar& map, const LabelImage& labels);

/// Nodes for layerNoises() whose layers cover areas in the ratio of `shares`, at least two numbers
/// above 0: node n divides layer n from those after it. Errors: usage for a layer that is too small
/// beside those after it, or too large. Throws std::bad_alloc.
[[nodiscard]] Result<std::vector<LayerNode>> layerChain(std::span<const double> shares,
                                                        double softness);

} // namespace lichen
