// SPDX-License-Identifier: MIT
// Building blocks of the generated materials: random numbers, periodic noise fields, periodic grain
// mosaics, and a supersampled canvas.
//
// Lengths are in pixels of the finished image; positions wrap at its border. The code uses only +,
// -, *, / and square roots of floats, so results are identical on every platform with IEEE floats.
#pragma once

#include <lichen/image.h>

#include <cstdint>
#include <vector>

namespace lichen::exemplars {

/// Samples per pixel along each axis.
inline constexpr int kSamplesPerPixel = 2;

/// A seeded random number generator.
class Random {
public:
  explicit Random(std::uint32_t seed);
  [[nodiscard]] std::uint32_t bits();
  /// Uniform in [0, 1).
  [[nodiscard]] float unit();
  [[nodiscard]] float range(float low, float high) { return low + (high - low) * unit(); }
  [[nodiscard]] bool chance(float probability) { return unit() < probability; }

private:
  std::uint32_t state_;
};

/// A unit vector.
struct Direction {
  float x = 1.0f;
  float y = 0.0f;
};
[[nodiscard]] Direction randomDirection(Random& random);

/// A periodic side x side grid of samples: sample (x, y) is values[y * side + x] and lies at pixel
/// ((x + 1/2) / kSamplesPerPixel, (y + 1/2) / kSamplesPerPixel).
struct Field {
  int side = 0;
  std::vector<float> values;

  explicit Field(int samplesPerSide);
  [[nodiscard]] float& at(int x, int y);
  [[nodiscard]] float at(int x, int y) const;
  [[nodiscard]] const float* row(int y) const;
  /// The sample that contains a pixel position; any position, wrapped.
  [[nodiscard]] float atPixel(float x, float y) const;
};

/// The bands of a fractal noise; each band has `gain` times the amplitude of the next coarser one.
struct Octaves {
  float coarsest = 0.0f; ///< period in pixels
  float finest = 0.0f;   ///< lower bound of the periods, in pixels
  float gain = 0.5f;
};

/// Sum of white noises, each filtered to a band one octave wide. Stationary, with almost no energy
/// below the coarsest band; mean 0, standard deviation 1.
[[nodiscard]] Field fractalNoise(int sidePixels, const Octaves& octaves, std::uint32_t seed);

/// The field after three box filters of this radius in samples.
[[nodiscard]] Field blurred(const Field& field, int radiusSamples);

/// One grain of a mosaic: a roughly elliptical cell around a centre.
struct Grain {
  float x = 0.0f;
  float y = 0.0f;
  float weight = 1.0f; ///< relative size
  Direction axis;      ///< direction of the long axis
  /// The squared distance that selects the grain is along^2 * alongFactor + across^2 *
  /// acrossFactor.
  float alongFactor = 1.0f;
  float acrossFactor = 1.0f;
  std::uint32_t id = 0; ///< seed for the grain's own Random
};

/// The grain at a position.
struct GrainHit {
  const Grain* grain = nullptr;
  float along = 0.0f;  ///< offset from the centre along the long axis, pixels
  float across = 0.0f; ///< offset across the long axis, pixels
  float edge = 0.0f;   ///< approximate distance to the nearest boundary, pixels
};

/// A weighted, anisotropic Voronoi mosaic with one grain per cell of a square grid.
class Mosaic {
public:
  struct Shape {
    float spacing = 10.0f;     ///< mean distance of the centres, pixels
    float smallest = 1.0f;     ///< grain weights are uniform in [smallest, largest]
    float largest = 1.0f;      ///< at most 2
    float longest = 1.0f;      ///< grain stretches are uniform in [1, longest]
    float irregularity = 1.0f; ///< 0: centres on the grid; 1: anywhere in the cell
  };
  Mosaic(int sidePixels, const Shape& shape, std::uint32_t seed);
  [[nodiscard]] GrainHit at(float x, float y) const;

private:
  int cells_ = 0;
  float cell_ = 0.0f; ///< pixels
  /// Offset of the grid, pixels. Grains are slightly sparser across cell borders, so without a
  /// random offset the image border would be visible in every mosaic.
  float shiftX_ = 0.0f;
  float shiftY_ = 0.0f;
  std::vector<Grain> grains_;
};

/// A colour in sRGB code values.
struct Color {
  float r = 0.0f;
  float g = 0.0f;
  float b = 0.0f;
};
[[nodiscard]] Color mix(const Color& a, const Color& b, float t);
[[nodiscard]] Color scaled(const Color& color, float factor);

/// Cubic step from 0 at `low` to 1 at `high`.
[[nodiscard]] float smoothStep(float low, float high, float value);
[[nodiscard]] float clamped(float value, float low, float high);

/// The supersampled picture, sidePixels * kSamplesPerPixel samples per side.
class Canvas {
public:
  explicit Canvas(int sidePixels);
  [[nodiscard]] int side() const { return side_; }
  [[nodiscard]] Color& at(int x, int y) {
    return samples_[std::size_t(y) * std::size_t(side_) + std::size_t(x)];
  }
  /// Averages the samples of each pixel as linear light and rounds to 8 bits. Approximates the sRGB
  /// curve by a square, which avoids the C library's pow.
  [[nodiscard]] SrgbImage resolve() const;

private:
  int side_ = 0;
  std::vector<Color> samples_;
};

/// The picture whose sample (x, y) is colorAt(x, y).
template <typename ColorAt>
[[nodiscard]] SrgbImage painted(int sidePixels, const ColorAt& colorAt) {
  Canvas canvas(sidePixels);
  for (int y = 0; y < canvas.side(); ++y)
    for (int x = 0; x < canvas.side(); ++x)
      canvas.at(x, y) = colorAt(x, y);
  return canvas.resolve();
}

/// A picture with a height field.
struct Relief {
  explicit Relief(int sidePixels) : canvas(sidePixels), height(canvas.side()) {}
  Canvas canvas;
  Field height; ///< pixels
};

/// Strength of a relief's lighting.
struct Lighting {
  float slope = 0.0f;  ///< brightness gained by a steep slope that faces the upper left
  float hollow = 0.0f; ///< brightness lost per pixel below the surroundings
};

/// Multiplies the picture by diffuse light from the upper left, darkening hollows.
void light(Relief& relief, const Lighting& lighting);

/// Pixel position of a sample index.
[[nodiscard]] inline float pixelOf(int sample) {
  return (float(sample) + 0.5f) / float(kSamplesPerPixel);
}

/// A hash of two indices, in [0, 1).
[[nodiscard]] float hashed(int i, int j, std::uint32_t seed);

} // namespace lichen::exemplars
