// SPDX-License-Identifier: MIT
// Periodic noise fields, grain mosaics and the canvas of the generated materials.
//
// Inputs: a side in pixels, sizes in pixels, a seed. Outputs: Field (side, side) row-major,
// Mosaic queries, an RGB image. Source of the mosaic: S. Worley, "A cellular texture basis
// function", 1996.
#include "periodic.h"

#include <lichen/lattice.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lichen::exemplars {
namespace {

int wrapped(int index, int count) {
  if (index >= 0 && index < count)
    return index; // common case, avoids the division
  const int remainder = index % count;
  return remainder < 0 ? remainder + count : remainder;
}

void standardize(Field& field) {
  double sum = 0.0, squares = 0.0;
  for (const float value : field.values) {
    sum += double(value);
    squares += double(value) * double(value);
  }
  const double count = double(field.values.size());
  const double mean = sum / count;
  const double deviation = std::sqrt(squares / count - mean * mean);
  for (float& value : field.values)
    value = float((double(value) - mean) / deviation);
}

/// One periodic box filter along x.
void boxFilterRows(const Field& from, Field& to, int radius) {
  const int side = from.side;
  const double scale = 1.0 / double(2 * radius + 1);
  std::vector<float> padded(std::size_t(side + 2 * radius + 1));
  for (int y = 0; y < side; ++y) {
    for (std::size_t k = 0; k < padded.size(); ++k)
      padded[k] = from.at(int(k) - radius, y);
    double sum = 0.0;
    for (int k = 0; k <= 2 * radius; ++k)
      sum += double(padded[std::size_t(k)]);
    float* row = &to.at(0, y);
    for (int x = 0; x < side; ++x) {
      row[x] = float(sum * scale);
      sum += double(padded[std::size_t(x + 2 * radius + 1)]) - double(padded[std::size_t(x)]);
    }
  }
}

/// One periodic box filter along y, as a running sum of rows.
void boxFilterColumns(const Field& from, Field& to, int radius) {
  const int side = from.side;
  const double scale = 1.0 / double(2 * radius + 1);
  std::vector<double> sums(std::size_t(side), 0.0);
  for (int k = -radius; k <= radius; ++k)
    for (int x = 0; x < side; ++x)
      sums[std::size_t(x)] += double(from.at(x, k));
  for (int y = 0; y < side; ++y) {
    const float* entering = from.row(y + radius + 1);
    const float* leaving = from.row(y - radius);
    float* row = &to.at(0, y);
    for (int x = 0; x < side; ++x) {
      row[x] = float(sums[std::size_t(x)] * scale);
      sums[std::size_t(x)] += double(entering[x]) - double(leaving[x]);
    }
  }
}

/// Independent uniform values, one per sample.
Field whiteNoise(int samplesPerSide, std::uint32_t seed) {
  Field field(samplesPerSide);
  for (int y = 0; y < samplesPerSide; ++y) {
    for (int x = 0; x < samplesPerSide; ++x) {
      const auto hash = pcg3d({std::uint32_t(x), std::uint32_t(y), seed});
      field.at(x, y) = float(hash[0] >> 8u);
    }
  }
  return field;
}

} // namespace

Random::Random(std::uint32_t seed) : state_(pcg(seed)) {}
std::uint32_t Random::bits() { return state_ = pcg(state_); }
float Random::unit() { return float(bits() >> 8u) * (1.0f / 16777216.0f); }

Direction randomDirection(Random& random) {
  for (;;) {
    const float x = random.range(-1.0f, 1.0f);
    const float y = random.range(-1.0f, 1.0f);
    const float lengthSquared = x * x + y * y;
    constexpr float kShortest = 0.01f; // avoids dividing by zero
    if (lengthSquared > 1.0f || lengthSquared < kShortest)
      continue;
    const float length = std::sqrt(lengthSquared);
    return {x / length, y / length};
  }
}

