// SPDX-License-Identifier: MIT
// A cooked bundle: a bundle without its scene, in one file that is used where it is mapped.
//
//   byte 0   kCookedMagic
//        8   uint32: kCookedVersion
//       12   uint32: bytes of the description
//       16   the description, CBOR [RFC 8949]
//       ...  texels of each table, from a multiple of kCookedAlignment, in order; zeros between
//
// Integers are little-endian. The description is a glTF document of materials and the extension, in
// which `tables` have the members name, vkFormat, width, height, depth (0: 2-D), mipLevels and
// offset [bytes from the start of the file] in place of KTX2 files. So the same reader checks it.
#pragma once

#include "findings.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace lichen {

inline constexpr std::string_view kCookedMagic = "LICHEN\x1a\n";
inline constexpr std::uint32_t kCookedVersion = 1;
inline constexpr std::size_t kCookedHeaderBytes = 16;
inline constexpr std::size_t kCookedAlignment = 64;

[[nodiscard]] bool isCooked(std::span<const std::byte> file);

/// Reads and checks a cooked bundle. Its tables borrow their texels from `file`. Returns nothing if
/// the description cannot be read; the bundle is valid only if no error was recorded. Throws
/// std::bad_alloc.
[[nodiscard]] std::optional<Bundle> readCooked(std::span<const std::byte> file,
                                               FindingList& findings);

} // namespace lichen
