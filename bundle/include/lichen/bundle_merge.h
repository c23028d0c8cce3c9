// SPDX-License-Identifier: MIT
// Several bundles -> one with all their noises.
#pragma once

#include <lichen/bundle.h>

#include <set>
#include <span>
#include <string>
#include <vector>

namespace lichen {

/// A bundle that was read without error, and what messages call it.
struct NamedBundle {
  std::string file;
  Bundle bundle;
};

struct MergedBundle {
  Bundle bundle;                  ///< material i uses noise i
  std::vector<std::string> notes; ///< sentences for the user: what was renamed or left out
};

/// All noises in order, each with the parameters and name of the first material that uses it, or
/// with the defaults and its own name. A name that an earlier noise has gets a number, with a note;
/// so does a material's. Texels stay as they are; tables that are equal become one.
/// Errors: badInput, naming the file, for a bundle without noises or with one of a revision that
/// this version cannot carry over; resources when memory does not suffice.
[[nodiscard]] Result<MergedBundle> mergeBundles(std::span<const NamedBundle> inputs);

/// The place in `into` of a noise of `from`: that of one which is the same but for its name, else
/// behind the others, with its tables, of which those that are there already are shared, and a
/// number behind a name in `taken`. Throws std::bad_alloc.
[[nodiscard]] std::size_t placeNoise(Bundle& into, const Bundle& from, std::size_t index,
                                     std::set<std::string> taken);

} // namespace lichen
