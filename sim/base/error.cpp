// SPDX-License-Identifier: MIT
#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

/// One line whatever a library's message or a strange file name contains.
std::string OneLine(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  }
  return text;
}

}  // namespace

FileError::FileError(const std::filesystem::path& file, const std::string& place,
                     const std::string& what)
    : Error(OneLine((file.empty() ? "an empty path" : file.string()) + ":" +
                    (place.empty() ? "" : place + ":") + " " + what)) {}

}  // namespace bulletnav::sim
