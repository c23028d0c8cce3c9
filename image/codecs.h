// SPDX-License-Identifier: MIT
// One decoder per format. They may throw std::bad_alloc, which decodeImage() catches; all other
// errors are in the Result. `file` starts with the format's signature.
#pragma once

#include <lichen/image_io.h>

namespace lichen {

[[nodiscard]] Result<ImageFile> decodePng(std::span<const std::byte> file, const std::string& name,
                                          const SizeCheck& check);
[[nodiscard]] Result<ImageFile> decodeJpeg(std::span<const std::byte> file, const std::string& name,
                                           const SizeCheck& check);
[[nodiscard]] Result<ImageFile> decodeExr(std::span<const std::byte> file, const std::string& name,
                                          const SizeCheck& check);

} // namespace lichen
