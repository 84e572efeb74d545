// SPDX-License-Identifier: MIT
#include "sim/import/texture_files.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

namespace fs = std::filesystem;
using tests::TemporaryFolder;

/// The process stands in another folder as long as this lives.
class Standing {
 public:
  explicit Standing(const fs::path& folder) : before_(fs::current_path()) {
    fs::current_path(folder);
  }
  ~Standing() { fs::current_path(before_); }
  Standing(const Standing&) = delete;
  Standing& operator=(const Standing&) = delete;
  Standing(Standing&&) = delete;
  Standing& operator=(Standing&&) = delete;

 private:
  fs::path before_;
};

TEST(FindTextureFile, CaseIsForgivenWhereverTheMeshIsNamedFrom) {
  const TemporaryFolder folder;
  const fs::path wood = folder.Write("Wood.PNG", "picture");
  const Standing there(folder.path());
  for (const fs::path& mesh : {fs::path("c.obj"), fs::path("./c.obj"), folder.path() / "c.obj"}) {
    for (const char* name : {"Wood.PNG", "wood.png", "C:\\work\\wood.png"}) {
      const auto found = FindTextureFile(mesh, name);
      ASSERT_TRUE(found.has_value()) << mesh << " " << name;
      EXPECT_TRUE(fs::equivalent(*found, wood));
    }
    EXPECT_FALSE(FindTextureFile(mesh, "brick.png").has_value());
  }
}

}  // namespace
}  // namespace bulletnav::sim
