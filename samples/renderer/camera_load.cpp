// SPDX-License-Identifier: MIT
// Camera projections and their faults [glTF 2.0, section 3.10.3].
#include "camera_load.h"

#include <fmt/format.h>

#include <limits>
#include <string>

namespace lichen::renderer {
namespace {

constexpr double kSmallest = 1e-6;
constexpr double kLargest = std::numeric_limits<float>::max();
constexpr double kWidest = 3.1; // radians; glTF requires less than pi

struct LensNumber {
  const char* name;
  double value;
  double low;
  double high;
};

std::string faultOf(const LensNumber& number, const std::string& lens) {
  if (number.value >= number.low && number.value <= number.high)
    return {};
  const std::string accepted = number.high < kLargest
                                   ? fmt::format("{:.7g} to {:.7g}", number.low, number.high)
                                   : fmt::format("{:.7g} or more", number.low);
  return fmt::format("{}/{}: {:.7g} is out of range; expected {}", lens, number.name, number.value,
                     accepted);
}

/// tinygltf stores an absent number as 0.
std::string faultOf(const tinygltf::PerspectiveCamera& lens, const std::string& pointer) {
  const bool hasRatio = lens.aspectRatio != 0.0;
  for (const LensNumber& number :
       {LensNumber{"yfov", lens.yfov, kSmallest, kWidest},
        LensNumber{"aspectRatio", hasRatio ? lens.aspectRatio : 1.0, kSmallest, kLargest},
        LensNumber{"znear", lens.znear, kSmallest, kLargest}})
    if (std::string fault = faultOf(number, pointer); !fault.empty())
      return fault;
  if (lens.zfar != 0.0 && !(lens.zfar > lens.znear))
    return fmt::format("{}/zfar: {:.7g} is out of range; expected more than znear ({:.7g})",
                       pointer, lens.zfar, lens.znear);
  return {};
}

std::string faultOf(const tinygltf::OrthographicCamera& lens, const std::string& pointer) {
  for (const LensNumber& number : {LensNumber{"xmag", lens.xmag, kSmallest, kLargest},
                                   LensNumber{"ymag", lens.ymag, kSmallest, kLargest},
                                   LensNumber{"znear", lens.znear, 0.0, kLargest}})
    if (std::string fault = faultOf(number, pointer); !fault.empty())
      return fault;
  // Compared as floats, because the projection divides by their float difference.
  if (!(float(lens.zfar) - float(lens.znear) >= float(kSmallest)))
    return fmt::format(
        "{}/zfar: {:.12g} is too close to znear ({:.12g}); expected a distance of at "
        "least 1e-6 between the two, as 32-bit floats",
        pointer, lens.zfar, lens.znear);
  return {};
}

} // namespace

Camera readCamera(const tinygltf::Model& model, std::size_t index,
                  const glm::dmat4& worldFromCamera) {
  const tinygltf::Camera& source = model.cameras[index];
  const std::string pointer = fmt::format("/cameras/{}/{}", index, source.type);
  Camera camera;
  camera.name = source.name;
  camera.worldFromCamera = worldFromCamera;
  camera.perspective = source.type == "perspective";
  if (camera.perspective) {
    camera.fault = faultOf(source.perspective, pointer);
    camera.verticalFieldOfView = float(source.perspective.yfov);
    camera.aspectRatio = float(source.perspective.aspectRatio);
    camera.near = float(source.perspective.znear);
    camera.far = float(source.perspective.zfar);
  } else {
    camera.fault = faultOf(source.orthographic, pointer);
    camera.halfHeight = float(source.orthographic.ymag);
    camera.aspectRatio = float(source.orthographic.xmag / source.orthographic.ymag);
    camera.near = float(source.orthographic.znear);
    camera.far = float(source.orthographic.zfar);
  }
  return camera;
}

} // namespace lichen::renderer
