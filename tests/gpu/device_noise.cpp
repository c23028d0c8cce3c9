// SPDX-License-Identifier: MIT
// Noises on a device and in C++; see device_noise.h.
#include "device_noise.h"

#include "glb_of.h"
#include "shared_device.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

namespace lichen::test {
namespace {

using Row = std::array<float, 4>;

Row rowOf(const std::array<float, 3>& v, float w = 0.0f) { return {v[0], v[1], v[2], w}; }

std::vector<std::byte> encoded(BundleFile file, Mapping mapping) {
  file.bundle.materials[0]->mapping = mapping;
  return glbOf(file);
}

std::vector<std::uint32_t> passFor(Method method, Mapping mapping) {
  std::string name(mapping == Mapping::uv ? nameOf(method) : nameOf(mapping));
  std::ranges::replace(name, '-', '_');
  return committedShader(name + "_evaluate.comp");
}

} // namespace

Footprint inSpace(Mapping mapping, const SamplePoint& p) {
  if (mapping == Mapping::triplanar)
    return TriplanarFootprint{p.position, p.dx, p.dy, p.normal};
  if (mapping == Mapping::surface)
    return SurfaceFootprint{p.position, p.dx, p.dy, p.normal, p.tangent};
  return SolidFootprint{p.position, p.dx, p.dy};
}

std::vector<SamplePoint> samplePoints(std::size_t count, float texelsPerTile) {
  std::mt19937 generator(11u);
  std::uniform_real_distribution<float> tiles(-4.0f, 4.0f), level(-4.0f, 6.0f), stretch(0.0f, 8.0f),
      angle(0.0f, 2.0f * std::numbers::pi_v<float>), weight(-0.2f, 1.2f);
  std::normal_distribution<float> gaussian;
  std::vector<SamplePoint> points(count);
  for (std::size_t k = 0; k < count; ++k) {
    SamplePoint& p = points[k];
    const float length = std::exp2(level(generator)) / texelsPerTile, turn = angle(generator);
    const float other = k % 3 == 0 ? length : length * std::exp2(-stretch(generator));
    p.plane.uv = {tiles(generator), tiles(generator)};
    p.plane.gradientX = {length * std::cos(turn), length * std::sin(turn)};
    p.plane.gradientY = {-other * std::sin(turn), other * std::cos(turn)};
    if (k % 2 == 1)
      std::swap(p.plane.gradientX, p.plane.gradientY);
    if (k % 10 == 0) { // at a texel's centre, with one pixel per texel
      for (float& uv : p.plane.uv)
        uv = (std::floor(uv * texelsPerTile) + 0.5f) / texelsPerTile;
      p.plane.gradientX = {1.0f / texelsPerTile, 0.0f};
      p.plane.gradientY = {0.0f, 1.0f / texelsPerTile};
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      p.position[axis] = k % 10 == 1 ? 0.0f : tiles(generator);
      p.normal[axis] = gaussian(generator);
      p.tangent[axis] = gaussian(generator);
      p.dx[axis] = length * gaussian(generator);
      p.dy[axis] = other * gaussian(generator);
    }
    if (k % 20 == 1)
      p.position[k / 20 % 3] = tiles(generator);
    if (k % 4 == 0) {
      p.normal = {};
      p.tangent = {};
      p.normal[k / 4 % 3] = k / 12 % 2 == 0 ? 2.0f : -2.0f;
      p.tangent[(k / 4 + 1 + k / 24 % 2) % 3] = 3.0f;
    } else if (k % 4 == 1) {
      p.normal[k / 4 % 3] = 0.0f;
    }
    p.tangent[3] = k % 3 == 0 ? -1.0f : 1.0f;
    p.mix = {weight(generator), {weight(generator), weight(generator)}};
  }
  return points;
}

std::vector<MaterialUse> manyUses(const MaterialUse& own, std::uint32_t tileRotation) {
  constexpr std::int64_t kFar = std::int64_t(1) << 40;
  const bool mayRepeat = own.parameters.mapping == LICHEN_MAPPING_UV;
  std::vector<MaterialUse> all(mayRepeat ? 6 : 4, own);
  const auto setOrigin = [](MaterialUse& use, std::int64_t x, std::int64_t y, std::int64_t z) {
    std::ranges::copy(std::array{x, y, z}, use.placement.tileOrigin);
  };
  all[1] = moved(own);
  all[1].parameters.pointProcess = LICHEN_POINT_PROCESS_POISSON;
  all[2].parameters.contrast = 1.4;
  all[2].parameters.impacts = 4.0;
  all[2].parameters.planeSharpness = 2.0;
  setOrigin(all[2], 3 - kFar, kFar - 5, -77);
  all[3] = moved(own);
  all[3].parameters.contrast = 0.7;
  all[3].parameters.blendSharpness = 3.0;
  all[3].parameters.planeSharpness = 64.0;
  all[3].parameters.tileRotation = tileRotation;
  setOrigin(all[3], 10000000, -9999999, kFar);
  if (!mayRepeat)
    return all;
  all[4].parameters.pointProcess = LICHEN_POINT_PROCESS_POISSON;
  all[4].parameters.tileRotation = tileRotation;
  all[4].placement.periodTiles[0] = 2.0;
  all[4].placement.periodTiles[1] = 3.0;
  setOrigin(all[4], -7, 0, 0);
  all[5].parameters.contrast = 1.4;
  all[5].placement.periodTiles[0] = all[5].placement.periodTiles[1] = 1.37;
  return all;
}

DeviceNoise::DeviceNoise(BundleFile file, Mapping mapping, const EvaluationOptions& options)
    : mapping_(mapping), glb_(encoded(std::move(file), mapping)),
      bundle(parseBundle(glb_, "noise").value()), method(bundle.noises[0].method()),
      host(sharedContext(), glb_), evaluator(methodEvaluator(bundle, 0, options)),
      committed_(passFor(method, mapping)) {}

DeviceNoise::~DeviceNoise() {
  CHECK(host.context().device().messages().texts() == std::vector<std::string>{});
}

std::vector<DeviceNoise::Value> DeviceNoise::drawn(int quantity, const MaterialUse& use,
                                                   const std::vector<SamplePoint>& points,
                                                   std::span<const std::uint32_t> spirv) {
  const auto withInputs = [&](auto inputOf) {
    std::vector<decltype(inputOf(points.front()))> inputs;
    std::ranges::transform(points, std::back_inserter(inputs), inputOf);
    return host.evaluate(spirv.empty() ? committed_ : spirv, quantity, use, inputs);
  };
  switch (mapping_) {
  case Mapping::triplanar:
    return withInputs([](const SamplePoint& p) {
      const float weight = p.hasMix ? std::max(0.0f, p.mix.weight) : -1.0f;
      return std::array{rowOf(p.position, weight), rowOf(p.dx), rowOf(p.dy), rowOf(p.normal)};
    });
  case Mapping::surface:
    return withInputs([&](const SamplePoint& p) {
      const float hasMix = p.hasMix && method == Method::texton ? 1.0f : 0.0f;
      return std::array{rowOf(p.position, hasMix), rowOf(p.dx, p.mix.weight),
                        rowOf(p.dy, p.mix.gradient[0]), rowOf(p.normal, p.mix.gradient[1]),
                        p.tangent};
    });
  case Mapping::solid:
    return withInputs([](const SamplePoint& p) {
      return std::array{rowOf(p.position), rowOf(p.dx), rowOf(p.dy)};
    });
  case Mapping::uv:
    break;
  }
  return withInputs([](const SamplePoint& p) {
    const auto& [weight, slope] = p.mix;
    return std::pair{p.plane, Row{weight, slope[0], slope[1], p.hasMix ? 1.0f : 0.0f}};
  });
}

std::vector<DeviceNoise::Gaussian>
DeviceNoise::drawnGaussian(const MaterialUse& use, const std::vector<SamplePoint>& points) {
  const std::vector<Value> values = drawn(kGaussian, use, points), lost = drawn(kLost, use, points);
  std::vector<Gaussian> all(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    std::copy_n(values[k].begin(), 3, all[k].value.begin());
    std::copy_n(lost[k].begin(), 3, all[k].lost.begin());
  }
  return all;
}

TileFootprint DeviceNoise::onPlane(const Point& point) const {
  const shader::LichenMaterial& m = host.material();
  const auto toTile = [&](const std::array<float, 2>& v) {
    return std::array{m.uvToTileXX * v[0] + m.uvToTileXY * v[1],
                      m.uvToTileYX * v[0] + m.uvToTileYY * v[1]};
  };
  return {toTile(point.uv), toTile(point.gradientX), toTile(point.gradientY)};
}

Footprint DeviceNoise::footprint(const SamplePoint& p) const {
  return mapping_ == Mapping::uv ? Footprint(onPlane(p.plane)) : inSpace(mapping_, p);
}

MixPlace DeviceNoise::mixOf(const SamplePoint& p) const {
  if (!p.hasMix)
    return evaluator->mixAt(host.planes(), p.plane.uv);
  return mapping_ == Mapping::triplanar ? MixPlace{p.mix.weight, {}} : p.mix;
}

DeviceNoise::Value DeviceNoise::value(const SamplePoint& p) const {
  return evaluator->evaluate(0, host.planes(), footprint(p), mixOf(p));
}

DeviceNoise::Gaussian DeviceNoise::gaussian(const SamplePoint& p) const {
  return evaluator->gaussian(0, host.planes(), footprint(p), mixOf(p));
}

std::array<float, 3> DeviceNoise::gradient(const SamplePoint& p) const {
  const TileFootprint at = onPlane(p.plane);
  const MixPlace mix = mixOf(p);
  const shader::LichenNoise& noise = host.constants().noise;
  const std::array<double, 2> texels{double(noise.tileTexelsX), double(noise.tileTexelsY)};
  // docs/gltf_extension/README.md: the footprint's side, and half a level less than it.
  const double xx = at.dx[0] * texels[0], xy = at.dx[1] * texels[1], yx = at.dy[0] * texels[0],
               yy = at.dy[1] * texels[1];
  const double squared = std::max({1.0, xx * xx + xy * xy, yx * yx + yy * yy});
  const double area = std::max({std::abs(xx * yy - xy * yx), std::sqrt(squared), squared / 16.0});
  const double side = 0.25 * std::log2(squared * area);
  const double step = 0.5 * std::exp2(std::max(0.5 * side, side - 0.5));
  const auto valueAt = [&](double x, double y) {
    TileFootprint there = at;
    MixPlace here = mix;
    there.position[0] += float(x);
    there.position[1] += float(y);
    here.weight += mix.gradient[0] * float(x) + mix.gradient[1] * float(y);
    return double(evaluator->evaluate(0, host.planes(), there, here)[0]);
  };
  const double x = step / texels[0], y = step / texels[1];
  return {float(valueAt(0.0, 0.0)), float((valueAt(x, 0.0) - valueAt(-x, 0.0)) / (2.0 * x)),
          float((valueAt(0.0, y) - valueAt(0.0, -y)) / (2.0 * y))};
}

void Differences::add(double found, double expected) {
  double difference = std::abs(found - expected);
  if (std::isnan(difference))
    difference = std::numeric_limits<double>::infinity();
  largest = std::max(largest, difference);
  beyond += difference > 1.0 / 1024.0 ? 1 : 0;
  ++count;
}

void Differences::check() const {
  CHECK(largest <= 1.0 / 255.0);
  CHECK(fractionBeyond() <= 0.001);
}

double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

SurfaceFrame frameOf(const SamplePoint& point, double rotation) {
  const auto scaled = [](const Vec& v, double s) { return Vec{s * v[0], s * v[1], s * v[2]}; };
  const auto plus = [](const Vec& a, const Vec& b) {
    return Vec{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  };
  const auto normalized = [&](const Vec& v) { return scaled(v, 1.0 / std::sqrt(dot(v, v))); };
  const auto& [x, y, z] = point.normal;
  const auto& [tx, ty, tz, sign] = point.tangent;
  const Vec n = normalized({double(x), double(y), double(z)});
  const Vec tangent{double(tx), double(ty), double(tz)};
  const Vec right = normalized(plus(tangent, scaled(n, -dot(tangent, n))));
  const Vec down = scaled({n[1] * right[2] - n[2] * right[1], n[2] * right[0] - n[0] * right[2],
                           n[0] * right[1] - n[1] * right[0]},
                          -double(sign));
  const double cosine = std::cos(rotation), sine = std::sin(rotation);
  return {plus(scaled(right, cosine), scaled(down, sine)),
          plus(scaled(down, cosine), scaled(right, -sine)), n};
}

} // namespace lichen::test
