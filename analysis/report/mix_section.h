// SPDX-License-Identifier: MIT
// One map's section on the inputs of a mix and the noise between them.
#pragma once

#include <lichen/noise_report.h>
#include <lichen/progress.h>

#include <string>

namespace lichen {

/// The number of pictures in describeMix().
[[nodiscard]] std::size_t mixPictures(const BakeRecord& record);

/// The section on map `map` of the inputs of record.mix: a path from each input to the next, or,
/// for one texture between all inputs, that texture beside them. A path has panes and their
/// spectra. A pane has a picture; of an input the name, and its share in that texture; of a step
/// the weight, the model error and the picture of what the shader fetches from. All panes show the
/// same number of texels per pixel. Pictures have at most side^2 pixels. Errors: as synthesize().
[[nodiscard]] Result<std::string> describeMix(const BakeRecord& record, std::size_t map, int side,
                                              const Progress& progress = {});

} // namespace lichen
