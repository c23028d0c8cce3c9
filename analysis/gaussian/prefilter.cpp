// SPDX-License-Identifier: MIT
// One inverse table -> kTableLevels tables, each averaged over the lost variance of its fetches and
// fitted with fewer cells.
#include "prefilter.h"

#include "table_lookup.h"
#include "transport/covariance.h"

#include <Eigen/Dense>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace lichen::gaussian {
namespace {

/// Samples along an axis for the part of the loss that all directions share.
constexpr int kPlacesOnAxis = 256;

/// Gaussian samples per cell for the rest of the loss. The stratified set is whitened, so a linear
/// table is averaged exactly for any number of samples. Against 4096 samples of the whole loss, on
/// the generated rust, terrazzo and a photograph of dirt, of 256 x 256, a cell is off by 0.1 to 0.7
/// codes of 8 bits (root mean square, by loss; at worst 6); 64 samples of the whole loss are off by
/// 0.5 to 1.2 and take twice as long.
constexpr std::size_t kSamplesPerCell = 32;

/// Losses of two directions that differ by less, as a share of the largest, count as equal.
constexpr double kAlike = 1e-3;

/// Element [i * side + j] is the weight of cell j in the mean of a lookup along one axis at the
/// centre of cell i, displaced by N(0, variance / 36).
std::vector<float> axisWeights(int side, double variance) {
  std::vector<double> displacements;
  for (int k = 0; k < kPlacesOnAxis; ++k)
    displacements.push_back(
        std::sqrt(variance) *
        (gaussian::gaussianQuantile((k + 0.5) / kPlacesOnAxis) - gaussian::kGaussianMean));
  const std::vector<float> middles = axisMiddles(side);
  std::vector<float> weights(std::size_t(side) * std::size_t(side), 0.0f);
  for (std::size_t i = 0; i < std::size_t(side); ++i)
    for (const double displacement : displacements) {
      const double place =
          std::clamp(side * gaussian::gaussianCdf(double(middles[i]) + displacement) - 0.5, 0.0,
                     double(side - 1));
      const auto cell = std::min(std::size_t(place), std::size_t(side) - 2);
      const auto above = float((place - double(cell)) / kPlacesOnAxis);
      weights[i * std::size_t(side) + cell] += 1.0f / kPlacesOnAxis - above;
      weights[i * std::size_t(side) + cell + 1] += above;
    }
  return weights;
}

/// Averages over independent displacements of variance / 36 along every axis.
InverseTable blurredAlongAxes(const InverseTable& table, double variance) {
  const auto side = std::size_t(table.side);
  const auto channels = std::size_t(table.channels);
  const std::vector<float> weights = axisWeights(table.side, variance);
  InverseTable from = table;
  InverseTable to = table;
  std::size_t stride = channels;
  for (int axis = 0; axis < table.dimensions; ++axis, stride *= side) {
    tbb::parallel_for(std::size_t(0), table.cellCount() / side, [&](std::size_t line) {
      const std::size_t perBlock = stride / channels;
      const std::size_t first = (line / perBlock * side * perBlock + line % perBlock) * channels;
      for (std::size_t i = 0; i < side; ++i)
        for (std::size_t c = 0; c < channels; ++c) {
          float sum = 0.0f;
          for (std::size_t j = 0; j < side; ++j)
            sum += weights[i * side + j] * from.values[first + j * stride + c];
          to.values[first + i * stride + c] = sum;
        }
    });
    std::swap(from, to);
  }
  return from;
}

/// Averages over displacements of covariance `loss` / 36, by samples.
template <std::size_t kDimensions>
InverseTable sampled(const InverseTable& table, const exemplar::ChannelMatrix& loss) {
  const std::vector<std::array<float, 3>> offsets = lossDisplacements(loss, kSamplesPerCell);
  using Lookup = TableLookup<kDimensions>;
  const Lookup lookup(table);
  const std::size_t samples = offsets.size();
  const auto side = std::size_t(table.side);
  // Cells share few coordinates: element [i * samples + s] of an axis is the displaced centre of
  // cell i.
  const std::vector<float> middles = axisMiddles(table.side);
  std::array<std::vector<typename Lookup::Place>, kDimensions> places;
  for (std::size_t axis = 0; axis < kDimensions; ++axis)
    for (const float middle : middles)
      for (const std::array<float, 3>& offset : offsets)
        places[axis].push_back(lookup.along(axis, middle + offset[axis]));
  const auto channels = std::size_t(table.channels);
  InverseTable result = table;
  tbb::parallel_for(std::size_t(0), table.cellCount(), [&](std::size_t cell) {
    std::array<const typename Lookup::Place*, kDimensions> along;
    std::size_t rest = cell;
    for (std::size_t axis = 0; axis < kDimensions; ++axis, rest /= side)
      along[axis] = &places[axis][rest % side * samples];
    TableValue total{};
    for (std::size_t s = 0; s < samples; ++s)
      total += std::apply([&](const auto*... axis) { return lookup.at(axis[s]...); }, along);
    for (std::size_t c = 0; c < channels; ++c)
      result.values[cell * channels + c] = total[c] / float(samples);
  });
  return result;
}

/// Averages over displacements of covariance `loss` / 36. The part that all directions share is
/// blurred axis by axis, exactly; the rest is sampled on the blurred table.
template <std::size_t kDimensions>
InverseTable averagedIn(const InverseTable& table, const exemplar::ChannelMatrix& loss) {
  const auto solver = transport::principalAxes(loss);
  const double alike = std::max(0.0, solver.eigenvalues()[0]);
  const InverseTable blurred = blurredAlongAxes(table, alike);
  const double largest = solver.eigenvalues()[loss.rows() - 1];
  if (largest - alike <= kAlike * largest)
    return blurred;
  const exemplar::ChannelMatrix rest =
      loss - alike * exemplar::ChannelMatrix::Identity(loss.rows(), loss.cols());
  return sampled<kDimensions>(blurred, rest);
}

/// Applies `function` to every value.
template <class Function>
InverseTable mapped(InverseTable table, const Function& function) {
  for (float& value : table.values)
    value = function(value);
  return table;
}

TexelFormat tableFormat(std::size_t channels, ValueEncoding encoding, int bits) {
  const bool unorm =
      bits == 8 && (encoding == ValueEncoding::root || encoding == ValueEncoding::linear);
  if (channels == 1)
    return unorm ? TexelFormat::r8Unorm : TexelFormat::r16Sfloat;
  if (channels == 2)
    return unorm ? TexelFormat::rg8Unorm : TexelFormat::rg16Sfloat;
  return unorm ? TexelFormat::rgba8Unorm : TexelFormat::rgba16Sfloat;
}

} // namespace

