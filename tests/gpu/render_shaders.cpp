// SPDX-License-Identifier: MIT
// The renderer's own shaders as the build embeds them, looked at by SPIRV-Tools: a driver may draw
// with invalid SPIR-V, and another one refuses it or draws something else.
#include <catch2/catch.hpp>

#include <cstdint>
#include <renderer_shader_list.h>
#include <span>
#include <spirv-tools/libspirv.hpp>
#include <string>
#include <utility>
#include <vector>

namespace {

/// What the validator says against a module; empty of a valid one.
std::string faultsOf(std::span<const std::uint32_t> module) {
  std::string faults;
  spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_0);
  tools.SetMessageConsumer(
      [&](spv_message_level_t, const char*, const spv_position_t& place, const char* text) {
        faults += "word " + std::to_string(place.index) + ": " + text + "\n";
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

TEST_CASE("a shader with a word out of place is found to be invalid") {
  const std::span<const std::uint32_t> sound = kRendererShaders[0].second;
  std::vector<std::uint32_t> broken(sound.begin(), sound.end());
  constexpr std::size_t kBound = 3; // word of the header: all ids are below it
  broken[kBound] = 2;
  CHECK(faultsOf(broken) != "");
}
