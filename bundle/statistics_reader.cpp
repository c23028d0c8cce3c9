// SPDX-License-Identifier: MIT
// Reads the mean, covariance and lost variance of an exemplar's stored values, or of one step of a
// mix. n is the number of channels.
#include "extension_reader.h"

#include <lichen/counted.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace lichen {
namespace {

using nlohmann::json;

bool isSymmetric(const std::vector<double>& c, std::size_t n) {
  double largest = 0.0;
  for (const double value : c)
    largest = std::max(largest, std::abs(value));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (std::abs(c[i * n + j] - c[j * n + i]) > kCovarianceTolerance * largest)
        return false;
  return true;
}

/// The range of a mean of stored values, with a tolerance for rounding.
NumberRange meanRange(ValueEncoding encoding) {
  constexpr double kRounding = 1e-6;
  constexpr double kSteepest = 20.0;    // 1 / 0.05, the least nz
  constexpr double kBrightestLog = 129; // log2(1 + x) of the largest float
  switch (encoding) {
  case ValueEncoding::slope:
    return {-kSteepest, kSteepest};
  case ValueEncoding::log2:
    return {0.0, kBrightestLog};
  default:
    return {-kRounding, 1.0 + kRounding};
  }
}

std::vector<double> readMean(ObjectReader& reader, ValueEncoding encoding, std::size_t n) {
  std::optional<std::vector<double>> mean = reader.numbers("mean", meanRange(encoding));
  if (!mean)
    return {};
  if (n != 0 && mean->size() != n)
    reader.error("map-mean", "mean",
                 counted(mean->size(), "value") + "; expected " + std::to_string(n) +
                     ", one per channel");
  return std::move(*mean);
}

std::vector<double> readCovariance(ObjectReader& reader, std::size_t n) {
  constexpr NumberRange kCovarianceRange{-1e6, 1e6};
  std::optional<std::vector<double>> covariance = reader.numbers("covariance", kCovarianceRange);
  if (!covariance)
    return {};
  if (n != 0 && covariance->size() != n * n)
    reader.error("map-covariance", "covariance",
                 counted(covariance->size(), "value") + "; expected " + std::to_string(n * n) +
                     ", a row of the matrix per channel");
  else if (n != 0 && !isSymmetric(*covariance, n))
    reader.error("map-covariance", "covariance", "not symmetric");
  else if (n != 0 && !hasEigenvaluesFrom(*covariance, n, -kCovarianceTolerance))
    reader.error("map-covariance", "covariance", "not positive semidefinite");
  return std::move(*covariance);
}

} // namespace

bool hasEigenvaluesFrom(std::vector<double> c, std::size_t n, double share) {
  double trace = 0.0;
  for (std::size_t i = 0; i < n; ++i)
    trace += c[i * n + i];
  if (trace <= 0.0)
    return share <= 0.0 && std::all_of(c.begin(), c.end(), [](double v) { return v == 0.0; });
  for (std::size_t k = 0; k < n; ++k)
    c[k * n + k] -= share * trace;
  for (std::size_t k = 0; k < n; ++k) {
    const double pivot = c[k * n + k];
    if (pivot <= 0.0)
      return false;
    for (std::size_t i = k + 1; i < n; ++i)
      for (std::size_t j = k + 1; j < n; ++j)
        c[i * n + j] -= c[i * n + k] * c[k * n + j] / pivot;
  }
  return true;
}

MapMoments readMoments(ObjectReader& reader, ValueEncoding encoding, std::size_t n) {
  return {readMean(reader, encoding, n), readCovariance(reader, n)};
}

std::vector<double> readLosses(ObjectReader& reader, std::size_t rows) {
  std::optional<std::vector<double>> losses = reader.numbers("mipLoss", {0.0, 1.0});
  if (!losses)
    return {};
  for (std::size_t r = 0; r < rows && losses->size() % rows == 0; ++r) {
    const std::span<const double> row = lossRow(*losses, r, rows);
    if (!row.empty() && row.front() != 0.0)
      reader.error("map-mip-loss", "mipLoss",
                   json(row.front()).dump() + " at " + std::to_string(r * row.size()) +
                       "; expected 0: level 0 loses nothing");
    const auto fall = std::is_sorted_until(row.begin(), row.end());
    if (fall != row.end())
      reader.error("map-mip-loss", "mipLoss",
                   json(*fall).dump() + " at " +
                       std::to_string(r * row.size() + std::size_t(fall - row.begin())) +
                       "; expected no less than the mip level before, " + json(*(fall - 1)).dump());
  }
  return std::move(*losses);
}

} // namespace lichen
