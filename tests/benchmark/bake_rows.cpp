// SPDX-License-Identifier: MIT
// Time and peak memory of bakes.
#include "exemplars.h"
#include "rows.h"

#include <cstdio>
#include <exemplar/value_encoding.h>
#include <filesystem>
#include <gaussian/gaussianize.h>
#include <gaussian/inverse_table.h>
#include <gaussian/mip_chain.h>
#include <gaussian/prefilter.h>
#include <materials.h>
#include <memory>
#include <optional>

namespace lichen::bench {
namespace {

constexpr int kRuns = 5;

struct ChildBake {
  double seconds = 0.0;
  double megabytes = 0.0;
};

/// Bakes in a separate process, so that nothing else raises its peak memory.
std::optional<ChildBake> bakeInChild(int sidePixels) {
  std::error_code none;
  const std::string command = "'" + std::filesystem::read_symlink("/proc/self/exe", none).string() +
                              "' --peak-memory-of-bake " + std::to_string(sidePixels);
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  ChildBake bake;
  if (pipe == nullptr || std::fscanf(pipe.get(), "%lf %lf", &bake.seconds, &bake.megabytes) != 2)
    return std::nullopt;
  return bake;
}

void appendChildBake(std::vector<Row>& rows, int sidePixels, double secondsTarget,
                     double megabytesTarget) {
  const std::string size = std::to_string(sidePixels) + " x " + std::to_string(sidePixels);
  const std::optional<ChildBake> bake = bakeInChild(sidePixels);
  if (!bake) {
    rows.push_back({"bake of " + size, 0.0, secondsTarget, "s", "the child process failed", true});
    return;
  }
  rows.push_back({"bake of " + size + " RGB, once, in a process of its own", bake->seconds,
                  secondsTarget, "s", "rust"});
  rows.push_back({"its peak memory", bake->megabytes, megabytesTarget, "MB",
                  "the whole process, VmHWM; the exemplar's generation included"});
}

/// Bakes the four maps of a set together.
Row setRow() {
  constexpr int kSetSide = 512;
  constexpr int kSetRuns = 3;
  const std::vector<MapExemplar> set = materialSet(kSetSide);
  return {"bake of a set of 512 x 512: base colour, normal, ORM, height",
          medianSeconds(kSetRuns, [&] { return bakedBundle(set); }), 6.0, "s",
          "rust and what its green makes, median of 3"};
}

/// Time of the prefiltered mip levels alone.
double levelSeconds(const SrgbImage& image) {
  using namespace gaussian;
  const MapExemplar map = baseColorMap(image);
  const exemplar::ColorSpace space = exemplar::colorSpaceOf(map);
  const std::vector<Point> points = exemplar::transportPoints(map, space);
  const Gaussianized gaussian =
      gaussianize(map, points, space.dimensions(), {}, gaussian::Precision::bits8, {});
  const Table table = gaussianTable(gaussian, 8);
  const std::vector<exemplar::ChannelMatrix> lost = lostVariance(table, space.dimensions());
  const std::vector<float> roots = exemplar::asStored(map).values;
  const InverseTable inverse = fitInverseTable(gaussian, points, roots, 3, {});
  return medianSeconds(kRuns, [&] { return prefilteredLevels(inverse, lost, true); });
}

/// Median and worst case over the exemplars; each is the median of `kRuns` runs.
void appendBakeTimes(std::vector<Row>& rows, const std::string& what, const TilingOptions& options,
                     double target) {
  Measured seconds;
  for (const Exemplar& exemplar : exemplars256())
    seconds.note(medianSeconds(kRuns, [&] { return bakedBundle(exemplar.image, options); }),
                 exemplar.name);
  seconds.append(rows, what, target, "s",
                 ", median of 5 each; the levels are more than the target asks for");
}

} // namespace

double bakeOnce(int sidePixels) {
  const SrgbImage image = exemplars::rust(sidePixels);
  const double start = secondsNow();
  const Bundle bundle = bakedBundle(image);
  return secondsNow() - start;
}

std::vector<Row> bakeRows() {
  constexpr int kSide = 256;
  std::vector<Row> rows;
  appendBakeTimes(rows, "bake of 256 x 256 RGB with its table and levels", {}, 0.7);
  const std::optional<ChildBake> child = bakeInChild(kSide);
  rows.push_back({"its peak memory", child ? child->megabytes : 0.0, 64.0, "MB",
                  child ? "the whole process, VmHWM" : "the child process failed", !child});
  rows.push_back({"all prefiltered levels of the table", levelSeconds(exemplars::rust(kSide)), 0.3,
                  "s", "rust, median of 5"});
  rows.push_back(setRow());
  return rows;
}

std::vector<Row> growthRows() {
  // TARGETS.md has 256 x 256, 1024 x 1024 and 4096 x 4096; the two sizes between lie on its curve.
  std::vector<Row> rows;
  appendChildBake(rows, 512, 3.5, 150.0);
  appendChildBake(rows, 1024, 14.0, 400.0);
  appendChildBake(rows, 2048, 65.0, 1265.0);
  appendChildBake(rows, 4096, 300.0, 4000.0);
  return rows;
}

} // namespace lichen::bench
