// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bulletnav::sim {

/// "my%20wood.png" -> "my wood.png".
std::string DecodePercents(std::string_view text);

/// What a URI beginning with "data:" holds, in base64 or as it stands. Nothing if it cannot be
/// decoded. Source: RFC 2397.
std::optional<std::vector<std::uint8_t>> DecodeDataUri(std::string_view uri);

/// The regular file in `folder` (empty: the current one) that `uri` names, as it stands or with its
/// percent codes read, if there is one.
std::optional<std::filesystem::path> FindByUri(const std::filesystem::path& folder,
                                               std::string_view uri);

}  // namespace bulletnav::sim
