// SPDX-License-Identifier: MIT
// Where this checkout and its build are. Only checkout_paths.cpp is compiled with their absolute
// paths, so that a compiler cache serves every other file to a checkout in another folder.
#pragma once

#include <string>
#include <string_view>

namespace lichen {

/// The absolute path of a file of the checkout, such as "docs/cli.md".
std::string sourcePath(std::string_view relative);
/// The absolute path of a program of this build, such as "lichen-render".
std::string programPath(std::string_view name);

} // namespace lichen
