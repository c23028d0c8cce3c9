// SPDX-License-Identifier: MIT
// Bakes the index map of a layered noise from a spectrum.
#pragma once

#include <lichen/bundle.h>
#include <lichen/result.h>
#include <lichen/spectrum_picture.h>

namespace lichen {

/// An index map in a bundle of its own: noise 0, of one channel and without an inverse table, whose
/// Gaussian value has this spectrum, on tiles of this width over height, in [1/256, 256]. It is a
/// noise of tiling, where frequencies below 3 cycles per tile make smaller patches than they
/// should, or with `hasSolids` one of kernels, which cost more. `bits` is 8 or 16. Errors: badInput
/// for a spectrum without power; resources if memory runs out. O(N log N) in the number of texels,
/// which grows with the frequencies up to 1,024 a side.
[[nodiscard]] Result<Bundle> bakeIndexMap(const SpectrumPicture& spectrum, double aspect,
                                          bool hasSolids, int bits = 8);

} // namespace lichen
