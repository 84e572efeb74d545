// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace bulletnav::bench {

/// A line of a text file as words, which blanks part. Complaints are sim::FileErrors that name the
/// file and the line.
class TextLine {
 public:
  TextLine(const std::filesystem::path& file, int number, std::vector<std::string_view> words);

  int number() const { return number_; }  // from 1
  const std::vector<std::string_view>& words() const { return words_; }
  /// `what` names the words that should be there, for the complaint.
  void ExpectWords(std::size_t count, std::string_view what) const;
  /// A word as a finite number.
  double Number(std::size_t word) const;
  std::vector<double> Numbers(std::size_t first, std::size_t count) const;
  std::int64_t Integer(std::size_t word) const;
  [[noreturn]] void Fail(const std::string& what) const;

 private:
  const std::filesystem::path& file_;
  int number_ = 0;
  std::vector<std::string_view> words_;
};

/// Calls `take` with each line that is not empty and no comment, which starts with '#'. A line is
/// good for the call alone. Throws sim::FileError if the file cannot be read or a line has a byte
/// of 0.
void ForEachLine(const std::filesystem::path& file,
                 const std::function<void(const TextLine&)>& take);

}  // namespace bulletnav::bench
