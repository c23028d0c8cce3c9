// SPDX-License-Identifier: MIT
// Gaussian model (spectra of height x width) -> texton coefficients (channels, height, width of the
// support), and the distance of their noise to the model.
//
// Let h^ = sqrt(b^) alpha^ be the noise's spectrum ([GLM17] eq. 4). The fit looks for spectra in
// two sets: spectra with the model's power, where the nearest to h^ is (t^* . h^) / |t^* . h^| t^,
// and spectra of coefficients inside the support. The distance of h^ to the first set is the
// transport distance between the two textures, so both projections work on h^. [GLM17] does the
// second projection on alpha^, where cropping is enough, but which weights distances by 1 / b^,
// ninefold at the highest frequency. On h^ it is a least-squares problem. Its normal matrix is B_x
// (x) B_y, where both are small, banded Toeplitz matrices of the kernel's autocorrelation.
//
// Relaxed averaged alternating reflections [L05] find the neighbourhood of a good minimum, because
// they leave bad ones. Then alternating projections, which never increase the distance, descend
// with Nesterov's momentum, restarted where it points uphill [OC15]. Two conditions narrow the
// second set: a slowly varying part that ends at the border has a cost (border_penalty.h), and no
// coefficient may stand out.
// Sources: [GLM17] algorithm 1 and section 4.3; [GLM14] eq. 1 and 2.
#include "fit.h"

#include "border_penalty.h"
#include "coefficients.h"
#include "gaussian_model.h"

#include <lichen/spectrum.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <tbb/parallel_for.h>

#include <cassert>
#include <cmath>

namespace lichen::texton {
namespace {

/// Tuned on three photographs of 128 x 128 at supports of 16, 32 and 64: 60 reflections and 40
/// descents end within 0.5 % of the error of 100 and 100.
constexpr int kReflections = 60;
constexpr int kDescents = 40;
constexpr float kFirstRelaxation = 0.9f;
constexpr float kLastRelaxation = 0.5f;

/// Largest magnitude of a texel over all its channels, relative to the root mean square. The
/// flatness of the magnitudes is then at most about its square, the 4 of docs/benchmarks.md.
constexpr float kHighestPeak = 2.0f;

using Spectra = std::vector<HalfSpectrum>;

/// Returns the normal matrix along an axis: a Toeplitz matrix of the kernel's autocorrelation,
/// circulant where the support wraps around the period. It is positive definite because b^ > 0.
Eigen::SparseMatrix<double> normalMatrix(int size, int period, int order) {
  const std::vector<double> b = kernelAutocorrelation(order);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < size; ++i) {
    for (int lag = -order; lag <= order; ++lag) {
      const int j = ((i + lag) % period + period) % period;
      if (j < size)
        entries.emplace_back(i, j, b[std::size_t(std::abs(lag))]);
    }
  }
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end()); // adds up entries that wrap twice
  return matrix;
}

/// Applies the inverse of a normal matrix along the rows of a matrix, by banded Cholesky factors.
class NormalSolver {
public:
  explicit NormalSolver(const Eigen::SparseMatrix<double>& normal)
      : lower_(Factors(normal).matrixL().nestedExpression().cast<float>()) {}

  /// Solves all rows at once. Eigen's own solver handles one right-hand side after the other, and
  /// its steps wait for each other.
  void solveRows(Eigen::MatrixXf& rows) const {
    using Entry = Eigen::SparseMatrix<float>::InnerIterator; // starts at the diagonal
    for (Eigen::Index j = 0; j < rows.cols(); ++j) {
      Entry entry(lower_, j);
      rows.col(j) /= entry.value();
      while (++entry)
        rows.col(entry.row()) -= entry.value() * rows.col(j);
    }
    for (Eigen::Index j = rows.cols() - 1; j >= 0; --j) {
      Entry entry(lower_, j);
      const float diagonal = entry.value();
      while (++entry)
        rows.col(j) -= entry.value() * rows.col(entry.row());
      rows.col(j) /= diagonal;
    }
  }

private:
  using Factors =
      Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>;
  Eigen::SparseMatrix<float> lower_;
};

/// Returns spectra with the model's power and random phases.
Spectra randomPhases(const GaussianModel& model, std::uint32_t seed) {
  Spectra spectra;
  for (const HalfSpectrum& channel : model.channels)
    spectra.push_back(
        forwardFft(phaseRandomizedPlane(channel, seed), model.width(), model.height()));
  return spectra;
}

