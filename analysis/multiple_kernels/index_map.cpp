// SPDX-License-Identifier: MIT
// Spectrum -> multiple-kernels noise of one channel without an inverse table.
#include <lichen/index_map.h>
#include <lichen/multiple_kernels.h>

#include <algorithm>

namespace lichen {

Result<IndexMapBake> bakeIndexMap(const SpectrumPicture& spectrum, int width, int height,
                                  int kernels) {
  // Index maps are not decoded, so any values do. Few are enough for what the tile must hold.
  constexpr int kMostSide = 256;
  const int largest = std::max(width, height);
  const int least = largest > kMostSide ? kMostSide : largest;
  MapExemplar values;
  values.target = MapTarget::height;
  values.channels = {MapChannel::height};
  values.encoding = ValueEncoding::linear;
  values.width = std::max(1, width * least / largest);
  values.height = std::max(1, height * least / largest);
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
  auto& map = bake.noise.maps.front().as<MultipleKernelsMap>();
  result.bundle.tables.push_back(std::move(bake.tables[map.kernels]));
  map.kernels = 0;
  map.inverseTable.reset();
  result.bundle.noises.push_back(std::move(bake.noise));
  return result;
}

} // namespace lichen
