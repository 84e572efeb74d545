// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/text_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

constexpr std::string_view kBlanks = " \t\r";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // some editors begin UTF-8 with it

std::vector<std::string_view> WordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t begin = line.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

/// Nothing if the word is not a T from end to end.
template <class T>
bool Parse(std::string_view word, T* value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), *value);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace

TextLine::TextLine(const std::filesystem::path& file, int number,
                   std::vector<std::string_view> words)
    : file_(file), number_(number), words_(std::move(words)) {}

void TextLine::ExpectWords(std::size_t count, std::string_view what) const {
  if (words_.size() == count) return;
  Fail("expected " + std::to_string(count) + " words, '" + std::string(what) + "', and found " +
       std::to_string(words_.size()));
}

double TextLine::Number(std::size_t word) const {
  double value = 0.0;
  const std::string text(words_.at(word));
  if (!Parse(text, &value)) Fail("expected a number, got '" + text + "'");
  if (!std::isfinite(value))
    Fail("'" + text + "' is not finite; mend the line, or leave it out if there are others");
  return value;
}

std::vector<double> TextLine::Numbers(std::size_t first, std::size_t count) const {
  std::vector<double> numbers;
  numbers.reserve(count);
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(Number(first + i));
  return numbers;
}

std::int64_t TextLine::Integer(std::size_t word) const {
  std::int64_t value = 0;
  const std::string text(words_.at(word));
  if (!Parse(text, &value)) Fail("expected a whole number, got '" + text + "'");
  return value;
}

void TextLine::Fail(const std::string& what) const {
  throw sim::FileError(file_, std::to_string(number_), what);
}

void ForEachLine(const std::filesystem::path& file,
                 const std::function<void(const TextLine&)>& take) {
  const std::string text = sim::ReadTextFile(file);
  std::string_view all = text;
  if (all.starts_with(kByteOrderMark)) all.remove_prefix(kByteOrderMark.size());
  int number = 0;
  for (std::size_t begin = 0; begin < all.size();) {
    const std::size_t end = std::min(all.find('\n', begin), all.size());
    const std::string_view part = all.substr(begin, end - begin);
    const TextLine line(file, ++number, WordsOf(part));
    if (part.find('\0') != std::string_view::npos) {
      line.Fail("there is a byte of 0, so this is no text or is damaged; write the file again");
    }
    if (!line.words().empty() && !line.words()[0].starts_with('#')) take(line);
    begin = end + 1;
  }
}

}  // namespace bulletnav::bench
