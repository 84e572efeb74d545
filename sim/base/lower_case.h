// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace bulletnav::sim {

/// With A to Z as a to z, whatever the locale; all other bytes stay.
inline std::string LowerCase(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

}  // namespace bulletnav::sim
