// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>

namespace bulletnav::bench {

/// Takes a line that warns the user.
using Warn = std::function<void(const std::string& line)>;

/// "bulletnav: warning: ..." on standard error.
void WarnLine(const std::string& what);

}  // namespace bulletnav::bench
