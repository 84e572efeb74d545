// SPDX-License-Identifier: MIT
#include "benchmark/base/json_cursor.h"

#include <algorithm>
#include <cmath>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using sim::FileError;

constexpr int kDeepest = 64;

std::string LineAndColumn(std::string_view text, std::size_t byte, int first_line) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto line = first_line + std::count(before.begin(), before.end(), '\n');
  const std::size_t last = before.rfind('\n');
  const std::size_t column = before.size() - (last == std::string_view::npos ? 0 : last + 1) + 1;
  return std::to_string(line) + ":" + std::to_string(column);
}

bool StartsLikeNan(std::string_view text) {
  return text.starts_with("NaN") || text.starts_with("Infinity") || text.starts_with("-Infinity");
}

std::string WhyBad(std::string_view text, std::size_t byte) {
  if (byte >= text.size()) return "the JSON ends too early: the file is cut off; copy it again";
  // The parser stops inside of a word that it cannot make sense of.
  const std::size_t from = byte > 2 ? byte - 2 : 0;
  for (std::size_t i = from; i <= byte; ++i) {
    if (StartsLikeNan(text.substr(i))) return "NaN and infinity are not numbers of JSON; mend it";
  }
  return "not valid JSON; mend it or take a sound copy of the file";
}

}  // namespace

void JsonCursor::Fail(std::string_view what) const {
  std::string place = owner_.empty() ? "" : " " + owner_;
  if (!place_.empty()) place += (place.empty() ? " " : ": ") + place_;
  throw FileError(file_, place, std::string(what));
}

JsonCursor JsonCursor::At(const char* key) const {
  if (!value_.is_object()) Fail("expected an object here");
  const auto found = value_.find(key);
  if (found == value_.end()) Fail("'" + std::string(key) + "' is missing");
  return {*found, file_, owner_, place_.empty() ? key : place_ + "." + key};
}

JsonCursor JsonCursor::Item(std::size_t i) const {
  return {value_.at(i), file_, owner_, place_ + "[" + std::to_string(i) + "]"};
}

double JsonCursor::Number() const {
  if (!value_.is_number()) Fail("expected a number here");
  const auto number = value_.get<double>();
  if (!std::isfinite(number)) Fail("expected a finite number here");
  return number;
}

std::string JsonCursor::Text() const {
  if (!value_.is_string()) Fail("expected a text here");
  return value_.get<std::string>();
}

void JsonCursor::ExpectList() const {
  if (!value_.is_array()) Fail("expected a list here");
}

void JsonCursor::ExpectList(std::size_t size) const {
  ExpectList();
  if (value_.size() != size) {
    Fail("expected a list of " + std::to_string(size) + ", got " + std::to_string(value_.size()));
  }
}

Json ParseJson(std::string_view text, const std::filesystem::path& file, int first_line) {
  const auto limit_depth = [&](int depth, Json::parse_event_t /*event*/, Json& /*parsed*/) {
    if (depth > kDeepest) throw FileError(file, "", "nests more than 64 levels deep");
    return true;
  };
  try {
    return Json::parse(text, limit_depth);
  } catch (const Json::parse_error& e) {
    const std::size_t byte = e.byte > 0 ? e.byte - 1 : 0;
    throw FileError(file, LineAndColumn(text, byte, first_line), WhyBad(text, byte));
  } catch (const Json::exception&) {
    throw FileError(file, "", "holds a number too large for this program; mend it");
  }
}

}  // namespace bulletnav::bench
