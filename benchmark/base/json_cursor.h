// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace bulletnav::bench {

using Json = nlohmann::ordered_json;  // keeps the order of keys

/// A value inside a JSON document that knows where it came from, so that every complaint can say
/// so: "file: what it belongs to: place: trouble", as in "x.json: episode '12': goals[0].radius:
/// ...". The document must outlive it. All readers throw sim::FileError.
class JsonCursor {
 public:
  /// `owner`: what the value belongs to, such as "episode '12'"; may be empty.
  JsonCursor(const Json& value, std::filesystem::path file, std::string owner)
      : JsonCursor(value, std::move(file), std::move(owner), "") {}

  const Json& value() const { return value_; }
  [[noreturn]] void Fail(std::string_view what) const;

  /// Member of an object. Fails if it is missing or this is no object.
  JsonCursor At(const char* key) const;
  /// Element of an array. Expects: in range (checked by nlohmann).
  JsonCursor Item(std::size_t i) const;
  bool Has(const char* key) const { return value_.is_object() && value_.contains(key); }

  /// Finite numbers only.
  double Number() const;
  std::string Text() const;
  /// A list; with its length, if that is given.
  void ExpectList(std::size_t size) const;
  void ExpectList() const;

 private:
  JsonCursor(const Json& value, std::filesystem::path file, std::string owner, std::string place)
      : value_(value), file_(std::move(file)), owner_(std::move(owner)), place_(std::move(place)) {}

  const Json& value_;
  std::filesystem::path file_;
  std::string owner_;
  std::string place_;
};

/// Parses JSON text. Throws sim::FileError with line:column and, for text that is cut off, holds
/// NaN or nests too deeply, the remedy. `first_line`: the file's line that `text` starts at.
Json ParseJson(std::string_view text, const std::filesystem::path& file, int first_line = 1);

}  // namespace bulletnav::bench
