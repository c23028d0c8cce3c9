// SPDX-License-Identifier: MIT
// A noise on a device, through the plugin and a committed pass, and the same noise in C++; points
// and uses of materials for which they are compared with each other and with oracles.
#pragma once

#include "plugin_host.h"

#include <lichen/bundle_writer.h>

#include <array>
#include <evaluation/method_evaluator.h>
#include <memory>
#include <span>
#include <vector>

namespace lichen::test {

/// A point for the passes of all mappings.
struct SamplePoint {
  Point plane;
  std::array<float, 3> position{}, dx{}, dy{}; ///< in space [metres], and derivatives
  std::array<float, 3> normal{};
  std::array<float, 4> tangent{};
  MixPlace mix;
  bool hasMix = true; ///< if not, the material says the weight
};

/// Where the evaluators of the other mappings than uv have such a point.
[[nodiscard]] Footprint inSpace(Mapping mapping, const SamplePoint& point);

/// Points some tiles around the origin, of which some are at texel centres, on vertices of lattices
/// or on surfaces along the axes. Footprints range from a sixteenth of a texel to a whole tile,
/// round and stretched, on every third point without any stretch.
[[nodiscard]] std::vector<SamplePoint> samplePoints(std::size_t count, float texelsPerTile = 64.0f);

/// Uses that together change every parameter of all methods: in space four, on texture coordinates
/// also two with a period. The last of those in space and the first periodic one rotate tiles by
/// multiples of a turn over `tileRotation`.
[[nodiscard]] std::vector<MaterialUse> manyUses(const MaterialUse& own,
                                                std::uint32_t tileRotation = 1);

/// The numbering of the passes (shaders_glsl/passes/evaluate.glsl).
enum Quantity { kValue, kGaussian, kGradient, kLost };

/// The first map of the first noise of a file. The destructor checks that the device reported no
/// message.
class DeviceNoise {
public:
  using Value = MethodEvaluator::Value;
  using Gaussian = MethodEvaluator::Gaussian;

  explicit DeviceNoise(BundleFile file, Mapping mapping = Mapping::uv,
                       const EvaluationOptions& options = {});
  ~DeviceNoise();
  DeviceNoise(const DeviceNoise&) = delete;
  DeviceNoise& operator=(const DeviceNoise&) = delete;

  /// What the committed pass of the method and mapping writes, or another one.
  [[nodiscard]] std::vector<Value> drawn(int quantity, const MaterialUse& use,
                                         const std::vector<SamplePoint>& points,
                                         std::span<const std::uint32_t> spirv = {});
  [[nodiscard]] std::vector<Gaussian> drawnGaussian(const MaterialUse& use,
                                                    const std::vector<SamplePoint>& points);

  // In C++, with the block of the last function above.
  [[nodiscard]] Footprint footprint(const SamplePoint& point) const;
  [[nodiscard]] TileFootprint onPlane(const Point& point) const;
  [[nodiscard]] Value value(const SamplePoint& point) const;
  [[nodiscard]] Gaussian gaussian(const SamplePoint& point) const;
  /// Differences of values over a texel of the footprint.
  [[nodiscard]] std::array<float, 3> gradient(const SamplePoint& point) const;

private:
  [[nodiscard]] MixPlace mixOf(const SamplePoint& point) const;

  const Mapping mapping_;
  const std::vector<std::byte> glb_;

public:
  const Bundle bundle;
  const Method method;
  PluginHost host;
  const std::shared_ptr<const MethodEvaluator> evaluator;

private:
  const std::vector<std::uint32_t> committed_;
};

/// Differences of values from those that are expected.
struct Differences {
  double largest = 0.0;
  std::size_t beyond = 0; ///< how many are beyond 1/1024
  std::size_t count = 0;

  void add(double found, double expected);
  /// The first components of two arrays.
  template <class Found, class Expected>
  void add(const Found& found, const Expected& expected, std::size_t components) {
    for (std::size_t c = 0; c < components; ++c)
      add(double(found[c]), double(expected[c]));
  }
  [[nodiscard]] double fractionBeyond() const { return double(beyond) / double(count); }
  /// 99.9 % are within 1/1024 and all within 1/255.
  void check() const;
};

using Vec = std::array<double, 3>;
[[nodiscard]] double dot(const Vec& a, const Vec& b);

/// An orthonormal frame on a surface, as an implementation of the format makes it from a normal, a
/// tangent and a material's rotation: the directions of the exemplar's x and y, and the normal.
struct SurfaceFrame {
  Vec right{}, down{}, outward{};
};
[[nodiscard]] SurfaceFrame frameOf(const SamplePoint& point, double rotation);

} // namespace lichen::test
