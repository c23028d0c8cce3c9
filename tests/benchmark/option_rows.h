// SPDX-License-Identifier: MIT
#pragma once

#include "rows.h"
#include "shader_frames.h"

namespace lichen::bench {

/// Cost of a mapping, a quality level or tile rotation, each relative to the shader without it.
void appendOptionRows(std::vector<Row>& rows, const Screen& screen);

} // namespace lichen::bench
