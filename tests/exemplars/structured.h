// SPDX-License-Identifier: MIT
// Generated photographs of materials with a structure, such as bricks, with ground truth: the cell
// of each pixel and the periods. Literals are art direction, as in samples/exemplars/materials.h.
#pragma once

#include <lichen/image.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace lichen::exemplars {

/// A position or an offset, in pixels.
struct Point {
  float x = 0.0f, y = 0.0f;
};

/// How the material is laid and photographed.
struct StructuredCondition {
  const char* name = "even";
  float turnDegrees = 0.0f;   ///< counterclockwise, up to 45
  float shear = 0.0f;         ///< pixels along x per pixel along y
  float keystone = 0.0f;      ///< the share by which the material is narrower at the top
  float gradient = 0.0f;      ///< the share of light that one side loses
  float vignette = 0.0f;      ///< the share of light that the corners lose
  float irregularity = 0.02f; ///< deviation of sizes and positions, in cells; at most 0.15
  float blurPixels = 0.0f;    ///< radius of the lens blur, at most 2
  float noise = 0.006f;       ///< of the camera, in code values
  /// The periods divide the side and the picture tiles. For no turn, shear, keystone or uneven
  /// light.
  bool whole = false;
};

struct StructuredPlan {
  const char* material = ""; ///< a name that structuredPlans() has
  StructuredCondition condition;
  std::uint32_t seed = 0;

  [[nodiscard]] std::string name() const; ///< "bond-turned-3"
};

struct StructuredPicture {
  SrgbImage image;
  /// cells[y * side + x] is the cell at the middle of the pixel, numbered from 0 by first
  /// appearance, or -1 for a joint. Cells that continue at the opposite side of a whole picture
  /// have one number. Empty if the material has no cells.
  std::vector<int> cells;
  /// Two offsets after which the structure repeats, in pixels, measured at the middle of the
  /// picture; both 0 if it does not repeat.
  std::array<Point, 2> periods;
};

/// Takes a square photograph of `sidePixels` pixels per side, of 8 bits. Details keep their size in
/// pixels. Deterministic.
[[nodiscard]] StructuredPicture structured(int sidePixels, const StructuredPlan& plan);

/// Maps of 8 bits that show the same as a photograph without light, lens and camera. All but color
/// are data.
struct StructuredMaps {
  SrgbImage color;
  SrgbImage normal; ///< green points up
  SrgbImage roughness, occlusion;
  SrgbImage height; ///< 0 the lowest place, 1 the highest
};
[[nodiscard]] StructuredMaps structuredMaps(int sidePixels, const StructuredPlan& plan);

/// All materials under all conditions.
[[nodiscard]] std::vector<StructuredPlan> structuredPlans();

} // namespace lichen::exemplars
