// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/scene/import.h"

namespace bulletnav::sim {

/// ImportScene and the program `bulletnav-import`, which reads the mesh for it, understand each
/// other by these. The program is called with ToArguments' texts and writes one ImportAnswer into
/// its standard output, which is a file. To be raised with every change of either, or of the blob.
inline constexpr const char* kImportProtocol = "2";

std::vector<std::string> ToArguments(const std::filesystem::path& file,
                                     const ImportOptions& options);

struct ImportRequest {
  std::filesystem::path file;
  ImportOptions options;
};
/// Of what follows the program's name. Throws Error if another version wrote it.
ImportRequest FromArguments(std::span<const char* const> arguments);

/// How reading ended; the last byte of the answer. Without one, the program did not come to its
/// end.
enum class ImportEnd : std::uint8_t {
  kScene = 'S',    // before it: the scene's blob
  kError = 'E',    // before it: the exception's text
  kTooLarge = 'M'  // it ran out of the memory allowed
};

/// Where the program is: beside the program or shared library that holds this code, in
/// ../libexec/bulletnav from there, in the build folder that this is in, where it was built as a
/// part of another project, where it was installed. Throws Error naming the first place if it is
/// nowhere.
std::filesystem::path ImportProgram();

}  // namespace bulletnav::sim
