// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/config/enum_names.h"

namespace bulletnav::sim {

/// JSON whose numbers are floats: written as the shortest text that reads back as the same float.
using FloatJson = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool,
                                       std::int64_t, std::uint64_t, float>;

/// Parses JSON text. Throws FileError with line:column and, for text that is cut off, holds NaN or
/// nests too deeply, what to do, which is `remedy` if that is given. `first_line`: the file's line
/// that `text` starts at. Json: FloatJson or nlohmann::ordered_json.
template <class Json>
Json ParseJson(std::string_view text, const std::filesystem::path& file, int first_line = 1,
               const std::string& remedy = "");

/// A value in a JSON document that knows where it came from, so that every complaint can say so:
/// "file: what it belongs to: place: trouble; remedy", as in "x.json: episode '12':
/// goals[0].radius: ...". Keys that nobody asks for are no error. The document must outlive the
/// node. All readers throw FileError.
template <class Json>
class JsonNode {
 public:
  using Float = typename Json::number_float_t;

  /// `owner`: what the value belongs to, such as "episode '12'"; it and the remedy may be empty.
  JsonNode(const Json& value, std::filesystem::path file, std::string owner = "",
           std::string remedy = "");

  const Json& value() const { return *value_; }
  [[noreturn]] void Fail(std::string_view what) const;

  /// Member of an object. Fails if it is missing or this is no object.
  JsonNode At(const char* key) const;
  bool Has(const char* key) const { return value_->is_object() && value_->contains(key); }
  bool IsNull() const { return value_->is_null(); }
  /// Item of a list. Expects: in range (checked by nlohmann).
  JsonNode Item(std::size_t i) const;
  /// A list of this length.
  void ExpectList(std::size_t size) const;
  /// Length of a list of at least `least` items.
  std::size_t Size(std::size_t least = 0) const;

  /// Finite numbers only.
  Float Number() const;
  Float Positive() const;
  bool Truth() const;
  /// A whole number from 0 to `most`.
  std::uint64_t Whole(std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) const;
  /// A whole number below `count`: the index of one of the file's `things`.
  int Index(std::size_t count, std::string_view things) const;
  std::string Text() const;
  template <class E>
  E Enum() const;

 private:
  struct Source {
    std::filesystem::path file;
    std::string owner;
    std::string remedy;
  };
  JsonNode(std::shared_ptr<const Source> source, const Json& value, std::string place)
      : source_(std::move(source)), value_(&value), place_(std::move(place)) {}

  std::shared_ptr<const Source> source_;
  const Json* value_;
  std::string place_;
};

template <class Json>
template <class E>
E JsonNode<Json>::Enum() const {
  const std::string text = Text();
  std::string known;
  for (const auto& [name, enumerator] : EnumNames<E>::kNames) {
    if (text == name) return enumerator;
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  Fail("'" + text + "' is not one of: " + known);
}

}  // namespace bulletnav::sim
