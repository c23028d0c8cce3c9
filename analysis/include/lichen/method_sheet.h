// SPDX-License-Identifier: MIT
// One exemplar under several methods: measures beside each other, and a page with pictures.
#pragma once

#include <lichen/bundle.h>
#include <lichen/exemplar.h>
#include <lichen/image.h>
#include <lichen/measures.h>
#include <lichen/progress.h>
#include <lichen/result.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace lichen {

/// A noise of one method, and what it takes to make and to use it.
struct MethodTrial {
  Bundle bundle;             ///< its first noise is made from the exemplar, used by its material
  double bakeSeconds = 0.0;  ///< > 0
  double plainFetches = 0.0; ///< time of a pixel in trilinear fetches, > 0
};

/// What a method makes of an exemplar.
struct MethodLook {
  SrgbImage picture;
  double distance = 0.0; ///< lookDistance() to the exemplar
};

/// Synthesizes the exemplar's map, at one texel per pixel, `exemplars` a side and at most
/// kMethodLookSide, and measures how near it looks. Errors: as compareNoise().
[[nodiscard]] Result<MethodLook> lookOf(const MethodTrial& trial, const MapExemplar& exemplar,
                                        double exemplars, const Progress& progress = {});
inline constexpr int kMethodLookSide = 1024; ///< pixels

/// The picture of the exemplar that lookOf() compares with.
[[nodiscard]] SrgbImage pictureOf(const MapExemplar& exemplar);

/// A row of the sheet.
struct MethodRow {
  Method method{};
  double distance = 0.0;         ///< lookDistance()
  std::vector<Measure> measures; ///< those of measureResult(), without targets
  std::size_t gpuBytes = 0;      ///< of the noise's tables
  double bakeSeconds = 0.0, plainFetches = 0.0;
};

struct MethodSheet {
  std::vector<MethodRow> rows; ///< one per trial
  std::vector<std::byte> page; ///< an HTML file that needs no other
};

/// Synthesizes two exemplars a side with each trial, and measures them. `name` is that of the
/// exemplar and may hold any bytes. Errors: as lookOf(). Takes seconds a trial.
[[nodiscard]] Result<MethodSheet> makeMethodSheet(const std::string& name,
                                                  const MapExemplar& exemplar,
                                                  std::span<const MethodTrial> trials,
                                                  const Progress& progress = {});

} // namespace lichen
