// SPDX-License-Identifier: MIT
#include "sim/config/yaml_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "sim/base/files.h"
#include "sim/base/nearest_word.h"

namespace bulletnav::sim {
namespace {

constexpr std::size_t kMaxConfigBytes = 16u << 20;

std::string Place(const YAML::Mark& mark) {
  if (mark.is_null()) return "";
  return std::to_string(mark.line + 1) + ":" + std::to_string(mark.column + 1);
}

std::string Listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

}  // namespace

std::string NearestWord(std::string_view word, const std::vector<std::string>& known) {
  return NearestWord(word, known, std::max<std::size_t>(2, word.size() / 2));
}

YamlNode::YamlNode(const YAML::Node& node, std::filesystem::path file)
    : node_(node), file_(std::move(file)) {}

void YamlNode::Fail(const std::string& what) const {
  throw FileError(file_, Place(node_.Mark()), what);
}

void YamlNode::FailAt(std::string_view key, const std::string& what) const {
  for (const auto& item : node_) {
    if (item.first.Scalar() == key) Child(item.second).Fail(what);
  }
  Fail(what);
}

std::string YamlNode::ToString() const {
  if (!node_.IsScalar()) Fail("expected a single value here");
  return node_.Scalar();
}

bool YamlNode::ToBool() const {
  const std::string text = ToString();
  if (text == "true") return true;
  if (text == "false") return false;
  Fail("'" + text + "' is neither true nor false");
}

std::int64_t YamlNode::ToInt(std::int64_t low, std::int64_t high) const {
  const std::string text = ToString();
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) Fail("'" + text + "' is not a whole number");
  if (value < low || value > high) {
    Fail(text + " is outside " + std::to_string(low) + " to " + std::to_string(high));
  }
  return value;
}

double YamlNode::ToDouble() const {
  const std::string text = ToString();
  double value = 0.0;
  const char* end = text.data() + text.size();
  const char* begin = text.starts_with('+') ? text.data() + 1 : text.data();
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) {
    Fail("'" + text + "' is not a finite number");
  }
  return value;
}

void YamlNode::ExpectSequence(std::optional<std::size_t> size) const {
  if (!node_.IsSequence()) Fail("expected a list here");
  if (size && node_.size() != *size) {
    Fail("expected a list of " + std::to_string(*size) + ", got " + std::to_string(node_.size()));
  }
}

void YamlNode::ExpectMap() const {
  if (!node_.IsMap()) Fail("expected a block of 'key: value' lines here");
}

YamlReader::YamlReader(const YamlNode& map) : map_(map) {
  map_.ExpectMap();
  std::set<std::string> seen;
  for (const auto& item : map_.yaml()) {
    const YamlNode key = map_.Child(item.first);
    if (!seen.insert(key.ToString()).second) {
      key.Fail("key '" + key.ToString() + "' is given twice");
    }
  }
}

std::optional<YamlNode> YamlReader::Take(std::string_view key) {
  known_.emplace_back(key);
  for (const auto& item : map_.yaml()) {
    if (item.first.Scalar() == key) return map_.Child(item.second);
  }
  return std::nullopt;
}

void YamlReader::Finish() const {
  for (const auto& item : map_.yaml()) {
    const std::string key = item.first.Scalar();
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    const std::string nearest = NearestWord(key, known_);
    map_.Child(item.first)
        .Fail("unknown key '" + key + "'; " +
              (nearest.empty() ? "known here: " + Listed(known_)
                               : "did you mean '" + nearest + "'?"));
  }
  if (!missing_.empty()) map_.Fail("key '" + missing_ + "' is missing");
}

YamlNode ParseYaml(const std::string& text, const std::filesystem::path& name) {
  try {
    return {YAML::Load(text), name};
  } catch (const YAML::Exception& e) {
    throw FileError(name, Place(e.mark), "not valid YAML: " + e.msg);
  }
}

std::string ReadYamlFile(const std::filesystem::path& file) {
  std::string text = ReadTextFile(file);
  if (text.size() > kMaxConfigBytes) throw FileError(file, "", "is too large for a config file");
  return text;
}

}  // namespace bulletnav::sim
