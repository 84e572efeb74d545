// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace bulletnav::sim {

/// What a depth camera makes of a range r along the ray, on a surface that the ray meets at angle
/// theta from its normal. 0 switches a part off; no return is 0.
/// * A reading's standard deviation is axial_m + axial_per_m2 (r - axial_from_m)^2
///   + grazing_m / sqrt(r) (theta / (pi/2 - theta))^2, the steps below included.
/// * Readings are disparity_m / n, n whole: focal length times baseline in steps of disparity.
/// * At an edge of depth, a ray reads its neighbour's surface as often as a normal error sideways
///   of lateral_rad would take it there.
/// * What the camera's partner, baseline_m to its right, cannot see is not read: shadows on the
///   left of near things.
/// * Nothing is read out of min_range_m to max_range_m, or flatter than max_angle_deg, or where
///   albedo cos(theta) / r^2 is below min_signal, within a factor of 0.5 to 1.5 drawn for each
///   pixel. The albedo is the square of the colour's luminance, 0.25 where there is no colour: so
///   what is dark only for want of light is taken for black.
/// * Of glass and mirrors, met at an angle theta from their normal, a share
///   1 - (1 - glass_lost) cos(theta) gives no return, and of the rest a share glass_behind is read
///   from farther off, up to twice the range, as from what is behind a pane or in a mirror; both
///   in patches. Which pixels show glass, the renderer tells (IsGlass).
/// * `panes`: expected number, in a picture, of upright parts of surfaces without any return, for
///   the windows, mirrors and sunlit places that nobody tells from others.
/// Not modelled: what really is behind a pane or in a mirror, errors that last from picture to
/// picture, several echoes. Sources: assets/sensor_noise.yaml.
struct DepthNoise {
  double axial_m = 0.0;
  double axial_per_m2 = 0.0;
  double axial_from_m = 0.0;
  double grazing_m = 0.0;
  double disparity_m = 0.0;
  double lateral_rad = 0.0;
  double baseline_m = 0.0;
  double min_range_m = 0.0;
  double max_range_m = 0.0;  // 0: no limit
  double max_angle_deg = 90.0;
  double min_signal = 0.0;
  double glass_lost = 0.0;
  double glass_behind = 0.0;
  double panes = 0.0;

  template <class V>
  void Visit(V& v) {
    v("axial_m", axial_m);
    v("axial_per_m2", axial_per_m2);
    v("axial_from_m", axial_from_m);
    v("grazing_m", grazing_m);
    v("disparity_m", disparity_m);
    v("lateral_rad", lateral_rad);
    v("baseline_m", baseline_m);
    v("min_range_m", min_range_m);
    v("max_range_m", max_range_m);
    v("max_angle_deg", max_angle_deg);
    v("min_signal", min_signal);
    v("glass_lost", glass_lost);
    v("glass_behind", glass_behind);
    v("panes", panes);
  }
  /// Throws Error.
  void Validate() const;
  bool operator==(const DepthNoise&) const = default;
};

/// What a colour camera makes of a picture, in this order. Display values are taken as square roots
/// of light.
/// * Blur: a point spreads with a standard deviation of blur_px, at most 0.8, across and upwards.
/// * Exposure: light times 2^s, s uniform to +-exposure_stops, one for a picture; white stays
/// white.
/// * Noise: a white pixel has collected `electrons`; their number's variance is itself (shot) plus
///   read_electrons^2. 0 electrons: none.
/// * White balance: red and blue light, each times 1 - white_balance to 1 + white_balance.
/// Source of the noise: EMVA standard 1288, linear camera model.
struct ColorNoise {
  double exposure_stops = 0.0;
  double white_balance = 0.0;
  double blur_px = 0.0;
  double electrons = 0.0;
  double read_electrons = 0.0;

  template <class V>
  void Visit(V& v) {
    v("exposure_stops", exposure_stops);
    v("white_balance", white_balance);
    v("blur_px", blur_px);
    v("electrons", electrons);
    v("read_electrons", read_electrons);
  }
  /// Throws Error.
  void Validate() const;
  bool operator==(const ColorNoise&) const = default;
};

/// Noise of a camera's pictures; by default none.
struct SensorNoise {
  DepthNoise depth;
  ColorNoise color;

  template <class V>
  void Visit(V& v) {
    v("depth", depth);
    v("color", color);
  }
  void Validate() const {
    depth.Validate();
    color.Validate();
  }
  bool is_none() const { return *this == SensorNoise(); }
  bool operator==(const SensorNoise&) const = default;
};

/// The models compiled into the program, `none` first.
std::vector<std::string> SensorNoiseNames();
/// One of them. Throws Error for another name, with those that are known.
SensorNoise NamedSensorNoise(std::string_view name);
/// For configs with a key `sensor_noise`: throws KeyError there unless the name is known.
void RequireSensorNoise(std::string_view name);

/// The same sensor, so much worse (above 1) or better: standard deviations, steps, shadows, what is
/// too dark, what glass loses, and colour's spreads go with `strength`; ranges and angles stay. 0:
/// no noise at all. Expects: strength in [0, 4] (checked).
SensorNoise Scaled(const SensorNoise& noise, double strength);

}  // namespace bulletnav::sim
