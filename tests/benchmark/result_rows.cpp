// SPDX-License-Identifier: MIT
// The quality measures of results from the bundle alone.
#include "exemplars.h"
#include "rows.h"

#include <lichen/quality.h>
#include <lichen/synthesize.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace lichen::bench {
namespace {

constexpr double kExemplarSide = 256.0;
/// As TARGETS.md measured its prototype: 256 x 256 -> 1024 x 1024.
constexpr int kResultSide = 1024;
/// 16 exemplars a side.
constexpr int kLatticeSide = 4096;

template <class T>
T require(Result<T> result) {
  if (!result) {
    std::fprintf(stderr, "lichen-bench: %s\n", result.error().message.c_str());
    std::exit(int(result.error().kind));
  }
  return std::move(result).value();
}

SrgbImage synthesized(const Bundle& bundle, int side) {
  SynthesisOptions options;
  options.width = options.height = side;
  return toSrgb(require(synthesize(bundle, options)));
}

/// One measure over all exemplars.
struct Measure {
  std::vector<double> values;
  std::string worstName;
  double worst = 0.0;

  void add(double value, const std::string& name) {
    values.push_back(value);
    if (worstName.empty() || value > worst) {
      worst = value;
      worstName = name;
    }
  }
  void append(std::vector<Row>& rows, const std::string& name, double target,
              const std::string& unit) const {
    rows.push_back({name + ", median", median(values), target, unit,
                    std::to_string(values.size()) + " exemplars"});
    rows.push_back({"the same, worst", worst, target, unit, worstName});
  }
};

} // namespace

std::vector<Row> resultRows() {
  Measure color, lattice, spectrum, seam;
  for (const Exemplar& exemplar : exemplars256()) {
    const Bundle bundle = bakedBundle(exemplar.image);
    const SrgbImage result = synthesized(bundle, kResultSide);
    color.add(require(colorDistance(exemplar.image, result)), exemplar.name);
    spectrum.add(require(spectrumDistanceDb(exemplar.image, result)), exemplar.name);
    seam.add(require(seamVisibility(exemplar.image, result)), exemplar.name);
    const LatticeView view{{}, 1.0 / kExemplarSide, 1.0 / kExemplarSide};
    lattice.add(require(latticeVisibility(synthesized(bundle, kLatticeSide), view)), exemplar.name);
  }
  std::vector<Row> rows;
  color.append(rows, "color_distance, 4 exemplars a side", 0.003, "");
  lattice.append(rows, "lattice_visibility, 16 exemplars a side", 0.03, "");
  spectrum.append(rows, "spectrum_distance_db, 4 exemplars a side", 0.6, "dB");
  seam.append(rows, "seam_visibility, 4 exemplars a side", 1.1, "");
  return rows;
}

} // namespace lichen::bench
