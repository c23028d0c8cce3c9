// SPDX-License-Identifier: MIT
// Spectrum -> multiple-kernels noise of one channel without an inverse table.
#include <lichen/index_map.h>
#include <lichen/multiple_kernels.h>

#include <algorithm>
#include <cmath>

namespace lichen {

Result<IndexMapBake> bakeIndexMap(const SpectrumPicture& spectrum, int width, int height,
                                  int kernels) {
  // Index maps are not decoded, so any values do; so many that they hold the spectrum.
  const double scale = std::max((spectrum.width + 1.0) / width, (spectrum.height + 1.0) / height);
  MapExemplar values;
  values.target = MapTarget::height;
  values.channels = {MapChannel::height};
  values.encoding = ValueEncoding::linear;
  values.width = std::max(1, int(std::lround(scale * width)));
  values.height = std::max(1, int(std::lround(scale * height)));
  const std::size_t count = std::size_t(values.width) * std::size_t(values.height);
  for (std::size_t i = 0; i < count; ++i)
    values.values.push_back((float(i) + 0.5f) / float(count));

  MultipleKernelsOptions options;
  options.kernels = kernels;
  options.spectrum = spectrum;
  options.periodic = Periodic::yes;
  Result<MultipleKernelsBake> baked = bakeMultipleKernels("index", std::span(&values, 1), options);
  if (!baked)
    return baked.error();
  MultipleKernelsBake& bake = baked.value();
  IndexMapBake result;
  result.decibels = bake.spectrumErrors.back().decibels;
  bake.noise.as<MultipleKernelsNoise>().texelsPerTileX = width;
  bake.noise.as<MultipleKernelsNoise>().texelsPerTileY = height;
  auto& map = bake.noise.maps.front().as<MultipleKernelsMap>();
  result.bundle.tables.push_back(std::move(bake.tables[map.kernels]));
  map.kernels = 0;
  map.inverseTable.reset();
  result.bundle.noises.push_back(std::move(bake.noise));
  return result;
}

} // namespace lichen
