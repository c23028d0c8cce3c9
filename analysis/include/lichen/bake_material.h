// SPDX-License-Identifier: MIT
// Photographs of a material -> noise, in one call: what `lichen bake` does, without files.
#pragma once

#include <lichen/bake_memory.h>
#include <lichen/bundle_writer.h>
#include <lichen/exemplar_preparation.h>
#include <lichen/image.h>
#include <lichen/method_bake.h>
#include <lichen/noise_verdict.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace lichen {

/// Which pixels of an exemplar are which material, in 2 to 4 colours.
struct LabelPicture {
  SrgbImage image;  ///< of the exemplar's shape
  std::string name; ///< in messages
};

/// A noise for each label, in which index maps alternate: 2 to 4 clusters of colours, or labels.
using LayersOptions = std::variant<int, LabelPicture>;

struct BakeOptions {
  std::string name; ///< of the noise and its material, UTF-8; empty: the photographs'
  ExemplarOptions exemplar;
  /// Absent: quilting if something repeats clearly or has clear outlines, otherwise tiling. An
  /// absent guide of quilting is as clear as the exemplar repeats. The bake sets the members that
  /// all methods have: progress, precision, and whether borders fit.
  std::optional<MethodOptions> method;
  int bits = 8;                ///< 8 or 16 per channel of the tables
  double tileSizeMetres = 1.0; ///< width of the exemplar, before it is straightened; kTileSizeRange
  MaterialNoise material;      ///< how the material uses the noise; its seed
  std::optional<LayersOptions> layers;
};

/// What is known of how good a noise is.
struct NoiseJudgement {
  std::vector<std::vector<Risk>> risks; ///< of each exemplar, as assessNoise() returns them
  std::vector<Measure> measures;        ///< of the first map, on a small result
  Verdict verdict;
};

struct BakedMaterial {
  /// Noise 0, and material 0, which uses it. Layers and index maps are further noises.
  Bundle bundle;
  std::vector<MapExemplar> exemplars;  ///< as they were baked, one per map
  std::vector<ExemplarOrigin> origins; ///< one per exemplar
  BakeFigures figures;             ///< of the first label's noise, if there are layers
  std::vector<double> proportions; ///< of what lies above the threshold of each index map
  NoiseJudgement judgement;
  std::vector<std::string> notes; ///< all that the observer heard
};

/// Chooses the method, unless the options do; straightens, flattens and fills the exemplar; bakes
/// it; and judges the noise. `set` holds the maps, read with options.exemplar.set. The steps are
/// "flatten", "outliers", "bake" and "judge". Errors: usage for options out of range, or maps
/// or a method that layers cannot have; badInput for labels of another shape, and as the bakes;
/// resources if memory runs out; environment if `observer` stops it. Thread-safe; runs on all
/// cores; same bytes for any number of threads.
[[nodiscard]] Result<BakedMaterial> bakeMaterial(MaterialSet set, const BakeOptions& options,
                                                 const BakeObserver& observer = {});

/// As above. The names of the photographs say which maps they are, as in materialSetOf().
[[nodiscard]] Result<BakedMaterial> bakeMaterial(std::vector<Photograph> photographs,
                                                 const BakeOptions& options,
                                                 const BakeObserver& observer = {});

/// Replaces bytes that are not UTF-8 with underscores: names of noises must be UTF-8.
[[nodiscard]] std::string asUtf8(const std::string& text);

/// How the maps of such a bake are read: options.exemplar.set, but labels are of a whole picture.
[[nodiscard]] MaterialSetOptions readingOf(const BakeOptions& options);

/// The memory of a bake with these options, the most that it may choose to take.
[[nodiscard]] BakeMemory bakeMemoryOf(const BakeOptions& options);
[[nodiscard]] BakeMemory bakeMemoryOf(const MethodOptions& options);

/// Judges the noise of a material of the bundle. `maps` are the exemplars as they were baked,
/// `bordersWereKept` is BakeFigures'. Errors: as assessNoise() and measureNoise().
[[nodiscard]] Result<NoiseJudgement> judgeNoise(const Bundle& bundle, const MaterialNoise& material,
                                                std::span<const MapExemplar> maps, Periodic borders,
                                                bool bordersWereKept,
                                                const Progress& progress = {});

/// A bundle with tileable images of its noises for the core materials, evaluated with each
/// material's parameters; ready for encodeGlb(). Each material has a noise. `progress` counts
/// materials. Errors: as synthesize() and encodePng().
[[nodiscard]] Result<BundleFile> withPreviews(Bundle bundle, PreviewShape shape,
                                              std::string generator, const Progress& progress = {});

} // namespace lichen
