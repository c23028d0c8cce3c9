// SPDX-License-Identifier: MIT
// Ratios of a shader with an option to one without it: textons on a surface, solids and triplanar
// tiling to those on texture coordinates, tiling's quality levels to the highest, rotated tiles to
// unrotated ones.
#include "option_rows.h"

#include "benchmark_noises.h"

#include <array>
#include <cstdio>
#include <local_random_phase.frag.h>
#include <multiple_kernels.frag.h>
#include <solid.frag.cosines.h>
#include <solid.frag.kernels.h>
#include <surface.frag.h>
#include <texton.frag.h>
#include <tiling.frag.joint.h>
#include <tiling.frag.one_tap.h>
#include <tiling.frag.sharp.h>
#include <tiling.frag.slopes.h>
#include <tiling.frag.turned.h>
#include <tiling.frag.turned_slopes.h>
#include <tiling.frag.two_taps.h>
#include <triplanar.frag.h>
#include <view.vert.h>

namespace lichen::bench {
namespace {

/// Slightly less than one texel per pixel: surface coordinates are rounded, and a pixel larger than
/// a texel reads two mips.
constexpr ScreenView kSurfaceFlat{0.999f * kFlat.uvPerScreenX, 0.999f * kFlat.uvPerScreenY, 1.0f};
/// A quarter of a tile per pixel. From this size on, the lowest tiling level uses one tap.
constexpr ScreenView kFar{0.25f * float(kScreenWidth), 0.25f * float(kScreenHeight), 1.0f};

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

void appendSurfaceRows(std::vector<Row>& rows, const Screen& screen) {
  constexpr double kTarget = 3.0;
  const ReadyNoise plane(screen.gpu(), textonGlb());
  const ReadyNoise surface(screen.gpu(), textonGlb(), {.mapping = LICHEN_MAPPING_SURFACE});
  const Shader unit{"texton", texton_frag, plane};
  const Shader option{"surface texton", surface_frag, surface};
  rows.push_back(ratioRow("surface texton, 60 impacts, over texton, 30 impacts, flat", kTarget,
                          option, unit, screen, kSurfaceFlat));
  rows.push_back(ratioRow("surface texton, 60 impacts, over texton, 30 impacts, perspective",
                          kTarget, option, unit, screen, kFloor));
}

/// A noise in a solid relative to that in the plane.
void appendSolidRows(std::vector<Row>& rows, const std::string& method,
                     const std::vector<std::byte>& glb, std::span<const std::uint32_t> inPlane,
                     std::span<const std::uint32_t> inSolid, const Screen& screen) {
  const ReadyNoise plane(screen.gpu(), glb);
  const ReadyNoise solid(screen.gpu(), glb, {.mapping = LICHEN_MAPPING_SOLID});
  const Shader unit{"plane", inPlane, plane}, option{"solid", inSolid, solid};
  const std::string name = method + " in a solid over the plane, ";
  rows.push_back(ratioRow(name + "flat", kNoTarget, option, unit, screen, kSurfaceFlat));
  rows.push_back(ratioRow(name + "perspective", kNoTarget, option, unit, screen, kFloor));
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

/// The quality levels of tiling, and a sharper blend at the highest level.
void appendLevelRows(std::vector<Row>& rows, const Glb& colors, const Screen& screen) {
  constexpr double kTarget = 1.0; // a level must be cheaper
  constexpr double kSharpTarget = 1.25, kSharpness = 4.0;
  const ReadyNoise plain(screen.gpu(), colors);
  const ReadyNoise sharp(screen.gpu(), colors, {.blendSharpness = kSharpness});
  const auto row = [&](const char* what, double target, std::span<const std::uint32_t> fragment,
                       const ReadyNoise& noise, const ScreenView& view) {
    rows.push_back(ratioRow(what, target, {what, fragment, noise},
                            {"three taps", tiling_frag_joint, plain}, screen, view));
  };
  row("tiling with two taps over three, flat", kTarget, tiling_frag_two_taps, plain, kFlat);
  row("tiling with two taps over three, perspective", kTarget, tiling_frag_two_taps, plain, kFloor);
  row("tiling with one tap from 1/4 tile a pixel on over three, from there", kTarget,
      tiling_frag_one_tap, plain, kFar);
  row("tiling with blend sharpness 4 over 1, flat", kSharpTarget, tiling_frag_sharp, sharp, kFlat);
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
  row("colours, tiles rotated freely", kColorTarget, colors, kMostTileRotation);
  row("slopes, code of tile rotation that is not used, over none", kUnusedTarget, slopes, 0);
  row("slopes, tiles rotated by 2 angles over not rotated", kSlopeTarget, slopes, 2);
  row("slopes, tiles rotated by 4 angles", kSlopeTarget, slopes, 4);
  row("slopes, tiles rotated freely", kSlopeTarget, slopes, kMostTileRotation);
}

} // namespace

void appendOptionRows(std::vector<Row>& rows, const Screen& screen) {
  const Glb colors = tilingGlb(GaussianOnly::no);
  appendSurfaceRows(rows, screen);
  appendSolidRows(rows, "local random phase", localRandomPhaseGlb(0.0), local_random_phase_frag,
                  solid_frag_cosines, screen);
  appendSolidRows(rows, "multiple kernels", multipleKernelsGlb(), multiple_kernels_frag,
                  solid_frag_kernels, screen);
  appendTriplanarRow(rows, colors, screen);
  appendLevelRows(rows, colors, screen);
  appendRotationRows(rows, colors, screen);
}

} // namespace lichen::bench
