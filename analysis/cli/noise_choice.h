// SPDX-License-Identifier: MIT
// Which noise of a bundle a verb works on.
#pragma once

#include <lichen/bundle.h>

#include <string>
#include <vector>

namespace lichen::cli {

/// The place of `wanted` among `names`, the first if it is empty. The message of a refusal begins
/// with `option` and says what `owner` has.
[[nodiscard]] Result<std::size_t> placeOf(const std::string& wanted,
                                          const std::vector<std::string>& names,
                                          const std::string& option, const std::string& owner);

/// That a file has no noise, of any revision: badInput.
[[nodiscard]] Error noNoiseIn(const std::string& file);

/// The noise of that name, the first for no name. `file` is what messages call the bundle.
[[nodiscard]] Result<std::size_t> findNoise(const Bundle& bundle, const std::string& file,
                                            const std::string& wanted);

/// The first material that uses the noise, so that its pattern is shown; the defaults where none
/// does.
[[nodiscard]] MaterialNoise materialOf(const Bundle& bundle, std::size_t noise);

} // namespace lichen::cli