exemplar::ChannelMatrix lossAt(double loss, const std::vector<exemplar::ChannelMatrix>& lost) {
  const auto n = lost.front().rows();
  exemplar::ChannelMatrix below = exemplar::ChannelMatrix::Zero(n, n);
  double scalarBelow = 0.0;
  const auto between = [&](const exemplar::ChannelMatrix& above,
                           double scalarAbove) -> exemplar::ChannelMatrix {
    const double t = (loss - scalarBelow) / (scalarAbove - scalarBelow);
    return below + t * (above - below);
  };
  for (const exemplar::ChannelMatrix& mip : lost) {
    const double scalar = scalarLoss(mip);
    if (scalar <= scalarBelow)
      continue;
    if (loss <= scalar)
      return between(mip, scalar);
    below = mip;
    scalarBelow = scalar;
  }
  return scalarBelow < 1.0 ? between(exemplar::ChannelMatrix::Identity(n, n), 1.0) : below;
}

std::vector<std::array<float, 3>> lossDisplacements(const exemplar::ChannelMatrix& loss,
                                                    std::size_t count) {
  const auto n = int(loss.rows());
  const exemplar::ChannelMatrix root = transport::power(loss, 0.5);
  std::vector<std::array<float, 3>> result;
  for (const Point& p : gaussian::stratifiedGaussian(count, n, gaussian::Precision::bits16)) {
    const std::array<float, 3> raw{p.x, p.y, p.z};
    exemplar::ChannelVector centred(n);
    for (int c = 0; c < n; ++c)
      centred[c] = double(raw[std::size_t(c)]) - gaussian::kGaussianMean;
    const exemplar::ChannelVector moved = root * centred;
    std::array<float, 3> displacement{};
    for (int c = 0; c < n; ++c)
      displacement[std::size_t(c)] = float(moved[c]);
    result.push_back(displacement);
  }
  return result;
}

InverseTable averaged(const InverseTable& table, const exemplar::ChannelMatrix& loss) {
  switch (table.dimensions) {
  case 1:
    return averagedIn<1>(table, loss);
  case 2:
    return averagedIn<2>(table, loss);
  default:
    return averagedIn<3>(table, loss);
  }
}

std::vector<InverseTable> prefilteredLevels(const InverseTable& table,
                                            const std::vector<exemplar::ChannelMatrix>& lost,
                                            bool holdsRoots) {
  std::vector<InverseTable> levels{table};
  const InverseTable light =
      holdsRoots ? mapped(table, [](float root) { return root * root; }) : table;
  for (int level = 1; level < kTableLevels; ++level) {
    InverseTable average = averaged(light, lossAt(levelLoss(level), lost));
    if (holdsRoots)
      average = mapped(std::move(average), [](float value) { return std::sqrt(value); });
    levels.push_back(coarser(average, table.side >> level, retainedAmplitude(level)));
  }
  return levels;
}

