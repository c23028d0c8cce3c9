// SPDX-License-Identifier: MIT
// A noise of the method that LICHEN_METHODS names, evaluated by the shader library. Included by
// that method's evaluate.cpp alone.
#pragma once

#include "method_evaluator.h"
#include "shader_library.h"

#include <bit>
#include <methods/method_parameters.h>

namespace lichen {
namespace { // as ShaderLibrary is

class ShaderEvaluator final : public MethodEvaluator {
  using Library = glsl::ShaderLibrary;
  using vec2 = glsl::vec2;
  using vec3 = glsl::vec3;
  using vec4 = glsl::vec4;

public:
  /// `wide`, unless null, evaluates planes, and `imageFor` changes images before they are decoded.
  ShaderEvaluator(const Bundle& bundle, std::size_t index, const EvaluationOptions& options,
                  WideEvaluation* wide = nullptr,
                  Table (*imageFor)(const Table& image, const Noise& noise) = nullptr)
      : wide_(wide) {
    const Noise& noise = bundle.noises[index];
    const MethodParameters& method = parametersOf(noise);
    const shader::LichenNoiseConstants constants = shaderConstants(bundle, index);
    noise_ = std::bit_cast<Library::LichenNoise>(constants.noise);
    offsets_ = std::bit_cast<decltype(offsets_)>(constants.offsets);
    for (std::size_t m = 0; m < noise.maps.size(); ++m) {
      const NoiseMap& stored = noise.maps[m];
      Map map{std::bit_cast<Library::LichenMap>(shaderMap(bundle, noise, m)), {}, {}};
      const Alpha alpha = method.lastChannelIsAlpha ? Alpha::lastChannel : Alpha::one;
      const Table& image = bundle.tables[imageTableOf(stored)];
      map.image = RepeatingImage(imageFor != nullptr ? imageFor(image, noise) : image, alpha);
      if (const std::optional<std::size_t> table = decodingTableOf(stored))
        map.table = ClampedVolume(bundle.tables[*table]);
      else if (isMix(noise))
        map.table = ClampedVolume(mixTable(stored));
      maps_.push_back(std::move(map));
    }
    if (method.sharedImage != nullptr)
      cells_ = RepeatingImage(bundle.tables[method.sharedImage(noise.maps.front())]);
    library_.cells = &cells_;
    library_.tileOffsets = offsets_.data();
    library_.nearestTableLevel = options.nearestTableLevel;
  }
  ShaderEvaluator(const ShaderEvaluator&) = delete; // the library points into it
  ShaderEvaluator& operator=(const ShaderEvaluator&) = delete;

  [[nodiscard]] Value evaluate(std::size_t map, const Material& material, const Footprint& at,
                               const MixPlace& mix) const override {
    if (const auto* plane = std::get_if<TileFootprint>(&at))
      return onPlane(map, material, *plane, mix);
    const Library::LichenShadingPoint shading = shadingAt(material, at, mix);
    const Map& m = maps_[map];
    return asArray(library_.lichenValue(m.image, m.table, shading, m.constants));
  }

  void evaluate(std::size_t map, const Material& material, std::span<const PlanePoint> points,
                std::span<Value> values) const override {
    const Map& m = maps_[map];
    std::size_t k = 0;
    if (wide_ != nullptr)
      k = wide_({std::bit_cast<shader::LichenNoise>(noise_), material.material,
                 std::bit_cast<shader::LichenMap>(m.constants), m.image, m.table,
                 library_.nearestTableLevel},
                points, values);
    for (; k < points.size(); ++k)
      values[k] = onPlane(map, material, points[k].at, points[k].mix);
  }

  [[nodiscard]] Gaussian gaussian(std::size_t map, const Material& material, const Footprint& at,
                                  const MixPlace& mix) const override {
    const Library::LichenShadingPoint shading = shadingAt(material, at, mix);
    const Map& m = maps_[map];
    const Library::LichenGaussian found =
        library_.lichenGaussian(m.image, m.table, shading, m.constants);
    return {asArray(found.value), asArray(found.lost)};
  }

