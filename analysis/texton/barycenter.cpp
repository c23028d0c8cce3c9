// SPDX-License-Identifier: MIT
// Spectra of n Gaussian textures (n, channels, height, width / 2 + 1) and weights (n) -> the
// spectrum of their barycentre (channels, height, width / 2 + 1).
//
// At a frequency, texture k is t_k z_k, where t_k is a vector over the channels and z_k a complex
// normal variable. A barycentre is the law of sum_k w_k t_k z_k under the joint law of the z_k that
// maximizes its variance [AC11]. Write z_k = v_k^* z with unit vectors v_k and independent z. The
// covariance is then M M^* with M = sum_k w_k t_k v_k^*, and the v_k must maximize |M|.
// - v_k <- M^* t_k / |M^* t_k| never lowers |M|: its square is convex, and the step maximizes its
//   linearization [JNRS10].
// - With numbers e^(-i phi_k) for v_k, which means one kernel, there are local maxima from three
//   textures on. With vectors of n elements there are none [BVB20]. So the code finds vectors first
//   and starts the numbers from M's principal axis. If they lose power, it also starts them from
//   pairs.
// - Up to three textures, numbers are as good as vectors: n unit vectors need not span more than
//   sqrt(n) dimensions [HZ07].
// Two textures have a closed form. Source: [GLM17] section 7; [XFPA14].
#include "barycenter.h"

#include "gaussian_model.h"
#include "transport/covariance.h"

#include <Eigen/Dense>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace lichen::texton {
namespace {

using Complex = std::complex<double>;
/// Column k is w_k t_k.
using Weighted = Eigen::MatrixXcd;

/// The iteration ends when a step raises |M|^2 by less; spectra are float.
constexpr double kNoGain = 1e-7;
constexpr int kMostSteps = 200;
/// One kernel counts as a barycentre if it misses less of |M|^2. The last steps may leave that
/// much.
constexpr double kAsGood = 1e-5;

template <class Real>
std::complex<Real> phaseOf(std::complex<Real> value) {
  const Real modulus = std::abs(value);
  return modulus > Real(0) ? value / modulus : std::complex<Real>(1);
}

/// Raises |weighted v| to a fixed point, starting from the rows v_k^* of `v`.
void raiseNorm(const Weighted& weighted, Eigen::MatrixXcd& v) {
  Eigen::MatrixXcd sum = weighted * v;
  double norm = sum.squaredNorm();
  for (int step = 0; step < kMostSteps; ++step) {
    v.noalias() = weighted.adjoint() * sum;
    for (Eigen::Index k = 0; k < v.rows(); ++k) {
      const double length = v.row(k).norm();
      if (length > 0.0)
        v.row(k) /= length;
      else
        v(k, 0) = 1.0; // t_k is zero, so any direction works
    }
    sum.noalias() = weighted * v;
    const double before = norm;
    norm = sum.squaredNorm();
    if (norm - before <= kNoGain * norm)
      return;
  }
}

struct FrequencyBarycenter {
  Eigen::VectorXcd kernel;
  double distance = 0.0; ///< squared transport distance to the barycentre of any rank
  double power = 0.0;    ///< of that barycentre
};

FrequencyBarycenter ofTwo(const Weighted& weighted) {
  // [GLM17] section 7, the equation of tau_rho
  const Complex phase = phaseOf(Complex(weighted.col(0).dot(weighted.col(1))));
  FrequencyBarycenter result;
  result.kernel = phase * weighted.col(0) + weighted.col(1);
  result.power = result.kernel.squaredNorm();
  return result;
}

/// Raises phases that start aligned with `kernel`, and replaces `best` if the result has more
/// power.
void startFrom(const Eigen::VectorXcd& kernel, const Weighted& weighted,
               FrequencyBarycenter& best) {
  Eigen::MatrixXcd numbers = (weighted.adjoint() * kernel).unaryExpr(&phaseOf<double>);
  raiseNorm(weighted, numbers);
  const Eigen::VectorXcd raised = weighted * numbers;
  if (best.kernel.size() == 0 || raised.squaredNorm() > best.kernel.squaredNorm())
    best.kernel = raised;
}

/// At a frequency that is its own mirror all vectors are real, and so must be the kernel.
FrequencyBarycenter ofMany(const Weighted& weighted, bool isOwnMirror) {
  const Eigen::Index count = weighted.cols();
  // Start from independent textures, which prefer no direction.
  Eigen::MatrixXcd vectors = Eigen::MatrixXcd::Identity(count, count);
  raiseNorm(weighted, vectors);
  const Eigen::MatrixXcd sum = weighted * vectors;
  FrequencyBarycenter result;
  result.power = sum.squaredNorm();
  const auto axes = transport::principalAxes<Eigen::MatrixXcd>(sum * sum.adjoint());
  startFrom(axes.eigenvectors().col(sum.rows() - 1), weighted, result);
  const auto isTooWeak = [&] {
    return result.kernel.squaredNorm() < (1.0 - kAsGood) * result.power;
  };
  // Where all vectors are real, as for symmetric exemplars, a real start would stay real.
  const Complex phase = isOwnMirror ? Complex(1.0) : Complex(0.0, 1.0);
  for (Eigen::Index k = 0; k < count && isTooWeak(); ++k)
    startFrom(weighted.col(k) + phase * weighted.col((k + 1) % count), weighted, result);
  if (isTooWeak())
    result.distance =
        result.power + result.kernel.squaredNorm() - 2.0 * (sum.adjoint() * result.kernel).norm();
  return result;
}

/// [GLM17] section 7: `model` times t^* . next / |t^* . next|, which aligns its phases with `next`.
GaussianModel aligned(GaussianModel model, const GaussianModel& next) {
  for (std::size_t i = 0; i < model.channels[0].values.size(); ++i) {
    std::complex<float> product = 0.0f;
    for (std::size_t c = 0; c < model.channels.size(); ++c)
      product += std::conj(model.channels[c].values[i]) * next.channels[c].values[i];
    const std::complex<float> phase = phaseOf(product);
    for (HalfSpectrum& channel : model.channels)
      channel.values[i] *= phase;
  }
  return model;
}

} // namespace

