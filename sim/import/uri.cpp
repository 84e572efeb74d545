// SPDX-License-Identifier: MIT
#include "sim/import/uri.h"

#include <array>
#include <cctype>

namespace bulletnav::sim {
namespace {

namespace fs = std::filesystem;

int HexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

std::optional<std::vector<std::uint8_t>> DecodeBase64(std::string_view text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<int, 256> value_of_digit = {};
  value_of_digit.fill(-1);
  for (std::size_t i = 0; i < kDigits.size(); ++i) {
    value_of_digit[static_cast<unsigned char>(kDigits[i])] = static_cast<int>(i);
  }
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('='))) {
    const int value = value_of_digit[static_cast<unsigned char>(c)];
    if (value < 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> count));
  }
  return bytes;
}

bool IsFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

}  // namespace

std::string DecodePercents(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int high = i + 2 < text.size() ? HexDigit(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? HexDigit(text[i + 2]) : -1;
    if (text[i] == '%' && high >= 0 && low >= 0) {
      out += static_cast<char>(16 * high + low);
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

std::optional<std::vector<std::uint8_t>> DecodeDataUri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const std::string_view data = uri.substr(comma + 1);
  if (uri.substr(0, comma).ends_with(";base64")) return DecodeBase64(data);
  return std::vector<std::uint8_t>(data.begin(), data.end());
}

std::optional<fs::path> FindByUri(const fs::path& folder, std::string_view uri) {
  if (uri.find('\0') != std::string_view::npos) return std::nullopt;
  if (const fs::path path = folder / uri; IsFile(path)) return path;
  const std::string decoded = DecodePercents(uri);
  if (decoded.find('\0') != std::string::npos) return std::nullopt;
  if (const fs::path path = folder / decoded; IsFile(path)) return path;
  return std::nullopt;
}

}  // namespace bulletnav::sim
