// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace tinyxml2 {  // NOLINT(readability-identifier-naming): its own
class XMLDocument;
class XMLElement;
}  // namespace tinyxml2

namespace bulletnav::sim {

/// Throws FileError with the line for what is no sound XML. Without `document`: only that.
void ParseXml(const std::string& text, const std::filesystem::path& file,
              tinyxml2::XMLDocument* document = nullptr);

/// Attributes of an XML file's elements as what they mean. Numbers are finite, with blanks or
/// commas between them. All throw FileError with the element's line.
class XmlAttributes {
 public:
  /// `file` is lent for the object's life.
  explicit XmlAttributes(const std::filesystem::path& file) : file_(file) {}

  [[noreturn]] void Fail(const tinyxml2::XMLElement& where, const std::string& what) const;
  /// Not empty.
  std::string Text(const tinyxml2::XMLElement& element, const char* attribute) const;
  std::vector<double> Numbers(const tinyxml2::XMLElement& element, const char* attribute) const;
  std::vector<double> Numbers(const tinyxml2::XMLElement& element, const char* attribute,
                              std::size_t count) const;
  double Number(const tinyxml2::XMLElement& element, const char* attribute) const;
  float Positive(const tinyxml2::XMLElement& element, const char* attribute) const;
  Eigen::Vector3d Vector(const tinyxml2::XMLElement& element, const char* attribute) const;

 private:
  const std::filesystem::path& file_;
};

}  // namespace bulletnav::sim