Field::Field(int samplesPerSide)
    : side(samplesPerSide), values(std::size_t(samplesPerSide) * std::size_t(samplesPerSide)) {}

float& Field::at(int x, int y) {
  return values[std::size_t(wrapped(y, side)) * std::size_t(side) + std::size_t(wrapped(x, side))];
}
float Field::at(int x, int y) const {
  return values[std::size_t(wrapped(y, side)) * std::size_t(side) + std::size_t(wrapped(x, side))];
}
const float* Field::row(int y) const {
  return values.data() + std::size_t(wrapped(y, side)) * std::size_t(side);
}
float Field::atPixel(float x, float y) const {
  return at(int(std::floor(x * float(kSamplesPerPixel))),
            int(std::floor(y * float(kSamplesPerPixel))));
}

Field fractalNoise(int sidePixels, const Octaves& octaves, std::uint32_t seed) {
  Field sum(sidePixels * kSamplesPerPixel);
  float amplitude = 1.0f;
  std::uint32_t octave = 0;
  for (float period = octaves.coarsest; period >= octaves.finest; period *= 0.5f) {
    // The difference between three box filters of a third of a period and three of twice that width
    // has its spectral peak near one cycle per period.
    const int radius = int(period * float(kSamplesPerPixel) * (1.0f / 6.0f) + 0.5f);
    Field band = blurred(whiteNoise(sum.side, pcg(seed) + octave++), radius);
    const Field low = blurred(band, 2 * radius + 1);
    for (std::size_t i = 0; i < band.values.size(); ++i)
      band.values[i] -= low.values[i];
    standardize(band);
    for (std::size_t i = 0; i < band.values.size(); ++i)
      sum.values[i] += amplitude * band.values[i];
    amplitude *= octaves.gain;
  }
  standardize(sum);
  return sum;
}

Field blurred(const Field& field, int radiusSamples) {
  if (radiusSamples == 0)
    return field;
  Field a = field;
  Field b(field.side);
  constexpr int kPasses = 3; // close to a Gaussian
  for (int pass = 0; pass < kPasses; ++pass) {
    boxFilterRows(a, b, radiusSamples);
    boxFilterColumns(b, a, radiusSamples);
  }
  return a;
}

Mosaic::Mosaic(int sidePixels, const Shape& shape, std::uint32_t seed)
    : cells_(std::max(3, int(float(sidePixels) / shape.spacing + 0.5f))),
      cell_(float(sidePixels) / float(cells_)) {
  Random random(seed);
  shiftX_ = random.range(0.0f, cell_);
  shiftY_ = random.range(0.0f, cell_);
  for (int y = 0; y < cells_; ++y) {
    for (int x = 0; x < cells_; ++x) {
      Grain grain;
      grain.x = (float(x) + 0.5f + shape.irregularity * (random.unit() - 0.5f)) * cell_ + shiftX_;
      grain.y = (float(y) + 0.5f + shape.irregularity * (random.unit() - 0.5f)) * cell_ + shiftY_;
      grain.weight = random.range(shape.smallest, shape.largest);
      grain.axis = randomDirection(random);
      const float stretch = random.range(1.0f, shape.longest);
      grain.alongFactor = 1.0f / (stretch * grain.weight * grain.weight);
      grain.acrossFactor = stretch / (grain.weight * grain.weight);
      grain.id = random.bits();
      grains_.push_back(grain);
    }
  }
}