Barycenter barycenter(std::span<const GaussianModel> models, std::span<const double> weights) {
  assert(!models.empty() && weights.size() == models.size());
  std::vector<std::size_t> counted;
  for (std::size_t k = 0; k < models.size(); ++k) {
    if (weights[k] > 0.0)
      counted.push_back(k);
  }
  assert(!counted.empty());
  Barycenter result{models[counted[0]], 0.0};
  if (counted.size() == 1)
    return result;
  const HalfSpectrum& shape = models[0].channels[0];
  const auto columns = std::size_t(shape.columns());
  std::vector<double> distances(std::size_t(shape.height), 0.0);
  std::vector<double> powers(std::size_t(shape.height), 0.0);
  tbb::parallel_for(std::size_t(0), powers.size(), [&](std::size_t v) {
    Weighted weighted(Eigen::Index(models[0].channels.size()), Eigen::Index(counted.size()));
    for (std::size_t u = 0; u < columns; ++u) {
      const std::size_t i = v * columns + u;
      for (Eigen::Index k = 0; k < weighted.cols(); ++k) {
        const std::size_t model = counted[std::size_t(k)];
        for (Eigen::Index c = 0; c < weighted.rows(); ++c)
          weighted(c, k) =
              weights[model] * Complex(models[model].channels[std::size_t(c)].values[i]);
      }
      const bool isOwnMirror = shape.multiplicity(int(u)) == 1 && 2 * v % powers.size() == 0;
      const FrequencyBarycenter found =
          counted.size() == 2 ? ofTwo(weighted) : ofMany(weighted, isOwnMirror);
      for (Eigen::Index c = 0; c < weighted.rows(); ++c)
        result.model.channels[std::size_t(c)].values[i] = std::complex<float>(found.kernel(c));
      distances[v] += shape.multiplicity(int(u)) * found.distance;
      powers[v] += shape.multiplicity(int(u)) * found.power;
    }
  });
  const double power = std::accumulate(powers.begin(), powers.end(), 0.0);
  const double distance = std::accumulate(distances.begin(), distances.end(), 0.0);
  if (power > 0.0)
    result.rankError = std::sqrt(std::max(distance, 0.0) / power);
  return result;
}

std::vector<GaussianModel> alignedModels(std::span<const GaussianModel> models) {
  std::vector<GaussianModel> result(models.begin(), models.end());
  for (std::size_t k = result.size() - 1; k-- > 0;)
    result[k] = aligned(std::move(result[k]), result[k + 1]);
  return result;
}

GaussianModel between(const GaussianModel& first, const GaussianModel& second, double rho) {
  GaussianModel result = first;
  for (std::size_t c = 0; c < result.channels.size(); ++c)
    for (std::size_t i = 0; i < result.channels[c].values.size(); ++i)
      result.channels[c].values[i] = float(1.0 - rho) * first.channels[c].values[i] +
                                     float(rho) * second.channels[c].values[i];
  return result;
}

