// SPDX-License-Identifier: MIT
// Validates the renderer's embedded shaders with SPIRV-Tools: a driver may accept invalid SPIR-V
// that another one rejects or renders differently.
#include <catch2/catch.hpp>

#include <cstdint>
#include <renderer_shader_list.h>
#include <span>
#include <spirv-tools/libspirv.hpp>
#include <string>
#include <utility>

namespace {

/// The validator's messages for a module; empty if it is valid.
std::string faultsOf(std::span<const std::uint32_t> module) {
  std::string faults;
  spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_0);
  tools.SetMessageConsumer(
      [&](spv_message_level_t, const char*, const spv_position_t& position, const char* text) {
        faults += "word " + std::to_string(position.index) + ": " + text + "\n";
      });
  const bool isValid = tools.Validate(module.data(), module.size());
  return isValid ? std::string() : faults + "invalid";
}

} // namespace

TEST_CASE("every shader that the renderer embeds is valid SPIR-V for Vulkan 1.0") {
  for (const auto& [name, module] : kRendererShaders) {
    INFO(name);
    CHECK(faultsOf(module) == "");
  }
  CHECK(std::size(kRendererShaders) > 1);
}
