// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "benchmark/slam/io/pictures.h"
#include "benchmark/slam/io/trajectory.h"

namespace bulletnav::bench {

/// "320 x 240".
std::string SizeText(int width_px, int height_px);

/// What all pictures of a recording must have in common, asked frame by frame. Each function throws
/// sim::FileError with file and remedy.
class RecordingCheck {
 public:
  /// `folder` is the recording's, for complaints about its intrinsics.
  RecordingCheck(std::filesystem::path folder, const Intrinsics& intrinsics);

  /// RGB of the next frame: at least 8 x 8 pixels, as large as the first one, which holds the
  /// principal point and fits the focal lengths.
  void TakeColor(const std::filesystem::path& file, const sim::Image& color);
  /// Depth of that frame: as large as its colour.
  void TakeDepth(const std::filesystem::path& file, const DepthPicture& depth);
  /// After the last frame: some picture had depth.
  void Finish() const;

 private:
  void TakeFirst(const std::filesystem::path& file, const sim::Image& color);

  std::filesystem::path folder_;
  Intrinsics intrinsics_;
  std::filesystem::path color_;  // the last file
  int width_ = 0;                // of the first picture
  int height_ = 0;
  bool has_depth_ = false;
};

}  // namespace bulletnav::bench