// Spectra (channels, h_k, w_k / 2 + 1) of n models -> the same at one height and width.
//
// More texels on the same tile mean more frequencies, without power there: zero-padding of the
// spectrum. This is exact and avoids the blur of a filter in space. No model loses texels.
// A taller tile has frequencies between the model's. They come from the transform of the kernel
// padded with zeros, which preserves covariances and leaves one kernel per channel. Padding the
// autocovariance instead might not give a covariance. A compact kernel loses least of all with the
// same spectrum in the cut. Here it is the kernel whose strongest colour axis has phase 0; for one
// channel it is the canonical texton of [DMR12].
namespace {

/// Returns the model at `width` x `height` texels per tile, neither fewer than it has.
GaussianModel refined(const GaussianModel& model, int width, int height) {
  if (width == model.width() && height == model.height())
    return model;
  const float scale = float(
      std::sqrt(double(width) * double(height) / (double(model.width()) * double(model.height()))));
  // The highest frequency of an even size stands for two frequencies. Each takes half of its power.
  constexpr float kHalfPower = 1.0f / std::numbers::sqrt2_v<float>;
  GaussianModel result;
  for (const HalfSpectrum& channel : model.channels) {
    HalfSpectrum fine{width, height, {}};
    fine.values.resize(std::size_t(fine.columns()) * std::size_t(height));
    for (int v = 0; v < channel.height; ++v) {
      const int row = channel.signedRow(v);
      const bool splitRow = 2 * v == channel.height && height > channel.height;
      for (int u = 0; u < channel.columns(); ++u) {
        const bool splitColumn = 2 * u == channel.width && width > channel.width;
        const std::complex<float> value = channel.at(u, v) * scale *
                                          (splitRow ? kHalfPower : 1.0f) *
                                          (splitColumn ? kHalfPower : 1.0f);
        fine.at(u, (row + height) % height) = value;
        if (splitRow)
          fine.at(u, height - row) = value;
      }
    }
    result.channels.push_back(std::move(fine));
  }
  return result;
}

/// Returns the same texture with the phases that make the strongest colour axis a sum of cosines.
GaussianModel compact(GaussianModel model) {
  const auto axes = transport::principalAxes(modelCovariance(model));
  const Eigen::VectorXf axis =
      axes.eigenvectors().col(axes.eigenvectors().cols() - 1).cast<float>();
  for (std::size_t i = 0; i < model.channels[0].values.size(); ++i) {
    std::complex<float> sum = 0.0f;
    for (std::size_t c = 0; c < model.channels.size(); ++c)
      sum += axis[Eigen::Index(c)] * model.channels[c].values[i];
    const float modulus = std::abs(sum);
    for (HalfSpectrum& channel : model.channels)
      channel.values[i] *= modulus > 0.0f ? std::conj(sum) / modulus : 1.0f;
  }
  return model;
}

/// Returns the model on a tile of `height` texels, not fewer than it has.
GaussianModel extended(const GaussianModel& model, int height) {
  if (height == model.height())
    return model;
  const auto width = std::size_t(model.width());
  GaussianModel result = compact(model);
  for (HalfSpectrum& channel : result.channels) {
    const std::vector<float> kernel = inverseFft(channel);
    std::vector<float> plane(width * std::size_t(height), 0.0f);
    for (int y = 0; y < channel.height; ++y) {
      const int row = (channel.signedRow(y) + height) % height;
      std::copy_n(kernel.begin() + std::ptrdiff_t(std::size_t(y) * width), width,
                  plane.begin() + std::ptrdiff_t(std::size_t(row) * width));
    }
    channel = forwardFft(plane, model.width(), height);
    channel.values[0] = 0.0f; // as in every model; the kernel's sum is rounding
  }
  return result;
}

} // namespace

std::vector<GaussianModel> onOneGrid(std::span<const GaussianModel> models) {
  int width = 0;
  for (const GaussianModel& model : models)
    width = std::max(width, model.width());
  std::vector<GaussianModel> result;
  int height = 0;
  for (const GaussianModel& model : models) {
    const double texels = double(model.height()) * double(width) / double(model.width());
    result.push_back(refined(model, width, int(std::lround(texels))));
    height = std::max(height, result.back().height());
  }
  for (GaussianModel& model : result)
    model = extended(model, height);
  return result;
}

} // namespace lichen::texton
