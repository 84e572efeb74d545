// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "sim/house/materials.h"
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// How much light a part gives off, for baking; drawn at full brightness itself.
enum class Glow { kNone, kLamp, kSky };

/// Puts simple solids together into one mesh. Lengths in metres; y up. Everything added goes
/// through the current frame (see Frame). Texture coordinates are in metres of the part's own axes
/// divided by the material's size, so that patterns keep their scale and follow the part when it is
/// turned. Faces look outwards, counter-clockwise.
class MeshBuilder {
 public:
  using Vec = Eigen::Vector3f;
  using Vec2 = Eigen::Vector2f;

  /// A level ellipse with half axes along x and z.
  struct Oval {
    Vec centre;
    Vec2 radii;
  };

  /// While one lives, parts are added relative to it: X_parent_this. Frames nest.
  class Frame {
   public:
    Frame(MeshBuilder* builder, const Eigen::Affine3f& X_parent_this);
    /// Translation to `at` and a turn about y, radians counter-clockwise from above.
    Frame(MeshBuilder* builder, const Vec& at, float yaw = 0.0f);
    ~Frame();
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;
    Frame(Frame&&) = delete;
    Frame& operator=(Frame&&) = delete;

   private:
    MeshBuilder* builder_;
    Eigen::Affine3f saved_;
  };

  /// Flat four-sided face a, b, c, d, counter-clockwise seen from its front. `u` is the direction
  /// in which the material's picture runs to the right; zero lets the builder choose.
  void Quad(const Surface& surface, const Vec& a, const Vec& b, const Vec& c, const Vec& d,
            const Vec& u = Vec::Zero());
  /// The same with the picture stretched over it once: a at the lower left, b at the lower right.
  /// `part` is what of it to show, in pictures from its lower left; it repeats beyond 1.
  void Picture(const Surface& surface, const Vec& a, const Vec& b, const Vec& c, const Vec& d,
               const Eigen::AlignedBox2f& part = {Vec2(0, 0), Vec2(1, 1)});
  void Triangle(const Surface& surface, const Vec& a, const Vec& b, const Vec& c);

  /// Axis-aligned box from `low` to `high`.
  void Box(const Surface& surface, const Vec& low, const Vec& high);
  /// Box standing on y = `bottom`, centred on (x, z).
  void Block(const Surface& surface, const Vec& centre_bottom, const Vec& size);
  /// Box with rounded vertical and top edges: cushions, mattresses, appliances.
  void RoundedBox(const Surface& surface, const Vec& low, const Vec& high, float radius);

  /// Solid between two level rectangles, given by their centres and sizes along x and z: legs that
  /// taper or splay, hoods, baskets.
  void TaperedBox(const Surface& surface, const Vec& low, const Vec2& low_size, const Vec& high,
                  const Vec2& high_size);

  /// Upright cylinder or cone frustum standing at `bottom`.
  void Cylinder(const Surface& surface, const Vec& bottom, float radius, float height,
                int sides = 12);
  void Cone(const Surface& surface, const Vec& bottom, float bottom_radius, float top_radius,
            float height, int sides = 12);
  /// Round bar from a to b.
  void Bar(const Surface& surface, const Vec& a, const Vec& b, float radius, int sides = 6);
  /// Profile (radius, height) turned about the vertical axis through `at`: vases, lamps, bowls.
  void Lathe(const Surface& surface, const Vec& at, std::span<const Vec2> profile, int sides = 12);
  /// Skin through level ovals, outwards when they go up: bowls of toilets, tubs, cushions. Open at
  /// its ends unless those have no size.
  void Loft(const Surface& surface, std::span<const Oval> ovals, int sides = 12);
  void Ball(const Surface& surface, const Vec& centre, const Vec& radii, int sides = 10);
  /// Simple polygon in the (x, z) plane, raised from y = low to high, with top and bottom. Any
  /// order.
  void Prism(const Surface& surface, std::span<const Vec2> polygon, float low, float high);
  /// Flat polygon at height y, looking up or down: floors and ceilings, any simple outline.
  void Polygon(const Surface& surface, std::span<const Vec2> polygon, float y, bool faces_up);
  /// Rectangular sheet hanging in folds between a and b (upper edge), `drop` long: curtains,
  /// towels.
  void Drape(const Surface& surface, const Vec& a, const Vec& b, float drop, float fold_depth,
             int folds);

  /// Parts added from now on give light.
  void SetGlow(Glow glow) { glow_ = glow; }

  /// Parts added from now on belong to a new object, which is returned: named by its category and
  /// a number from 1 on.
  const SceneObject& BeginObject(std::string_view category, std::string_view room);

  /// Adds everything `part` holds, through the current frame, to the current object.
  void Append(const MeshBuilder& part);

  std::size_t triangles() const { return mesh_.triangles.size(); }
  /// Box around everything added so far.
  Eigen::AlignedBox3f Bounds() const { return mesh_.Bounds(); }
  /// One a triangle, in step with the mesh's triangles.
  const std::vector<Glow>& glows() const { return glows_; }
  /// The mesh so far, its textures drawn through the cache. Vertices are not shared between faces.
  /// Without objects if none was begun.
  SceneMesh Finish(TextureCache* cache);

 private:
  std::uint32_t MaterialOf(const Surface& surface);
  /// The current object's number.
  std::uint32_t Object() const;
  std::uint32_t AddVertex(const Vec& local, const Vec2& uv);
  void AddTriangle(std::uint32_t material, std::uint32_t a, std::uint32_t b, std::uint32_t c);
  /// Corners in order around a convex face, with texture coordinates in metres.
  void Face(const Surface& surface, std::span<const Vec> corners, std::span<const Vec2> metres);
  /// Six faces; `at(x, y, z)` is a corner, each argument 0 or 1 for its low or high side.
  template <class Corner>
  void Hexahedron(const Surface& surface, const Corner& at);
  /// Strip of quads between rings of points, textured around and along.
  void Tube(const Surface& surface, const std::vector<std::vector<Vec>>& rings);

  /// Ring between two level ovals, textured in one plane: table tops keep their straight grain.
  void LevelBand(const Surface& surface, const std::vector<Vec>& outer,
                 const std::vector<Vec>& inner);

  friend class Frame;
  SceneMesh mesh_;
  std::vector<Glow> glows_;
  Glow glow_ = Glow::kNone;
  Eigen::Affine3f X_WL_ = Eigen::Affine3f::Identity();
  std::map<std::pair<std::string, Rgb8>, std::uint32_t> materials_;
  std::map<std::string, int, std::less<>> objects_of_category_;
};

}  // namespace bulletnav::sim
