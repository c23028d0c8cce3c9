// SPDX-License-Identifier: MIT
// The images that lichen-bench measures.
#pragma once

#include <lichen/bundle.h>
#include <lichen/image.h>
#include <lichen/local_random_phase.h>
#include <lichen/material_set.h>
#include <lichen/tiling.h>

#include <span>
#include <string>
#include <vector>

namespace lichen::bench {

struct Exemplar {
  std::string name;
  SrgbImage image;
};

/// The generated materials at 256 x 256, then crops of that size from the photographs in
/// ../shared/exemplars, if that folder exists.
[[nodiscard]] std::vector<Exemplar> exemplars256();

[[nodiscard]] MapExemplar baseColorMap(const SrgbImage& image);

/// A generated material set of one surface: base colour (RGB), normal (two slopes),
/// occlusion-roughness-metallic and height.
[[nodiscard]] std::vector<MapExemplar> materialSet(int sidePixels);

/// The sets in the folders of ../shared/exemplars, if that folder exists.
[[nodiscard]] std::vector<MaterialSet> photographedSets();

/// The bundle of a bake, with its material. If the bake failed, there is nothing to measure, and
/// the program ends with the bake's message.
[[nodiscard]] Bundle bundleOf(Result<MethodBake> bake);
/// Bakes an exemplar or a set.
[[nodiscard]] Bundle bakedBundle(std::span<const MapExemplar> maps,
                                 const TilingOptions& options = {});
[[nodiscard]] Bundle bakedBundle(const SrgbImage& image, const TilingOptions& options = {});
/// The same for a texton of support 64.
[[nodiscard]] Bundle textonBundle(const SrgbImage& image);
/// The same for local random-phase noise, by default of 50 cosines.
[[nodiscard]] Bundle localRandomPhaseBundle(const SrgbImage& image,
                                            const LocalRandomPhaseOptions& options = {});

/// The same for multiple-kernels noise of at most 8 kernels.
[[nodiscard]] Bundle multipleKernelsBundle(const SrgbImage& image);
/// The same for quilting.
[[nodiscard]] Bundle quiltingBundle(const SrgbImage& image);

} // namespace lichen::bench
