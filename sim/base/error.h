// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>

namespace bulletnav::sim {

/// What a user can mend: a file, a config, a flag, a pose. The message is one line that names the
/// file, the place in it, what is wrong and the remedy. Our own bugs end the program instead, see
/// check.h.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Bad content of a file. `place` is a line:column, a JSON path, an element name, or empty.
class FileError : public Error {
 public:
  FileError(const std::filesystem::path& file, const std::string& place, const std::string& what);
};

/// A body pose that physics cannot accept: inside geometry, outside the scene, above no floor.
class PoseError : public Error {
 public:
  using Error::Error;
};

/// No usable renderer: no EGL device, a lost context, an unsupported size.
class RenderError : public Error {
 public:
  using Error::Error;
};

}  // namespace bulletnav::sim
