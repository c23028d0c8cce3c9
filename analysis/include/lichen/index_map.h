// SPDX-License-Identifier: MIT
// Bakes the index map of a layered noise from a spectrum.
#pragma once

#include <lichen/bundle.h>
#include <lichen/result.h>
#include <lichen/spectrum_picture.h>

#include <array>

namespace lichen {

/// An index map in a bundle of its own, noise 0: a multiple-kernels noise of one channel whose
/// Gaussian value has this spectrum, on tiles of `width` x `height` texels. `decibels` is how far
/// the spectrum of its kernels is from that, as SpectrumError has it. Errors: as
/// bakeMultipleKernels().
struct IndexMapBake {
  Bundle bundle;
  double decibels = 0.0;
};
[[nodiscard]] Result<IndexMapBake> bakeIndexMap(const SpectrumPicture& spectrum, int width,
                                                int height, int kernels = 8);

} // namespace lichen
