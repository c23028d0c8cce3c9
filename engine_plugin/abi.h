// SPDX-License-Identifier: MIT
// The boundary of the C interface: reads and writes structs of older and newer headers, and
// contains exceptions.
#pragma once

#include "diagnostic.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>

namespace lichen::plugin {

/// Maximum of a sampler's anisotropy; above the limit of every device.
inline constexpr double kMostAnisotropy = 64.0;

/// Size of the members type, size and next that every struct starts with.
inline constexpr std::size_t kHeaderBytes = offsetof(LichenBundleProperties, noiseCount);

/// Copies a host's struct of any size. Members missing from an older struct become zero; members of
/// a newer struct that this library does not know must be zero.
template <class Struct>
LichenResult readStruct(const Struct* source, LichenStructureType type, Struct& copy,
                        LichenDiagnostic* diagnostic) {
  if (source == nullptr || source->type != type || source->size < kHeaderBytes) {
    writeDiagnostic(
        diagnostic,
        "a struct is NULL or has an invalid type (expected %d) or size; use LICHEN_INIT",
        int(type));
    return LICHEN_ERROR_USAGE;
  }
  const unsigned char* bytes = reinterpret_cast<const unsigned char*>(source);
  bool unknown =
      source->size > sizeof(Struct) && std::any_of(bytes + sizeof(Struct), bytes + source->size,
                                                   [](unsigned char byte) { return byte != 0; });
  copy = Struct{};
  std::memcpy(&copy, source, std::min<std::size_t>(source->size, sizeof(Struct)));
  if constexpr (requires { copy.reserved; })
    unknown = unknown || copy.reserved != 0;
  if (!unknown && copy.next == nullptr)
    return LICHEN_SUCCESS;
  writeDiagnostic(
      diagnostic,
      "a struct of type %d has members that library version 0x%08x does not know; next must be "
      "NULL, and reserved and members of newer headers must be 0",
      int(type), LICHEN_HEADER_VERSION);
  return LICHEN_ERROR_VERSION;
}

/// Writes the members that both the host's struct and the library's have; keeps type, size and
/// next.
template <class Struct>
LichenResult writeStruct(const Struct& values, LichenStructureType type, Struct* target) {
  if (target == nullptr || target->type != type || target->size < kHeaderBytes)
    return LICHEN_ERROR_USAGE;
  if (target->next != nullptr)
    return LICHEN_ERROR_VERSION;
  const std::size_t end = std::min<std::size_t>(target->size, sizeof(Struct));
  std::memcpy(reinterpret_cast<unsigned char*>(target) + kHeaderBytes,
              reinterpret_cast<const unsigned char*>(&values) + kHeaderBytes, end - kHeaderBytes);
  return LICHEN_SUCCESS;
}

inline LichenResult checkHeaderVersion(std::uint32_t version, LichenDiagnostic* diagnostic) {
  constexpr int kMinorBits = 16;
  if (version >> kMinorBits == LICHEN_HEADER_VERSION >> kMinorBits)
    return LICHEN_SUCCESS;
  writeDiagnostic(
      diagnostic,
      "headerVersion 0x%08x does not match library version 0x%08x; set it to "
      "LICHEN_HEADER_VERSION and use a header with the same major version (high 16 bits)",
      version, LICHEN_HEADER_VERSION);
  return LICHEN_ERROR_VERSION;
}

/// Runs `body` and converts exceptions into results. Functions that release or destroy, and queries
/// that allocate nothing, cannot throw and do not need it.
template <class Body>
LichenResult guarded(LichenDiagnostic* diagnostic, Body&& body) noexcept {
  try {
    return body();
  } catch (const std::bad_alloc&) {
    writeDiagnostic(diagnostic, "out of host memory");
    return LICHEN_ERROR_OUT_OF_HOST_MEMORY;
  } catch (const std::length_error&) { // from a container that would exceed the address space
    writeDiagnostic(diagnostic, "out of host memory");
    return LICHEN_ERROR_OUT_OF_HOST_MEMORY;
  } catch (const std::exception& error) {
    writeDiagnostic(diagnostic, "internal error: %s", error.what());
    return LICHEN_ERROR_INTERNAL;
  } catch (...) {
    writeDiagnostic(diagnostic, "internal error");
    return LICHEN_ERROR_INTERNAL;
  }
}

} // namespace lichen::plugin
