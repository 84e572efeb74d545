// SPDX-License-Identifier: MIT
#include "benchmark/replay/replay_page.h"

#include <fmt/format.h>

#include "benchmark/base/gzip.h"
#include "benchmark/replay/base64.h"
#include "benchmark/replay/page_parts.h"
#include "sim/base/error.h"

namespace bulletnav::bench {

std::string EscapeHtml(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<') {
      safe += "&lt;";
    } else if (c == '&') {
      safe += "&amp;";
    } else if (c == '"') {
      safe += "&quot;";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string EscapeScript(std::string_view json) {
  std::string safe;
  for (const char c : json) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

ReplayPage::ReplayPage(const std::filesystem::path& file, std::string_view title)
    : file_(file), out_(file, std::ios::binary) {
  out_ << "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>"
       << EscapeHtml(title) << "</title>\n<meta name=\"viewport\" content=\"width=device-width\">\n"
       << "<style>\n"
       << kReplayCss << "</style>\n"
       << kReplayHtml;
}

void ReplayPage::AddText(const std::string& id, std::string_view text) {
  AddPacked(id, Compress(text));
}

void ReplayPage::AddPacked(const std::string& id, std::span<const std::uint8_t> gzip) {
  AddBlock(id, "application/gzip", gzip);
}

void ReplayPage::AddPicture(const std::string& id, std::span<const std::uint8_t> picture) {
  const bool is_png = !picture.empty() && picture.front() == 0x89;
  AddBlock(id, is_png ? "image/png" : "image/jpeg", picture);
}

void ReplayPage::AddBlock(const std::string& id, std::string_view type,
                          std::span<const std::uint8_t> bytes) {
  out_ << fmt::format("<script type=\"{}\" id=\"{}\">", type, id) << Base64(bytes) << "</script>\n";
}

void ReplayPage::Finish(std::string_view run) {
  out_ << "<script type=\"application/json\" id=\"run\">" << EscapeScript(run) << "</script>\n";
  for (const char* program : kReplayPrograms) out_ << "<script>\n" << program << "</script>\n";
  out_ << "</html>\n";
  out_.close();
  if (!out_) throw sim::FileError(file_, "", "cannot be written; is the disk full?");
}

}  // namespace bulletnav::bench
