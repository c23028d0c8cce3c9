// SPDX-License-Identifier: MIT
// Local random-phase noise at its limits, a Fourier series and a Gabor noise, against closed forms;
// and its colours and the correlations of its sets.
#include "bundle_of.h"
#include "example_exemplar.h"
#include "statistics_of_maps.h"

#include <lichen/image.h>
#include <lichen/local_random_phase.h>
#include <lichen/quality.h>
#include <lichen/synthesize.h>
#include <lichen/tiling.h>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <evaluation/method_evaluator.h>
#include <local_random_phase/cosine_table.h>
#include <local_random_phase/octave_lattice.h>
#include <local_random_phase/window_spectrum.h>
#include <numbers>
#include <random>

using namespace lichen;
using namespace lichen::local_random_phase;
using namespace lichen::test;

namespace {

constexpr int kTexels = 128, kSmall = 64; // sides of exemplars
constexpr double kTau = 2.0 * std::numbers::pi;

/// A noise of one channel with the given cosines, ordered by octave and even in number.
Bundle noiseOf(const std::vector<Cosine>& cosines, int columns, int rows) {
  LocalRandomPhaseNoise shared;
  shared.texelsPerTileX = shared.texelsPerTileY = kTexels;
  shared.columns = columns;
  shared.rows = rows;
  shared.cosines = cosinesByOctave(cosines);
  CosineVectors vectors;
  for (const Cosine& cosine : cosines) { // Gaussian values have the deviation 1/6
    vectors.vectors.emplace_back(
        Eigen::MatrixXd::Constant(1, 1, std::sqrt(2.0 * cosine.energy) / 6.0));
    vectors.phases.emplace_back(Eigen::MatrixXd::Zero(1, 1));
  }
  NoiseMap map;
  map.target = MapTarget::height;
  map.channels = {MapChannel::height};
  map.encoding = ValueEncoding::linear;
  map.mean = {0.5};
  map.covariance = {0.01};
  map.data = LocalRandomPhaseMap();
  Noise noise;
  noise.data = shared;
  noise.maps = {map};
  Bundle bundle;
  bundle.tables = {cosineTable(shared, cosines, vectors, {0, 0, 1}, {})};
  bundle.noises = {noise};
  return bundle;
}

/// The first Gaussian channel of a seed, in standard deviations.
class Field {
public:
  Field(const Bundle& bundle, std::uint32_t seed) : evaluator_(methodEvaluator(bundle, 0)) {
    MaterialNoise material;
    material.seed = seed;
    material_ = shaderMaterial(bundle, material, {});
  }
  [[nodiscard]] double at(double x, double y) const {
    const TileFootprint footprint{{float(x), float(y)}, {}, {}};
    return 6.0 * (double(evaluator_->gaussian(0, material_, footprint).value[0]) - 0.5);
  }
  [[nodiscard]] const shader::LichenMaterial& material() const { return material_.material; }

private:
  std::shared_ptr<const MethodEvaluator> evaluator_;
  shader::LichenTriplanarMaterial material_{};
};

/// A cosine as the shader reads it.
struct StoredCosine {
  double u, v, width, height; ///< middle and sides of the rectangle [cycles / tile]
  int octave;
  double energy;
};

std::vector<StoredCosine> storedCosines(const Bundle& bundle) {
  const auto& shared = bundle.noises[0].as<LocalRandomPhaseNoise>();
  const CosineImageLayout layout(shared);
  const Table& table = bundle.tables[bundle.noises[0].maps[0].as<LocalRandomPhaseMap>().cosines];
  const auto texels = cosineTexels(decodeLevel(table, 0), layout);
  std::vector<StoredCosine> cosines;
  for (std::size_t octave = 0; octave < shared.cosines.size(); ++octave)
    for (int k = 0; k < shared.cosines[octave]; ++k) {
      const std::size_t j = cosines.size(), column = j % kRowCosines;
      const auto* row = &texels[j / kRowCosines * layout.cosineColumns];
      const CosineTexel& box = row[0][column];
      double energy = 0.0;
      for (int v = 0; v < shared.variants; ++v)
        energy += 18.0 * std::pow(double(row[1 + v][column][0]), 2.0) / shared.variants;
      cosines.push_back({box[0], box[1], box[2], box[3], int(octave), energy});
    }
  return cosines;
}

/// The closed form: the autocorrelation of the windows times the mean of cos 2 pi f t over the
/// rectangle.
double autocovariance(const std::vector<StoredCosine>& cosines, const WindowSpectrum& window,
                      const std::array<double, 2>& edges, double x, double y) {
  const auto sinc = [](double cycles) {
    const double phase = std::numbers::pi * cycles;
    return phase == 0.0 ? 1.0 : std::sin(phase) / phase;
  };
  double sum = 0.0;
  for (const StoredCosine& cosine : cosines) {
    const double scale = std::ldexp(1.0, cosine.octave);
    sum += cosine.energy * window.correlation(x / edges[0] * scale, y / edges[1] * scale) *
           sinc(cosine.width * x) * sinc(cosine.height * y) *
           std::cos(kTau * (cosine.u * x + cosine.v * y));
  }
  return sum;
}

/// A lag [tiles], and the mean product of values that far apart.
struct LagProduct {
  double x, y;
  double mean, error; ///< `error`: the standard error, from the spread over the seeds
};

std::vector<LagProduct> lagProducts(const Bundle& bundle,
                                    const std::vector<std::array<double, 2>>& lags, int seeds,
                                    int points) {
  std::vector<LagProduct> products;
  for (const auto& lag : lags)
    products.push_back({lag[0], lag[1], 0.0, 0.0});
  std::mt19937 generator(5u);
  std::uniform_real_distribution<double> tiles(-60.0, 60.0);
  for (int seed = 1; seed <= seeds; ++seed) {
    const Field field(bundle, std::uint32_t(seed));
    std::vector<double> sums(lags.size(), 0.0);
    for (int k = 0; k < points; ++k) {
      const double x = tiles(generator), y = tiles(generator), here = field.at(x, y);
      for (std::size_t l = 0; l < lags.size(); ++l)
        sums[l] += here * field.at(x + lags[l][0], y + lags[l][1]) / points;
    }
    for (std::size_t l = 0; l < lags.size(); ++l) {
      products[l].mean += sums[l] / seeds;
      products[l].error += sums[l] * sums[l] / seeds;
    }
  }
  for (LagProduct& product : products)
    product.error = std::sqrt((product.error - product.mean * product.mean) / (seeds - 1));
  return products;
}

} // namespace

