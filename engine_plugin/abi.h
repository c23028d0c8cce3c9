// SPDX-License-Identifier: MIT
// What every function of the C interface does at its boundary: read and write structs of older and
// newer headers, write diagnostics, keep exceptions in.
#pragma once

#include <lichen/lichen.h>

#include <algorithm>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>

namespace lichen::plugin {

/// Writes one line into the host's diagnostic, cut where it does not fit.
[[gnu::format(printf, 2, 3)]] inline void say(LichenDiagnostic* diagnostic, const char* format,
                                              ...) {
  if (diagnostic == nullptr || diagnostic->type != LICHEN_STRUCTURE_DIAGNOSTIC ||
      diagnostic->size <= offsetof(LichenDiagnostic, text) || diagnostic->next != nullptr)
    return;
  std::va_list arguments;
  va_start(arguments, format);
  const std::size_t capacity = std::min<std::size_t>(
      diagnostic->size - offsetof(LichenDiagnostic, text), sizeof diagnostic->text);
  std::vsnprintf(diagnostic->text, capacity, format, arguments);
  va_end(arguments);
}

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