class Fit {
public:
  Fit(const GaussianModel& model, int width, int height, int order)
      : model_(model), kernelX_(kernelAmplitudes(order, model.width())),
        kernelY_(kernelAmplitudes(order, model.height())),
        solverX_(normalMatrix(width, model.width(), order)),
        solverY_(normalMatrix(height, model.height(), order)),
        border_(normalMatrix(width, model.width(), order),
                normalMatrix(height, model.height(), order)),
        work_(model.channels) {
    coefficients_ = {width, height, int(model.channels.size()), {}};
    coefficients_.values.resize(patchSize() * model.channels.size());
  }

  [[nodiscard]] const TextonCoefficients& coefficients() const { return coefficients_; }
  void setCoefficients(TextonCoefficients coefficients) { coefficients_ = std::move(coefficients); }

  /// Does one averaged reflection of `x` in both sets. The coefficients belong to the second set.
  void reflect(Spectra& x, float relaxation) {
    forFrequencies([&](std::size_t i, float kernel) {
      const std::complex<float> phase = phaseTowards(x, i);
      for (std::size_t c = 0; c < x.size(); ++c)
        work_[c].values[i] =
            kernel * (2.0f * product(phase, model_.channels[c].values[i]) - x[c].values[i]);
    });
    workToCoefficients();
    border_.adapt(coefficients_);
    narrow();
    coefficientsToWork();
    forFrequencies([&](std::size_t i, float kernel) {
      const std::complex<float> phase = phaseTowards(x, i);
      for (std::size_t c = 0; c < x.size(); ++c) {
        const std::complex<float> nearest = product(phase, model_.channels[c].values[i]);
        x[c].values[i] = relaxation * (x[c].values[i] + kernel * work_[c].values[i]) +
                         (1.0f - 2.0f * relaxation) * nearest;
      }
    });
  }

  /// Sets the coefficients to the projection of `x` on the first set and then on the second.
  void project(const Spectra& x) {
    forFrequencies([&](std::size_t i, float kernel) {
      const std::complex<float> phase = phaseTowards(x, i);
      for (std::size_t c = 0; c < x.size(); ++c)
        work_[c].values[i] = kernel * product(phase, model_.channels[c].values[i]);
    });
    workToCoefficients();
    narrow();
  }

  /// As project(), but starts from the current coefficients.
  void descend() {
    coefficientsToWork();
    forFrequencies([&](std::size_t i, float kernel) {
      // h^ is alpha^ times a positive factor, which does not change the phase.
      const std::complex<float> phase = phaseTowards(work_, i);
      for (std::size_t c = 0; c < work_.size(); ++c)
        work_[c].values[i] = kernel * product(phase, model_.channels[c].values[i]);
    });
    workToCoefficients();
    narrow();
  }

private:
  [[nodiscard]] std::size_t patchSize() const {
    return std::size_t(coefficients_.width) * std::size_t(coefficients_.height);
  }

  /// Complex product without the standard operator's checks for infinities.
  static std::complex<float> product(std::complex<float> a, std::complex<float> b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
  }

  /// Calls act(index, sqrt(b^)) for each frequency; rows run in parallel.
  template <class Act>
  void forFrequencies(const Act& act) const {
    const auto columns = std::size_t(model_.channels[0].columns());
    tbb::parallel_for(std::size_t(0), std::size_t(model_.height()), [&](std::size_t v) {
      for (std::size_t u = 0; u < columns; ++u)
        act(v * columns + u, kernelX_[u] * kernelY_[v]);
    });
  }

  /// [GLM14] eq. 2 in colour: (t^* . x) / |t^* . x|.
  [[nodiscard]] std::complex<float> phaseTowards(const Spectra& x, std::size_t i) const {
    float re = 0.0f;
    float im = 0.0f;
    for (std::size_t c = 0; c < x.size(); ++c) {
      const std::complex<float> t = model_.channels[c].values[i];
      const std::complex<float> value = x[c].values[i];
      re += t.real() * value.real() + t.imag() * value.imag();
      im += t.real() * value.imag() - t.imag() * value.real();
    }
    const float modulus = std::sqrt(re * re + im * im);
    return modulus > 0.0f ? std::complex<float>(re / modulus, im / modulus) : 1.0f;
  }

  void coefficientsToWork() {
    tbb::parallel_for(std::size_t(0), work_.size(), [&](std::size_t c) {
      work_[c] = channelSpectrum(coefficients_, c, model_.width(), model_.height());
    });
  }

