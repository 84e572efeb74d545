// SPDX-License-Identifier: MIT
#include "benchmark/episodes/scene_cache.h"

#include <memory>
#include <thread>
#include <vector>

#include <gmock/gmock.h>

#include "benchmark/base/file_hash.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/scene/glb_writer.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SceneCacheTest : public testing::Test {
 protected:
  fs::path Scene(const std::string& name, float length = 9.0f) const {
    const fs::path file = folder_.path() / name;
    sim::WriteFileAtomically(file, sim::EncodeGlb(tests::LCorridor(length, 8, 2, 2.5f)));
    return file;
  }
  static std::string Complaint(SceneCache* cache, const fs::path& file) {
    try {
      cache->Get(file);
    } catch (const sim::Error& e) {
      return e.what();
    }
    return "nothing";
  }
  SceneCache cache_{{.import = {}, .navmesh = {}, .backend = sim::Backend::kEmbree}};
  tests::TemporaryFolder folder_;
};

TEST_F(SceneCacheTest, ImportsOnceToDrawToCheckAndToPlay) {
  const fs::path file = Scene("a.glb");
  const float area = cache_.LoadGround(file)->navmesh.area();
  EXPECT_GT(cache_.kept_bytes(), 0u);
  EXPECT_EQ(cache_.LoadGround(folder_.path() / "." / "a.glb")->navmesh.area(), area);
  cache_.Expect(file);
  cache_.DropOthers();
  const auto world = cache_.Get(file);
  EXPECT_EQ(world->navmesh().area(), area);
  EXPECT_EQ(world->name(), "a.glb");
  EXPECT_EQ(cache_.Get(file), world);
  EXPECT_EQ(cache_.HashOf(file), FileHash(file));
  EXPECT_EQ(cache_.imports(), 1);
  EXPECT_EQ(cache_.kept_bytes(), 0u);
}

TEST_F(SceneCacheTest, DropsWorldsWithTheirLastEpisode) {
  const fs::path file = Scene("a.glb");
  cache_.Expect(file);
  cache_.Expect(file);
  const std::weak_ptr<const sim::World> world = cache_.Get(file);
  cache_.Done(file);
  EXPECT_FALSE(world.expired());
  cache_.Done(file);
  EXPECT_TRUE(world.expired());
}

TEST_F(SceneCacheTest, DropsImportsInWhichNothingIsPlayed) {
  const fs::path played = Scene("played.glb");
  const fs::path other = Scene("other.glb");
  cache_.LoadGround(played);
  const std::size_t one = cache_.kept_bytes();
  cache_.LoadGround(other);
  cache_.Expect(played);
  cache_.DropOthers();
  EXPECT_EQ(cache_.kept_bytes(), one);
}

TEST_F(SceneCacheTest, KeepsNoMoreThanItMay) {
  SceneCache small({.import = {}, .navmesh = {}, .backend = sim::Backend::kEmbree}, 0);
  const fs::path file = Scene("a.glb");
  small.LoadGround(file);
  EXPECT_EQ(small.kept_bytes(), 0u);
  small.Get(file);
  EXPECT_EQ(small.imports(), 2);
}

TEST_F(SceneCacheTest, RefusesAFileThatChanged) {
  SceneCache small({.import = {}, .navmesh = {}, .backend = sim::Backend::kEmbree}, 0);
  const fs::path file = Scene("a.glb");
  small.LoadGround(file);
  Scene("a.glb", 11.0f);
  EXPECT_THAT(Complaint(&small, file), HasSubstr("a.glb: has changed since this run began"));
  EXPECT_THAT(Complaint(&small, folder_.path() / "none.glb"), HasSubstr("none.glb"));
}

TEST_F(SceneCacheTest, ManyThreadsImportOnce) {
  const fs::path file = Scene("a.glb");
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) cache_.Expect(file);
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      EXPECT_EQ(cache_.Get(file)->name(), "a.glb");
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(cache_.imports(), 1);
}

}  // namespace
}  // namespace bulletnav::bench
