// SPDX-License-Identifier: MIT
#include "benchmark/replay/replay_page.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "benchmark/replay/base64.h"
#include "benchmark/replay/make_replay.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/base/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

std::string Base64Of(const std::string& text) {
  return Base64(std::vector<std::uint8_t>(text.begin(), text.end()));
}

TEST(Base64, IsAsInRfc4648) {
  EXPECT_EQ(Base64Of(""), "");
  EXPECT_EQ(Base64Of("f"), "Zg==");
  EXPECT_EQ(Base64Of("fo"), "Zm8=");
  EXPECT_EQ(Base64Of("foo"), "Zm9v");
  EXPECT_EQ(Base64Of("foobar"), "Zm9vYmFy");
}

TEST(ReplayPage, NoTextEndsItsElement) {
  EXPECT_EQ(EscapeHtml("a<b>&\"c\""), "a&lt;b>&amp;&quot;c&quot;");
  EXPECT_EQ(EscapeScript(R"({"name":"</script>"})"), R"({"name":"\u003c/script>"})");
}

TEST(ReplayPage, HoldsItsBlocksAndNeedsNoOtherFile) {
  const sim::TemporaryFolder folder;
  const fs::path file = folder.path() / "page.html";
  ReplayPage page(file, "a <run>");
  page.AddText("e0", "{}");
  page.AddPicture("g0", std::vector<std::uint8_t>{0xff, 0xd8});
  page.AddPicture("g1", std::vector<std::uint8_t>{0x89, 'P'});
  page.Finish("{\"rows\":[]}");
  const std::string text = sim::ReadTextFile(file);
  EXPECT_NE(text.find("<title>a &lt;run></title>"), std::string::npos);
  EXPECT_NE(text.find("<script type=\"application/gzip\" id=\"e0\">H4sI"), std::string::npos);
  EXPECT_NE(text.find("<script type=\"image/jpeg\" id=\"g0\">/9g=</script>"), std::string::npos);
  EXPECT_NE(text.find("<script type=\"image/png\" id=\"g1\">"), std::string::npos);
  EXPECT_EQ(text.find("src=\""), std::string::npos);
  EXPECT_EQ(text.find("@import"), std::string::npos);
  EXPECT_TRUE(text.ends_with("</html>\n"));
}

TEST(MakeReplay, AFolderWithoutResultsIsRefusedAndNothingIsWritten) {
  const sim::TemporaryFolder folder;
  ReplayOptions options;
  options.run = folder.path();
  EXPECT_THROW(MakeReplay(options), sim::Error);
  EXPECT_FALSE(fs::exists(folder.path() / "replay.html"));
}

}  // namespace
}  // namespace bulletnav::bench
