// SPDX-License-Identifier: MIT
// What lichen-bench prints: numbers next to their targets, and the families that measure them.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace lichen::bench {

/// The target of a row that is there for comparison.
inline constexpr double kNoTarget = std::numeric_limits<double>::infinity();

/// A number beside a measurement. It names a column: "ms", "fetches".
struct Detail {
  std::string name;
  double value = 0.0;
};

/// One measurement. Every target of TARGETS.md is an upper limit.
struct Row {
  std::string what;
  double measured = 0.0;
  double target = 0.0;
  std::string unit; ///< empty if the value is a ratio
  /// How it was measured, or why it could not be; explains a missed target.
  std::string note;
  bool skipped = false; ///< the machine lacks a requirement that `note` names
  std::vector<Detail> details;

  [[nodiscard]] bool met() const { return !skipped && measured <= target; }
};

/// Median of an unsorted list; for an even count, the lower of the two middle values.
[[nodiscard]] double median(std::vector<double> values);

/// One number per exemplar, and the exemplar with the greatest.
struct Measured {
  std::vector<double> values;
  std::string worst;

  void note(double value, const std::string& name);
  [[nodiscard]] double largest() const;
  /// Two rows: the median, and the worst.
  void append(std::vector<Row>& rows, const std::string& what, double target,
              const std::string& unit, const std::string& note) const;
};

/// Median time of `work` over `runs` runs, in seconds.
template <class Work>
[[nodiscard]] double medianSeconds(int runs, Work&& work);

/// Median of how much longer `work` takes than `base` right after it, over `runs` pairs of runs, in
/// seconds: the two see the same load.
template <class Work, class Base>
[[nodiscard]] double medianSecondsBeyond(int runs, const Work& work, const Base& base);

[[nodiscard]] double secondsNow();

/// Peak resident memory of this process so far, in MB (VmHWM of /proc/self/status).
[[nodiscard]] double peakMemoryMegabytes();

/// What the numbers depend on: processor, cores, memory, load, compiler and build.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> machineFacts();

std::vector<Row> bakeRows();      ///< time and memory of bakes, time of the table's mip levels
std::vector<Row> growthRows();    ///< time and memory of larger bakes
std::vector<Row> transportRows(); ///< speckle of the transport
std::vector<Row> synthRows();     ///< speed of a synthesis
std::vector<Row> resultRows();    ///< the quality measures
std::vector<Row> viewRows();      ///< mean colour, contrast, features and shimmer at all distances
std::vector<Row> litRows();       ///< brightness of lit pictures at all distances
std::vector<Row> textonRows();    ///< time, model error, flatness, border, covariance of textons
std::vector<Row> structureRows(); ///< what remains of planks, beside tiling
std::vector<Row> quiltingRows();  ///< structure that quilting keeps, and when a bake chooses it
std::vector<Row> localRandomPhaseRows(); ///< time and quality of local random-phase noise
std::vector<Row> multipleKernelsRows();  ///< the same of multiple-kernels noise
std::vector<Row> shaderRows();           ///< ratios to plain and bare fetches
std::vector<Row> optionRows();           ///< mappings, layers, blend sharpness, tile rotation

/// Bakes a generated exemplar of this side and returns the seconds it took. Serves `lichen-bench
/// --peak-memory-of-bake SIDE`, which the bake and growth families run in separate processes.
double bakeOnce(int sidePixels);

template <class Work>
double medianSeconds(int runs, Work&& work) {
  std::vector<double> seconds;
  for (int run = 0; run < runs; ++run) {
    const double start = secondsNow();
    std::forward<Work>(work)();
    seconds.push_back(secondsNow() - start);
  }
  return median(std::move(seconds));
}

template <class Work, class Base>
double medianSecondsBeyond(int runs, const Work& work, const Base& base) {
  std::vector<double> seconds;
  for (int run = 0; run < runs; ++run)
    seconds.push_back(medianSeconds(1, work) - medianSeconds(1, base));
  return median(std::move(seconds));
}

} // namespace lichen::bench
