// SPDX-License-Identifier: MIT
// Several bundles -> one bundle with all their noises.
#pragma once

#include <lichen/bundle.h>

#include <set>
#include <span>
#include <string>
#include <vector>

namespace lichen {

/// A valid bundle, and the file name that messages use for it.
struct NamedBundle {
  std::string file;
  Bundle bundle;
};

struct MergedBundle {
  Bundle bundle;                  ///< one material for each noise but those without one
  std::vector<std::string> notes; ///< sentences for the user: what was renamed or dropped
};

/// Merges all noises, in order. Each gets the parameters and name of the first material that uses
/// it, or the defaults and its own name. Noises that only the layers of others use, and no
/// material, get no material. A mix weight from a texture becomes the default weight, with a note.
/// A noise or material whose name is already taken gets a number appended, with a note. Texels are
/// copied unchanged, and equal tables are shared. Errors: badInput, naming the file, for a bundle
/// without noises or with ignored ones; resources when memory does not suffice.
[[nodiscard]] Result<MergedBundle> mergeBundles(std::span<const NamedBundle> inputs);

/// Adds noise `index` of `from` to `into` and returns its index there. If `into` already has a
/// noise that differs only in name, returns that one. Otherwise appends the noise, shares the
/// tables that `into` already has, and appends a number to a name in `taken`. The other layers and
/// the index maps of a layered noise come first, in the same way. Throws std::bad_alloc.
[[nodiscard]] std::size_t placeNoise(Bundle& into, const Bundle& from, std::size_t index,
                                     std::set<std::string> taken);

/// A noise of a bundle that outlives this.
struct BundledNoise {
  const Bundle* bundle = nullptr;
  std::size_t noise = 0;
};

/// One bundle with a layered noise, its noise 0, of 2 to 4 noises and one index map fewer: node n
/// of `nodes` takes indices[n]; both are renumbered as a file has them. The layers of inputs that
/// are layered themselves are ignored. A material of the first layer's parameters, as
/// mergeBundles() has them, uses it. Errors: usage, where layersFault() finds one; resources when
/// memory does not suffice.
[[nodiscard]] Result<Bundle> layerNoises(const std::string& name,
                                         std::span<const BundledNoise> layers,
                                         std::span<const BundledNoise> indices,
                                         const std::vector<LayerNode>& nodes);

} // namespace lichen
