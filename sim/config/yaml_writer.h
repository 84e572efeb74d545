// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <charconv>
#include <string>
#include <string_view>

#include "sim/base/check.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::sim {

/// Writes a struct as a YAML map, through the same Visit that reads it: reading what was written
/// gives the same struct, with every default spelled out. Optional values that are absent are left
/// out. Numbers are the shortest that read back to the same bits.
class YamlWriter {
 public:
  template <class T>
  void operator()(std::string_view key, const T& value) {
    if constexpr (internal::kIsOptional<T>) {
      if (!value) return;
    }
    emitter_ << YAML::Key << std::string(key) << YAML::Value;
    Write(value);
  }
  template <class T>
  void Required(std::string_view key, const T& value) {
    (*this)(key, value);
  }

  template <class T>
  void Write(const T& value);
  std::string text() const { return std::string(emitter_.c_str()) + "\n"; }

 private:
  template <class T>
  void WriteScalar(const T& value);
  template <class T>
  void WriteList(const T& values);
  template <class T>
  void WriteCompound(const T& value);

  YAML::Emitter emitter_;
};

template <class T>
void YamlWriter::WriteScalar(const T& value) {
  if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, std::string>) {
    emitter_ << value;
  } else if constexpr (std::is_enum_v<T>) {
    emitter_ << std::string(NameOf(value));
  } else {
    std::array<char, 64> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    BULLETNAV_CHECK(error == std::errc());
    emitter_ << std::string(digits.data(), end);
  }
}

/// Numbers and words in one line, all else a line each.
template <class T>
void YamlWriter::WriteList(const T& values) {
  using Item = typename T::value_type;
  constexpr bool kIsShort = std::is_arithmetic_v<Item> || std::is_enum_v<Item>;
  // Said twice, all that follows would be in one line.
  if (kIsShort || values.empty()) emitter_ << YAML::Flow;
  emitter_ << YAML::BeginSeq;
  for (const auto& item : values) Write(static_cast<const Item&>(item));
  emitter_ << YAML::EndSeq;
}

template <class T>
void YamlWriter::Write(const T& value) {
  if constexpr (std::is_same_v<T, YamlNode>) {
    emitter_ << value.yaml();
  } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T> ||
                       std::is_same_v<T, std::string>) {
    WriteScalar(value);
  } else {
    WriteCompound(value);
  }
}

template <class T>
void YamlWriter::WriteCompound(const T& value) {
  if constexpr (internal::kIsOptional<T>) {
    BULLETNAV_CHECK(value.has_value());
    Write(*value);
  } else if constexpr (internal::kIsVector<T> || internal::kIsArray<T>) {
    WriteList(value);
  } else if constexpr (internal::kIsMap<T>) {
    emitter_ << YAML::BeginMap;
    for (const auto& [key, item] : value) (*this)(key, item);
    emitter_ << YAML::EndMap;
  } else if constexpr (requires { value.ToYaml(); }) {
    emitter_ << YAML::Load(value.ToYaml());
  } else {
    emitter_ << YAML::BeginMap;
    T copy = value;  // a Visit may change what it visits
    copy.Visit(*this);
    emitter_ << YAML::EndMap;
  }
}

/// The struct as YAML text.
template <class T>
std::string ToYaml(const T& value) {
  YamlWriter writer;
  writer.Write(value);
  return writer.text();
}

}  // namespace bulletnav::sim