GrainHit Mosaic::at(float x, float y) const {
  const int cellX = int(std::floor((x - shiftX_) / cell_));
  const int cellY = int(std::floor((y - shiftY_) / cell_));
  GrainHit hit;
  float first = std::numeric_limits<float>::max();
  float second = first;
  constexpr int kReach = 2; // cells; a grain of weight 2 rarely reaches farther
  for (int j = cellY - kReach; j <= cellY + kReach; ++j) {
    const int wrappedY = wrapped(j, cells_);
    const float rowY = y - float(j - wrappedY) * cell_;
    for (int i = cellX - kReach; i <= cellX + kReach; ++i) {
      const int wrappedX = wrapped(i, cells_);
      const Grain& grain =
          grains_[std::size_t(wrappedY) * std::size_t(cells_) + std::size_t(wrappedX)];
      const float dx = x - float(i - wrappedX) * cell_ - grain.x;
      const float dy = rowY - grain.y;
      const float along = dx * grain.axis.x + dy * grain.axis.y;
      const float across = dy * grain.axis.x - dx * grain.axis.y;
      const float squared =
          along * along * grain.alongFactor + across * across * grain.acrossFactor;
      if (squared < first) {
        second = first;
        first = squared;
        hit.grain = &grain;
        hit.along = along;
        hit.across = across;
      } else {
        second = std::min(second, squared);
      }
    }
  }
  hit.edge = 0.5f * (std::sqrt(second) - std::sqrt(first)) * hit.grain->weight;
  return hit;
}

Color mix(const Color& a, const Color& b, float t) {
  return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t};
}
Color scaled(const Color& color, float factor) {
  return {color.r * factor, color.g * factor, color.b * factor};
}

float clamped(float value, float low, float high) { return std::min(std::max(value, low), high); }

float smoothStep(float low, float high, float value) {
  const float t = clamped((value - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

Canvas::Canvas(int sidePixels)
    : side_(sidePixels * kSamplesPerPixel), samples_(std::size_t(side_) * std::size_t(side_)) {}

SrgbImage Canvas::resolve() const {
  const int side = side_ / kSamplesPerPixel;
  SrgbImage image(side, side, 3);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      Color light;
      for (int j = 0; j < kSamplesPerPixel; ++j) {
        for (int i = 0; i < kSamplesPerPixel; ++i) {
          const Color& s = samples_[std::size_t(y * kSamplesPerPixel + j) * std::size_t(side_) +
                                    std::size_t(x * kSamplesPerPixel + i)];
          const float r = clamped(s.r, 0.0f, 1.0f);
          const float g = clamped(s.g, 0.0f, 1.0f);
          const float b = clamped(s.b, 0.0f, 1.0f);
          light = {light.r + r * r, light.g + g * g, light.b + b * b};
        }
      }
      constexpr float kShare = 1.0f / float(kSamplesPerPixel * kSamplesPerPixel);
      float* pixel = image.pixel(x, y);
      const float means[3] = {light.r * kShare, light.g * kShare, light.b * kShare};
      for (int c = 0; c < 3; ++c)
        pixel[c] = std::floor(std::sqrt(means[c]) * 255.0f + 0.5f) / 255.0f;
    }
  }
  return image;
}

void light(Relief& relief, const Lighting& lighting) {
  const Field& height = relief.height;
  constexpr int kSurroundings = 5; // samples
  const Field around = blurred(height, kSurroundings);
  for (int y = 0; y < height.side; ++y) {
    for (int x = 0; x < height.side; ++x) {
      const float slopeX = height.at(x + 1, y) - height.at(x - 1, y);
      const float slopeY = height.at(x, y + 1) - height.at(x, y - 1);
      const float facing = (slopeX + slopeY) / std::sqrt(1.0f + slopeX * slopeX + slopeY * slopeY);
      // Clamped so that a single deep pit or high rim does not turn black or white.
      const float below = clamped(around.at(x, y) - height.at(x, y), -0.6f, 2.0f);
      const float shade = 1.0f + lighting.slope * facing - lighting.hollow * below;
      relief.canvas.at(x, y) = scaled(relief.canvas.at(x, y), clamped(shade, 0.35f, 1.5f));
    }
  }
}

float hashed(int i, int j, std::uint32_t seed) {
  return float(pcg3d({std::uint32_t(i), std::uint32_t(j), seed})[0] >> 8u) * 0x1p-24f;
}

} // namespace lichen::exemplars
