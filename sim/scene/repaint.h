// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "sim/math/rng.h"
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// Other paint on a scene's things. The default leaves it as it is.
struct Repaint {
  std::uint64_t seed = 0;  // other colours for another seed
  double recolored = 0.0;  // share of textures and colours, see RecolorMaterials
  double exchanged = 0.0;  // share of textures, see ExchangeTextures

  template <class V>
  void Visit(V& v) {
    v("seed", seed);
    v("recolored", recolored);
    v("exchanged", exchanged);
  }
  /// Throws Error.
  void Validate() const;
  bool operator==(const Repaint&) const = default;
};

/// Expects a valid mesh; it stays one. A function of the arguments.
void ApplyRepaint(const Repaint& repaint, SceneMesh* mesh);

/// Gives `share` of a mesh's textures, and of its materials without one, another colour of any hue,
/// mostly pale: what is drawn on a texture stays, lighter and darker. Networks that are trained on
/// scenes painted so cannot know a floor by its wood. Light (colours of vertices) stays.
/// Expects a valid mesh, share in [0, 1]. The same bits on every processor.
/// Source: domain randomisation of colours (Tobin et al., IROS 2017); the ranges are ours.
void RecolorMaterials(double share, const Rng& rng, SceneMesh* mesh);

/// Materials with a texture, `share` of them, take each other's in a random order.
/// Expects as above.
void ExchangeTextures(double share, const Rng& rng, SceneMesh* mesh);

}  // namespace bulletnav::sim
