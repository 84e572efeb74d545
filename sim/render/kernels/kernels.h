// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "sim/render/kernels/bvh_layout.h"
#include "sim/render/triangle_shading.h"

/// The inner loops that run on the CPU, compiled once for each instruction set and chosen when the
/// program starts. Plain structs of pointers: these files must not pull in code from std that the
/// linker could then use elsewhere on a processor without that instruction set.
/// All variants compute the same bits: no fused multiply-add, no approximate reciprocals in
/// results.
namespace bulletnav::sim {

inline constexpr int kRowPadding = 16;   // rows of the buffers are a multiple of this long
inline constexpr int kTileColumns = 32;  // the coarse depth grid is 16 x 32 tiles
inline constexpr int kTileRows = 16;
inline constexpr int kBuckets = 512;
inline constexpr float kBucketsPerMetre = 8.0f;

/// The scene, as in RenderMesh and Bvh.
struct KernelScene {
  const BvhNode* nodes;  // for find_visible
  const BvhLeaf* leaves;
  const float* corners;  // for resolve: [triangles, 3, 3]
  const TriangleShading* shading;
  const std::uint32_t* texels;
  const TextureInfo* textures;
  bool back_faces;  // whether find_visible draws triangles seen from behind
};

/// The picture's sampling pattern; made once a renderer.
struct KernelGrid {
  int rows;
  int cols;
  int stride;              // cols rounded up to a multiple of kRowPadding
  int tile_row_shift;      // row >> shift is a row of tiles
  int tile_column_shift;   // column >> shift is a column of tiles
  int circle;              // columns around all headings: cols in a panorama, which goes round;
                           // more in a pinhole picture, which shows the first `cols` of them
  const float* y;          // [rows]
  const float* y_squared;  // [rows]
  const float* area;       // [rows], see RayGrid
  float xz_max;            // largest hypot(x, z)
  float half_pixel;        // half the least step of (x, y, z) from pixel to pixel
  float max_depth;
  // Bounds of boxes and triangles in fixed point with 8 fractional bits; true values lie between
  // an entry and the entry plus the slack.
  const std::int32_t* column_of_angle;  // of a heading in diamond-angle units, [kAngles + 1]
  const std::int32_t* row_of_slope;     // of s = y / (1 + |y|), [kSlopes + 1]
  float angle_scale;                    // entries a diamond-angle unit
  float slope_scale;                    // entries a unit of s
  std::int32_t column_slack;
  std::int32_t row_slack;
};

/// One camera.
struct KernelFrame {
  float origin[3];
  float cos_yaw;
  float sin_yaw;
  const float* x;  // [stride] world directions of the columns
  const float* z;
  const float* xz_squared;  // [stride]
  bool is_level;            // no pitch; else all of the above is of the frame that is made level:
  float tilt[3][3];         // level = tilt * (world - origin)
};

/// A node or leaf that waits for its turn, nearest first.
struct QueueEntry {
  std::int32_t reference;      // as in BvhNode::child
  float inverse_near;          // 1 / t of its nearest possible hit
  std::uint32_t tile_columns;  // a bit for each tile column it may cover
  std::int16_t first_row;
  std::int16_t last_row;
  std::int32_t next;  // in the same bucket, -1 ends
};

/// What each pixel sees.
struct KernelHits {
  float* inverse_t;  // [rows, stride] 1 / t of the nearest hit so far, 0 = none
  std::int32_t* id;  // [rows, stride] its triangle
};

/// Working memory of find_visible.
struct KernelScratch {
  float* tile_farthest;  // [kTileRows, kTileColumns] least inverse_t in a tile
  std::uint16_t*
      dirty;  // [kTileColumns] a bit for each tile whose farthest pixel may have come nearer
  QueueEntry* entries;    // room for every node and leaf
  std::int32_t* buckets;  // [kBuckets] first entry, -1 = none
};

/// A rasteriser's picture of triangle numbers + 1, 0 where there is none.
struct KernelIdPicture {
  const std::uint32_t* ids;
  int width;
  const std::int32_t*
      place;  // [rows, stride] 4 * the lower left of the four ids around a pixel's ray
              // + which of them is nearest (1: right, 2: above)
};

/// A ray of its own, for light and plans: t counts in lengths of `direction`, from 0 to `far`.
struct KernelRay {
  float origin[3];
  float direction[3];
  float far;
};

/// What it meets; triangle -1: nothing.
struct KernelHit {
  float t;
  std::int32_t triangle;
};

struct Kernels {
  const char* name;
  /// Finds the nearest triangle of every pixel: a sweep through the hierarchy from near to far that
  /// leaves out what is hidden behind what is already drawn or falls between the pixels' centres.
  void (*find_visible)(const KernelScene&, const KernelGrid&, const KernelFrame&,
                       const KernelScratch&, const KernelHits&);
  /// Does the same from a rasteriser's picture: meets each pixel's ray with the triangles around
  /// it.
  void (*resolve)(const KernelScene&, const KernelGrid&, const KernelFrame&, const KernelIdPicture&,
                  const KernelHits&);
  /// Colours [rows, cols, 3] and depths [rows, cols] of the hits; either may be null.
  void (*shade)(const KernelScene&, const KernelGrid&, const KernelFrame&, const KernelHits&,
                std::uint8_t* color, float* depth);
  /// What `count` rays meet: the nearest triangle of each, or, if `any`, some triangle.
  void (*trace)(const KernelScene&, const KernelRay*, int count, bool any, KernelHit*);
};

/// The kernels this processor can run and BULLETNAV_ISA allows, the fastest first; at least one.
std::span<const Kernels* const> SupportedKernels();

extern const Kernels kKernelsGeneric;
#ifdef __x86_64__
extern const Kernels kKernelsAvx2;
extern const Kernels kKernelsAvx512;
#endif

}  // namespace bulletnav::sim
