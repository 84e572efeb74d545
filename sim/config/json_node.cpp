// SPDX-License-Identifier: MIT
#include "sim/config/json_node.h"

#include <algorithm>
#include <cmath>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

constexpr int kDeepest = 64;

/// What is wrong with a text, and what usually helps.
struct Trouble {
  std::string what;
  std::string remedy;
};

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

Trouble WhyBad(std::string_view text, std::size_t byte) {
  if (byte >= text.size()) {
    return {"the JSON ends too early: the file is cut off", "copy it again"};
  }
  // The parser stops inside of a word that it cannot make sense of.
  const std::size_t from = byte > 2 ? byte - 2 : 0;
  for (std::size_t i = from; i <= byte; ++i) {
    if (StartsLikeNan(text.substr(i))) {
      return {"NaN and infinity are not numbers of JSON", "mend it"};
    }
  }
  return {"not valid JSON", "mend it or take a sound copy of the file"};
}

}  // namespace

template <class Json>
Json ParseJson(std::string_view text, const std::filesystem::path& file, int first_line,
               const std::string& remedy) {
  const auto fail = [&](const std::string& place, const Trouble& trouble) {
    throw FileError(file, place, trouble.what + "; " + (remedy.empty() ? trouble.remedy : remedy));
  };
  const auto limit_depth = [&](int depth, typename Json::parse_event_t /*event*/,
                               Json& /*parsed*/) {
    if (depth > kDeepest) throw FileError(file, "", "nests more than 64 levels deep");
    return true;
  };
  try {
    return Json::parse(text, limit_depth);
  } catch (const typename Json::parse_error& e) {
    const std::size_t byte = e.byte > 0 ? e.byte - 1 : 0;
    fail(LineAndColumn(text, byte, first_line), WhyBad(text, byte));
  } catch (const typename Json::exception&) {
    const bool is_one_line = text.find('\n') == std::string_view::npos;
    fail(is_one_line ? std::to_string(first_line) : "",
         {"holds a number too large for this program", "mend it"});
  }
  return {};
}

template <class Json>
JsonNode<Json>::JsonNode(const Json& value, std::filesystem::path file, std::string owner,
                         std::string remedy)
    : source_(
          std::make_shared<Source>(Source{std::move(file), std::move(owner), std::move(remedy)})),
      value_(&value) {}

template <class Json>
void JsonNode<Json>::Fail(std::string_view what) const {
  std::string place = place_;
  if (!source_->owner.empty()) place = " " + source_->owner + (place.empty() ? "" : ": ") + place;
  const std::string end = source_->remedy.empty() ? "" : "; " + source_->remedy;
  throw FileError(source_->file, place, std::string(what) + end);
}

template <class Json>
JsonNode<Json> JsonNode<Json>::At(const char* key) const {
  if (!value_->is_object()) Fail("expected an object here");
  const auto found = value_->find(key);
  if (found == value_->end()) Fail("'" + std::string(key) + "' is missing");
  return {source_, *found, place_.empty() ? key : place_ + "." + key};
}

template <class Json>
JsonNode<Json> JsonNode<Json>::Item(std::size_t i) const {
  return {source_, value_->at(i), place_ + "[" + std::to_string(i) + "]"};
}

template <class Json>
void JsonNode<Json>::ExpectList(std::size_t size) const {
  if (Size() == size) return;
  Fail("expected a list of " + std::to_string(size) + ", got " + std::to_string(Size()));
}

template <class Json>
std::size_t JsonNode<Json>::Size(std::size_t least) const {
  if (!value_->is_array()) Fail("expected a list here");
  if (value_->size() < least) {
    Fail("expected a list of at least " + std::to_string(least) + ", got " +
         std::to_string(value_->size()));
  }
  return value_->size();
}

template <class Json>
typename JsonNode<Json>::Float JsonNode<Json>::Number() const {
  if (!value_->is_number()) Fail("expected a number here");
  const auto number = value_->template get<Float>();
  if (!std::isfinite(number)) Fail("expected a finite number here");
  return number;
}

template <class Json>
typename JsonNode<Json>::Float JsonNode<Json>::Positive() const {
  const Float number = Number();
  if (!(number > 0)) Fail("is not above 0");
  return number;
}

template <class Json>
bool JsonNode<Json>::Truth() const {
  if (!value_->is_boolean()) Fail("expected true or false here");
  return value_->template get<bool>();
}

template <class Json>
std::uint64_t JsonNode<Json>::Whole(std::uint64_t most) const {
  if (!value_->is_number_unsigned()) Fail("expected a whole number here");
  const auto number = value_->template get<std::uint64_t>();
  if (number > most) Fail("expected a whole number up to " + std::to_string(most));
  return number;
}

template <class Json>
int JsonNode<Json>::Index(std::size_t count, std::string_view things) const {
  const std::uint64_t index = Whole();
  if (index >= count) {
    Fail(std::to_string(index) + " is none of the " + std::to_string(count) + " " +
         std::string(things));
  }
  return static_cast<int>(index);
}

template <class Json>
std::string JsonNode<Json>::Text() const {
  if (!value_->is_string()) Fail("expected a text here");
  return value_->template get<std::string>();
}

template FloatJson ParseJson<FloatJson>(std::string_view, const std::filesystem::path&, int,
                                        const std::string&);
template nlohmann::ordered_json ParseJson<nlohmann::ordered_json>(std::string_view,
                                                                  const std::filesystem::path&, int,
                                                                  const std::string&);
template class JsonNode<FloatJson>;
template class JsonNode<nlohmann::ordered_json>;

}  // namespace bulletnav::sim
