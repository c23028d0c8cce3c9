// SPDX-License-Identifier: MIT
// Camera projections and their faults [glTF 2.0, section 3.10.3].
#include "camera_load.h"

#include <fmt/format.h>

namespace lichen::renderer {
namespace {

constexpr double kSmallest = 1e-6;
constexpr double kWidest = 3.1; // radians; glTF requires less than pi

/// A member that a lens must have, and the range of its number.
struct LensNumber {
  const char* name;
  double low;
  double high = kLargest;
};

/// The first fault of the numbers, or nothing.
std::string faultOf(const Place& lens, std::initializer_list<LensNumber> numbers) {
  for (const auto& [name, low, high] : numbers) {
    const double value = lens.member(name).asNumber();
    if (value >= low && value <= high)
      continue;
    const std::string accepted = high < kLargest ? fmt::format("{:.7g} to {:.7g}", low, high)
                                                 : fmt::format("{:.7g} or more", low);
    return fmt::format("{}/{}: {:.7g} is out of range; expected {}", lens.pointer(), name, value,
                       accepted);
  }
  return {};
}

/// An optional number that 0 leaves out, with a note.
double numberUnlessZero(const Place& lens, const char* key, std::vector<std::string>& notes) {
  const double value = lens.number(key, 0.0);
  if (value == 0.0 && lens.find(key))
    notes.push_back(lens.pointer() + "/" + key +
                    ": 0 is invalid and treated as absent; expected more than 0");
  return value;
}

void readPerspective(const Place& lens, Camera& camera, std::vector<std::string>& notes) {
  const double ratio = numberUnlessZero(lens, "aspectRatio", notes);
  const double near = lens.member("znear").asNumber();
  const double far = numberUnlessZero(lens, "zfar", notes);
  camera.fault = faultOf(lens, {{"yfov", kSmallest, kWidest}});
  if (camera.fault.empty() && ratio != 0.0)
    camera.fault = faultOf(lens, {{"aspectRatio", kSmallest}});
  if (camera.fault.empty())
    camera.fault = faultOf(lens, {{"znear", kSmallest}});
  if (camera.fault.empty() && far != 0.0 && !(far > near))
    camera.fault = fmt::format("{}/zfar: {:.7g} is out of range; expected more than znear ({:.7g})",
                               lens.pointer(), far, near);
  camera.verticalFieldOfView = float(lens.member("yfov").asNumber());
  camera.aspectRatio = float(ratio);
  camera.near = float(near);
  camera.far = float(far);
}

void readOrthographic(const Place& lens, Camera& camera) {
  const double near = lens.member("znear").asNumber(), far = lens.member("zfar").asNumber();
  const double halfHeight = lens.member("ymag").asNumber();
  camera.fault = faultOf(lens, {{"xmag", kSmallest}, {"ymag", kSmallest}, {"znear", 0.0}});
  // Compared as floats, because the projection divides by their float difference.
  if (camera.fault.empty() && !(float(far) - float(near) >= float(kSmallest)))
    camera.fault =
        fmt::format("{}/zfar: {:.12g} is too close to znear ({:.12g}); expected a distance of at "
                    "least 1e-6 between the two, as 32-bit floats",
                    lens.pointer(), far, near);
  camera.halfHeight = float(halfHeight);
  camera.aspectRatio = float(lens.member("xmag").asNumber() / halfHeight);
  camera.near = float(near);
  camera.far = float(far);
}

} // namespace

Camera readCamera(const Place& source, const glm::dmat4& worldFromCamera,
                  std::vector<std::string>& notes) {
  Camera camera;
  (void)source.member("type");
  camera.name = source.string("name").value_or("");
  camera.worldFromCamera = worldFromCamera;
  camera.perspective = source.oneOf("type", {"perspective", "orthographic"}) == "perspective";
  if (camera.perspective)
    readPerspective(source.member("perspective"), camera, notes);
  else
    readOrthographic(source.member("orthographic"), camera);
  return camera;
}

} // namespace lichen::renderer
