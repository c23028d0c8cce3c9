// SPDX-License-Identifier: MIT
// Maps -> edges -> conductances -> coordinates spread within cells -> an image with mip levels.
//
// docs/decisions/012-quilting.md says how the constants were chosen.
#include "cells.h"

#include "exemplar/color_space.h"
#include "exemplar/planes.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace lichen::quilting {
namespace {

using exemplar::ImageLevel;
using exemplar::Plane; // here on a torus
using exemplar::quantile;

/// The maps of the largest size, reduced, each with a total variance of 1.
std::vector<ImageLevel> standardized(std::span<const MapExemplar> maps) {
  constexpr int kMostSide = 700; // of the reduced images; cells are found at half of that
  const auto pixels = [](const MapExemplar& map) { return double(map.width) * map.height; };
  const MapExemplar& largest = *std::ranges::max_element(maps, {}, pixels);
  std::vector<ImageLevel> levels;
  for (const MapExemplar& map : maps) {
    if (map.width != largest.width || map.height != largest.height)
      continue;
    ImageLevel level = exemplar::reducedImage(map, kMostSide);
    const double variance = exemplar::momentsOf(level.values, level.channels).covariance.trace();
    const auto scale = variance > 0.0 ? float(1.0 / std::sqrt(variance)) : 0.0f;
    for (float& value : level.values)
      value *= scale;
    levels.push_back(std::move(level));
  }
  return levels;
}

/// Convolves each channel with one kernel along x and another along y; the centres are in the
/// middle. Wraps around.
ImageLevel convolved(const ImageLevel& source, const std::vector<float>& alongX,
                     const std::vector<float>& alongY) {
  const auto pass = [](const ImageLevel& from, const std::vector<float>& kernel, bool isX) {
    ImageLevel to = from;
    const int reach = int(kernel.size()) / 2, side = isX ? from.width : from.height;
    const auto channels = std::size_t(from.channels);
    for (int y = 0; y < from.height; ++y)
      for (int x = 0; x < from.width; ++x)
        for (std::size_t c = 0; c < channels; ++c) {
          float sum = 0.0f;
          for (int k = -reach; k <= reach; ++k) {
            const int at = (((isX ? x : y) + k) % side + side) % side;
            const std::size_t pixel =
                isX ? std::size_t(y) * std::size_t(from.width) + std::size_t(at)
                    : std::size_t(at) * std::size_t(from.width) + std::size_t(x);
            sum += kernel[std::size_t(k + reach)] * from.values[pixel * channels + c];
          }
          to.values[(std::size_t(y) * std::size_t(from.width) + std::size_t(x)) * channels + c] =
              sum;
        }
    return to;
  };
  return pass(pass(source, alongX, true), alongY, false);
}

/// A share of the mean side of a plane. At least 1. [texels]
double shareOfSide(double share, const Plane& plane) {
  return std::max(1.0, share * std::sqrt(double(plane.width) * plane.height));
}

struct Gaussian {
  std::vector<float> values, derivative;
};

/// At whole texels, the centre in the middle.
Gaussian gaussianOf(double deviation) {
  constexpr double kReach = 4.0; // deviations
  Gaussian result;
  const int reach = int(std::ceil(kReach * deviation));
  for (int k = -reach; k <= reach; ++k) {
    const double value = std::exp(-0.5 * k * k / (deviation * deviation)) /
                         (deviation * std::sqrt(2.0 * std::numbers::pi));
    result.values.push_back(float(value));
    result.derivative.push_back(float(k / (deviation * deviation) * value));
  }
  return result;
}

/// The magnitude of the gradient of all channels of all images.
Plane gradientOf(const std::vector<ImageLevel>& images) {
  constexpr double kDeviation = 1.0 / 256.0; // of the smoothing, over a mean side
  Plane result{images.front().width, images.front().height, {}};
  const auto [smooth, derivative] = gaussianOf(shareOfSide(kDeviation, result));
  result.values.resize(std::size_t(result.width) * std::size_t(result.height));
  for (const ImageLevel& image : images)
    for (const bool isX : {true, false}) {
      const ImageLevel slopes =
          convolved(image, isX ? derivative : smooth, isX ? smooth : derivative);
      const auto channels = std::size_t(image.channels);
      for (std::size_t i = 0; i < slopes.values.size(); ++i)
        result.values[i / channels] += slopes.values[i] * slopes.values[i];
    }
  for (float& value : result.values)
    value = std::sqrt(value);
  return result;
}

/// A plane of half the sides, each value the largest of those it covers: 2 x 2, or up to 3 along
/// an odd side.
Plane halfMaximum(const Plane& source) {
  Plane result{std::max(1, source.width / 2), std::max(1, source.height / 2), {}};
  result.values.resize(std::size_t(result.width) * std::size_t(result.height));
  const auto half = [](int at, int side, int halfSide) { // at the same share of the side
    return (2 * at + 1) * halfSide / (2 * side);
  };
  for (int y = 0; y < source.height; ++y)
    for (int x = 0; x < source.width; ++x) {
      float& most = result.values[result.index(half(x, source.width, result.width),
                                               half(y, source.height, result.height))];
      most = std::max(most, source.values[source.index(x, y)]);
    }
  return result;
}

/// Smooths edges, so that joints a little apart still correlate.
std::vector<float> averagedEdges(const Plane& edges) {
  constexpr double kDeviation = 1.0 / 128.0; // over a mean side
  const std::vector<float> smooth = gaussianOf(shareOfSide(kDeviation, edges)).values;
  return convolved({edges.width, edges.height, 1, edges.values}, smooth, smooth).values;
}

/// Whether coordinates pass: 1 in the middle of a cell, nearly 0 on its outline.
Plane conductances(Plane edges) {
  constexpr double kMiddle = 0.5, kStrong = 0.98;
  constexpr float kShare = 0.15f; // from a middling gradient to a strong one
  constexpr float kMostExponent = 16.0f;
  const float middling = quantile(edges.values, kMiddle);
  const float strong = quantile(edges.values, kStrong);
  const float limit = std::max(middling + kShare * (strong - middling), 1e-12f);
  for (float& value : edges.values)
    value = std::exp(-std::min(value * value / (limit * limit), kMostExponent));
  return edges;
}

/// Solves for the displacement of the spread coordinates. [texels]
std::vector<std::array<float, 2>> spreadCoordinates(const Plane& passes, double count) {
  constexpr double kPull = 0.1; // towards where a point is: divides what is much larger than a cell
  constexpr double kLeak = 1e-6; // keeps the matrix well conditioned
  const int width = passes.width, height = passes.height;
  const auto texels = Eigen::Index(passes.values.size());
  const double pull = kPull * count / double(texels);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(texels, 2);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto here = Eigen::Index(passes.index(x, y));
      entries.emplace_back(here, here, pull);
      for (const bool isX : {true, false}) {
        const auto next = Eigen::Index(isX ? passes.index((x + 1) % width, y)
                                           : passes.index(x, (y + 1) % height));
        const double conductance =
            double(std::min(passes.values[std::size_t(here)], passes.values[std::size_t(next)])) +
            kLeak;
        entries.emplace_back(here, here, conductance);
        entries.emplace_back(next, next, conductance);
        entries.emplace_back(here, next, -conductance);
        entries.emplace_back(next, here, -conductance);
        // The neighbour is one texel further.
        right(here, isX ? 0 : 1) += conductance;
        right(next, isX ? 0 : 1) -= conductance;
      }
    }
  Eigen::SparseMatrix<double> matrix(texels, texels);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::MatrixX2d solution = solver.solve(right);
  std::vector<std::array<float, 2>> result;
  result.reserve(std::size_t(texels));
  for (Eigen::Index i = 0; i < texels; ++i)
    result.push_back({float(solution(i, 0)), float(solution(i, 1))});
  return result;
}

