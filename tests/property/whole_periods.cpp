// SPDX-License-Identifier: MIT
// Frames of whole periods in pictures whose periods are known, also in perspective, and maps inside
// frames.
#include "plane_of.h"
#include "random_field.h"

#include <lichen/regularity.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <exemplar/value_encoding.h>
#include <functional>
#include <numbers>
#include <placement/perspective.h>
#include <placement/whole_periods.h>
#include <random>
#include <vector>

using namespace lichen;
using lichen::placement::Keystone;
using lichen::placement::seen;
using lichen::placement::wholePeriods;

namespace {

using PixelVector = std::array<double, 2>;

/// Two periods, in pixels.
struct PictureLattice {
  PixelVector first, second;

  /// The numbers of both that lead to a vector.
  [[nodiscard]] PixelVector coordinatesOf(const PixelVector& v) const {
    const double area = first[0] * second[1] - first[1] * second[0];
    return {(v[0] * second[1] - v[1] * second[0]) / area,
            (first[0] * v[1] - first[1] * v[0]) / area};
  }
  /// The distance to the vector of the lattice with the nearest numbers.
  [[nodiscard]] double distanceTo(const PixelVector& v) const {
    const PixelVector at = coordinatesOf(v);
    const double a = at[0] - std::round(at[0]), b = at[1] - std::round(at[1]);
    return std::hypot(a * first[0] + b * second[0], a * first[1] + b * second[1]);
  }
};

/// A lattice of these periods along x and y, turned, and before that sheared along x.
PictureLattice slantedLattice(double right, double down, double degrees, double shear) {
  const double c = std::cos(degrees * std::numbers::pi / 180.0),
               s = std::sin(degrees * std::numbers::pi / 180.0);
  const auto slanted = [&](double x, double y) {
    x += shear * y;
    return PixelVector{c * x - s * y, s * x + c * y};
  };
  return {slanted(right, 0.0), slanted(0.0, down)};
}

/// From a position in the picture to the plane that it shows.
using OnPlane = std::function<PixelVector(double x, double y)>;

PixelVector seenFromAbove(double x, double y) { return {x, y}; }

/// A picture with these periods only: a sum of waves. Each pixel has noise of this amplitude.
MapExemplar periodicPicture(int width, int height, const PictureLattice& lattice, double noise,
                            std::uint32_t seed, const OnPlane& onPlane = seenFromAbove) {
  constexpr int kHighest = 3; // waves per period
  struct Wave {
    double u, v, amplitude, phase;
  };
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<Wave> waves;
  for (int v = 0; v <= kHighest; ++v)
    for (int u = v == 0 ? 1 : -kHighest; u <= kHighest; ++u)
      waves.push_back({double(u), double(v), normal(generator), 7.0 * normal(generator)});
  return test::planeOf(width, height, [&](int x, int y) {
    const PixelVector at = lattice.coordinatesOf(onPlane(x, y));
    double sum = 3.0 * double(x) / width + noise * normal(generator); // uneven light
    for (const Wave& wave : waves)
      sum += wave.amplitude *
             std::cos(2.0 * std::numbers::pi * (wave.u * at[0] + wave.v * at[1]) + wave.phase);
    return 0.5 + 0.03 * sum;
  });
}

/// From the first corner to the second and to the fourth.
PixelVector rightOf(const TileCorners& corners) {
  return {corners[1][0] - corners[0][0], corners[1][1] - corners[0][1]};
}
PixelVector downOf(const TileCorners& corners) {
  return {corners[3][0] - corners[0][0], corners[3][1] - corners[0][1]};
}

/// The parallelogram with this corner and these sides.
TileCorners cornersOf(const PixelVector& corner, const PixelVector& right,
                      const PixelVector& down) {
  const auto moved = [&](double a, double b) {
    return PixelVector{corner[0] + a * right[0] + b * down[0],
                       corner[1] + a * right[1] + b * down[1]};
  };
  return {moved(0.0, 0.0), moved(1.0, 0.0), moved(1.0, 1.0), moved(0.0, 1.0)};
}

MapExemplar partBetween(const MapExemplar& map, const TileCorners& corners) {
  std::vector<MapExemplar> maps{map};
  REQUIRE(rectify(maps, corners));
  return maps.front();
}

void checkInside(const TileCorners& corners, int width, int height) {
  for (const auto& [x, y] : corners) {
    CHECK(x > -1e-6);
    CHECK(y > -1e-6);
    CHECK(x < width + 1e-6);
    CHECK(y < height + 1e-6);
  }
}

double areaOf(const TileCorners& corners) {
  const PixelVector right = rightOf(corners), down = downOf(corners);
  return right[0] * down[1] - right[1] * down[0];
}

/// The area of the largest rectangle of the lattice's vectors that fits in the
/// picture.
double largestArea(const PictureLattice& lattice, int width, int height) {
  constexpr int kMost = 20;
  constexpr double kSkew = 0.03;
  std::vector<PixelVector> vectors;
  for (int i = -kMost; i <= kMost; ++i)
    for (int j = -kMost; j <= kMost; ++j)
      vectors.push_back({i * lattice.first[0] + j * lattice.second[0],
                         i * lattice.first[1] + j * lattice.second[1]});
  double most = 0.0;
  for (const PixelVector& r : vectors)
    for (const PixelVector& d : vectors) {
      if (std::abs(r[0]) + std::abs(d[0]) > width || std::abs(r[1]) + std::abs(d[1]) > height ||
          r[0] < std::abs(r[1]))
        continue;
      const double area = r[0] * d[1] - r[1] * d[0];
      if (std::abs(r[0] * d[0] + r[1] * d[1]) <
          kSkew * std::hypot(r[0], r[1]) * std::hypot(d[0], d[1]))
        most = std::max(most, area);
    }
  return most;
}

} // namespace

