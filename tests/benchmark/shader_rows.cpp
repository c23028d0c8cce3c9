// SPDX-License-Identifier: MIT
// Cost of the shaders and of their published peers, relative to one plain trilinear fetch and to
// three bare ones. All of them draw in turn in one process.
#include "benchmark_noises.h"
#include "peer_images.h"
#include "rows.h"
#include "shader_frames.h"

#include <algorithm>
#include <array>
#include <bare.frag.h>
#include <cmath>
#include <hextile.frag.h>
#include <hextile.frag.unrotated.h>
#include <hn18.frag.h>
#include <local_random_phase.frag.h>
#include <local_random_phase.frag.structured.h>
#include <materials.h>
#include <multiple_kernels.frag.h>
#include <plain.frag.h>
#include <quilting.frag.h>
#include <stdexcept>
#include <texton.frag.h>
#include <texton.frag.mixed.h>
#include <tiling.frag.gaussian.h>
#include <tiling.frag.joint.h>
#include <tiling.frag.nearest_level.h>
#include <unity.frag.h>
#include <view.vert.h>

namespace lichen::bench {
namespace {

using Fragment = std::span<const std::uint32_t>;

/// TARGETS.md: ratios to one plain fetch.
struct Targets {
  double flat = kNoTarget;
  double perspective = kNoTarget;
};

/// A row of the table, in both views.
struct TimedShader {
  const char* name;
  std::unique_ptr<ScreenPass> pass;
  VkDescriptorSet set;
  Targets targets;
  std::unique_ptr<ReadyNoise> noise; ///< owns the set; null for the peers
};

/// Throws std::runtime_error if the mean of the picture is not near the exemplar's.
TimedShader peer(const char* name, Fragment fragment, const Screen& screen,
                 const PeerImages& images) {
  // The methods have no mean in common, and what interpolation loses of the variance changes it.
  constexpr double kTolerance = 0.03;
  TimedShader shader{
      name,
      std::make_unique<ScreenPass>(screen.gpu(), view_vert, fragment, images.layout()),
      images.set(),
      {},
      nullptr};
  const std::array<double, 3> mean = meanDrawn(screen, {*shader.pass, shader.set}, kFlat);
  for (std::size_t c = 0; c < mean.size(); ++c)
    if (!(std::abs(mean[c] - images.mean()[c]) < kTolerance))
      throw std::runtime_error(std::string(name) + ": a channel of the picture has a mean of " +
                               std::to_string(mean[c]) + ", the mean of the exemplar " +
                               std::to_string(images.mean()[c]));
  return shader;
}

TimedShader noise(const char* name, Fragment fragment, const Screen& screen,
                  const std::vector<std::byte>& glb, Targets targets) {
  auto ready = std::make_unique<ReadyNoise>(screen.gpu(), glb);
  auto pass = std::make_unique<ScreenPass>(screen.gpu(), view_vert, fragment, ready->layout());
  const VkDescriptorSet set = ready->set();
  return {name, std::move(pass), set, targets, std::move(ready)};
}

/// The first two shaders are the units.
void appendRows(std::vector<Row>& rows, const Screen& screen, std::span<const TimedShader> shaders,
                const ScreenView& view, const char* viewName, double Targets::*target) {
  std::vector<Drawn> drawn;
  for (const TimedShader& shader : shaders)
    drawn.push_back({*shader.pass, shader.set});
  const std::vector<double> seconds = frameSeconds(screen, drawn, view);
  const double plain = seconds[0], bare = seconds[1];
  for (std::size_t i = 0; i < shaders.size(); ++i) {
    Row row{std::string(shaders[i].name) + ", " + viewName, seconds[i] / plain,
            shaders[i].targets.*target, "", screen.note()};
    row.details = {{"ms", 1e3 * seconds[i]}, {"x three bare", seconds[i] / bare}};
    rows.push_back(std::move(row));
  }
}

std::vector<Row> measure() {
  const Screen screen;
  const PeerImages images(screen.gpu(), exemplars::rust(kShaderExemplarSide));
  const auto joint = tilingGlb(GaussianOnly::no);
  const auto gaussian = tilingGlb(GaussianOnly::yes);
  const TimedShader shaders[] = {
      peer("one plain fetch", plain_frag, screen, images),
      peer("three bare fetches", bare_frag, screen, images),
      peer("hextile-demo", hextile_frag, screen, images),
      peer("hextile-demo without rotation", hextile_frag_unrotated, screen, images),
      peer("Unity's stochastic texturing", unity_frag, screen, images),
      peer("[HN18] without prefilter", hn18_frag, screen, images),
      noise("tiling, joint table", tiling_frag_joint, screen, joint, {4.2, 4.2}),
      noise("tiling, nearest table level", tiling_frag_nearest_level, screen, joint, {3.5, 3.7}),
      noise("tiling, Gaussian only", tiling_frag_gaussian, screen, gaussian, {2.8, 3.1}),
      noise("quilting of bricks", quilting_frag, screen, quiltingGlb(), {5.7, 5.7}),
      noise("texton, 30 impacts", texton_frag, screen, textonGlb(), {36.0, 40.0}),
      noise("mix of textons, 30 impacts", texton_frag_mixed, screen, mixGlb(), {42.0, 46.0}),
      noise("local random phase, 50 cosines", local_random_phase_frag, screen,
            localRandomPhaseGlb(0.0), {54.0, 60.0}),
      noise("the same with a structure", local_random_phase_frag_structured, screen,
            localRandomPhaseGlb(0.5), {}),
      noise("multiple kernels, 30 impacts", multiple_kernels_frag, screen, multipleKernelsGlb(),
            {}),
      noise("structure of bricks with a list", local_random_phase_frag_structured, screen,
            bricksGlb(), {})};
  std::vector<Row> rows;
  appendRows(rows, screen, shaders, kFlat, "flat", &Targets::flat);
  appendRows(rows, screen, shaders, kFloor, "perspective", &Targets::perspective);
  return rows;
}

} // namespace

std::vector<Row> shaderRows() {
  try {
    return measure();
  } catch (const std::exception& problem) {
    return {{"tiling, joint table, flat", 0.0, 4.2, "", problem.what(), true}};
  }
}

} // namespace lichen::bench
