// SPDX-License-Identifier: MIT
// Names of the debug views and their shader constants.
#include "debug_views.h"

#include "shaders/scene_interface.h"

#include <array>

namespace lichen::renderer {
namespace {

struct DebugView {
  std::string_view name;
  int value;
};
constexpr std::array kDebugViews{
    DebugView{"normals", DEBUG_NORMALS},     DebugView{"base-color", DEBUG_BASE_COLOR},
    DebugView{"roughness", DEBUG_ROUGHNESS}, DebugView{"metallic", DEBUG_METALLIC},
    DebugView{"occlusion", DEBUG_OCCLUSION}, DebugView{"weights", DEBUG_WEIGHTS},
    DebugView{"lattice", DEBUG_LATTICE},     DebugView{"mip-level", DEBUG_MIP_LEVEL},
    DebugView{"gaussian", DEBUG_GAUSSIAN},   DebugView{"impacts", DEBUG_IMPACTS},
    DebugView{"planes", DEBUG_PLANES}};

} // namespace

std::vector<std::string_view> debugViewNames() {
  std::vector<std::string_view> names;
  for (const DebugView& view : kDebugViews)
    names.push_back(view.name);
  return names;
}

Result<int> debugViewValue(const std::string& name) {
  if (name.empty())
    return DEBUG_NONE;
  std::string names;
  for (const DebugView& view : kDebugViews) {
    if (view.name == name)
      return view.value;
    names += (names.empty() ? "" : ", ") + std::string(view.name);
  }
  return Error{ErrorKind::usage, "unknown debug view \"" + name + "\"; available: " + names};
}

} // namespace lichen::renderer
