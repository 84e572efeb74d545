// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/config/yaml_reader.h"

namespace bulletnav::sim {

/// JSON whose numbers are floats: written as the shortest text that reads back as the same float.
using FloatJson = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool,
                                       std::int64_t, std::uint64_t, float>;

/// A JSON value together with its file and its place in it ("rooms[2].polygon"), so that every
/// complaint can say where. All readers throw FileError, which ends with the file's remedy.
class JsonNode {
 public:
  /// Parses `text`; `file` stands for it in errors and `remedy` ends them.
  static JsonNode Parse(const std::string& text, const std::filesystem::path& file,
                        const std::string& remedy);

  [[noreturn]] void Fail(const std::string& what) const;

  /// Member of an object. Keys that nobody asks for are no error.
  JsonNode operator[](std::string_view key) const;
  /// Item of a list.
  JsonNode operator[](std::size_t i) const;
  /// Length of a list of at least `least` items.
  std::size_t size(std::size_t least = 0) const;

  bool IsNull() const { return json_->is_null(); }
  float ToFloat() const;
  float ToPositive() const;
  bool ToBool() const;
  std::uint64_t ToUint() const;
  /// A whole number below `count`: the index of one of the file's `things`.
  int ToIndex(std::size_t count, std::string_view things) const;
  std::string ToString() const;
  template <class E>
  E ToEnum() const;

 private:
  struct Source {
    std::filesystem::path file;
    std::string remedy;
    FloatJson root;
  };
  JsonNode(std::shared_ptr<const Source> source, const FloatJson* json, std::string place);

  std::shared_ptr<const Source> source_;  // what json_ points into
  const FloatJson* json_;
  std::string place_;
};

template <class E>
E JsonNode::ToEnum() const {
  const std::string text = ToString();
  std::string known;
  for (const auto& [name, enumerator] : EnumNames<E>::kNames) {
    if (text == name) return enumerator;
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  Fail("'" + text + "' is not one of: " + known);
}

}  // namespace bulletnav::sim