/// For each texel, the vector to the nearest one of `isInside`. [texels] 0, 0 if there is none.
std::vector<std::array<int, 2>> nearestInside(const Plane& grid,
                                              const std::vector<std::uint8_t>& isInside) {
  constexpr int kNone = std::numeric_limits<int>::max();
  const int width = grid.width, height = grid.height;
  // Along each column, the vector to the nearest one; of those, the nearest along each row.
  std::vector<int> down(isInside.size(), kNone);
  for (int x = 0; x < width; ++x)
    for (const int step : {1, -1}) {
      int last = kNone;
      for (int k = 0; k < 2 * height; ++k) {
        const int y = step > 0 ? k % height : height - 1 - k % height;
        const std::size_t i = grid.index(x, y);
        last = isInside[i] != 0 ? 0 : last == kNone ? kNone : last + 1;
        if (last != kNone && (down[i] == kNone || last < std::abs(down[i])))
          down[i] = -step * last;
      }
    }
  std::vector<std::array<int, 2>> result(isInside.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::int64_t nearest = std::numeric_limits<std::int64_t>::max();
      for (int k = 0; k <= width / 2; ++k) {
        if (std::int64_t(k) * k >= nearest)
          break;
        for (const int across : {k, -k}) {
          const int rows = down[grid.index(((x + across) % width + width) % width, y)];
          if (rows == kNone)
            continue;
          const std::int64_t distance = std::int64_t(across) * across + std::int64_t(rows) * rows;
          if (distance < nearest) {
            nearest = distance;
            result[grid.index(x, y)] = {across, rows};
          }
        }
      }
    }
  return result;
}

} // namespace

