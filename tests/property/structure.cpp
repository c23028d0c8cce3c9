// SPDX-License-Identifier: MIT
// The structure of local random-phase noise against closed forms: its frequencies, its image at
// every magnification and distance, its share of the variance; and what repeats in an exemplar.
#include "bundle_of.h"
#include "example_exemplar.h"

#include <lichen/lattice.h>
#include <lichen/local_random_phase.h>
#include <lichen/structure_texel.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <evaluation/method_evaluator.h>
#include <local_random_phase/cosine_table.h>
#include <local_random_phase/octave_lattice.h>
#include <numbers>
#include <placement/near_periods.h>
#include <random>

using namespace lichen;
using namespace lichen::local_random_phase;

namespace {

constexpr int kWidth = 96, kHeight = 80;

struct Wave {
  int u, v;
  double amplitude, turns;
};
constexpr std::array<Wave, 4> kWaves{
    {{1, 0, 0.8, 0.1}, {3, -5, 0.5, 0.3}, {0, 7, 0.3, 0.8}, {12, 9, 0.2, 0.45}}};

/// The sum of the waves at a place [tiles], each times factor(wave).
template <class Factor>
double sumOfWaves(double x, double y, const Factor& factor) {
  double sum = 0.0;
  for (const Wave& wave : kWaves)
    sum += factor(wave) * wave.amplitude *
           std::cos(2.0 * std::numbers::pi * (wave.u * x + wave.v * y + wave.turns));
  return sum;
}

/// The transform of the waves at the centres of pixels, as the bake has it.
MapSpectrum spectrumOfWaves() {
  std::vector<float> plane;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      plane.push_back(float(
          sumOfWaves((x + 0.5) / kWidth, (y + 0.5) / kHeight, [](const Wave&) { return 1.0; }) /
          (kWidth * kHeight)));
  MapSpectrum spectrum;
  spectrum.toStored = Eigen::MatrixXd::Identity(1, 1);
  spectrum.channels.push_back(forwardFft(plane, kWidth, kHeight));
  double variance = 0.0;
  for (const Wave& wave : kWaves)
    variance += 0.5 * wave.amplitude * wave.amplitude;
  spectrum.covariance = Eigen::MatrixXd::Constant(1, 1, variance);
  return spectrum;
}

using Offsets = std::vector<std::array<double, 2>>;

/// The amplitude that a pixel leaves of a wave of so many squared cycles.
double amplitudeLeft(double squaredCycles) {
  return std::pow(std::max(1.0 - std::numbers::pi * std::numbers::pi / 18.0 * squaredCycles, 0.0),
                  3.0);
}

/// Evaluates the structure of all waves, with cosines that have no energy.
class WaveStructure {
public:
  /// With the offset 0 only, tiles and their mean agree.
  explicit WaveStructure(const Offsets& offsets = Offsets(3), double turbulence = 0.0) {
    const MapSpectrum spectrum = spectrumOfWaves();
    const FrequencySet set = strongestFrequencies(random_phase::powerPlane({spectrum}), 1.0);
    const std::array<int, 2> size = structureSize(set);
    shared_.texelsPerTileX = kWidth;
    shared_.texelsPerTileY = kHeight;
    shared_.cosines = {2};
    shared_.structure = {size[0], size[1], int(offsets.size()), turbulence};
    MapStructure structure;
    structure.offsets = offsets;
    structure.image = structureImage(spectrum, shared_.structure, {});
    structure.mean = structureImage(spectrum, shared_.structure, structure.offsets);
    Bundle bundle;
    Noise noise;
    NoiseMap map;
    map.target = MapTarget::height;
    map.channels = {MapChannel::height};
    map.encoding = ValueEncoding::linear;
    map.mean = {0.5};
    map.covariance = {0.01};
    LocalRandomPhaseMap own;
    own.structureAmplitudes = {structure.largest(0) / 6.0};
    own.structureDeviations = structure.image.deviations;
    const std::vector<Cosine> cosines(2, {{0, 1, 1, 2}, 0, 0.0});
    bundle.tables = {
        cosineTable(shared_, cosines, cosineVectors({spectrum}, cosines), {0, 0, 1}, structure)};
    map.data = own;
    noise.data = shared_;
    noise.maps = {map};
    bundle.noises = {noise};
    material_ = shaderMaterial(bundle, MaterialNoise(), {});
    evaluator_ = methodEvaluator(bundle, 0);
    largest_ = 6.0 * own.structureAmplitudes[0];
  }

