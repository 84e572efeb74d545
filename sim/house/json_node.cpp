// SPDX-License-Identifier: MIT
#include "sim/house/json_node.h"

#include <algorithm>
#include <utility>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

/// "line:column" of a byte, counted from 1.
std::string LineAndColumn(const std::string& text, std::size_t byte) {
  const std::string before = text.substr(0, std::min(byte, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n');
  const std::size_t column = start == std::string::npos ? byte : byte - start - 1;
  return std::to_string(line) + ":" + std::to_string(std::max<std::size_t>(1, column));
}

}  // namespace

JsonNode::JsonNode(std::shared_ptr<const Source> source, const FloatJson* json, std::string place)
    : source_(std::move(source)), json_(json), place_(std::move(place)) {}

JsonNode JsonNode::Parse(const std::string& text, const std::filesystem::path& file,
                         const std::string& remedy) {
  try {
    auto source = std::make_shared<Source>(Source{file, remedy, FloatJson::parse(text)});
    return {source, &source->root, ""};
  } catch (const FloatJson::parse_error& e) {
    throw FileError(file, LineAndColumn(text, e.byte), "is not JSON; " + remedy);
  } catch (const FloatJson::out_of_range&) {
    throw FileError(file, "", "holds a number too large for a float; " + remedy);
  }
}

void JsonNode::Fail(const std::string& what) const {
  throw FileError(source_->file, place_, what + "; " + source_->remedy);
}

JsonNode JsonNode::operator[](std::string_view key) const {
  if (!json_->is_object()) Fail("is not an object");
  const auto found = json_->find(std::string(key));
  if (found == json_->end()) Fail("has no '" + std::string(key) + "'");
  return {source_, &*found, place_ + (place_.empty() ? "" : ".") + std::string(key)};
}

JsonNode JsonNode::operator[](std::size_t i) const {
  return {source_, &json_->at(i), place_ + "[" + std::to_string(i) + "]"};
}

std::size_t JsonNode::size(std::size_t least) const {
  if (!json_->is_array()) Fail("is not a list");
  if (json_->size() < least) {
    Fail("holds " + std::to_string(json_->size()) + " items, not at least " +
         std::to_string(least));
  }
  return json_->size();
}

float JsonNode::ToFloat() const {
  if (!json_->is_number()) Fail("is not a number");
  return json_->get<float>();
}

float JsonNode::ToPositive() const {
  const float value = ToFloat();
  if (value <= 0.0f) Fail("is not above 0");
  return value;
}

bool JsonNode::ToBool() const {
  if (!json_->is_boolean()) Fail("is not true or false");
  return json_->get<bool>();
}

std::uint64_t JsonNode::ToUint() const {
  if (!json_->is_number_unsigned()) Fail("is not a whole number from 0 on");
  return json_->get<std::uint64_t>();
}

int JsonNode::ToIndex(std::size_t count, std::string_view things) const {
  const std::uint64_t index = ToUint();
  if (index >= count) {
    Fail(std::to_string(index) + " is none of the " + std::to_string(count) + " " +
         std::string(things));
  }
  return static_cast<int>(index);
}

std::string JsonNode::ToString() const {
  if (!json_->is_string()) Fail("is not a text");
  return json_->get<std::string>();
}

}  // namespace bulletnav::sim
