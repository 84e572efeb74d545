// SPDX-License-Identifier: MIT
#pragma once

namespace bulletnav::bench {

/// Runs this process's command line in the program bulletnav-learn beside this one instead. Loading
/// torch takes half a second and 150 MB, which most commands have no use for. Throws
/// sim::FileError.
[[noreturn]] void HandOverToLearn();

}  // namespace bulletnav::bench