TEST_CASE("the frame of a picture spans whole periods, turned and sheared as they are") {
  constexpr int kWidth = 210, kHeight = 180;
  for (const double degrees : {0.0, 3.0, -8.0, 20.0})
    for (const double shear : {0.0, 0.1})
      for (const double noise : {0.0, 3.0}) { // the structure's deviation is about 3
        const PictureLattice lattice = slantedLattice(31.4, 23.7, degrees, shear);
        const MapExemplar map = periodicPicture(kWidth, kHeight, lattice, noise, 5);
        const auto frame = wholePeriods(map).part;
        INFO(degrees << " degrees, shear " << shear << ", noise " << noise);
        REQUIRE(frame);
        checkInside(*frame, kWidth, kHeight);
        CHECK(lattice.distanceTo(rightOf(*frame)) < 1.0);
        CHECK(lattice.distanceTo(downOf(*frame)) < 1.0);
        const PixelVector right = rightOf(*frame);
        CHECK(std::atan2(right[1], right[0]) * 180.0 / std::numbers::pi ==
              Approx(degrees).margin(1.0));
        if (degrees < 10.0) // of a greater turn, other vectors than the periods fill more
          CHECK(areaOf(*frame) > 0.8 * largestArea(lattice, kWidth, kHeight));
      }
}

TEST_CASE("the frame of a picture that is searched at a lower resolution is in its own pixels") {
  constexpr int kWidth = 901, kHeight = 720;
  const PictureLattice lattice = slantedLattice(131.0, 96.0, 4.0, 0.0);
  const auto frame = wholePeriods(periodicPicture(kWidth, kHeight, lattice, 0.5, 6)).part;
  REQUIRE(frame);
  checkInside(*frame, kWidth, kHeight);
  CHECK(lattice.distanceTo(rightOf(*frame)) < 2.0);
  CHECK(lattice.distanceTo(downOf(*frame)) < 2.0);
}

TEST_CASE("the borders of the frame are in joints if the picture leaves room for that") {
  constexpr int kWidth = 230, kHeight = 190, kColumn = 60, kRow = 50, kJoint = 4, kLeft = 17,
                kTop = 22;
  MapExemplar map =
      periodicPicture(kWidth, kHeight, slantedLattice(kColumn, kRow, 0.0, 0.0), 0.0, 8);
  const std::size_t channels = map.channels.size();
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const int column = (x + kColumn - kLeft) / kColumn, row = (y + kRow - kTop) / kRow;
      const bool isJoint =
          (x + kColumn - kLeft) % kColumn < kJoint || (y + kRow - kTop) % kRow < kJoint;
      for (std::size_t c = 0; c < channels; ++c) // each cell has a colour
        map.values[(std::size_t(y) * kWidth + std::size_t(x)) * channels + c] =
            isJoint ? 0.0f : 0.5f + 0.04f * float((5 * column + 3 * row) % 11);
    }
  const auto frame = wholePeriods(map).part;
  REQUIRE(frame);
  const auto fromJoint = [](double at, int first, int period) { // of its middle
    const double share = (at - first - 0.5 * kJoint) / period;
    return period * std::abs(share - std::round(share));
  };
  for (const auto& [x, y] : *frame) {
    CHECK(fromJoint(x, kLeft, kColumn) < 0.5 * kJoint + 1.5);
    CHECK(fromJoint(y, kTop, kRow) < 0.5 * kJoint + 1.5);
  }
}

