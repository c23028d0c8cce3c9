// SPDX-License-Identifier: MIT
// Exemplar maps (width * height * channels values each) -> a local random-phase noise and its
// tables.
#include "cosine_table.h"
#include "cosine_vectors.h"
#include "gaussian/gaussian_distribution.h"
#include "gaussianization/gaussianized_maps.h"
#include "octave_lattice.h"
#include "placement/near_periods.h"
#include "structure.h"
#include "transport/covariance_map.h"
#include "user_spectrum.h"

#include <lichen/local_random_phase.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lichen {
namespace {

using namespace local_random_phase;

/// The spectrum of a Gaussian image of at least one dimension.
MapSpectrum spectrumOf(const gaussianization::Gaussianized& image) {
  MapSpectrum result;
  const auto pixels = image.image.size();
  constexpr auto kMean = float(gaussian::kGaussianMean);
  constexpr auto kPerDeviation = float(1.0 / gaussian::kGaussianDeviation);
  const auto isConstant = [&] {
    const Point& first = image.image.front();
    return std::all_of(image.image.begin(), image.image.end(), [&](const Point& point) {
      return point.x == first.x && point.y == first.y && point.z == first.z;
    });
  };
  if (isConstant())
    return result;
  const float scale = kPerDeviation / float(pixels);
  for (int channel = 0; channel < image.dimensions; ++channel) {
    std::vector<float> plane;
    plane.reserve(pixels);
    double squares = 0.0;
    for (const Point& point : image.image) {
      plane.push_back(scale * ((channel == 0   ? point.x
                                : channel == 1 ? point.y
                                               : point.z) -
                               kMean));
      squares += double(plane.back()) * double(plane.back());
    }
    result.variances.push_back(squares * double(pixels));
    result.channels.push_back(forwardFft(plane, image.width, image.height));
  }
  return result;
}

/// How stored values follow the Gaussian channels about their mean, to the first order, scaled as
/// MapSpectrum::toStored: by the root of their covariance, the symmetric one with a table, the
/// triangular one without.
Eigen::MatrixXd toStoredOf(const gaussianization::GaussianizedMap& map) {
  const auto channels = Eigen::Index(map.map.mean.size());
  if (channels != map.image.dimensions) // which axes the Gaussian ones are is not known
    return Eigen::MatrixXd::Identity(map.image.dimensions, map.image.dimensions);
  const Eigen::MatrixXd covariance =
      Eigen::Map<const Eigen::MatrixXd>(map.map.covariance.data(), channels, channels);
  const Eigen::MatrixXd root = map.inverse ? transport::power<Eigen::MatrixXd>(covariance, 0.5)
                                           : Eigen::MatrixXd(covariance.llt().matrixL());
  return std::sqrt(double(channels)) / root.norm() * root;
}

/// How luminance follows the Gaussian channels of a colour map about its mean, to the first order
/// and up to a factor. Empty for others.
std::vector<double> luminanceOf(const gaussianization::GaussianizedMap& map,
                                const Eigen::MatrixXd& toStored) {
  constexpr std::array<double, 3> kLuminance{0.2126, 0.7152, 0.0722}; // ITU-R BT.709
  const bool isColor =
      map.map.target == MapTarget::baseColor || map.map.target == MapTarget::emissive;
  if (!isColor || map.image.dimensions != int(kLuminance.size()))
    return {};
  Eigen::Vector3d ofStored(kLuminance.data());
  if (map.map.encoding == ValueEncoding::root) // light is the square
    ofStored = ofStored.cwiseProduct(Eigen::Vector3d(map.map.mean.data()));
  const Eigen::Vector3d luminance = toStored.transpose() * ofStored;
  return {luminance[0], luminance[1], luminance[2]};
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

std::size_t appended(Table table, std::vector<Table>& tables) {
  tables.push_back(std::move(table));
  return tables.size() - 1;
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
Result<LocalRandomPhaseBake> bakeMaps(const std::string& name, std::span<const MapExemplar> maps,
                                      const LocalRandomPhaseOptions& options) {
  if (Result<void> checked = checkOptions(options); !checked)
    return checked.error();
  LocalRandomPhaseBake bake;
  bake.noise.name = name;
  LocalRandomPhaseNoise shared;
  std::vector<MapSpectrum> spectra;
  std::vector<LocalRandomPhaseMap> data;
  const auto append = [&](gaussianization::GaussianizedMap map) {
    shared.texelsPerTileX = std::max(shared.texelsPerTileX, map.image.width);
    shared.texelsPerTileY = std::max(shared.texelsPerTileY, map.image.height);
    spectra.push_back(spectrumOf(map.image));
    if (!spectra.back().channels.empty()) {
      spectra.back().toStored = toStoredOf(map);
      spectra.back().luminance = luminanceOf(map, spectra.back().toStored);
    }
    LocalRandomPhaseMap own;
    own.dimensions = map.image.dimensions;
    if (map.inverse)
      own.inverseTable = appended(*std::move(map.inverse), bake.tables);
    data.push_back(own);
    bake.noise.maps.push_back(std::move(map.map));
  };
  const Result<bool> periodic = gaussianization::gaussianizeMaps(name, maps, options, append);
  if (!periodic)
    return periodic.error();
  bake.exemplarWasPeriodic = periodic.value();

  const std::array<int, 2> cells = cellsOfOctave0(shared.texelsPerTileX, shared.texelsPerTileY);
  shared.columns = cells[0];
  shared.rows = cells[1];
  if (options.spectrum)
    if (Result<void> replaced = replaceSpectra(*options.spectrum, spectra); !replaced)
      return replaced.error();
  const bool mayHave = !options.spectrum && options.structure != 0.0;
  const placement::NearPeriods periods =
      mayHave ? placement::nearPeriods(maps, std::size_t(kMostStructureOffsets), options.guide)
              : placement::NearPeriods();
  bake.structure = options.structure.value_or(periods.strength);
  const std::vector<MapStructure> structures =
      takeStructure(spectra, bake.structure, periods.shifts, shared.structure);
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
    data[m].cosines = appended(std::move(table), bake.tables);
    bake.noise.maps[m].data = data[m];
    channel += channels;
  }
  bake.noise.data = shared;
  return bake;
}

} // namespace

Result<LocalRandomPhaseBake> bakeLocalRandomPhase(std::string name,
                                                  std::span<const MapExemplar> maps,
                                                  const LocalRandomPhaseOptions& options) {
  return withinMemory([&] { return gaussianization::noMemoryToBake(name, maps); },
                      [&] { return bakeMaps(name, maps, options); });
}

} // namespace lichen
