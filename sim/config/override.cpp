// SPDX-License-Identifier: MIT
#include "sim/config/override.h"

#include <charconv>
#include <optional>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

[[noreturn]] void Refuse(const std::string& override_text, const std::string& why) {
  throw Error("'" + override_text + "': " + why);
}

std::vector<std::string> Parts(const std::string& key, const std::string& whole) {
  std::vector<std::string> parts(1);
  for (const char c : key) {
    if (c == '.') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  for (const std::string& part : parts) {
    if (part.empty()) Refuse(whole, "a key is empty; write KEY=VALUE, as max_steps=100");
  }
  return parts;
}

/// The same value without marks: complaints would give them as lines of the file.
YAML::Node WithoutMarks(const YAML::Node& node) {
  YAML::Node copy(node.Type());
  if (node.IsScalar()) copy = node.Scalar();
  for (const auto& item : node) {
    if (node.IsSequence()) {
      copy.push_back(WithoutMarks(item));
    } else {
      copy.force_insert(item.first.Scalar(), WithoutMarks(item.second));
    }
  }
  copy.SetTag(node.Tag());
  return copy;
}

YAML::Node ValueOf(const std::string& text, const std::string& whole) {
  if (text.empty()) return YAML::Node("");
  try {
    return WithoutMarks(YAML::Load(text));
  } catch (const YAML::Exception& e) {
    Refuse(whole, "the value is no YAML: " + e.msg);
  }
}

std::size_t PlaceIn(const YAML::Node& list, const std::string& part, const std::string& whole) {
  std::size_t place = 0;
  const char* const end = part.data() + part.size();
  const auto [stop, error] = std::from_chars(part.data(), end, place);
  if (error == std::errc() && stop == end && place < list.size()) return place;
  Refuse(whole, "'" + part + "' is no place in a list of " + std::to_string(list.size()) +
                    "; the first is 0");
}

/// YAML::Node refers to what it is a copy of: `node` is changed in place.
void Put(YAML::Node node, std::span<const std::string> path, const YAML::Node& value,
         const std::string& whole) {
  const std::string& part = path.front();
  if (node.IsSequence()) {
    const std::size_t place = PlaceIn(node, part, whole);
    if (path.size() == 1) {
      node[place] = value;
    } else {
      Put(node[place], path.subspan(1), value, whole);
    }
    return;
  }
  if (!node.IsMap()) Refuse(whole, "there is no '" + part + "' below a single value");
  if (path.size() == 1) {
    node[part] = value;
    return;
  }
  const YAML::Node below = node[part];
  if (!below.IsDefined() || below.IsNull()) node[part] = YAML::Node(YAML::NodeType::Map);
  Put(node[part], path.subspan(1), value, whole);
}

}  // namespace

YamlNode WithOverrides(const YamlNode& root, const std::filesystem::path& file,
                       std::span<const std::string> overrides) {
  std::string name = file.string();
  const char* between = " with ";
  for (const std::string& text : overrides) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
      Refuse(text, "there is no '='; write KEY=VALUE, as max_steps=100");
    }
    const std::vector<std::string> path = Parts(text.substr(0, equals), text);
    Put(root.yaml(), path, ValueOf(text.substr(equals + 1), text), text);
    name += between + text;
    between = " ";
  }
  return {root.yaml(), name};
}

YamlNode ReadWithOverrides(const std::filesystem::path& file,
                           std::span<const std::string> overrides) {
  return WithOverrides(ParseYaml(ReadYamlFile(file), file), file, overrides);
}

}  // namespace bulletnav::sim