CellField cellsOf(std::span<const MapExemplar> maps, double count) {
  constexpr float kInside = 0.5f;
  const Plane edges = halfMaximum(gradientOf(standardized(maps)));
  const Plane passes = conductances(edges);
  const std::vector<std::array<float, 2>> spread = spreadCoordinates(passes, count);
  std::vector<std::uint8_t> isInside;
  for (const float value : passes.values)
    isInside.push_back(value > kInside ? 1 : 0);
  const std::vector<std::array<int, 2>> nearest = nearestInside(passes, isInside);
  CellField result{passes.width, passes.height, {}, averagedEdges(edges)};
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x) {
      const auto [across, down] = nearest[passes.index(x, y)];
      const auto wrapped = [](int value, int side) { return (value % side + side) % side; };
      const auto [toX, toY] =
          spread[passes.index(wrapped(x + across, result.width), wrapped(y + down, result.height))];
      result.toCentre.push_back({(toX + float(across)) / float(result.width),
                                 (toY + float(down)) / float(result.height)});
    }
  return result;
}

CellImage cellImage(const CellField& cells, int bits) {
  CellImage image;
  float reach = 1e-3f;
  for (const std::array<float, 2>& vector : cells.toCentre)
    for (const float axis : vector)
      reach = std::max(reach, std::abs(axis));
  image.reach = std::min(double(reach), kMostCellReach);
  image.table.format = bits == 8 ? TexelFormat::rgba8Unorm : TexelFormat::rgba16Sfloat;
  image.table.width = std::uint32_t(cells.width);
  image.table.height = std::uint32_t(cells.height);
  ImageLevel level{cells.width, cells.height, 2, {}};
  for (const std::array<float, 2>& vector : cells.toCentre)
    level.values.insert(level.values.end(), vector.begin(), vector.end());
  double first = 0.0; // mean square of level 0
  while (true) {
    double squares = 0.0;
    for (const float value : level.values)
      squares += double(value) * double(value);
    squares /= double(level.values.size());
    if (first == 0.0)
      first = squares;
    const float sharpness = first > 0.0 ? float(std::sqrt(squares / first)) : 0.0f;
    std::vector<float> texels;
    for (std::size_t i = 0; i < level.values.size(); i += 2) {
      for (std::size_t axis = 0; axis < 2; ++axis)
        texels.push_back(
            std::clamp(0.5f + 0.5f * level.values[i + axis] / float(image.reach), 0.0f, 1.0f));
      texels.insert(texels.end(), {sharpness, 1.0f});
    }
    appendTexels(image.table.texels, image.table.format, texels);
    if (level.width == 1 && level.height == 1)
      break;
    level = exemplar::areaAverage(level);
    ++image.table.mipLevels;
  }
  return image;
}

} // namespace lichen::quilting
