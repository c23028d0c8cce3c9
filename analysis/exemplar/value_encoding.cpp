// SPDX-License-Identifier: MIT
#include "value_encoding.h"

#include <lichen/image.h>

#include <cmath>

namespace lichen::exemplar {

float decoded(float value, ValueEncoding encoding) {
  switch (encoding) {
  case ValueEncoding::srgb:
    return srgbToLinear(value);
  case ValueEncoding::log2:
    return std::exp2(value) - 1.0f;
  case ValueEncoding::linear:
  case ValueEncoding::slope:
    return value;
  }
  return value;
}

float encoded(float value, ValueEncoding encoding) {
  switch (encoding) {
  case ValueEncoding::srgb:
    return linearToSrgb(value);
  case ValueEncoding::log2:
    return std::log2(value + 1.0f);
  case ValueEncoding::linear:
  case ValueEncoding::slope:
    return value;
  }
  return value;
}

} // namespace lichen::exemplar
