// SPDX-License-Identifier: MIT
#pragma once

namespace bulletnav::sim {

/// Allows this process that many seconds of processor time in all; then the system ends it.
void LimitCpuSeconds(int seconds);

/// Called by work that finds more to do: allows that many seconds more. Does nothing where there is
/// no limit.
void AllowCpuSeconds(int more);

}  // namespace bulletnav::sim
