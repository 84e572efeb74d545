// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::python {

/// Reads a call's keyword arguments, as YAML or JSON, into a T. Throws sim::Error with what is
/// wrong, without lines and columns of a text that the caller has never seen.
template <class T>
T ReadArguments(const std::string& text) try {
  return sim::LoadYamlText<T>(text, "arguments");
} catch (const sim::FileError& e) {
  const std::string message = e.what();
  const std::size_t place = message.find(": ");
  if (!message.starts_with("arguments:") || place == std::string::npos) throw;
  throw sim::Error(message.substr(place + 2));
}

}  // namespace bulletnav::python