Table inverseTableTexels(const std::vector<InverseTable>& levels, ValueEncoding encoding,
                         int bits) {
  const InverseTable& first = levels.front();
  const auto side = std::uint32_t(first.side);
  const auto channels = std::size_t(first.channels);
  Table table;
  table.format = tableFormat(channels, encoding, bits);
  table.width = side;
  table.height = first.dimensions > 1 ? side : 1;
  table.depth = first.dimensions > 2 ? side : 1;
  table.mipLevels = std::uint32_t(levels.size());
  const auto texelChannels = std::size_t(channelCount(table.format));
  for (const InverseTable& level : levels) {
    std::vector<float> texels;
    for (std::size_t cell = 0; cell < level.cellCount(); ++cell)
      for (std::size_t c = 0; c < texelChannels; ++c)
        texels.push_back(c < channels ? level.values[cell * channels + c] : 1.0f);
    appendTexels(table.texels, table.format, texels);
  }
  return table;
}

// A table of N^D cells -> one of n^D. Lookups are linear in the cells and the Gaussian's axes are
// independent, so the fit is a product of fits along the axes: n x N matrices (M + r I)^-1 (B + r
// S) with M = E[w w^T], B = E[w v^T], w and v the interpolation weights of a coarse and a fine
// lookup at the same Gaussian value, and S the weights of the fine lookup at the coarse cells'
// centres.
namespace {

/// Quantiles of the Gaussian that the moments are averaged over.
constexpr int kQuantiles = 2048;

/// Weight r of a cell's own centre, for cells that hardly any Gaussian value reaches: a thousandth
/// of the weight of a cell in the middle of a table of uniform weights.
constexpr double kCentreShare = 1e-3;

/// The interpolation weights of a lookup: of the cell `first` and the one after it.
struct LookupWeights {
  int first;
  Eigen::Vector2d weights;
};

LookupWeights lookupWeights(double u, int side) {
  const double place = std::clamp(side * u - 0.5, 0.0, double(side - 1));
  const int first = std::min(int(place), side - 2);
  return {first, {1.0 - (place - first), place - first}};
}

Eigen::MatrixXf axisFit(int fineSide, int side, double amplitude) {
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(side, side);
  Eigen::MatrixXd mixed = Eigen::MatrixXd::Zero(side, fineSide);
  for (int k = 0; k < kQuantiles; ++k) {
    const double quantile = gaussian::gaussianQuantile((k + 0.5) / kQuantiles);
    const double u = gaussian::gaussianCdf(gaussian::kGaussianMean +
                                           amplitude * (quantile - gaussian::kGaussianMean));
    const LookupWeights coarse = lookupWeights(u, side), fine = lookupWeights(u, fineSide);
    mass.block<2, 2>(coarse.first, coarse.first) +=
        coarse.weights * coarse.weights.transpose() / kQuantiles;
    mixed.block<2, 2>(coarse.first, fine.first) +=
        coarse.weights * fine.weights.transpose() / kQuantiles;
  }
  const double centre = kCentreShare / side;
  for (int cell = 0; cell < side; ++cell) {
    mass(cell, cell) += centre;
    const LookupWeights fine = lookupWeights((cell + 0.5) / side, fineSide);
    mixed.block<1, 2>(cell, fine.first) += centre * fine.weights.transpose();
  }
  return mass.ldlt().solve(mixed).cast<float>();
}

} // namespace

InverseTable coarser(const InverseTable& table, int side, double amplitude) {
  const Eigen::MatrixXf fit = axisFit(table.side, side, amplitude);
  const auto channels = std::size_t(table.channels);
  std::vector<float> from = table.values;
  // Axis by axis: `before` values lie between neighbours of the axis, `after` times as many lines.
  std::size_t before = channels;
  for (int axis = 0; axis < table.dimensions; ++axis) {
    const std::size_t line = before * std::size_t(table.side);
    const std::size_t after = from.size() / line;
    std::vector<float> to(after * before * std::size_t(side));
    for (std::size_t k = 0; k < after; ++k) {
      using Lines = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      const Eigen::Map<const Lines> source(&from[k * line], table.side, Eigen::Index(before));
      Eigen::Map<Lines>(&to[k * before * std::size_t(side)], side, Eigen::Index(before)) =
          fit * source;
    }
    from = std::move(to);
    before *= std::size_t(side);
  }
  return {table.dimensions, side, table.channels, std::move(from)};
}

} // namespace lichen::gaussian