  [[nodiscard]] Value decoded(std::size_t map,
                              const std::array<float, 3>& gaussian) const override {
    const Map& m = maps_[map];
    const Library::LichenGaussian exact{asVec(gaussian), vec3(0.0), 0.0};
    return asArray(library_.lichenDecode(m.table, exact, 1.0, m.constants));
  }

  [[nodiscard]] MixPlace mixAt(const Material& material,
                               const std::array<float, 2>& uv) const override {
    const auto own = std::bit_cast<Library::LichenMaterial>(material.material);
    const vec2 gradient = library_.lichenMixGradient(own);
    return {library_.lichenMixWeight(asVec(uv), own).v, {gradient.x.v, gradient.y.v}};
  }

private:
  struct Map {
    Library::LichenMap constants;
    RepeatingImage image;
    ClampedVolume table;
  };

  static vec2 asVec(const std::array<float, 2>& v) { return {v[0], v[1]}; }
  static vec3 asVec(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }
  static vec4 asVec(const std::array<float, 4>& v) { return {v[0], v[1], v[2], v[3]}; }
  static std::array<float, 3> asArray(const vec3& v) { return {v.x.v, v.y.v, v.z.v}; }
  static Value asArray(const vec4& v) { return {v.x.v, v.y.v, v.z.v, v.w.v}; }
  static vec2 positionOf(const Library::LichenMaterial& material, const TileFootprint& at) {
    return asVec(at.position) + vec2(material.offsetX, material.offsetY);
  }

  /// GLSL passes structs by value; flattened, GCC copies none of them. The other mappings, which
  /// are larger, would take half a minute to compile so.
  [[nodiscard]] LICHEN_FLATTEN Value onPlane(std::size_t map, const Material& material,
                                             const TileFootprint& at, const MixPlace& mix) const {
    const auto own = std::bit_cast<Library::LichenMaterial>(material.material);
    const Map& m = maps_[map];
    Library::LichenPoint point =
        library_.lichenPointAt(positionOf(own, at), asVec(at.dx), asVec(at.dy), own, noise_);
    library_.lichenSetMix(point, mix.weight, asVec(mix.gradient));
    return asArray(library_.lichenValueAt(m.image, m.table, point, own, noise_, m.constants));
  }

  [[nodiscard]] Library::LichenShadingPoint
  shadingAt(const Material& material, const Footprint& footprint, const MixPlace& mix) const {
    const auto planes = std::bit_cast<Library::LichenTriplanarMaterial>(material);
    Library::LichenShadingPoint shading;
    if (const auto* space = std::get_if<TriplanarFootprint>(&footprint)) {
      shading =
          library_.lichenPointTriplanarGrad(asVec(space->position), asVec(space->dx),
                                            asVec(space->dy), asVec(space->normal), planes, noise_);
    } else if (const auto* surface = std::get_if<SurfaceFootprint>(&footprint)) {
      shading = library_.lichenPointSurfaceGrad(asVec(surface->position), asVec(surface->dx),
                                                asVec(surface->dy), asVec(surface->normal),
                                                asVec(surface->tangent), planes.material, noise_);
    } else if (const auto* solid = std::get_if<SolidFootprint>(&footprint)) {
      shading = library_.lichenPointSolidGrad(asVec(solid->position), asVec(solid->dx),
                                              asVec(solid->dy), planes.material, noise_);
    } else {
      const auto& plane = std::get<TileFootprint>(footprint);
      shading.material = planes.material;
      shading.noise = noise_;
      shading.point = library_.lichenPointAt(positionOf(planes.material, plane), asVec(plane.dx),
                                             asVec(plane.dy), planes.material, noise_);
    }
    library_.lichenSetMix(shading.point, mix.weight, asVec(mix.gradient));
    return shading;
  }

  WideEvaluation* wide_;
  Library::LichenNoise noise_;
  std::vector<Map> maps_;
  RepeatingImage cells_; ///< the image that all maps share, if there is one
  std::array<glsl::uint, LICHEN_MAX_OFFSETS> offsets_{};
  mutable Library library_; ///< GLSL has no const functions; none changes it
};

} // namespace
} // namespace lichen
