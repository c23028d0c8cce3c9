// SPDX-License-Identifier: MIT
// Ratios of a shader with an option to one without it: surfaces, solids and triplanar tiling to
// those on texture coordinates, layers to one tiling, a sharper blend to the default, rotated tiles
// to unrotated ones.
#include "benchmark_noises.h"
#include "rows.h"
#include "shader_frames.h"

#include <array>
#include <cstdio>
#include <layered.frag.h>
#include <local_random_phase.frag.h>
#include <multiple_kernels.frag.h>
#include <solid.frag.cosines.h>
#include <solid.frag.kernels.h>
#include <span>
#include <stdexcept>
#include <string>
#include <surface.frag.kernels.h>
#include <surface.frag.textons.h>
#include <texton.frag.h>
#include <tiling.frag.joint.h>
#include <tiling.frag.sharp.h>
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

/// A noise with another mapping relative to that in the plane.
struct Mapped {
  std::string what; ///< of the rows
  std::vector<std::byte> glb;
  std::span<const std::uint32_t> inPlane, mapped; ///< shaders
  LichenMapping mapping;
  double target;
};

void appendMappedRows(std::vector<Row>& rows, const Mapped& noise, const Screen& screen) {
  const ReadyNoise plane(screen.gpu(), noise.glb);
  const ReadyNoise mapped(screen.gpu(), noise.glb, {.mapping = noise.mapping});
  const Shader unit{"plane", noise.inPlane, plane}, option{"mapped", noise.mapped, mapped};
  rows.push_back(ratioRow(noise.what + ", flat", noise.target, option, unit, screen, kSurfaceFlat));
  rows.push_back(
      ratioRow(noise.what + ", perspective", noise.target, option, unit, screen, kFloor));
}

void appendMappings(std::vector<Row>& rows, const Screen& screen) {
  constexpr double kSurfaceTarget = 3.0;
  const std::vector<std::byte> kernels = multipleKernelsGlb();
  for (const Mapped& noise :
       {Mapped{"surface texton, 60 impacts, over texton, 30 impacts", textonGlb(), texton_frag,
               surface_frag_textons, LICHEN_MAPPING_SURFACE, kSurfaceTarget},
        Mapped{"multiple kernels on a surface, 60 impacts, over the plane, 30 impacts", kernels,
               multiple_kernels_frag, surface_frag_kernels, LICHEN_MAPPING_SURFACE, kNoTarget},
        Mapped{"local random phase in a solid over the plane", localRandomPhaseGlb(0.0),
               local_random_phase_frag, solid_frag_cosines, LICHEN_MAPPING_SOLID, kNoTarget},
        Mapped{"multiple kernels in a solid over the plane", kernels, multiple_kernels_frag,
               solid_frag_kernels, LICHEN_MAPPING_SOLID, kNoTarget}})
    appendMappedRows(rows, noise, screen);
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

void appendSharpnessRow(std::vector<Row>& rows, const Glb& colors, const Screen& screen) {
  constexpr double kTarget = 1.25, kSharpness = 4.0;
  const ReadyNoise plain(screen.gpu(), colors);
  const ReadyNoise sharp(screen.gpu(), colors, {.blendSharpness = kSharpness});
  rows.push_back(ratioRow("tiling with blend sharpness 4 over 1, flat", kTarget,
                          {"sharpness 4", tiling_frag_sharp, sharp},
                          {"sharpness 1", tiling_frag_joint, plain}, screen, kFlat));
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
  appendMappings(rows, screen);
  appendLayerRows(rows, colors, screen);
  appendTriplanarRow(rows, colors, screen);
  appendSharpnessRow(rows, colors, screen);
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
