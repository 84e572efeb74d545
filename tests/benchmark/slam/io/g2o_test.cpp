// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/g2o.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr const char* kFlat =
    "# a hand-made graph\n"
    "EDGE_SE2 7 9 0.5 -1 0.25 4 0.5 0.25 5 0.125 6\n"
    "\n"
    "VERTEX_SE2 7 1 2 0.5\n"
    "VERTEX_SE2 8 3 4 -0.5\r\n"
    "VERTEX_SE2\t9 5e0 +6 1\n"
    "FIX 8\n"
    "EDGE_SE2 7 8 1 0 0 1 0 0 1 0 1";

TEST(G2o, ReadsAHandMadePlane) {
  const tests::TemporaryFolder folder;
  const auto read = ReadG2o(folder.Write("a.g2o", kFlat));
  const auto& graph = std::get<agent::PlanarPoseGraph>(read);
  ASSERT_EQ(graph.vertices.size(), 3u);
  EXPECT_EQ(graph.vertices[2].id, 9);
  EXPECT_EQ(graph.vertices[2].pose.x, 5.0);
  EXPECT_EQ(graph.vertices[2].pose.y, 6.0);
  EXPECT_EQ(graph.vertices[1].pose.yaw, -0.5);
  EXPECT_FALSE(graph.vertices[0].is_fixed);
  EXPECT_TRUE(graph.vertices[1].is_fixed);
  ASSERT_EQ(graph.edges.size(), 2u);
  EXPECT_EQ(graph.edges[0].from, 7);
  EXPECT_EQ(graph.edges[0].measured.y, -1.0);
  Eigen::Matrix3d information;
  information << 4.0, 0.5, 0.25, 0.5, 5.0, 0.125, 0.25, 0.125, 6.0;
  EXPECT_EQ(graph.edges[0].information, information);
  EXPECT_TRUE(graph.edges[0].is_loop);
  EXPECT_FALSE(graph.edges[1].is_loop);
}

TEST(G2o, ReadsAHandMadeSpace) {
  std::string information;
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) information += i == j ? " 8" : " 0";
  }
  const tests::TemporaryFolder folder;
  const auto read = ReadG2o(folder.Write("a.g2o",
                                         "VERTEX_SE3:QUAT 0 1 2 3 0 0 0 1\n"
                                         "VERTEX_SE3:QUAT 1 1 2 3 0 0 0.6 0.801\n"
                                         "EDGE_SE3:QUAT 0 1 4 5 6 0 0 1 0" +
                                             information + "\n"));
  const auto& graph = std::get<agent::SpatialPoseGraph>(read);
  ASSERT_EQ(graph.vertices.size(), 2u);
  EXPECT_EQ(graph.vertices[0].pose.position, Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR(graph.vertices[1].pose.rotation.norm(), 1.0, 1e-15);
  EXPECT_NEAR(graph.vertices[1].pose.rotation.z(), 0.6, 1e-3);
  ASSERT_EQ(graph.edges.size(), 1u);
  EXPECT_EQ(graph.edges[0].measured.rotation.z(), 1.0);
  // On half angles there, on angles here: (8 * (angle / 2)^2) is 2 * angle^2.
  EXPECT_EQ(graph.edges[0].information(2, 2), 8.0);
  EXPECT_EQ(graph.edges[0].information(5, 5), 2.0);
}

TEST(G2o, WritesWhatItReads) {
  const tests::TemporaryFolder folder;
  agent::SpatialPoseGraph graph;
  const agent::SpatialPose pose = {{0.1, 1.0 / 3.0, -2e-9}, agent::RotationBy({0.3, -0.2, 0.1})};
  graph.vertices = {{-3, {}, true}, {4, pose}};
  agent::PoseMatrix<agent::SpatialPose> root = decltype(root)::Identity();
  root(0, 5) = 0.3;
  root(2, 4) = -0.7;
  graph.edges = {{-3, 4, pose, root * root.transpose()}};
  WriteG2o(folder.path() / "b.g2o", graph);
  const auto read = std::get<agent::SpatialPoseGraph>(ReadG2o(folder.path() / "b.g2o"));
  EXPECT_TRUE(read.vertices[0].is_fixed);
  EXPECT_EQ(read.vertices[1].pose.position, pose.position);
  EXPECT_TRUE(read.vertices[1].pose.rotation.isApprox(pose.rotation, 1e-15));
  EXPECT_TRUE(read.edges[0].information.isApprox(graph.edges[0].information, 1e-15));
  EXPECT_EQ(ToG2o(read), ToG2o(graph));

  const auto flat = ReadG2o(folder.Write("a.g2o", kFlat));
  WriteG2o(folder.path() / "c.g2o", flat);
  EXPECT_EQ(ToG2o(std::get<agent::PlanarPoseGraph>(ReadG2o(folder.path() / "c.g2o"))),
            ToG2o(std::get<agent::PlanarPoseGraph>(flat)));
}

TEST(G2o, TellsFileAndLine) {
  const tests::TemporaryFolder folder;
  const auto expect = [&](const std::string& text, const std::string& what) {
    EXPECT_THAT(
        [&] {
          ReadG2o(folder.Write("bad.g2o", text));
        },
        ThrowsMessage<sim::FileError>(HasSubstr("bad.g2o:" + what)))
        << text;
  };
  const std::string two = "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\n";
  expect("", " has no vertices");
  expect("VERTEX_SE2 0 0 0\n", "1: expected 5 words, 'VERTEX_SE2 id x y yaw', and found 4");
  expect(two + "VERTEX_SE2 1 1 0 0\n", "3: vertex 1 is there twice");
  expect(two + "VERTEX_SE2 x 1 0 0\n", "3: expected a whole number, got 'x'");
  expect("VERTEX_SE2 0 0 nan 0\n", "1: 'nan' is not finite");
  expect("VERTEX_SE2 0 0 1.2.3 0\n", "1: expected a number, got '1.2.3'");
  expect(two + "VERTEX_SE3:QUAT 2 0 0 0 0 0 0 1\n", "3: 'VERTEX_SE3:QUAT' is not known here");
  expect("VERTEX_SE3:QUAT 2 0 0 0 0 0 0 0\n", "1: the quaternion 'qx qy qz qw' is not of length 1");
  expect(two + "\nEDGE_SE2 0 5 1 0 0 1 0 0 1 0 1\n", "4: there is no vertex 5; add it");
  expect(two + "FIX 6\n", "3: there is no vertex 6");
  expect(two + "EDGE_SE2 0 1 1 0 0 1 0 0 -1 0 1\n", "3: the information is not positive definite");
  expect(two + "EDGE_SE2 0 1 1 0 0 inf 0 0 1 0 1\n", "3: 'inf' is not finite");
  expect("VERTEX_SE2 0 1e300 0 0\n", "1: the pose has a number beyond 1e12");
  expect(two + "EDGE_SE2 0 1 1 0 0 1e300 0 0 1e300 0 1e300\n", "3: the information has a number");
  expect(two + "EDGE_SE2 1 1 1 0 0 1 0 0 1 0 1\n", "3: it joins a vertex to itself");
  expect(two + "EDGE" + std::string(1, '\0') + "_SE2 0 1\n", "3: there is a byte of 0");
  EXPECT_THROW(ReadG2o(folder.path() / "none.g2o"), sim::FileError);
}

}  // namespace
}  // namespace bulletnav::bench
