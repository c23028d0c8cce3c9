// SPDX-License-Identifier: MIT
// A glTF scene of a test -> its picture, on the test's own device. What the validation layers say
// fails the test.
#pragma once

#include "loaded_scene.h"
#include "pipelines.h"
#include "renderer.h"
#include "require_device.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace lichen::test {

inline VulkanDevice& testDevice() {
  static const std::unique_ptr<VulkanDevice> instance = requireDevice();
  return *instance;
}

/// The pipelines of all scenes that are drawn on it.
inline renderer::PipelineStore& testPipelines() {
  static renderer::PipelineStore store(testDevice());
  return store;
}

/// For the test's device.
inline renderer::RenderSettings settingsOf(std::uint32_t width, std::uint32_t height,
                                           std::uint32_t frames) {
  renderer::RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.frames = frames;
  static renderer::SkyCache skies; // most pictures have the same sun
  settings.skies = &skies;
  settings.pipelines = &testPipelines();
  return settings;
}

inline renderer::Picture renderPicture(std::span<const std::byte> glb,
                                       const renderer::RenderSettings& settings) {
  const TemporaryFolder folder;
  const auto scene = renderer::readScene(writeInto(folder, "scene.glb", glb));
  if (!scene)
    FAIL(scene.error().message);
  testDevice().messages().clear();
  auto picture = renderer::renderScene(testDevice(), scene.value(), settings);
  if (!picture)
    FAIL(picture.error().message);
  for (const std::string& text : testDevice().messages().texts())
    FAIL_CHECK(text);
  return std::move(picture).value();
}

/// Over all values.
inline double largestDifference(const LinearImage& a, const LinearImage& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    largest = std::max(largest, std::abs(double(a.values[i]) - double(b.values[i])));
  return largest;
}

inline LinearImage render(std::span<const std::byte> glb,
                          const renderer::RenderSettings& settings) {
  return renderPicture(glb, settings).pixels;
}

} // namespace lichen::test
