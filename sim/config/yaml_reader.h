// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "sim/base/error.h"
#include "sim/config/enum_names.h"

namespace bulletnav::sim {

/// A node together with the file it came from, so that every complaint can say where.
class YamlNode {
 public:
  YamlNode(const YAML::Node& node, std::filesystem::path file);

  const YAML::Node& yaml() const { return node_; }
  YamlNode Child(const YAML::Node& node) const { return {node, file_}; }
  /// Throws FileError at this node's file:line:column.
  [[noreturn]] void Fail(const std::string& what) const;
  /// As Fail, at the value of this map's `key`; at the map itself where it has no such key.
  [[noreturn]] void FailAt(std::string_view key, const std::string& what) const;

  bool ToBool() const;
  std::int64_t ToInt(std::int64_t low, std::int64_t high) const;
  double ToDouble() const;
  std::string ToString() const;
  void ExpectSequence(std::optional<std::size_t> size) const;
  void ExpectMap() const;

 private:
  YAML::Node node_;
  std::filesystem::path file_;
};

/// What a struct's Validate throws when it knows which of its keys is to blame.
class KeyError : public Error {
 public:
  KeyError(std::string key, const std::string& what) : Error(what), key_(std::move(key)) {}
  const std::string& key() const { return key_; }

 private:
  std::string key_;
};

/// Fills a struct from a YAML map. The struct lists its keys once:
///   struct Foo { double width_m = 1; template <class V> void Visit(V& v) { v("width_m", width_m);
///   } };
/// Unknown, duplicate, missing-required and wrong-type keys are errors at the key's line; an
/// unknown key is answered with the nearest known one, before anything is called missing. Values
/// not named keep their in-class default. A type that is no map has, in place of Visit, a function
/// `void ReadYaml(const YamlNode&, T&)` in its namespace and, to be written, a member `ToYaml()`. A
/// member of type std::optional<YamlNode> takes any content, for others to read.
class YamlReader {
 public:
  explicit YamlReader(const YamlNode& map);

  template <class T>
  void operator()(std::string_view key, T& value) {
    if (const std::optional<YamlNode> node = Take(key)) Read(*node, value);
  }
  template <class T>
  void Required(std::string_view key, T& value) {
    if (const std::optional<YamlNode> node = Take(key)) {
      Read(*node, value);
    } else if (missing_.empty()) {
      missing_ = key;
    }
  }
  /// Throws at the first key that nobody asked for, else if a required key is missing.
  void Finish() const;

  template <class T>
  static void Read(const YamlNode& node, T& value);

 private:
  template <class T>
  static void ReadMap(const YamlNode& node, T& value);
  template <class T>
  static void ReadStruct(const YamlNode& node, T& value);
  template <class T>
  static void ReadOptional(const YamlNode& node, std::optional<T>& value);
  std::optional<YamlNode> Take(std::string_view key);

