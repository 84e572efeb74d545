// SPDX-License-Identifier: MIT
#include "sim/import/ply_check.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

constexpr std::uint64_t kMostElements = 1'000'000'000;
constexpr std::size_t kLongestHeader = 1 << 20;

std::optional<std::uint64_t> SizeOfType(const std::string& type) {
  static const std::map<std::string, std::uint64_t, std::less<>> sizes = {
      {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
      {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
      {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = sizes.find(type);
  return found == sizes.end() ? std::nullopt : std::optional(found->second);
}

class PlyChecker {
 public:
  PlyChecker(const std::filesystem::path& file, std::span<const std::uint8_t> bytes)
      : file_(file),
        text_(reinterpret_cast<const char*>(bytes.data()), std::min(bytes.size(), kLongestHeader)),
        all_(reinterpret_cast<const char*>(bytes.data()), bytes.size()) {}

  void Check() {
    if (Line() != "ply") Fail("does not start with 'ply'");
    for (std::string line = Line(); line != "end_header"; line = Line()) {
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if (keyword == "format") ReadFormat(&words);
      if (keyword == "element") ReadElement(&words);
      if (keyword == "property") ReadProperty(&words);
    }
    FinishElement();
    if (least_bytes_ > all_.size() - at_) {
      Fail("announces more data than the file holds; it is cut off or damaged");
    }
    if (is_ascii_) {
      CheckText();
      CheckNumbers();
    } else {
      CheckLists();
    }
  }

 private:
  struct Property {
    std::uint64_t size = 0;   // bytes of a number
    std::uint64_t count = 0;  // bytes of a list's length; 0: no list
    bool is_index = false;    // of vertices
  };
  struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
  };

  [[noreturn]] void Fail(const std::string& what) const {
    throw FileError(file_, std::to_string(line_), what);
  }

  std::string Line() {
    const std::size_t end = text_.find('\n', at_);
    ++line_;
    if (end == std::string_view::npos) Fail("the header does not end");
    std::string line(text_.substr(at_, end - at_));
    if (line.ends_with('\r')) line.pop_back();
    at_ = end + 1;
    return line;
  }

  /// A library that reads text as numbers may lose its way in anything else.
  void CheckText() {
    const std::size_t odd = all_.find_first_not_of("0123456789+-.eEnNaAiIfFtTyY \t\r\n", at_);
    if (odd == std::string_view::npos) return;
    FailAt(odd, "holds what is no number; it is damaged");
  }

  /// Nor does it look where the numbers end.
  void CheckNumbers() {
    for (const Element& element : elements_) {
      if (element.properties.empty()) continue;
      for (std::uint64_t item = 0; item < element.count; ++item) CheckItem(element);
    }
  }

  void CheckItem(const Element& element) {
    for (const Property& property : element.properties) {
      const std::string_view number = Number();
      if (property.count > 0) SkipNumbers(number, property);
    }
  }

  void SkipNumbers(std::string_view count, const Property& property) {
    std::uint64_t numbers = 0;
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), numbers);
    if (error != std::errc() || end != count.data() + count.size()) {
      FailAt(at_, "has a list without a length; it is damaged");
    }
    for (std::uint64_t i = 0; i < numbers; ++i) {
      const std::string_view number = Number();
      if (!property.is_index) continue;
      std::uint64_t index = 0;
      const auto read = std::from_chars(number.data(), number.data() + number.size(), index);
      if (read.ec == std::errc() && index < vertices_) continue;
      FailAt(at_ - number.size(), "has a face with vertex " + std::string(number) + " of " +
                                      std::to_string(vertices_) + "; export the mesh again");
    }
  }

  std::string_view Number() {
    constexpr std::string_view kSpace = " \t\r\n";
    const std::size_t begin = all_.find_first_not_of(kSpace, at_);
    if (begin == std::string_view::npos) {
      FailAt(all_.size(), "holds fewer numbers than it announces; it is cut off or damaged");
    }
    at_ = std::min(all_.find_first_of(kSpace, begin), all_.size());
    return all_.substr(begin, at_ - begin);
  }

  [[noreturn]] void FailAt(std::size_t position, const std::string& what) {
    const auto end = all_.begin() + static_cast<std::ptrdiff_t>(position);
    line_ = 1 + static_cast<int>(std::count(all_.begin(), end, '\n'));
    Fail(what);
  }

  void ReadFormat(std::istringstream* words) {
    std::string format;
    *words >> format;
    is_ascii_ = format == "ascii";
    is_big_endian_ = format == "binary_big_endian";
    if (!is_ascii_ && format != "binary_little_endian" && format != "binary_big_endian") {
      Fail("'" + format + "' is not a format of ply");
    }
  }

  void ReadElement(std::istringstream* words) {
    FinishElement();
    Element element;
    if (!(*words >> element.name >> element.count) || element.count > kMostElements) {
      Fail("has no sane element count; it is damaged, export or download it again");
    }
    if (element.name == "vertex") vertices_ = element.count;
    elements_.push_back(element);
  }

  void ReadProperty(std::istringstream* words) {
    std::string type;
    *words >> type;
    Property property;
    if (type == "list") {
      *words >> type;
      property.count = RequireType(type);
      *words >> type;
    }
    property.size = RequireType(type);
    std::string name;
    *words >> name;
    property.is_index = property.count > 0 && name.starts_with("vertex_ind");
    // In text, a digit and a space; the last line may lack its end. Of a list, at least its length.
    bytes_an_item_ += is_ascii_ ? 2 : property.count > 0 ? property.count : property.size;
    if (elements_.empty()) Fail("has a property before the first element");
    elements_.back().properties.push_back(property);
  }

  std::uint64_t RequireType(const std::string& type) {
    const auto size = SizeOfType(type);
    if (!size) Fail("'" + type + "' is not a type of ply");
    return *size;
  }

  /// Goes through binary data, for their lists: a library that reads one does not look where the
  /// file ends.
  void CheckLists() {
    for (const Element& element : elements_) {
      if (element.properties.empty()) continue;
      for (std::uint64_t item = 0; item < element.count; ++item) {
        for (const Property& property : element.properties) SkipBinary(element, item, property);
      }
    }
  }

  void SkipBinary(const Element& element, std::uint64_t item, const Property& property) {
    const auto fail = [&](const std::string& what) {
      throw FileError(file_, element.name + " " + std::to_string(item), what);
    };
    const std::uint64_t head = property.count;
    const std::uint64_t left = all_.size() - at_;
    const std::uint64_t numbers = head == 0 ? 1 : left < head ? 0 : NumberAt(at_, head);
    if (left < head || numbers > (left - head) / property.size) {
      fail("has more data than the file holds; it is cut off or damaged");
    }
    for (std::uint64_t i = 0; property.is_index && i < numbers; ++i) {
      const std::uint64_t index = NumberAt(at_ + head + i * property.size, property.size);
      if (index < vertices_) continue;
      fail("has vertex " + std::to_string(index) + " of " + std::to_string(vertices_) +
           "; export the mesh again");
    }
    at_ += head + numbers * property.size;
  }

  /// A whole number that is not negative; others are larger than any count.
  std::uint64_t NumberAt(std::uint64_t place, std::uint64_t bytes) const {
    std::uint64_t number = 0;
    for (std::uint64_t i = 0; i < bytes; ++i) {
      const std::uint64_t from = is_big_endian_ ? i : bytes - 1 - i;
      number = number << 8 | static_cast<std::uint8_t>(all_[place + from]);
    }
    return number;
  }

  void FinishElement() {
    if (elements_.empty()) return;
    const std::uint64_t total = elements_.back().count * bytes_an_item_;
    least_bytes_ += is_ascii_ && total > 0 ? total - 1 : total;
    bytes_an_item_ = 0;
  }

  const std::filesystem::path& file_;
  std::string_view text_;  // the beginning, where the header ends
  std::string_view all_;
  std::size_t at_ = 0;
  int line_ = 0;
  bool is_ascii_ = false;
  bool is_big_endian_ = false;
  std::vector<Element> elements_;
  std::uint64_t vertices_ = 0;
  std::uint64_t bytes_an_item_ = 0;
  std::uint64_t least_bytes_ = 0;
};

}  // namespace

void CheckPly(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
  PlyChecker(file, bytes).Check();
}

}  // namespace bulletnav::sim
