// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace bulletnav::python {

/// The files of a module that has been imported and of all that is loaded from its package, or from
/// its folder if it is in no package and in no site-packages: what may act in it. Its own first,
/// then in alphabetical order; none if it has no file. The lock must be held.
std::vector<std::filesystem::path> ModuleSources(const std::string& module);

}  // namespace bulletnav::python
