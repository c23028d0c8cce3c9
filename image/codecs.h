// SPDX-License-Identifier: MIT
// One decoder per format. Each may throw std::bad_alloc, which decodeImage() catches; everything
// else is a result. `file` begins with the format's signature.
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