TEST_CASE("where one window reaches alone, the noise is a Fourier series with random phases") {
  // [LRP14] section 3.1, the limit of large windows. Windows end sqrt(3) / 2 edges from their
  // vertices, so nearer than 1 - sqrt(3) / 2 to a vertex its own is 1 and all others are 0. Here an
  // edge is 8 tiles long, and rectangles have no sides.
  const std::array<std::array<int, 2>, 6> frequencies{
      {{3, 2}, {6, -4}, {1, 8}, {9, 1}, {7, 7}, {12, -9}}};
  std::vector<Cosine> cosines;
  for (const auto& [u, v] : frequencies)
    cosines.push_back({{u, u, v, v}, 0, 0.25 / double(cosines.size() + 1)});
  const Field field(noiseOf(cosines, 1, 2), 1);
  const shader::LichenMaterial& material = field.material();
  std::mt19937 generator(6u);
  std::uniform_real_distribution<double> place(-0.16, 0.16);
  constexpr int kPoints = 60, kVertices = 400, kUnknowns = 12;
  constexpr double kReach = 0.133; // 1 - sqrt(3) / 2 = 0.13397
  std::vector<std::array<std::complex<double>, 6>> phases;
  for (int vertex = 0; vertex < kVertices; ++vertex) {
    const int i = vertex % 20 - 10, j = vertex / 20 - 10;
    Eigen::MatrixXd waves(kPoints, kUnknowns);
    Eigen::VectorXd values(kPoints);
    for (int k = 0; k < kPoints;) {
      const double column = place(generator), row = place(generator);
      if (squaredEdges(column, row) > kReach * kReach)
        continue;
      const double x = (column + 0.5 * row) / double(material.columnsPerTile),
                   y = row / double(material.rowsPerTile);
      for (std::size_t f = 0; f < frequencies.size(); ++f) {
        const double phase = kTau * ((frequencies[f][0] - 0.5) * x + (frequencies[f][1] - 0.5) * y);
        waves(k, Eigen::Index(2 * f)) = std::cos(phase);
        waves(k, Eigen::Index(2 * f + 1)) = std::sin(phase);
      }
      values[k++] =
          field.at(x + (i + 0.5 * j) / double(material.columnsPerTile) - double(material.offsetX),
                   y + j / double(material.rowsPerTile) - double(material.offsetY));
    }
    const Eigen::VectorXd fit = waves.colPivHouseholderQr().solve(values);
    // Positions in floats of up to 120 tiles are off by 4e-6, and the series rises by at most 2 pi
    // 15 a tile; the polynomial of the cosine is off by 1.1e-4 of each.
    CHECK((waves * fit - values).cwiseAbs().maxCoeff() < 1e-3); // measured 5e-4
    phases.emplace_back();
    for (std::size_t f = 0; f < frequencies.size(); ++f) {
      const std::complex<double> wave(fit[Eigen::Index(2 * f)], fit[Eigen::Index(2 * f + 1)]);
      // Amplitudes are rounded to 8 significant bits.
      CHECK(std::abs(wave) == Approx(std::sqrt(2.0 * cosines[f].energy)).epsilon(0.004));
      phases.back()[f] = wave / std::abs(wave);
    }
  }
  // Phases are uniform and independent: the mean of n of them on the unit circle is longer than r
  // with the probability exp(-n r^2), here 6e-6 for each of 6 phases and 15 differences.
  constexpr double kLongest = 0.173;
  for (std::size_t a = 0; a < frequencies.size(); ++a)
    for (std::size_t b = a; b < frequencies.size(); ++b) {
      std::complex<double> sum = 0.0;
      for (const auto& own : phases)
        sum += (a == b ? own[a] : own[a] * std::conj(own[b])) / double(kVertices);
      INFO("phases " << a << " and " << b);
      CHECK(std::abs(sum) < kLongest);
    }
}