TEST_CASE("a picture whose borders fit and look alike stays whole, whatever repeats inside") {
  constexpr int kWidth = 210, kHeight = 180; // 6.7 and 7.6 periods
  MapExemplar map = periodicPicture(kWidth, kHeight, slantedLattice(31.4, 23.7, 0.0, 0.0), 0.0, 5);
  const auto hasPart = [&](bool bordersFit) {
    return wholePeriods(map, bordersFit).part.has_value();
  };
  CHECK(hasPart(false));
  CHECK(hasPart(true)); // what repeats contradicts
  const std::size_t channels = map.channels.size();
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      if (std::min({x, y, kWidth - 1 - x, kHeight - 1 - y}) < 3) // a joint all around
        std::fill_n(&map.values[std::size_t(y * kWidth + x) * channels], channels, 0.3f);
  CHECK(hasPart(false));
  CHECK_FALSE(hasPart(true));
}

TEST_CASE("the frame of upright boards is upright, though they repeat after any shift along them") {
  constexpr int kSide = 300, kBoard = 48, kJoint = 4, kTones = 4, kFieldSide = 512, kStreak = 12;
  constexpr double kSlant = 0.02; // a keystone that is found by chance makes some of that
  int found = 0, slanted = 0;
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    const std::vector<float> field = test::randomField(kFieldSide, test::bellPower(100.0), seed);
    const MapExemplar map = test::planeOf(kSide, kSide, [&](int x, int y) {
      const float streak = field[std::size_t((y / kStreak) * kFieldSide + x)];
      const int tone = x / kBoard % kTones;
      return x % kBoard < kJoint ? 0.0f : 0.5f + 0.1f * float(tone) + 0.02f * streak;
    });
    const auto frame = wholePeriods(map).part;
    if (!frame)
      continue;
    const PixelVector right = rightOf(*frame), down = downOf(*frame);
    ++found;
    slanted += int(std::abs(right[1]) > kSlant * right[0] || std::abs(down[0]) > kSlant * down[1]);
  }
  CHECK(found > 5);
  CHECK(slanted == 0);
}

TEST_CASE("the corners of a picture in perspective span whole periods of the plane it shows") {
  constexpr int kSide = 220;
  constexpr double kHalf = 0.5 * kSide;
  const PictureLattice lattice = slantedLattice(31.4, 23.7, 3.0, 0.0);
  // How much narrower the left and the upper side are.
  for (const auto& [left, upper] :
       {PixelVector{0.0, 0.1}, PixelVector{0.0, -0.1}, PixelVector{0.1, 0.0},
        PixelVector{-0.1, 0.0}, PixelVector{0.0, 0.03}, PixelVector{0.05, -0.04}}) {
    const OnPlane onPlane = [left = left, upper = upper](double x, double y) {
      const double depth = 1.0 + left / (2.0 - left) * (x - kHalf) / kHalf +
                           upper / (2.0 - upper) * (y - kHalf) / kHalf;
      return PixelVector{(x - kHalf) / depth, (y - kHalf) / depth};
    };
    const auto corners = wholePeriods(periodicPicture(kSide, kSide, lattice, 0.5, 7, onPlane)).part;
    INFO("left side " << left << ", upper side " << upper);
    REQUIRE(corners);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& [x, y] = (*corners)[k];
      const auto& [nextX, nextY] = (*corners)[(k + 1) % 4];
      CHECK(std::min({x, y, kSide - x, kSide - y}) > -1e-6);
      const PixelVector from = onPlane(x, y), to = onPlane(nextX, nextY);
      CHECK(lattice.distanceTo({to[0] - from[0], to[1] - from[1]}) < 1.5);
    }
  }
}

TEST_CASE("a keystone maps a square to a trapezoid, and its middle to where the diagonals meet") {
  constexpr double kShare = 0.2;
  const auto checkSeen = [](const Keystone& keystone, double u, double v, double x, double y) {
    const auto at = seen(keystone, u, v);
    CHECK(at[0] == Approx(x).margin(1e-12));
    CHECK(at[1] == Approx(y).margin(1e-12));
  };
  checkSeen({0.0, kShare}, 0.0, 0.0, 0.5 * kShare, 0.0);
  checkSeen({0.0, kShare}, 1.0, 0.0, 1.0 - 0.5 * kShare, 0.0);
  checkSeen({0.0, kShare}, 1.0, 1.0, 1.0, 1.0);
  checkSeen({0.0, kShare}, 0.0, 1.0, 0.0, 1.0);
  constexpr double kMeeting = (1.0 - kShare) / (2.0 - kShare); // from the short side
  checkSeen({0.0, kShare}, 0.5, 0.5, 0.5, kMeeting);
  checkSeen({0.0, -kShare}, 0.5, 0.5, 0.5, 1.0 - kMeeting);
  checkSeen({kShare, 0.0}, 0.5, 0.5, kMeeting, 0.5);
  checkSeen({-kShare, 0.0}, 1.0, 1.0, 1.0, 1.0 - 0.5 * kShare);
  // The share of x maps (0, 0) to (0, 0.1), and the share of y maps that to (0.09, 0.08) / 0.98.
  checkSeen({kShare, kShare}, 0.0, 0.0, 0.09 / 0.98, 0.08 / 0.98);
  checkSeen({kShare, kShare}, 1.0, 1.0, 1.0, 1.0);
}

