// SPDX-License-Identifier: MIT
// Spectra (channels, h_k, w_k / 2 + 1) of n models -> the same at one height and width.
//
// More texels on the same tile mean more frequencies, without power there: zero-padding of the
// spectrum. This is exact and avoids the blur of a filter in space. No model loses texels.
// A taller tile has frequencies between the model's. They come from the transform of the kernel
// padded with zeros, which preserves covariances and leaves one kernel per channel. Padding the
// autocovariance instead might not give a covariance. A compact kernel loses least of all with the
// same spectrum in the cut. Here it is the kernel whose strongest colour axis has phase 0; for one
// channel it is the canonical texton of [DMR12].
#include "one_grid.h"

#include "gaussian/model_covariance.h"
#include "transport/covariance_map.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace lichen::texton {
namespace {

/// Returns the model at `width` x `height` texels per tile, neither fewer than it has.
gaussian::GaussianModel refined(const gaussian::GaussianModel& model, int width, int height) {
  if (width == model.width() && height == model.height())
    return model;
  const float scale = float(
      std::sqrt(double(width) * double(height) / (double(model.width()) * double(model.height()))));
  // The highest frequency of an even size stands for two frequencies. Each takes half of its power.
  constexpr float kHalfPower = 1.0f / std::numbers::sqrt2_v<float>;
  gaussian::GaussianModel result;
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
gaussian::GaussianModel compact(gaussian::GaussianModel model) {
  const auto axes = transport::principalAxes(gaussian::modelCovariance(model));
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
gaussian::GaussianModel extended(const gaussian::GaussianModel& model, int height) {
  if (height == model.height())
    return model;
  const auto width = std::size_t(model.width());
  gaussian::GaussianModel result = compact(model);
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

std::vector<gaussian::GaussianModel> onOneGrid(std::span<const gaussian::GaussianModel> models) {
  int width = 0;
  for (const gaussian::GaussianModel& model : models)
    width = std::max(width, model.width());
  std::vector<gaussian::GaussianModel> result;
  int height = 0;
  for (const gaussian::GaussianModel& model : models) {
    const double texels = double(model.height()) * double(width) / double(model.width());
    result.push_back(refined(model, width, int(std::lround(texels))));
    height = std::max(height, result.back().height());
  }
  for (gaussian::GaussianModel& model : result)
    model = extended(model, height);
  return result;
}

} // namespace lichen::texton
