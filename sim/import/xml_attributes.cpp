// SPDX-License-Identifier: MIT
#include "sim/import/xml_attributes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include <tinyxml2.h>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

using Element = tinyxml2::XMLElement;

/// Absent where there is something else between the blanks and commas.
std::optional<std::vector<double>> NumbersIn(const std::string& text) {
  constexpr const char* kBetween = " ,\t\r\n";
  std::vector<double> numbers;
  for (std::size_t at = text.find_first_not_of(kBetween); at != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(kBetween, at), text.size());
    if (text[at] == '+') ++at;
    double number = 0.0;
    const auto [next, error] = std::from_chars(text.data() + at, text.data() + end, number);
    if (error != std::errc() || next != text.data() + end || !std::isfinite(number)) return {};
    numbers.push_back(number);
    at = text.find_first_not_of(kBetween, end);
  }
  return numbers;
}

std::string Called(const Element& element, const char* attribute) {
  return std::string("'") + attribute + "' of '" + element.Name() + "' ";
}

}  // namespace

void ParseXml(const std::string& text, const std::filesystem::path& file,
              tinyxml2::XMLDocument* document) {
  tinyxml2::XMLDocument own;
  tinyxml2::XMLDocument& parsed = document == nullptr ? own : *document;
  if (parsed.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS) return;
  throw FileError(
      file, std::to_string(parsed.ErrorLineNum()),
      std::string("is no sound XML (") + parsed.ErrorName() + "); mend it, or take another copy");
}

void XmlAttributes::Fail(const Element& where, const std::string& what) const {
  throw FileError(file_, std::to_string(where.GetLineNum()), what);
}

std::string XmlAttributes::Text(const Element& element, const char* attribute) const {
  const char* text = element.Attribute(attribute);
  if (text == nullptr || *text == '\0') {
    Fail(element, std::string("'") + element.Name() + "' has no '" + attribute + "'; add it");
  }
  return text;
}

std::vector<double> XmlAttributes::Numbers(const Element& element, const char* attribute) const {
  std::string text = Text(element, attribute);
  const auto numbers = NumbersIn(text);
  if (numbers) return *numbers;
  std::replace(text.begin(), text.end(), '\n', ' ');
  Fail(element, Called(element, attribute) + "is '" + text + "'; give plain numbers");
}

std::vector<double> XmlAttributes::Numbers(const Element& element, const char* attribute,
                                           std::size_t count) const {
  std::vector<double> numbers = Numbers(element, attribute);
  if (numbers.size() == count) return numbers;
  Fail(element, Called(element, attribute) + "has " + std::to_string(numbers.size()) +
                    " numbers; give " + std::to_string(count));
}

double XmlAttributes::Number(const Element& element, const char* attribute) const {
  return Numbers(element, attribute, 1)[0];
}

float XmlAttributes::Positive(const Element& element, const char* attribute) const {
  const double number = Number(element, attribute);
  if (!(number > 0.0)) Fail(element, Called(element, attribute) + "is not above 0; mend it");
  return static_cast<float>(number);
}

Eigen::Vector3d XmlAttributes::Vector(const Element& element, const char* attribute) const {
  return Eigen::Vector3d(Numbers(element, attribute, 3).data());
}

}  // namespace bulletnav::sim
