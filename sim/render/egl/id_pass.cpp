// SPDX-License-Identifier: MIT
#include "sim/render/egl/id_pass.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "sim/render/egl/shaders.h"

namespace bulletnav::sim {
namespace {

constexpr float kNear = 0.02f;  // metres; nothing comes nearer to a body's axis
// Chunks are drawn in rounds by distance; before each round but the first, the hidden go.
constexpr std::array kRounds = {1.5f, 4.0f, std::numeric_limits<float>::infinity()};

bool IsNearer(float distance, const ChunkInView& item) {
  return distance < item.distance;
}

}  // namespace

IdPass::IdPass(const SceneBuffers& scene, const ViewLayout& layout, int batch)
    : scene_(scene), layout_(layout) {
  program_ = NewRasterProgram(kIdVertexShader, kIdFragmentShader);
  ids_ = NewTarget(GL_R32UI, layout.width, layout.height, batch);
  depth_ = NewTarget(GL_DEPTH_COMPONENT32F, layout.width, layout.height);
  GLuint name = 0;
  for (int layer = 0; layer < batch; ++layer) {
    glCreateFramebuffers(1, &name);
    framebuffers_.emplace_back(name);
    glNamedFramebufferTextureLayer(name, GL_COLOR_ATTACHMENT0, ids_.get(), 0, layer);
    glNamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, depth_.get(), 0);
  }
  glCreateVertexArrays(1, &name);
  vertices_ = GlVertexArray(name);
  glVertexArrayVertexBuffer(name, 0, scene.corners.get(), 0, 3 * sizeof(float));
  glVertexArrayAttribFormat(name, 0, 3, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(name, 0, 0);
  glEnableVertexArrayAttrib(name, 0);
}

void IdPass::Begin(std::size_t layer) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[layer].get());
  const std::array<GLuint, 4> none = {};
  const float far = 0.0f;
  glClearBufferuiv(GL_COLOR, 0, none.data());
  glClearBufferfv(GL_DEPTH, 0, &far);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  if (scene_.mesh.back_faces) {
    glDisable(GL_CULL_FACE);
  } else {
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
  }
  glUseProgram(program_.get());
  glBindVertexArray(vertices_.get());
  glUniform1f(4, kNear);
}

void IdPass::Draw(std::span<const CameraPose> cameras, bool leave_out_hidden) {
  std::vector<int> visible;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    Begin(i);
    if (leave_out_hidden) {
      DrawNearToFar(cameras[i]);
      continue;
    }
    for (const FlatView& view : layout_.views) {
      SetView(cameras[i], view);
      visible.clear();
      const auto in_view = ChunksInView(scene_.chunks, cameras[i], view);
      for (const ChunkInView& item : in_view) visible.push_back(item.chunk);
      DrawChunks(visible);
    }
  }
}

void IdPass::DrawNearToFar(const CameraPose& camera) {
  std::vector<std::span<const ChunkInView>> left;
  std::vector<std::vector<ChunkInView>> in_view;
  for (const FlatView& view : layout_.views) {
    in_view.push_back(ChunksInView(scene_.chunks, camera, view));
  }
  left.assign(in_view.begin(), in_view.end());
  for (std::size_t round = 0; round < kRounds.size(); ++round) {
    std::optional<DepthTiles> tiles;
    if (round > 0) tiles = ReadDepth();
    for (std::size_t v = 0; v < left.size(); ++v) {
      const auto end = std::upper_bound(left[v].begin(), left[v].end(), kRounds[round], IsNearer);
      const auto count = static_cast<std::size_t>(end - left[v].begin());
      DrawThoseSeen(camera, layout_.views[v], left[v].first(count), tiles);
      left[v] = left[v].subspan(count);
    }
  }
}

void IdPass::DrawThoseSeen(const CameraPose& camera, const FlatView& view,
                           std::span<const ChunkInView> items,
                           const std::optional<DepthTiles>& tiles) {
  const ViewAxes axes(view, camera);
  std::vector<int> chosen;
  for (const ChunkInView& item : items) {
    const Chunk& chunk = scene_.chunks[static_cast<std::size_t>(item.chunk)];
    if (!tiles || tiles->MayShow(chunk, camera, view, axes, kNear)) chosen.push_back(item.chunk);
  }
  SetView(camera, view);
  DrawChunks(chosen);
}

void IdPass::SetView(const CameraPose& camera, const FlatView& view) {
  const ViewAxes axes(view, camera);
  glUniform3fv(0, 1, camera.position.data());
  glUniform3fv(1, 1, axes.right.data());
  glUniform3fv(2, 1, axes.up.data());
  glUniform3fv(3, 1, axes.forward.data());
  glViewport(view.first_x, 0, view.width, view.height);
}

void IdPass::DrawChunks(const std::vector<int>& chunks) {
  firsts_.clear();
  counts_.clear();
  for (const int index : chunks) {
    const Chunk& chunk = scene_.chunks[static_cast<std::size_t>(index)];
    firsts_.push_back(3 * chunk.first);
    counts_.push_back(3 * chunk.count);
  }
  glMultiDrawArrays(GL_TRIANGLES, firsts_.data(), counts_.data(),
                    static_cast<GLsizei>(firsts_.size()));
}

DepthTiles IdPass::ReadDepth() {
  depth_picture_.resize(static_cast<std::size_t>(layout_.width) *
                        static_cast<std::size_t>(layout_.height));
  glReadPixels(0, 0, layout_.width, layout_.height, GL_DEPTH_COMPONENT, GL_FLOAT,
               depth_picture_.data());
  return {depth_picture_, layout_.width, layout_.height};
}

void IdPass::ReadIds(std::vector<std::uint32_t>* ids) const {
  ids->resize(static_cast<std::size_t>(layout_.width) * static_cast<std::size_t>(layout_.height));
  glReadPixels(0, 0, layout_.width, layout_.height, GL_RED_INTEGER, GL_UNSIGNED_INT, ids->data());
}

}  // namespace bulletnav::sim