  void workToCoefficients() {
    tbb::parallel_for(std::size_t(0), work_.size(), [&](std::size_t c) {
      const std::vector<float> plane = inverseFft(work_[c], coefficients_.height);
      // Column-major: a column of `patch` is a row of the texton.
      const Eigen::Map<const Eigen::MatrixXf> whole(plane.data(), model_.width(),
                                                    coefficients_.height);
      Eigen::Map<Eigen::MatrixXf> patch(coefficients_.values.data() + c * patchSize(),
                                        coefficients_.width, coefficients_.height);
      Eigen::MatrixXf columns = whole.topRows(coefficients_.width).transpose();
      solverX_.solveRows(columns);
      Eigen::MatrixXf rows = columns.transpose();
      solverY_.solveRows(rows);
      patch = rows;
    });
  }
  /// Smooths the border and limits peaks.
  void narrow() {
    border_.apply(coefficients_);
    const Eigen::Map<const Eigen::MatrixXf> channels(
        coefficients_.values.data(), Eigen::Index(patchSize()), coefficients_.channels);
    const Eigen::VectorXf sizes = channels.rowwise().norm();
    const float highest = kHighestPeak * sizes.norm() / std::sqrt(float(sizes.size()));
    for (std::size_t i = 0; i < patchSize(); ++i)
      if (const float size = sizes[Eigen::Index(i)]; size > highest)
        for (std::size_t c = 0; c < work_.size(); ++c)
          coefficients_.values[c * patchSize() + i] *= highest / size;
  }

  const GaussianModel& model_;
  std::vector<float> kernelX_;
  std::vector<float> kernelY_;
  NormalSolver solverX_;
  NormalSolver solverY_;
  BorderPenalty border_;
  Spectra work_;
  TextonCoefficients coefficients_;
};

double innerProduct(const std::vector<float>& a, const std::vector<float>& b,
                    const std::vector<float>& c) {
  double sum = 0.0; // (a - b) . (b - c)
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += (double(a[i]) - double(b[i])) * (double(b[i]) - double(c[i]));
  return sum;
}

/// Runs projections with momentum. Ends at the last step, not at an extrapolated point.
void descendWithMomentum(Fit& fit, const ProgressPart& progress) {
  TextonCoefficients last = fit.coefficients();
  TextonCoefficients from = last;
  int sinceRestart = 0;
  for (int step = 0; step < kDescents; ++step) {
    progress.reach(double(step + 1) / kDescents);
    fit.setCoefficients(from);
    fit.descend();
    const TextonCoefficients& now = fit.coefficients();
    // [OC15] eq. 13: restart where the step and the momentum disagree.
    sinceRestart = innerProduct(from.values, now.values, last.values) > 0.0 ? 0 : sinceRestart + 1;
    const float momentum = float(sinceRestart) / float(sinceRestart + 3);
    from = now;
    for (std::size_t i = 0; i < from.values.size(); ++i)
      from.values[i] += momentum * (now.values[i] - last.values[i]);
    last = now;
  }
}

/// [GLM14] eq. 5: 0 for a model without variance.
double relativeDistance(const GaussianModel& model, const GaussianModel& noise) {
  const double variance = modelVariance(model);
  return variance > 0.0 ? std::sqrt(squaredTransportDistance(model, noise) / variance) : 0.0;
}

} // namespace

TextonCoefficients fitCoefficients(const GaussianModel& model, const FitOptions& options) {
  assert(options.width >= 1 && options.width <= model.width());
  assert(options.height >= 1 && options.height <= model.height());
  Spectra x = randomPhases(model, options.seed); // allocate before the fit takes its own memory
  Fit fit(model, options.width, options.height, options.order);
  constexpr double kReflectionsOfProgress = double(kReflections) / (kReflections + kDescents);
  const ProgressPart reflections = options.progress.part(0.0, kReflectionsOfProgress);
  for (int step = 0; step < kReflections; ++step) {
    const float done = float(step) / float(kReflections);
    reflections.reach(double(step + 1) / kReflections);
    fit.reflect(x, kFirstRelaxation + (kLastRelaxation - kFirstRelaxation) * done);
  }
  fit.project(x);
  x = {}; // frees as much memory as the model takes
  descendWithMomentum(fit, options.progress.part(kReflectionsOfProgress, 1.0));
  return fit.coefficients();
}

double relativeModelError(const GaussianModel& model, const TextonCoefficients& coefficients,
                          int order) {
  return relativeDistance(model, noiseModel(coefficients, order, model.width(), model.height()));
}

ModelErrors modelErrors(const GaussianModel& model, const TextonCoefficients& coefficients,
                        int order) {
  const GaussianModel noise = noiseModel(coefficients, order, model.width(), model.height());
  ModelErrors errors{relativeDistance(model, noise), {}};
  for (std::size_t c = 0; c < model.channels.size(); ++c)
    errors.channels.push_back(relativeDistance({{model.channels[c]}}, {{noise.channels[c]}}));
  return errors;
}

} // namespace lichen::texton
