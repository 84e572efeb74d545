// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string_view>

#include "sim/config/json_node.h"

namespace bulletnav::bench {

using Json = nlohmann::ordered_json;  // keeps the order of keys; numbers are doubles
using JsonCursor = sim::JsonNode<Json>;

/// See sim::ParseJson.
inline Json ParseJson(std::string_view text, const std::filesystem::path& file,
                      int first_line = 1) {
  return sim::ParseJson<Json>(text, file, first_line);
}

}  // namespace bulletnav::bench
