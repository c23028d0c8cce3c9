// SPDX-License-Identifier: MIT
// Ratios of a shader with an option to one without it: textons on surfaces and triplanar tiling to
// those on texture coordinates, layers to one tiling, rotated tiles to unrotated ones.
#include "benchmark_noises.h"
#include "rows.h"
#include "shader_frames.h"

#include <array>
#include <cstdio>
#include <layered.frag.h>
#include <span>
#include <stdexcept>
#include <string>
#include <surface.frag.h>
#include <texton.frag.h>
#include <tiling.frag.joint.h>
#include <tiling.frag.slopes.h>
#include <tiling.frag.turned.h>
#include <tiling.frag.turned_slopes.h>
#include <triplanar.frag.h>
#include <view.vert.h>

namespace lichen::bench {
namespace {

/// Slightly less than one texel per pixel: surface coordinates are rounded, and a pixel larger than
/// a texel reads two mips.
constexpr ScreenView kSurfaceFlat{0.999f * kFlat.uvPerScreenX, 0.999f * kFlat.uvPerScreenY, 1.0f};

/// A shader and the noise that it draws.
struct Shader {
  const char* name;
  std::span<const std::uint32_t> fragment;
  const ReadyNoise& noise;
};

Row ratioRow(const std::string& what, double target, const Shader& option, const Shader& unit,
             const Screen& screen, const ScreenView& view) {
  ScreenPass unitPass(screen.gpu(), view_vert, unit.fragment, unit.noise.layout());
  ScreenPass optionPass(screen.gpu(), view_vert, option.fragment, option.noise.layout());
  const std::array drawn{Drawn{unitPass, unit.noise.set()}, Drawn{optionPass, option.noise.set()}};
  const std::vector<double> seconds = frameSeconds(screen, drawn, view);
  char note[160];
  std::snprintf(note, sizeof note, "%s; %s %.1f ms", screen.note().c_str(), unit.name,
                1e3 * seconds[0]);
  return {what, seconds[1] / seconds[0], target, "", note};
}

/// A texton on a surface relative to one in the plane.
void appendSurfaceRows(std::vector<Row>& rows, const Screen& screen) {
  constexpr double kTarget = 3.0;
  const std::vector<std::byte> glb = textonGlb();
  const ReadyNoise plane(screen.gpu(), glb);
  const ReadyNoise mapped(screen.gpu(), glb, {.mapping = LICHEN_MAPPING_SURFACE});
  const Shader unit{"plane", texton_frag, plane}, option{"surface", surface_frag, mapped};
  const std::string what = "surface texton, 60 impacts, over texton, 30 impacts, ";
  rows.push_back(ratioRow(what + "flat", kTarget, option, unit, screen, kSurfaceFlat));
  rows.push_back(ratioRow(what + "perspective", kTarget, option, unit, screen, kFloor));
}

using Glb = std::vector<std::byte>;

void appendTriplanarRow(std::vector<Row>& rows, const Glb& colors, const Screen& screen) {
  constexpr double kTarget = 2.0;
  const ReadyNoise plane(screen.gpu(), colors);
  const ReadyNoise planes(screen.gpu(), colors, {.mapping = LICHEN_MAPPING_TRIPLANAR});
  rows.push_back(ratioRow("triplanar tiling on a sphere over tiling", kTarget,
                          {"triplanar tiling", triplanar_frag, planes},
                          {"tiling", tiling_frag_joint, plane}, screen, kSurfaceFlat));
}

void appendLayerRows(std::vector<Row>& rows, const Glb& colors, const Screen& screen) {
  const ReadyNoise plain(screen.gpu(), colors);
  const ReadyNoise layers(screen.gpu(), layeredGlb(), {.isLayered = true});
  const Shader unit{"tiling", tiling_frag_joint, plain}, option{"layers", layered_frag, layers};
  const std::string what = "two layers of tiling over tiling, ";
  rows.push_back(ratioRow(what + "flat", kNoTarget, option, unit, screen, kFlat));
  rows.push_back(ratioRow(what + "perspective", kNoTarget, option, unit, screen, kFloor));
}

/// Rotated tiles relative to unrotated ones, for colours and for slopes, which are decoded tile by
/// tile.
void appendRotationRows(std::vector<Row>& rows, const Glb& colorGlb, const Screen& screen) {
  constexpr double kUnusedTarget = 1.0, kColorTarget = 1.05, kSlopeTarget = 1.5;
  struct Kind {
    Glb glb;
    std::span<const std::uint32_t> rotated, plain; ///< shaders
  };
  const auto row = [&](const char* what, double target, const Kind& kind, std::uint32_t angles) {
    const ReadyNoise plain(screen.gpu(), kind.glb);
    const ReadyNoise rotated(screen.gpu(), kind.glb, {.tileRotation = angles});
    rows.push_back(ratioRow(what, target, {what, kind.rotated, rotated},
                            {"not rotated", kind.plain, plain}, screen, kFlat));
  };
  const Kind colors{colorGlb, tiling_frag_turned, tiling_frag_joint};
  const Kind slopes{slopeGlb(), tiling_frag_turned_slopes, tiling_frag_slopes};
  row("colours, code of tile rotation that is not used, over none", kUnusedTarget, colors, 0);
  row("colours, tiles rotated by 2 angles over not rotated", kColorTarget, colors, 2);
  row("colours, tiles rotated by 4 angles", kColorTarget, colors, 4);
  row("slopes, code of tile rotation that is not used, over none", kUnusedTarget, slopes, 0);
  row("slopes, tiles rotated by 2 angles over not rotated", kSlopeTarget, slopes, 2);
  row("slopes, tiles rotated by 4 angles", kSlopeTarget, slopes, 4);
}

std::vector<Row> measureOptions() {
  const Screen screen;
  const Glb colors = tilingGlb(GaussianOnly::no);
  std::vector<Row> rows;
  appendSurfaceRows(rows, screen);
  appendLayerRows(rows, colors, screen);
  appendTriplanarRow(rows, colors, screen);
  appendRotationRows(rows, colors, screen);
  return rows;
}

} // namespace

std::vector<Row> optionRows() {
  try {
    return measureOptions();
  } catch (const std::exception& problem) {
    return {{"options of the shaders", 0.0, kNoTarget, "", problem.what(), true}};
  }
}

} // namespace lichen::bench
