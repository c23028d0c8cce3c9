// SPDX-License-Identifier: MIT
// Multiple kernels as one of the methods of a bake.
#include "method_analysis.h"

#include <lichen/counted.h>

#include <fmt/format.h>

namespace lichen {
namespace {

/// As tiling needs, and the spectra of all channels.
BakeMemory memory(const MethodOptions&) { return {64.0, 160.0}; }

/// How far the spectrum is from that asked for, and with fewer kernels.
std::string errorWords(const std::vector<SpectrumError>& errors) {
  std::string words =
      fmt::format("their spectrum is {:.2f} dB from that asked for", errors.back().decibels);
  for (std::size_t k = 0; k + 1 < errors.size(); ++k)
    words += fmt::format("{} {} kernels {:.2f} dB", k == 0 ? "; with" : ", with", errors[k].kernels,
                         errors[k].decibels);
  return words;
}

Result<MethodBake> bake(const MethodOptions& options, const MethodInput& input) {
  Result<MethodBake> baked = bakeMultipleKernels(
      input.name, input.maps, optionsFor<MultipleKernelsOptions>(options, input));
  if (!baked)
    return baked;
  MethodBake& result = baked.value();
  result.notes.push_back(kernelWords(result.noise.as<MultipleKernelsNoise>()) + ": " +
                         errorWords(result.figures.spectrumErrors));
  return baked;
}

} // namespace

const MethodAnalysis kMultipleKernelsAnalysis{memory, bake};

std::string kernelWords(const MultipleKernelsNoise& noise) {
  std::string words =
      fmt::format("{} with the window {}", counted(std::uint64_t(noise.kernels), "kernel"),
                  nameOf(noise.window));
  if (noise.rings > 0)
    words += fmt::format(", {} of them {}", noise.rings, noise.rings == 1 ? "a ring" : "rings");
  if (noise.cosines > 0)
    words += fmt::format(", and a pattern of {}", counted(std::uint64_t(noise.cosines), "cosine"));
  return words;
}

} // namespace lichen
