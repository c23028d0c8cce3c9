// SPDX-License-Identifier: MIT
// What the bakes of all methods return.
#pragma once

#include <lichen/bundle.h>

#include <string>
#include <string_view>
#include <vector>

namespace lichen {

/// How close a texton is to the Gaussian texture that it approximates.
struct TextonQuality {
  /// Relative model error [GLM14] eq. 5 over all channels, where each quantity (colours, slopes,
  /// every other channel) is measured in its own standard deviation: 0 for equal spectra.
  double modelError = 0.0;
  std::vector<double> channelErrors; ///< of each channel alone, in the order of the maps
  /// r^2 sum l^4 / (sum l^2)^2 of the first map's texton, for colours of its luminance: 1 if all
  /// texels are equal in magnitude, 3 if they are Gaussian, more if few dominate, which takes more
  /// impacts.
  double flatness = 0.0;
  /// The largest error of a covariance between two channels, relative to the product of their
  /// standard deviations, computed from the texels as stored (half floats or floats).
  double covarianceError = 0.0;
};

/// How near so many kernels come to a spectrum.
struct SpectrumError {
  int kernels = 0;
  double decibels = 0.0; ///< root mean square of the difference, over all directions
};

/// What a bake knows of its noise beyond what the noise holds. Members of other methods than the
/// noise's are 0 or empty.
struct BakeFigures {
  bool bordersWereKept = true; ///< opposite borders of the exemplar fit, or were taken to
  double structure = 0.0;      ///< share of the power with the phases of the exemplar
  double strength = 0.0;       ///< how clearly the exemplar repeats
  TextonQuality quality;
  /// Errors with a quarter, half and all of the most kernels that may be, in this order, without
  /// repeated numbers of kernels; the last is the noise's. They show what more kernels bring.
  std::vector<SpectrumError> spectrumErrors;
};

/// A noise baked by any method. Its maps are in the order given.
struct MethodBake {
  Noise noise; ///< table indices start at 0
  std::vector<Table> tables;
  BakeFigures figures;
  std::string_view borderTreatment = "blends"; ///< what the bake does with borders that do not fit
  std::vector<std::string> notes;              ///< for the user, one sentence each
};

} // namespace lichen
