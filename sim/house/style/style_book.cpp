// SPDX-License-Identifier: MIT
#include "sim/house/style/style_book.h"

#include <algorithm>
#include <charconv>
#include <iterator>

#include "sim/config/yaml_reader.h"
#include "sim/house/style/style_texts.h"
#include "sim/house/style/tint.h"

namespace bulletnav::sim {

namespace style {

void ReadYaml(const YamlNode& node, Paint& value) {
  const std::string text = node.ToString();
  unsigned rgb = 0;
  const char* end = text.data() + text.size();
  const bool is_hex = text.size() == 8 && text.starts_with("0x");
  if (!is_hex || std::from_chars(text.data() + 2, end, rgb, 16).ptr != end) {
    node.Fail("'" + text + "' is no colour; one is written 0xRRGGBB");
  }
  value = {Hex(rgb)};
}

}  // namespace style

/// A material, or {material: colour}.
void ReadYaml(const YamlNode& node, Surface& value) {
  const bool is_plain = node.yaml().IsScalar();
  if (!is_plain) {
    node.ExpectMap();
    if (node.yaml().size() != 1) node.Fail("a surface is a material or {material: colour}");
    style::Paint tint;
    ReadYaml(node.Child(node.yaml().begin()->second), tint);
    value.tint = tint;
  }
  const YamlNode name = is_plain ? node : node.Child(node.yaml().begin()->first);
  try {
    value.material = FindMaterial(name.ToString()).name;
  } catch (const FileError&) {
    throw;
  } catch (const Error& e) {
    name.Fail(e.what());
  }
}

namespace style {
namespace {

template <class T>
void RequireFull(const YamlNode& map, const char* key, const std::vector<T>& list) {
  if (list.empty()) map.FailAt(key, std::string("'") + key + "' has no entry");
}

/// Looks at what no type says: lists have entries, and words that must be materials are.
struct BookCheck {
  template <class T>
  void operator()(const char* /*key*/, const T& /*value*/) {}
  template <class T>
  void Required(const char* key, const T& value) {
    Check(key, value);
  }

  void Check(const char* key, const std::string& material) { RequireMaterial(key, material); }
  void Check(const char* key, const std::vector<std::string>& materials) {
    RequireFull(map, key, materials);
    for (const std::string& material : materials) RequireMaterial(key, material);
  }
  template <class T>
  void Check(const char* key, const std::vector<T>& list) {
    RequireFull(map, key, list);
  }
  void RequireMaterial(const char* key, const std::string& material) {
    try {
      FindMaterial(material);
    } catch (const Error& e) {
      map.FailAt(key, e.what());
    }
  }

  const YamlNode& map;
};

std::vector<StyleBook> ReadBooks() {
  std::vector<StyleBook> books;
  for (const auto& style : EnumNames<StyleKind>::kNames) {
    const auto text =
        std::find_if(std::begin(kStyleTexts), std::end(kStyleTexts), [&](const auto& entry) {
          return entry.first == style.first;
        });
    const std::string file = "assets/styles/" + std::string(style.first) + ".yaml";
    if (text == std::end(kStyleTexts)) throw FileError(file, "", "is not there");
    books.push_back(ReadBook(std::string(text->second), file));
  }
  return books;
}

}  // namespace

StyleBook ReadBook(const std::string& text, const std::filesystem::path& file) {
  const YamlNode map = ParseYaml(text, file);
  StyleBook book;
  YamlReader::Read(map, book);
  BookCheck check{map};
  book.Visit(check);
  return book;
}

const StyleBook& BookOf(StyleKind kind) {
  static const std::vector<StyleBook> books = ReadBooks();
  return books.at(static_cast<std::size_t>(kind));
}

}  // namespace style
}  // namespace bulletnav::sim
