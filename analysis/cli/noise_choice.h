// SPDX-License-Identifier: MIT
// Names of noises: which one of a bundle a verb uses, and what a new one is called.
#pragma once

#include "options.h"

#include <lichen/bundle.h>

#include <string>
#include <vector>

namespace lichen::cli {

/// Returns the index of `wanted` in `names`; 0 if `wanted` is empty. Errors: usage; the message
/// starts with `option` and `wanted`, and lists the names of this kind that `owner` has.
[[nodiscard]] Result<std::size_t> indexOf(const std::string& wanted,
                                          const std::vector<std::string>& names,
                                          const std::string& option, const std::string& kind,
                                          const std::string& owner);

/// The option --name of the verbs that make noises.
[[nodiscard]] Accepted<std::string> nameText();

/// Whether a file name has the extension of a bundle: .glb, .gltf or .lichen.
[[nodiscard]] bool namesBundle(const std::string& file);

/// The badInput error for a file that has no noise of any revision.
[[nodiscard]] Error noNoiseIn(const std::string& file);

/// Returns the index of the noise with this name; of the first noise if `wanted` is empty. Messages
/// call the bundle `file`, and write `option` before the name of a noise.
[[nodiscard]] Result<std::size_t> findNoise(const Bundle& bundle, const std::string& file,
                                            const std::string& wanted,
                                            const std::string& option = "--noise ");

/// A bundle, and one of its noises.
struct ChosenNoise {
  std::string file;
  Bundle bundle;
  std::size_t index = 0;

  [[nodiscard]] const Noise& noise() const { return bundle.noises[index]; }
};

/// Reads BUNDLE, whose first noise is meant, or BUNDLE:NAME. The text is split at the last colon if
/// the part before it is a file and the whole text is not.
[[nodiscard]] Result<ChosenNoise> chosenNoise(const std::string& text);

/// Returns the first material that uses the noise, for its pattern, or default parameters if no
/// material does.
[[nodiscard]] MaterialNoise materialOf(const Bundle& bundle, std::size_t noise);

} // namespace lichen::cli
