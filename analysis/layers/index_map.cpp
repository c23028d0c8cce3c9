// SPDX-License-Identifier: MIT
// Spectrum -> a field of random phases (height, width) -> a noise of one channel without an inverse
// table.
#include "random_phase/map_spectrum.h"

#include <lichen/index_map.h>
#include <lichen/multiple_kernels.h>
#include <lichen/tiling.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lichen {
namespace {

/// Width and height of a field: the longer side is a power of two, as small as may be, since
/// outlines are softer by what fetches between texels lose.
std::array<int, 2> sidesOf(const SpectrumPicture& spectrum, double aspect) {
  double power = 0.0, ofColumns = 0.0, ofRows = 0.0;
  for (std::size_t i = 0; i < spectrum.amplitudes.size(); ++i) {
    const int pixel = int(i) / spectrum.channels;
    const double own = double(spectrum.amplitudes[i]) * double(spectrum.amplitudes[i]);
    power += own;
    ofColumns += own * std::pow(pixel % spectrum.width - spectrum.width / 2, 2.0);
    ofRows += own * std::pow(pixel / spectrum.width - spectrum.height / 2, 2.0);
  }
  constexpr int kLeast = 64, kFewest = 128, kMost = 1024;
  constexpr double kMostLoss = 1.0 / 32.0;
  for (int longer = kFewest;; longer *= 2) {
    const auto width = int(std::lround(longer * std::min(1.0, aspect)));
    const auto height = int(std::lround(longer * std::min(1.0, 1.0 / aspect)));
    // Bilinear fetches of a wave of f cycles per texel lose (2 pi f)^2 / 6 along each axis.
    constexpr double kOfSquaredCycles = 4.0 * std::numbers::pi * std::numbers::pi / 6.0;
    const double loss =
        kOfSquaredCycles / power * (ofColumns / width / width + ofRows / height / height);
    if (std::min(width, height) >= kLeast && (longer >= kMost || loss <= kMostLoss))
      return {width, height};
  }
}

/// A periodic Gaussian field with this spectrum, in [0, 1].
Result<MapExemplar> fieldOf(const SpectrumPicture& spectrum, double aspect) {
  const auto [width, height] = sidesOf(spectrum, aspect);
  std::vector<random_phase::MapSpectrum> spectra(1);
  spectra[0].channels.push_back({width, height, {}});
  HalfSpectrum& transform = spectra[0].channels[0];
  transform.values.resize(std::size_t(transform.columns()) * std::size_t(height));
  spectra[0].covariance = Eigen::MatrixXd::Identity(1, 1);
  if (Result<void> replaced = random_phase::replaceSpectra(spectrum, spectra); !replaced)
    return replaced.error();
  MapExemplar field{
      MapTarget::height,    {MapChannel::height}, ValueEncoding::linear, width, height,
      inverseFft(transform)};
  constexpr float kMostDeviations = 8.0f;
  for (float& value : field.values)
    value = std::clamp(0.5f + 0.5f / kMostDeviations * value * float(width) * float(height), 0.0f,
                       1.0f);
  return field;
}

/// The noise of a bake in a bundle of its own, without the inverse table.
template <class Map>
Result<Bundle> withoutTable(Result<MethodBake> baked) {
  if (!baked)
    return baked.error();
  Bundle bundle;
  bundle.noises.push_back(std::move(baked.value().noise));
  auto& map = bundle.noises[0].maps[0].as<Map>();
  bundle.tables.push_back(std::move(baked.value().tables[map.imageTable()]));
  visitTables(bundle.noises[0].maps[0], [](std::size_t& table) { table = 0; });
  map.inverseTable.reset();
  return bundle;
}

} // namespace

Result<Bundle> bakeIndexMap(const SpectrumPicture& spectrum, double aspect, bool hasSolids,
                            int bits) {
  const Result<MapExemplar> field = fieldOf(spectrum, aspect);
  if (!field)
    return field.error();
  const std::span<const MapExemplar> maps(&field.value(), 1);
  MultipleKernelsOptions options;
  options.periodic = Periodic::yes;
  options.bits = bits;
  // Transport makes the values Gaussian, as shares of areas need; few waves alone are not.
  options.gaussian = GaussianOnly::no;
  if (hasSolids)
    return withoutTable<MultipleKernelsMap>(bakeMultipleKernels("index", maps, options));
  return withoutTable<TilingMap>(bakeTiling("index", maps, options));
}

} // namespace lichen