  YamlNode map_;
  std::vector<std::string> known_;
  /// The first required key that the map lacks.
  std::string missing_;
};

namespace internal {

template <class T>
inline constexpr bool kIsVector = false;
template <class T>
inline constexpr bool kIsVector<std::vector<T>> = true;
template <class T>
inline constexpr bool kIsArray = false;
template <class T, std::size_t n>
inline constexpr bool kIsArray<std::array<T, n>> = true;
template <class T>
inline constexpr bool kIsMap = false;
template <class T>
inline constexpr bool kIsMap<std::map<std::string, T>> = true;
template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

template <class E>
void ReadEnum(const YamlNode& node, E& value) {
  const std::string text = node.ToString();
  std::string known;
  for (const auto& [name, enumerator] : EnumNames<E>::kNames) {
    if (text == name) {
      value = enumerator;
      return;
    }
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  node.Fail("'" + text + "' is not one of: " + known);
}

template <class T>
void ReadInteger(const YamlNode& node, T& value) {
  using Limits = std::numeric_limits<T>;
  constexpr auto kHigh = sizeof(T) < 8 ? static_cast<std::int64_t>(Limits::max())
                                       : std::numeric_limits<std::int64_t>::max();
  value = static_cast<T>(node.ToInt(static_cast<std::int64_t>(Limits::min()), kHigh));
}

template <class T>
void ReadScalar(const YamlNode& node, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    value = node.ToBool();
  } else if constexpr (std::is_enum_v<T>) {
    ReadEnum(node, value);
  } else if constexpr (std::is_integral_v<T>) {
    ReadInteger(node, value);
  } else if constexpr (std::is_floating_point_v<T>) {
    value = static_cast<T>(node.ToDouble());
  } else {
    value = node.ToString();
  }
}

}  // namespace internal

template <class T>
void YamlReader::ReadOptional(const YamlNode& node, std::optional<T>& value) {
  if constexpr (std::is_same_v<T, YamlNode>) {
    value.emplace(node);
  } else {
    Read(node, value.emplace());
  }
}

template <class T>
void YamlReader::Read(const YamlNode& node, T& value) {
  if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, std::string>) {
    internal::ReadScalar(node, value);
  } else if constexpr (internal::kIsOptional<T>) {
    ReadOptional(node, value);
  } else if constexpr (internal::kIsVector<T>) {
    node.ExpectSequence(std::nullopt);
    value.clear();
    for (const YAML::Node& item : node.yaml()) Read(node.Child(item), value.emplace_back());
  } else if constexpr (internal::kIsArray<T>) {
    node.ExpectSequence(value.size());
    for (std::size_t i = 0; i < value.size(); ++i) Read(node.Child(node.yaml()[i]), value[i]);
  } else if constexpr (internal::kIsMap<T>) {
    ReadMap(node, value);
  } else if constexpr (requires { ReadYaml(node, value); }) {
    ReadYaml(node, value);
  } else {
    ReadStruct(node, value);
  }
}

template <class T>
void YamlReader::ReadMap(const YamlNode& node, T& value) {
  node.ExpectMap();
  value.clear();
  for (const auto& item : node.yaml()) {
    const std::string key = node.Child(item.first).ToString();
    const auto [place, is_new] = value.try_emplace(key);
    if (!is_new) node.Child(item.first).Fail("key '" + key + "' is given twice");
    Read(node.Child(item.second), place->second);
  }
}

template <class T>
void YamlReader::ReadStruct(const YamlNode& node, T& value) {
  YamlReader reader(node);
  value.Visit(reader);
  reader.Finish();
  if constexpr (requires { value.Validate(); }) {
    try {
      value.Validate();
    } catch (const FileError&) {
      throw;
    } catch (const KeyError& e) {
      node.FailAt(e.key(), e.what());
    } catch (const Error& e) {
      node.Fail(e.what());
    }
  }
}

/// The YAML of `text`; `name` stands for it in errors. Throws FileError on bad syntax.
YamlNode ParseYaml(const std::string& text, const std::filesystem::path& name);

template <class T>
T LoadYamlText(const std::string& text, const std::filesystem::path& name) {
  T value;
  YamlReader::Read(ParseYaml(text, name), value);
  return value;
}

/// Reads a block that may be absent or empty, which leaves a T as it is by default.
template <class T>
T ReadBlock(const std::optional<YamlNode>& block) {
  T value;
  if (block && !block->yaml().IsNull()) YamlReader::Read(*block, value);
  return value;
}

/// Reads `file` into a T. Throws FileError.
template <class T>
T LoadYaml(const std::filesystem::path& file);

/// The member of `known` with the fewest edits from `word`; empty if none is near.
std::string NearestWord(std::string_view word, const std::vector<std::string>& known);

std::string ReadYamlFile(const std::filesystem::path& file);

template <class T>
T LoadYaml(const std::filesystem::path& file) {
  return LoadYamlText<T>(ReadYamlFile(file), file);
}

}  // namespace bulletnav::sim
