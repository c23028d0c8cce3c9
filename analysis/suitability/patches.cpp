// SPDX-License-Identifier: MIT
// Colours (height, width, channels) -> deviation of the patches in their noise.
#include "patches.h"

#include "exemplar/value_encoding.h"

#include <lichen/fft.h>
#include <lichen/image.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace lichen::suitability {
namespace {

constexpr int kPatches = 1, kReference = 4; // cycles per side along the faster axis
constexpr int kSmallestSide = 16;           // two pixels in the waves of twice the reference
constexpr int kPixelsFromAfar = 32;         // along each side of the exemplar

/// Gain of averaging over a pixel from afar.
double gainFromAfar(int cycles) {
  const double x = std::numbers::pi * cycles / kPixelsFromAfar;
  return cycles == 0 ? 1.0 : std::sin(x) / x;
}

/// Energies, not normalised.
struct Energy {
  double patches = 0.0;
  double reference = 0.0;
  double fromAfar = 0.0;
};

void add(const HalfSpectrum& spectrum, Energy& energy) {
  for (int v = 0; v < spectrum.height; ++v)
    for (int u = 0; u < spectrum.columns(); ++u) {
      const int across = std::abs(spectrum.signedRow(v));
      const int cycles = std::max(u, across);
      if (cycles == 0)
        continue;
      const double power = spectrum.multiplicity(u) * double(std::norm(spectrum.at(u, v)));
      const double gain = gainFromAfar(u) * gainFromAfar(across);
      energy.fromAfar += gain * gain * power;
      if (cycles == kPatches)
        energy.patches += power;
      if (cycles == kReference)
        energy.reference += power;
    }
}

} // namespace

Patches patchesOf(const MapExemplar& map) {
  if (std::min(map.width, map.height) < kSmallestSide)
    return {};
  const std::size_t channels = map.channels.size();
  std::vector<float> codes(map.values.size() / channels);
  Energy energy;
  for (std::size_t c = 0; c < channels; ++c) {
    for (std::size_t i = 0; i < codes.size(); ++i)
      codes[i] = linearToSrgb(exemplar::decoded(map.values[i * channels + c], map.encoding));
    add(forwardFft(codes, map.width, map.height), energy);
  }
  // A ring of n cycles has 8 n waves.
  const double own = energy.reference * kPatches / kReference;
  const double excess = std::max(0.0, energy.patches - 2.0 * own);
  const double pixels = double(map.width) * double(map.height);
  return {std::sqrt(excess / double(channels)) / pixels,
          energy.fromAfar > 0.0 ? std::sqrt(excess / energy.fromAfar) : 0.0};
}

} // namespace lichen::suitability
