// SPDX-License-Identifier: MIT
// What every function of the C interface does at its boundary: read and write structs of older and
// newer headers, keep exceptions in.
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

/// Of a sampler; more than any device has.
inline constexpr double kMostAnisotropy = 64.0;

/// The bytes of type, size and next, with which every struct starts.
inline constexpr std::size_t kHeaderBytes = offsetof(LichenBundleProperties, noiseCount);

/// Copies a host's struct of any size: what it lacks is zero, what we do not know must be zero.
template <class Struct>
LichenResult readStruct(const Struct* given, LichenStructureType type, Struct& known,
                        LichenDiagnostic* diagnostic) {
  if (given == nullptr || given->type != type || given->size < kHeaderBytes) {
    say(diagnostic, "a struct is NULL or lacks its type (%d expected) or size: use LICHEN_INIT",
        int(type));
    return LICHEN_ERROR_USAGE;
  }
  const unsigned char* bytes = reinterpret_cast<const unsigned char*>(given);
  bool unknown =
      given->size > sizeof(Struct) && std::any_of(bytes + sizeof(Struct), bytes + given->size,
                                                  [](unsigned char byte) { return byte != 0; });
  known = Struct{};
  std::memcpy(&known, given, std::min<std::size_t>(given->size, sizeof(Struct)));
  if constexpr (requires { known.reserved; })
    unknown = unknown || known.reserved != 0;
  if (!unknown && known.next == nullptr)
    return LICHEN_SUCCESS;
  say(diagnostic,
      "a struct of type %d holds what library version 0x%08x does not know: next must be NULL, "
      "reserved and members of newer headers 0",
      int(type), LICHEN_HEADER_VERSION);
  return LICHEN_ERROR_VERSION;
}

/// Fills a host's struct as far as it and the library's go, keeping its type, size and next.
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
  say(diagnostic,
      "headerVersion 0x%08x does not fit library version 0x%08x: set it to LICHEN_HEADER_VERSION, "
      "and use a header of the library's major version, the high 16 bits",
      version, LICHEN_HEADER_VERSION);
  return LICHEN_ERROR_VERSION;
}

/// Runs `body`; what is thrown inside becomes a result. For functions that can fail: those that
/// release or destroy, and the queries that allocate nothing, have nothing inside that throws.
template <class Body>
LichenResult guarded(LichenDiagnostic* diagnostic, Body&& body) noexcept {
  try {
    return body();
  } catch (const std::bad_alloc&) {
    say(diagnostic, "out of host memory");
    return LICHEN_ERROR_OUT_OF_HOST_MEMORY;
  } catch (const std::length_error&) { // of a container: more than can be addressed
    say(diagnostic, "out of host memory");
    return LICHEN_ERROR_OUT_OF_HOST_MEMORY;
  } catch (const std::exception& error) {
    say(diagnostic, "internal error: %s", error.what());
    return LICHEN_ERROR_INTERNAL;
  } catch (...) {
    say(diagnostic, "internal error");
    return LICHEN_ERROR_INTERNAL;
  }
}

} // namespace lichen::plugin