  /// In deviations; `texels`: side of the footprint, of the structure's own texels.
  [[nodiscard]] double at(double x, double y, double texels) const {
    const float dx = float(texels / shared_.structure.columns);
    const float dy = float(texels / shared_.structure.rows);
    const TileFootprint footprint{{float(x), float(y)}, {dx, 0.0f}, {0.0f, dy}};
    return 6.0 * (double(evaluator_->gaussian(0, material_, footprint).value[0]) - 0.5);
  }
  /// Rounding of the texels.
  [[nodiscard]] double quantum() const { return largest_ / kMostStructureInteger; }
  [[nodiscard]] const CosineStructure& structure() const { return shared_.structure; }

  [[nodiscard]] const LocalRandomPhaseNoise& shared() const { return shared_; }
  [[nodiscard]] std::uint32_t seedWord() const { return material_.material.seedWord; }

private:
  LocalRandomPhaseNoise shared_;
  shader::LichenTriplanarMaterial material_{};
  std::shared_ptr<const MethodEvaluator> evaluator_;
  double largest_ = 0.0;
};

} // namespace

TEST_CASE("a structure takes the strongest frequencies, and no more than its share needs") {
  const MapSpectrum spectrum = spectrumOfWaves();
  const PowerPlane power = random_phase::powerPlane({spectrum});
  CHECK(strongestFrequencies(power, 0.0).largest() == std::array{0, 0});
  // Powers are as the squares 0.64, 0.25, 0.09 and 0.04.
  const auto held = [&](double share) {
    const FrequencySet set = strongestFrequencies(power, share);
    return std::array{set.holds(1, 0), set.holds(3, -5), set.holds(0, 7) && set.holds(0, -7),
                      set.holds(12, 9)};
  };
  CHECK(held(0.5) == std::array{true, false, false, false});
  CHECK(held(0.7) == std::array{true, true, false, false});
  CHECK(held(0.95) == std::array{true, true, true, false});
  CHECK(held(0.99) == std::array{true, true, true, true});
  const SplitSpectrum parts = split(spectrum, strongestFrequencies(power, 0.7));
  CHECK(parts.inside.covariance(0, 0) == Approx(0.5 * (0.64 + 0.25)).epsilon(1e-4));
  CHECK(parts.outside.covariance(0, 0) == Approx(0.5 * (0.09 + 0.04)).epsilon(1e-3));
}

TEST_CASE("the structure of a grey exemplar has its share of the variance") {
  MapExemplar map = test::threeMaterials(64, 64, 3);
  map.target = MapTarget::height;
  map.channels = {MapChannel::height};
  map.encoding = ValueEncoding::linear;
  for (std::size_t i = 0; i < map.values.size() / 3; ++i)
    map.values[i] = map.values[3 * i];
  map.values.resize(map.values.size() / 3);
  for (const double share : {0.3, 0.7}) {
    LocalRandomPhaseOptions options;
    options.structure = share;
    const Bundle bundle = test::bundleOf(bakeLocalRandomPhase("example", {&map, 1}, options));
    const auto& own = bundle.noises[0].maps[0].as<LocalRandomPhaseMap>();
    // One frequency more than the share needs, at most; of colours, the power of stored values
    // counts.
    CHECK(std::pow(own.structureDeviations[0], 2.0) == Approx(share).margin(0.03));
  }
}

