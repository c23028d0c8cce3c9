// SPDX-License-Identifier: MIT
// Creates pipelines of smaller shaders. Mesa 22's lavapipe inlines all code of a shader before it
// removes what specialization constants leave out, in a time that grows with the square of the
// code's length: creating pipelines took most of the time of the tests.
#pragma once

namespace lichen::test {

/// From now on, pipelines are created with shaders whose specialization constants are frozen and
/// whose branches that are never taken are gone. What runs still computes the same. Call it
/// after each creation of a device, which loads Vulkan's functions anew. Does nothing in a build
/// without SPIRV-Tools.
void freezeConstants();

} // namespace lichen::test
