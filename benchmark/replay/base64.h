// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace bulletnav::bench {

/// With padding, on one line. Source: RFC 4648, section 4.
std::string Base64(std::span<const std::uint8_t> bytes);

}  // namespace bulletnav::bench
