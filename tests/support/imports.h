// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/scene/import.h"
#include "sim/scene/mesh.h"

namespace bulletnav::tests {

/// What importing the file is refused with, or "no error".
inline std::string ImportError(const std::filesystem::path& file,
                               const sim::ImportOptions& options = {}) {
  try {
    sim::ImportScene(file, options);
  } catch (const sim::Error& e) {
    return e.what();
  }
  return "no error";
}

/// Around the triangles of the objects with that name.
inline Eigen::AlignedBox3f BoxOf(const sim::SceneMesh& mesh, const std::string& name) {
  Eigen::AlignedBox3f box;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.objects[mesh.triangle_objects[t]].name != name) continue;
    for (const std::uint32_t v : mesh.triangles[t]) box.extend(mesh.positions[v]);
  }
  return box;
}

/// Corners within 2 micrometres.
inline void ExpectBox(const Eigen::AlignedBox3f& box, const Eigen::Vector3f& low,
                      const Eigen::Vector3f& high) {
  EXPECT_LT((box.min() - low).norm(), 2e-6f) << box.min().transpose();
  EXPECT_LT((box.max() - high).norm(), 2e-6f) << box.max().transpose();
}

}  // namespace bulletnav::tests