TEST_CASE("a structure is the sum of its waves at every point, and fades with the footprint") {
  const WaveStructure structure;
  std::mt19937 generator(7u);
  std::uniform_real_distribution<double> tiles(-2.0, 2.0);
  const auto whole = [](const Wave&) { return 1.0; };
  // A cubic B-spline through samples of a wave of f cycles a sample is off by about (2 pi f)^4 /
  // 720 and as much again, since the mean square over all places is kept, not the values at
  // samples: here, at most 12 / 128 cycles, by 0.0004 of the shortest wave.
  for (int k = 0; k < 2000; ++k) {
    const double x = tiles(generator), y = tiles(generator);
    CHECK(std::abs(structure.at(x, y, 0.01) - sumOfWaves(x, y, whole)) <
          1e-3 + structure.quantum());
  }
  // At level 2 the shortest wave has 12 / 32 cycles a sample, and its mean square alone is right.
  for (const int level : {1, 2}) {
    const double squared = std::pow(4.0, level) - std::pow(4.0, -3.0 * level);
    const auto retained = [&](const Wave& wave) {
      const double u = double(wave.u) / structure.structure().columns;
      const double v = double(wave.v) / structure.structure().rows;
      return amplitudeLeft(squared * (u * u + v * v));
    };
    double wanted = 0.0, found = 0.0, errors = 0.0;
    for (const Wave& wave : kWaves)
      wanted += 0.5 * std::pow(wave.amplitude * retained(wave), 2.0);
    constexpr int kPoints = 20000;
    for (int k = 0; k < kPoints; ++k) {
      const double x = tiles(generator), y = tiles(generator);
      const double value = structure.at(x, y, std::ldexp(1.0, level));
      found += value * value / kPoints;
      errors += std::pow(value - sumOfWaves(x, y, retained), 2.0) / kPoints;
    }
    INFO("level " << level);
    CHECK(found == Approx(wanted).epsilon(0.03)); // four standard errors of that many points
    CHECK(errors < 0.002 * wanted);
  }
  CHECK(structure.at(0.3, 0.2, 64.0) == 0.0); // all is averaged out
}

TEST_CASE("structure and random part share the variance, and their sum has it everywhere") {
  constexpr int kTexels = 128, kSide = 192, kSeeds = 16;
  const MapExemplar map = test::threeMaterials(kTexels, kTexels, 3);
  for (const double share : {0.3, 0.7, 1.0}) {
    LocalRandomPhaseOptions options;
    options.structure = share;
    options.guide = 0.0;
    const Bundle bundle = test::bundleOf(bakeLocalRandomPhase("example", {&map, 1}, options));
    const Noise& noise = bundle.noises[0];
    const auto& own = noise.maps[0].as<LocalRandomPhaseMap>();
    const auto& shared = noise.as<LocalRandomPhaseNoise>();
    INFO("structure " << share);
    double random = 0.0;
    const CosineImageLayout layout(shared);
    const auto texels = cosineTexels(decodeLevel(bundle.tables[own.cosines], 0), layout);
    for (std::size_t i = 0; i < texels.size(); ++i)
      if (i % layout.cosineColumns >= kCosineColumns)
        for (const CosineTexel& cosine : texels[i])
          for (std::size_t c = 0; c < 3; ++c)
            random += 36.0 * std::pow(double(cosine[c]), 2.0) / (2.0 * shared.variants);
    // The highest frequencies of an even size, which have no mirror, are in neither.
    CHECK(random / 3.0 + std::pow(own.structureDeviations[0], 2.0) == Approx(1.0).margin(0.02));
    const auto evaluator = methodEvaluator(bundle, 0);
    // The mean square of each seed's field. Their spread gives the standard error of the
    // mean.
    std::vector<double> squares;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
      MaterialNoise material;
      material.seed = seed;
      const shader::LichenTriplanarMaterial constants = shaderMaterial(bundle, material, {});
      double sum = 0.0;
      for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
          const TileFootprint at{
              {(float(x) + 0.5f) / kTexels, (float(y) + 0.5f) / kTexels}, {}, {}};
          const auto value = evaluator->gaussian(0, constants, at).value;
          for (std::size_t c = 0; c < 3; ++c)
            sum += 36.0 * std::pow(double(value[c]) - 0.5, 2.0) / (3.0 * kSide * kSide);
        }
      squares.push_back(sum);
    }
    double mean = 0.0, spread = 0.0;
    for (const double square : squares)
      mean += square / kSeeds;
    for (const double square : squares)
      spread += std::pow(square - mean, 2.0) / (kSeeds - 1);
    const double error = std::sqrt(spread / kSeeds);
    INFO("variance " << mean << " +- " << error);
    CHECK(error < 0.03);
    CHECK(std::abs(mean - 1.0) < 4.0 * error); // fails by chance once in 1,000 runs of 16 seeds
  }
}

