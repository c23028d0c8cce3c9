// SPDX-License-Identifier: MIT
// Mutates scenes for libFuzzer: half of the time a JSON value, so that the file stays valid glTF;
// else bytes of the binary chunk or of the whole file.
#include "bundle/gltf_container.h"
#include "mutation.h"

#include <lichen/gltf_files.h>

#include <algorithm>
#include <cstdint>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using namespace lichen;
using namespace lichen::fuzz;

Bytes dumped(const GltfContainer& container, const Bytes& binary) {
  constexpr auto kReplace = nlohmann::json::error_handler_t::replace; // text may be invalid UTF-8
  const std::string text = container.document.dump(-1, ' ', false, kReplace);
  if (container.isGlb)
    return frameGlb(text, binary, container.otherChunks);
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed) {
  Random random(seed);
  const std::span<const std::byte> file(reinterpret_cast<const std::byte*>(data), size);
  std::variant<GltfContainer, Finding> opened = openGltf(file);
  auto* container = std::get_if<GltfContainer>(&opened);
  constexpr std::size_t kRawOneIn = 8;
  if (!container || below(random, kRawOneIn) == 0)
    return LLVMFuzzerMutate(data, size, most);

  const std::span<const std::byte> chunk = container->binaryChunk.value_or(file.first(0));
  Bytes binary(chunk.begin(), chunk.end());
  if (!binary.empty() && below(random, 3) == 0) {
    const std::size_t bytes = binary.size();
    binary.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(binary.data()), bytes, bytes));
    binary.resize(bytes); // bufferViews still fit
  } else {
    mutateJson(container->document, random);
  }
  const Bytes changed = dumped(*container, binary);
  if (changed.size() > most)
    return LLVMFuzzerMutate(data, size, most);
  std::transform(changed.begin(), changed.end(), data,
                 [](std::byte b) { return std::to_integer<std::uint8_t>(b); });
  return changed.size();
}
