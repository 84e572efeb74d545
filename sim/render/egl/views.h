// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "sim/render/renderer.h"

namespace bulletnav::sim {

/// One flat view of the id pass. A panorama is covered by a ring of upright views, plus one up and
/// one down for projections that see the poles; a pinhole picture is one view.
struct FlatView {
  Eigen::Vector3f right = Eigen::Vector3f::Zero();  // in the camera's frame before its pitch, unit
  Eigen::Vector3f up = Eigen::Vector3f::Zero();
  Eigen::Vector3f forward = Eigen::Vector3f::Zero();
  float tan_x = 1.0f;  // half extents at distance 1
  float tan_y = 1.0f;
  int first_x = 0;  // place in the id picture, pixels
  int width = 0;
  int height = 0;
};

/// The views of a projection, side by side in one picture. `ring` of them stand upright, clockwise
/// from behind, each covering cols / ring columns.
struct ViewLayout {
  /// `oversampling`: pixels of the views for each of the panorama's, along one side.
  ViewLayout(const CameraSpec& spec, double oversampling);

  std::vector<FlatView> views;
  int ring = 0;
  int width = 0;  // of the whole picture
  int height = 0;

 private:
  void Cover(const PanoramaSpec& spec, double oversampling);
  void Cover(const PinholeSpec& spec, double oversampling);
  /// Half extents at distance 1, and the sizes of a pixel there.
  void SetSizes(const Eigen::Array2d& tangents, const Eigen::Array2d& pixel);
};

/// For each pixel of the panorama, where in the id picture (rows from below) the ids around its ray
/// are, as in KernelIdPicture::place: [rows, stride].
std::vector<std::int32_t> PlacesOfRays(const ViewLayout& layout, const RayGrid& rays, int stride);

/// A view's axes in the world for a camera; right and up are divided by the half extents, so that
/// dot products with them and with forward are clip coordinates.
struct ViewAxes {
  ViewAxes(const FlatView& view, const CameraPose& camera);
  Eigen::Vector3f right;
  Eigen::Vector3f up;
  Eigen::Vector3f forward;
};

}  // namespace bulletnav::sim