TEST_CASE("turbulence displaces a structure by its deviation, along both axes") {
  constexpr double kTurbulence = 0.002;
  const Offsets none(3);
  const WaveStructure still(none), displaced(none, kTurbulence);
  // The mean square of a change is the slope's times the displacement's.
  double slopes = 0.0;
  for (const Wave& wave : kWaves)
    slopes += 0.5 * std::pow(2.0 * std::numbers::pi * wave.amplitude, 2.0) *
              (wave.u * wave.u + wave.v * wave.v);
  double changes = 0.0;
  constexpr int kPoints = 40000;
  for (int k = 0; k < kPoints; ++k) {
    const double x = k * 0.0137, y = k * 0.0871;
    changes += std::pow(displaced.at(x, y, 0.01) - still.at(x, y, 0.01), 2.0) / kPoints;
  }
  // Four standard errors of the mean over the 40,000 x 0.0012 tiles, with 14 vertices a tile.
  CHECK(std::sqrt(changes / slopes) == Approx(kTurbulence).epsilon(0.05));
}

TEST_CASE("the structure of a bake is what repeats, whatever its guide") {
  const MapExemplar random = test::threeMaterials(64, 64, 3);
  for (const double guide : {0.0, 0.03, 1.0}) {
    LocalRandomPhaseOptions options;
    options.guide = guide;
    const Result<MethodBake> bake = bakeLocalRandomPhase("x", {&random, 1}, options);
    REQUIRE(bake);
    CHECK(bake.value().figures.structure == 0.0);
  }
}

TEST_CASE("near-periods are found where an exemplar repeats, and not in random fields") {
  // A pattern of 32 x 24 pixels, repeated four and five times.
  MapExemplar pattern = test::threeMaterials(32, 24, 5);
  MapExemplar repeated = pattern;
  repeated.width = 128;
  repeated.height = 120;
  repeated.values.clear();
  for (int y = 0; y < repeated.height; ++y)
    for (int x = 0; x < repeated.width; ++x)
      for (int c = 0; c < 3; ++c)
        repeated.values.push_back(pattern.values[std::size_t((y % 24 * 32 + x % 32) * 3 + c)]);
  const placement::NearPeriods periods = placement::nearPeriods({&repeated, 1}, 64);
  CHECK(periods.strength == 1.0);
  REQUIRE(periods.shifts.size() == 20);
  for (const std::array<double, 2>& shift : periods.shifts) {
    CHECK(std::abs(4.0 * shift[0] - std::round(4.0 * shift[0])) < 1e-9);
    CHECK(std::abs(5.0 * shift[1] - std::round(5.0 * shift[1])) < 1e-9);
  }
  CHECK(placement::nearPeriods({&repeated, 1}, 7).shifts.size() == 7);
  CHECK(placement::nearPeriods({&repeated, 1}, 64, 0.0).shifts.empty());
  // Twenty random fields, of four sizes of grain.
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const MapExemplar random = test::threeMaterials(128, 96, seed, int(seed % 4) + 1);
    INFO("seed " << seed);
    CHECK(placement::nearPeriods({&random, 1}, 64).strength == 0.0);
  }
}
