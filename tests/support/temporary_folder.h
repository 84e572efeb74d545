// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string_view>

#include "sim/base/temporary_folder.h"

namespace bulletnav::tests {

/// An empty folder that goes away with the object.
class TemporaryFolder : public sim::TemporaryFolder {
 public:
  /// A file in the folder with this content.
  std::filesystem::path Write(std::string_view name, std::string_view content) const;
};

}  // namespace bulletnav::tests
