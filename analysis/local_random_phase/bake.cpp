// SPDX-License-Identifier: MIT
// Exemplar maps (width * height * channels values each) -> a local random-phase noise and its
// tables.
#include "cosine_table.h"
#include "cosine_vectors.h"
#include "gaussian/gaussian_distribution.h"
#include "gaussian/gaussianized_maps.h"
#include "octave_lattice.h"
#include "placement/near_periods.h"
#include "random_phase/map_spectrum.h"

#include <lichen/local_random_phase.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lichen {
namespace {

using namespace local_random_phase;

/// Below this, repetition does not show.
constexpr double kLeastStructure = 0.3;

double structureOf(const placement::NearPeriods& periods) {
  return periods.strength < kLeastStructure ? 0.0 : periods.strength;
}

Result<void> checkOptions(const LocalRandomPhaseOptions& options) {
  if (options.cosines < int(kCosinesRange.least) || options.cosines > int(kCosinesRange.most))
    return Error{ErrorKind::usage, std::to_string(options.cosines) + " cosines; expected 1 to " +
                                       std::to_string(kMostCosines)};
  const auto isWithin = [](const std::optional<double>& value, const NumberRange& range) {
    return !value || (*value >= range.least && *value <= range.most);
  };
  if (!isWithin(options.structure, kStructureRange) || !isWithin(options.guide, kGuideRange) ||
      !isWithin(options.turbulence, kTurbulenceRange))
    return Error{ErrorKind::usage, "structure, guide and turbulence: expected 0 to 1"};
  if (options.spectrum && options.structure.value_or(0.0) > 0.0)
    return Error{ErrorKind::usage,
                 "a structure has the phases of the exemplar; expected none with a "
                 "spectrum of its own"};
  return {};
}

/// Takes the frequencies of the structure out of the spectra, and returns them for each map. Sets
/// what the maps share of it.
std::vector<MapStructure> takeStructure(std::vector<MapSpectrum>& spectra, double share,
                                        const std::vector<std::array<double, 2>>& offsets,
                                        CosineStructure& shared) {
  std::vector<MapStructure> structures(spectra.size());
  const FrequencySet set = strongestFrequencies(powerPlane(spectra), share);
  if (set.largest() == std::array{0, 0})
    return structures;
  const std::array<int, 2> size = structureSize(set);
  shared = {size[0], size[1], int(offsets.size()), 0.0};
  for (std::size_t m = 0; m < spectra.size(); ++m) {
    SplitSpectrum parts = split(std::move(spectra[m]), set);
    structures[m].image = structureImage(parts.inside, shared, {});
    structures[m].offsets = offsets;
    if (!offsets.empty())
      structures[m].mean = structureImage(parts.inside, shared, offsets);
    spectra[m] = std::move(parts.outside);
  }
  return structures;
}

/// Sets what a map's constants say of its structure.
void setStructure(LocalRandomPhaseMap& map, const MapStructure& structure) {
  map.structureDeviations = structure.image.deviations;
  if (!structure.image.levels.empty())
    for (std::size_t c = 0; c < std::size_t(map.dimensions); ++c)
      map.structureAmplitudes.push_back(
          std::min(gaussian::kGaussianDeviation * structure.largest(c), double(kMostAmplitude)));
}

/// As bakeLocalRandomPhase(), but throws std::bad_alloc.
Result<MethodBake> bakeMaps(const std::string& name, std::span<const MapExemplar> maps,
                            const LocalRandomPhaseOptions& options) {
  if (Result<void> checked = checkOptions(options); !checked)
    return checked.error();
  MethodBake bake;
  bake.noise.name = name;
  LocalRandomPhaseNoise shared;
  std::vector<MapSpectrum> spectra;
  std::vector<LocalRandomPhaseMap> data;
  if (Result<void> begun =
          random_phase::beginBake(name, maps, options, bake, shared, spectra, data);
      !begun)
    return begun.error();

  const std::array<int, 2> cells = cellsOfOctave0(shared.texelsPerTileX, shared.texelsPerTileY);
  shared.columns = cells[0];
  shared.rows = cells[1];
  shared.hasGivenSpectrum = options.spectrum.has_value();
  if (options.spectrum)
    if (Result<void> replaced = replaceSpectra(*options.spectrum, spectra); !replaced)
      return replaced.error();
  const bool mayHave = !options.spectrum && options.structure != 0.0;
  const placement::NearPeriods periods =
      mayHave ? placement::nearPeriods(maps, std::size_t(kMostStructureOffsets), options.guide)
              : placement::NearPeriods();
  bake.figures.structure = options.structure.value_or(structureOf(periods));
  const std::vector<MapStructure> structures =
      takeStructure(spectra, bake.figures.structure, periods.shifts, shared.structure);
  if (shared.structure.columns > 0)
    shared.structure.turbulence = options.turbulence;
  const PowerPlane power = powerPlane(spectra);
  const auto count = std::size_t(options.cosines);
  const std::vector<FrequencyBox> boxes =
      options.spectrum ? boxesAroundPower(power, count) : boxesOfEqualPower(smoothed(power), count);
  std::vector<Cosine> cosines = fitCosines(
      power, boxes, edgesOfOctave0(shared.columns, shared.rows), options.spectrum.has_value());
  if (cosines.empty()) // nothing varies
    cosines.assign(2, {{0, 1, 1, 2}, 0, 0.0});
  const CosineVectors vectors = cosineVectors(spectra, cosines);
  shared.cosines = cosinesByOctave(cosines);
  shared.variants = vectors.variants;
  std::size_t channel = 0;
  for (std::size_t m = 0; m < spectra.size(); ++m) {
    const std::size_t channels = spectra[m].channels.size();
    Table table = cosineTable(shared, cosines, vectors, {m, channel, channels}, structures[m]);
    setStructure(data[m], structures[m]);
    table.name = name + "." + std::string(nameOf(bake.noise.maps[m].target)) + ".cosines";
    data[m].cosines = gaussian::appended(std::move(table), bake.tables);
    bake.noise.maps[m].data = data[m];
    channel += channels;
  }
  bake.noise.data = shared;
  return bake;
}

} // namespace

Result<MethodBake> bakeLocalRandomPhase(std::string name, std::span<const MapExemplar> maps,
                                        const LocalRandomPhaseOptions& options) {
  return withinMemory([&] { return gaussian::noMemoryToBake(name, maps); },
                      [&] { return bakeMaps(name, maps, options); });
}

} // namespace lichen
