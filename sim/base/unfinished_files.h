// SPDX-License-Identifier: MIT
#pragma once

namespace bulletnav::sim {

/// Removes the temporary files that WriteFileAtomically is writing now, in any thread. For a
/// process that is about to end: those calls fail.
void RemoveUnfinishedFiles();

}  // namespace bulletnav::sim