TEST_CASE("a random field has no frame") {
  // Cut from fields that tile. Of 40 with grain of up to a sixth of the side, none has one; of 40
  // with grain of a quarter, 10 have one by chance.
  constexpr int kSide = 200, kFieldSide = 256;
  int found = 0;
  for (const double wavesPerField : {48.0, 12.0})
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
      const std::vector<float> field =
          test::randomField(kFieldSide, test::bellPower(wavesPerField), seed);
      const MapExemplar map = test::planeOf(
          kSide, kSide, [&](int x, int y) { return field[std::size_t(y * kFieldSide + x)]; });
      found += int(wholePeriods(map).part.has_value());
    }
  CHECK(found == 0);
}

TEST_CASE("a map inside a frame has the values at the frame's positions") {
  // Bilinear interpolation is exact for a plane.
  const auto planeAt = [](double x, double y) { return 0.1 + 0.003 * x + 0.002 * y; };
  MapExemplar map;
  map.channels = {MapChannel::red, MapChannel::green};
  map.encoding = ValueEncoding::linear;
  map.width = 120;
  map.height = 100;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      map.values.push_back(float(planeAt(x + 0.5, y + 0.5)));
      map.values.push_back(float(1.0 - planeAt(x + 0.5, y + 0.5)));
    }
  const PixelVector origin{20.0, 8.0}, right{76.0, 7.0}, down{-5.0, 54.0};
  const MapExemplar inside = partBetween(map, cornersOf(origin, right, down));
  REQUIRE(inside.width == 76);  // hypot(76, 7) = 76.3
  REQUIRE(inside.height == 54); // hypot(5, 54) = 54.2
  REQUIRE(inside.values.size() == std::size_t(2 * 76 * 54));
  double most = 0.0;
  for (int y = 0; y < inside.height; ++y)
    for (int x = 0; x < inside.width; ++x) {
      const double u = (x + 0.5) / inside.width, v = (y + 0.5) / inside.height;
      const double expected =
          planeAt(origin[0] + u * right[0] + v * down[0], origin[1] + u * right[1] + v * down[1]);
      const float* const pixel = &inside.values[std::size_t(2 * (y * inside.width + x))];
      most = std::max({most, std::abs(double(pixel[0]) - expected),
                       std::abs(double(pixel[1]) - (1.0 - expected))});
    }
  CHECK(most < 1e-5);
}

TEST_CASE("light and not its sRGB code is interpolated inside a frame") {
  MapExemplar map;
  map.channels = {MapChannel::red};
  map.width = 64;
  map.height = 64;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      map.values.push_back(x % 2 == 0 ? 0.2f : 0.9f);
  // Half a pixel further, every value is between two pixels.
  const MapExemplar inside = partBetween(map, cornersOf({8.5, 8.0}, {40.0, 0.0}, {0.0, 40.0}));
  const float half = exemplar::encoded(0.5f * (exemplar::decoded(0.2f, ValueEncoding::srgb) +
                                               exemplar::decoded(0.9f, ValueEncoding::srgb)),
                                       ValueEncoding::srgb);
  for (const float value : inside.values)
    REQUIRE(value == Approx(half));
}

TEST_CASE("slopes inside a turned frame are the turned surface's") {
  // A plane that rises by (0.3, -0.2) along x and along y, which is up.
  MapExemplar map;
  map.channels = {MapChannel::red, MapChannel::green};
  map.encoding = ValueEncoding::slope;
  map.width = map.height = 64;
  for (int i = 0; i < 64 * 64; ++i)
    map.values.insert(map.values.end(), {0.3f, -0.2f});
  const MapExemplar inside = partBetween(map, cornersOf({12.0, 6.0}, {40.0, 9.0}, {-9.0, 40.0}));
  const double length = std::hypot(40.0, 9.0);
  // The frame's axes in the picture with y up: right is (40, -9), up is (9, 40).
  const double alongRight = (0.3 * 40.0 - 0.2 * -9.0) / length;
  const double alongUp = (0.3 * 9.0 - 0.2 * 40.0) / length;
  for (std::size_t i = 0; i < inside.values.size(); i += 2) {
    REQUIRE(double(inside.values[i]) == Approx(alongRight));
    REQUIRE(double(inside.values[i + 1]) == Approx(alongUp));
  }
}
