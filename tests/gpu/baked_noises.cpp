// SPDX-License-Identifier: MIT
// Baked noises for the tests; see baked_noises.h.
#include "baked_noises.h"

#include "../property/bundle_of.h"
#include "../property/example_exemplar.h"
#include "slopes_of_color.h"

#include <lichen/local_random_phase.h>
#include <lichen/multiple_kernels.h>
#include <lichen/quilting.h>
#include <lichen/texton.h>
#include <lichen/tiling.h>

#include <cmath>
#include <numbers>

namespace lichen::test {
namespace {

MapExemplar exemplarOf(MapTarget target, std::uint64_t seed) {
  using enum MapChannel;
  MapExemplar map = threeMaterials(kExemplarWidth, kExemplarHeight, seed);
  if (target == MapTarget::baseColor)
    return map;
  if (target == MapTarget::normal)
    return slopesOf(std::move(map));
  map.target = target;
  map.encoding = ValueEncoding::linear;
  map.channels = {occlusion, roughness, metallic};
  if (target == MapTarget::height) {
    map.channels = {height};
    for (std::size_t i = 0; i < map.values.size() / 3; ++i)
      map.values[i] = map.values[3 * i];
    map.values.resize(map.values.size() / 3);
  }
  return map;
}

template <class Options>
Options with16Bits(const Baked& kind) {
  Options options;
  options.bits = 16;
  if constexpr (requires { options.gaussian; })
    options.gaussian = kind.gaussian;
  return options;
}

/// The last kernels become rings, with the round windows that rings have.
void turnIntoRings(Bundle& bundle, int rings) {
  auto& noise = bundle.noises[0].as<MultipleKernelsNoise>();
  Table& image = bundle.tables[bundle.noises[0].maps[0].as<MultipleKernelsMap>().kernels];
  std::vector<KernelRow> rows = kernelRows(image, noise);
  const std::vector<PatternCosine> pattern = patternCosines(image, noise);
  noise.rings = rings;
  for (std::size_t k = rows.size() - std::size_t(rings); k < rows.size(); ++k) {
    KernelRow& row = rows[k];
    row.frequency = {std::hypot(row.frequency[0], row.frequency[1]), 0.0f};
    const double scale = double(row.toWindow[3]); // of a support of the area pi / scale^2
    row.toWindow = {float(scale), 0.0f, 0.0f, float(scale)};
    row.amplitude =
        float(scale * std::sqrt(7.0 * 64.0 / (std::numbers::pi * row.columns * row.rows)));
  }
  image.texels = kernelTable(rows, pattern).texels;
}

Bundle bakedBundle(const Baked& kind) {
  std::vector<MapExemplar> maps;
  for (const MapTarget target : kind.targets)
    maps.push_back(exemplarOf(target, kind.exemplar));
  switch (kind.method) {
  case Method::tiling:
    return bundleOf(bakeTiling("noise", maps, with16Bits<TilingOptions>(kind)));
  case Method::texton: {
    TextonOptions options;
    options.support = 16;
    return bundleOf(bakeTexton("noise", maps, options));
  }
  case Method::localRandomPhase: {
    auto options = with16Bits<LocalRandomPhaseOptions>(kind);
    options.cosines = 24;
    options.structure = kind.structure;
    options.guide = kind.guide;
    options.turbulence = kind.structure > 0.0 && kind.structure < 1.0 ? 0.05 : 0.0;
    return bundleOf(bakeLocalRandomPhase("noise", maps, options));
  }
  case Method::multipleKernels: {
    auto options = with16Bits<MultipleKernelsOptions>(kind);
    options.window = kind.window;
    options.kernels = 6;
    if (kind.patternCosines > 0)
      options.perturbation.emplace().cosines = kind.patternCosines;
    Bundle bundle = bundleOf(bakeMultipleKernels("noise", maps, options));
    turnIntoRings(bundle, kind.rings);
    return bundle;
  }
  case Method::quilting: {
    auto options = with16Bits<QuiltingOptions>(kind);
    options.guide = kind.guide;
    Bundle bundle = bundleOf(bakeQuilting("noise", maps, options));
    bundle.noises[0].as<QuiltingNoise>().grain = kind.grain;
    return bundle;
  }
  }
  return {};
}

} // namespace

BundleFile fileOf(Bundle bundle) {
  BundleFile file;
  file.bundle = std::move(bundle);
  if (file.bundle.materials.empty())
    file.bundle.materials = {MaterialNoise()};
  file.previews.emplace_back();
  file.shape = PreviewShape::none;
  return file;
}

BundleFile baked(const Baked& kind) { return fileOf(bakedBundle(kind)); }

} // namespace lichen::test
