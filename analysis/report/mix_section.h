// SPDX-License-Identifier: MIT
// One map's section on the inputs of a mix and the noise between them.
#pragma once

#include <lichen/noise_report.h>

#include <nlohmann/json_fwd.hpp>

namespace lichen {

/// Panes that a path from one input to the next shows at most: both exemplars and five steps.
inline constexpr int kMostPathPanes = 7;

/// The data of the section on map `map` of the inputs: a path from each input to the next, or, for
/// one texture between all inputs, that texture beside them. A path has panes (a name, a picture,
/// at a step also its weight, model error and the picture of what the shader fetches from) and the
/// spectra of both exemplars and the steps. Pictures have at most side^2 pixels. Errors: as
/// synthesize().
[[nodiscard]] Result<nlohmann::ordered_json> describeMix(const BakeRecord& record, std::size_t map,
                                                         int side);

} // namespace lichen