TEST_CASE("a noise with one cosine has the autocovariance of a Gabor noise") {
  // [LRP14] section 3.2, the limit of few cosines: windowed waves of a rectangle of frequencies.
  const WindowSpectrum window;
  const std::array<double, 2> edges = edgesOfOctave0(7, 8);
  const std::vector<std::array<double, 2>> lags{{0.0, 0.0},  {0.05, 0.0},  {0.0, 0.08},
                                                {0.1, -0.1}, {0.25, 0.15}, {0.04, -0.3},
                                                {-0.2, 0.1}, {0.5, 0.0},   {0.02, 0.03}};
  constexpr int kSeeds = 16, kPoints = 6000;
  for (const auto& [box, octave] :
       {std::pair(FrequencyBox{5, 5, 3, 3}, 0), std::pair(FrequencyBox{4, 7, -3, 2}, 1)}) {
    const Bundle bundle = noiseOf({{box, octave, 1.0}, {{1, 1, 0, 0}, octave, 0.0}}, 7, 8);
    const std::vector<StoredCosine> cosine{{0.5 * (box.low() + box.high()),
                                            0.5 * (box.lowRow() + box.highRow()), box.width(),
                                            box.height(), octave, 1.0}};
    for (const LagProduct& lag : lagProducts(bundle, lags, kSeeds, kPoints)) {
      const double wanted = autocovariance(cosine, window, edges, lag.x, lag.y);
      INFO("lag " << lag.x << ", " << lag.y << ": " << lag.mean << " +- " << lag.error);
      CHECK(lag.error < 0.005);
      CHECK(std::abs(lag.mean - wanted) < 0.02); // four of the largest standard errors
    }
  }
}

TEST_CASE("a spectrum of one frequency makes a noise with the autocovariance of its few cosines") {
  MapExemplar map =
      emptyMap(MapTarget::height, {MapChannel::height}, ValueEncoding::linear, kTexels);
  const std::vector<double> field = gaussianFields(1, 1, kTexels)[0];
  for (const double g : field)
    map.values.push_back(float(1.0 / (1.0 + std::exp(-g))));
  LocalRandomPhaseOptions options;
  options.cosines = 12;
  options.spectrum = SpectrumPicture{41, 41, std::vector<float>(41 * 41)};
  options.spectrum->amplitudes[(20 + 4) * 41 + 20 + 7] = 1.0f; // 7 cycles along x, 4 along y
  const Bundle bundle = test::bundleOf(bakeLocalRandomPhase("wave", {&map, 1}, options));
  const std::vector<StoredCosine> cosines = storedCosines(bundle);
  const auto& shared = bundle.noises[0].as<LocalRandomPhaseNoise>();
  const WindowSpectrum window;
  const std::array<double, 2> edges = edgesOfOctave0(shared.columns, shared.rows);
  const std::vector<std::array<double, 2>> lags{{0.0, 0.0},  {0.05, 0.0}, {0.0, 0.12},
                                                {0.07, 0.1}, {0.2, 0.0},  {-0.2, 0.3}};
  constexpr int kSeeds = 16, kPoints = 4000;
  for (const LagProduct& lag : lagProducts(bundle, lags, kSeeds, kPoints)) {
    const double wanted = autocovariance(cosines, window, edges, lag.x, lag.y);
    INFO("lag " << lag.x << ", " << lag.y << ": " << lag.mean << " +- " << lag.error);
    CHECK(lag.error < 0.005);
    CHECK(std::abs(lag.mean - wanted) < 0.02); // four of the largest standard errors
    // And near the origin that of the one wave.
    if (std::hypot(lag.x, lag.y) < 0.13)
      CHECK(wanted == Approx(std::cos(kTau * (7.0 * lag.x + 4.0 * lag.y))).margin(0.1));
  }
}

