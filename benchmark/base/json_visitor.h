// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <nlohmann/json.hpp>

namespace bulletnav::bench {

/// Turns a struct that lists its members (`template <class V> void Visit(V&)`) into JSON, keys in
/// their order. An absent value is null. Who includes this links nlohmann_json.
class JsonVisitor {
 public:
  using Json = nlohmann::ordered_json;

  template <class T>
  void operator()(const char* key, T& value) {
    json_[key] = ToJson(value);
  }
  template <class T>
  static Json ToJson(T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
      return value;
    } else {
      JsonVisitor visitor;
      value.Visit(visitor);
      return visitor.json_;
    }
  }
  template <class T>
  static Json ToJson(std::optional<T>& value) {
    return value ? ToJson(*value) : Json();
  }
  template <class T>
  static Json ToJson(std::vector<T>& values) {
    Json list = Json::array();
    for (T& value : values) list.push_back(ToJson(value));
    return list;
  }
  template <class T>
  static Json ToJson(std::map<std::string, T>& values) {
    Json object = Json::object();
    for (auto& [name, value] : values) object[name] = ToJson(value);
    return object;
  }

 private:
  Json json_ = Json::object();
};

}  // namespace bulletnav::bench
