// SPDX-License-Identifier: MIT
#include "benchmark/cli/camera_options.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr const char* kPinhole = "pinhole";

/// "WxH" -> cols and rows.
template <class Spec>
void ParseSize(const std::string& text, Spec* spec) {
  if (text.empty()) return;
  int width = 0;
  int height = 0;
  int used = 0;
  const int fields = std::sscanf(text.c_str(), "%6dx%6d%n", &width, &height, &used);
  if (fields != 2 || used != static_cast<int>(text.size())) {
    throw sim::Error("--size " + text + ": is not WIDTHxHEIGHT, as in 512x128");
  }
  spec->cols = width;
  spec->rows = height;
}

std::vector<std::string> ProjectionNames() {
  std::vector<std::string> names;
  for (const auto& [name, projection] : sim::EnumNames<sim::Projection>::kNames) {
    names.emplace_back(name);
  }
  names.emplace_back(kPinhole);
  return names;
}

std::string Listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : "|") + name;
  return list;
}

}  // namespace

void CameraOptions::AddTo(CLI::App* command) {
  const std::vector<std::string> names = ProjectionNames();
  command->add_option_function<std::string>(
      "--projection",
      [this, names](const std::string& text) {
        if (std::find(names.begin(), names.end(), text) == names.end()) {
          throw CLI::ValidationError("--projection",
                                     "'" + text + "' is not one of " + Listed(names));
        }
        projection_ = text;
      },
      "Projection: " + Listed(names));
  command->add_option("--size", size_,
                      "Width and height in pixels: WxH (512x128; pinhole 640x480)");
  const auto number = [this](double* value) {
    return [this, value](double given) {
      *value = given;
      is_pinhole_wanted_ = true;
    };
  };
  command->add_option_function<double>("--hfov", number(&hfov_deg_),
                                       "Pinhole: horizontal field of view, degrees (90)");
  command->add_option_function<double>("--pitch", number(&pitch_deg_),
                                       "Pinhole: degrees upwards, negative looks down (0)");
}

sim::CameraSpec CameraOptions::spec() const {
  if (projection_ == kPinhole) return Pinhole();
  if (is_pinhole_wanted_) {
    throw sim::Error("--hfov and --pitch are of a pinhole camera; give --projection pinhole too");
  }
  return Panorama();
}

sim::CameraSpec CameraOptions::Pinhole() const {
  sim::PinholeSpec spec;
  ParseSize(size_, &spec);
  spec.hfov_deg = hfov_deg_;
  spec.pitch_deg = pitch_deg_;
  try {
    spec.Validate();
  } catch (const sim::Error& e) {
    throw sim::Error(std::string("--projection pinhole: ") + e.what());
  }
  return spec;
}

sim::CameraSpec CameraOptions::Panorama() const {
  sim::PanoramaSpec spec;
  ParseSize(size_, &spec);
  for (const auto& [name, projection] : sim::EnumNames<sim::Projection>::kNames) {
    if (name == projection_) spec.projection = projection;
  }
  try {
    spec.Validate();
  } catch (const sim::Error& e) {
    throw sim::Error("--size " + size_ + ": " + e.what());
  }
  return spec;
}

}  // namespace bulletnav::bench
