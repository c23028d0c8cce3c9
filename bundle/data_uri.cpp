// SPDX-License-Identifier: MIT
// Four digits -> three bytes; see data_uri.h.
#include "data_uri.h"

#include <cstdint>
#include <string_view>

namespace lichen {
namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::optional<std::vector<std::byte>> decodeBase64(std::string_view text) {
  for (int padding = 0; padding < 2 && text.ends_with('='); ++padding)
    text.remove_suffix(1);
  if (text.size() % 4 == 1)
    return std::nullopt;
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  unsigned bitCount = 0;
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos)
      return std::nullopt;
    bits = bits << 6u | std::uint32_t(digit);
    bitCount += 6;
    if (bitCount >= 8) {
      bitCount -= 8;
      bytes.push_back(std::byte(bits >> bitCount & 0xffu));
    }
  }
  return bytes;
}

} // namespace

bool isDataUri(const std::string& uri) { return uri.starts_with("data:"); }

Result<std::vector<std::byte>> readDataUri(const std::string& uri) {
  constexpr std::string_view kMarker = ";base64,";
  const std::size_t marker = uri.find(kMarker);
  std::optional<std::vector<std::byte>> bytes;
  if (marker != std::string::npos)
    bytes = decodeBase64(std::string_view(uri).substr(marker + kMarker.size()));
  if (!bytes)
    return Error{ErrorKind::badInput, "data URI with invalid base64"};
  return std::move(*bytes);
}

} // namespace lichen
