// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

namespace bulletnav::bench {

/// One HTML file with everything in it: the page's own style, blocks that are unpacked when they
/// are asked for, what is shown first, and the page's program.
class ReplayPage {
 public:
  /// Begins `file`. Throws sim::FileError if it cannot be written.
  ReplayPage(const std::filesystem::path& file, std::string_view title);

  /// A block of text, compressed; `id`: letters and digits.
  void AddText(const std::string& id, std::string_view text);
  /// A block that is a gzip file already.
  void AddPacked(const std::string& id, std::span<const std::uint8_t> gzip);
  /// A block of a JPEG or PNG.
  void AddPicture(const std::string& id, std::span<const std::uint8_t> picture);
  /// Ends the page with block "run", JSON. Throws sim::FileError if the disk is full.
  void Finish(std::string_view run);

 private:
  void AddBlock(const std::string& id, std::string_view type, std::span<const std::uint8_t> bytes);

  std::filesystem::path file_;
  std::ofstream out_;
};

/// Text as it may stand in HTML.
std::string EscapeHtml(std::string_view text);
/// JSON as it may stand in a script element: "<" as an escape.
std::string EscapeScript(std::string_view json);

}  // namespace bulletnav::bench