TEST_CASE("maps of a set correlate as Gaussian values with their covariance do, decoded") {
  // Of three materials the height follows the colour, but their Gaussian values follow each other
  // less than linearly, and random phases keep only the covariance of these.
  std::vector<MapExemplar> maps{
      test::threeMaterials(kSmall, kSmall, 3),
      emptyMap(MapTarget::height, {MapChannel::height}, ValueEncoding::linear, kSmall)};
  const std::vector<double> grain = gaussianFields(1, 4, kSmall)[0];
  for (std::size_t i = 0; i < grain.size(); ++i)
    maps[1].values.push_back(float(0.2 + 0.6 * double(maps[0].values[3 * i]) + 0.05 * grain[i]));
  LocalRandomPhaseOptions options;
  options.structure = 0.0;
  const Bundle bundle = test::bundleOf(bakeLocalRandomPhase("set", maps, options));
  const std::array<double, 3> found =
      correlationsWithHeight(synthesized(bundle, MapTarget::baseColor, 2).values,
                             synthesized(bundle, MapTarget::height, 2).values);

  // The exemplar's Gaussian values, from a bake for tiling.
  TilingOptions precise;
  precise.bits = 16;
  const Bundle tiling = test::bundleOf(bakeTiling("set", maps, precise));
  Eigen::MatrixXd gaussian(4, kSmall * kSmall);
  for (std::size_t m = 0; m < 2; ++m) {
    const Table& image = tiling.tables[tiling.noises[0].maps[m].as<TilingMap>().gaussian];
    const std::vector<float> texels = decodeLevel(image, 0);
    const auto stride = std::size_t(channelCount(image.format));
    for (std::size_t i = 0; i < texels.size() / stride; ++i)
      for (std::size_t c = 0; c < (m == 0 ? 3u : 1u); ++c)
        gaussian(Eigen::Index(3 * m + c), Eigen::Index(i)) = double(texels[i * stride + c]);
  }
  const Eigen::MatrixXd centred = gaussian.colwise() - gaussian.rowwise().mean();
  const Eigen::Matrix4d covariance = centred * centred.transpose() / double(kSmall * kSmall);
  const Eigen::Matrix4d root = covariance.llt().matrixL();
  const auto evaluator = methodEvaluator(bundle, 0);
  std::mt19937 generator(7u);
  std::normal_distribution<double> normal;
  std::vector<float> color, height;
  for (int k = 0; k < 200000; ++k) {
    const Eigen::Vector4d white(normal(generator), normal(generator), normal(generator),
                                normal(generator));
    const Eigen::Vector4f value = (root * white).cast<float>().array() + 0.5f;
    const auto light = evaluator->decoded(0, {value[0], value[1], value[2]});
    color.insert(color.end(), light.begin(), light.begin() + 3);
    height.push_back(evaluator->decoded(1, {value[3], 0.5f, 0.5f})[0]);
  }
  const std::array<double, 3> wanted = correlationsWithHeight(color, height);
  const std::array<double, 3> ofExemplar =
      correlationsWithHeight(decodedValues(maps[0]), maps[1].values);
  for (std::size_t c = 0; c < 3; ++c) {
    INFO("channel " << c);
    CHECK(found[c] == Approx(wanted[c]).margin(0.03)); // measured 0.012
  }
  // 0.66 and 0.95: the limit of what random phases can do for such a set.
  CHECK(ofExemplar[0] - wanted[0] > 0.2);
}

TEST_CASE("the noise has the colours of the exemplar, whatever its structure") {
  const MapExemplar map = test::threeMaterials(kSmall, kSmall, 3);
  SrgbImage exemplar(kSmall, kSmall, 3);
  exemplar.values = map.values;
  for (const double structure : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    LocalRandomPhaseOptions options;
    options.transport = TransportEffort::fast;
    options.structure = structure;
    const Bundle bundle = test::bundleOf(bakeLocalRandomPhase("example", {&map, 1}, options));
    const Result<double> distance =
        colorDistance(exemplar, toSrgb(synthesized(bundle, MapTarget::baseColor, 4)));
    REQUIRE(distance);
    INFO("structure " << structure);
    CHECK(distance.value() < 0.02); // measured 0.008 to 0.013
  }
}
