// SPDX-License-Identifier: MIT
#pragma once

namespace bulletnav::sim {

/// Id pass: which triangle is nearest at each pixel of the flat views. Depth is reversed (near /
/// distance), so that floats are as fine far away as close by.
inline constexpr const char* kIdVertexShader = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 0) uniform vec3 origin;
layout(location = 1) uniform vec3 right;    // divided by the view's half extent, like up
layout(location = 2) uniform vec3 up;
layout(location = 3) uniform vec3 forward;
layout(location = 4) uniform float near;
flat out uint id;
void main() {
  vec3 p = position - origin;
  gl_Position = vec4(dot(right, p), dot(up, p), near, dot(forward, p));
  id = uint(gl_VertexID) / 3u + 1u;
}
)";

inline constexpr const char* kIdFragmentShader = R"(#version 450 core
flat in uint id;
layout(location = 0) out uint color;
void main() { color = id; }
)";

/// Resolve pass: for each pixel of the panorama, the triangles seen at the four nearest pixels of
/// the id pass are met with the pixel's own ray, and the nearest hit is shaded with the arithmetic
/// of the CPU's kernels. Four pixels an invocation, because four RGB are three words.
inline constexpr const char* kResolveShader = R"(#version 450 core
layout(local_size_x = 64) in;

struct Triangle {
  vec4 g1, g2;  // xyz gradient, w offset
  vec4 uv0_duv1;
  vec2 duv2;
  uint color0, color1;
  uint color2, texture_index;
  float nx, ny;
  float nz, plane, texel_density, glass;
};
struct View {
  vec4 right;    // xyz in the camera's frame divided by the half extent
  vec4 up;
  vec4 forward;
  ivec4 place;   // first x, width, height in the id picture
};
struct Camera {
  vec4 origin;
  vec4 turn;  // cos, sin of yaw
};

layout(std430, binding = 0) readonly buffer Corners { float corners[]; };
layout(std430, binding = 1) readonly buffer Shading { Triangle triangles[]; };
layout(std430, binding = 2) readonly buffer Texels { uint texels[]; };
layout(std430, binding = 3) readonly buffer Textures { ivec2 textures[]; };
layout(std430, binding = 4) readonly buffer Rays { float rays[]; };  // y, area [rows], x, z [cols]
layout(std430, binding = 5) readonly buffer Views { View views[]; };
layout(std430, binding = 6) readonly buffer Cameras { Camera cameras[]; };
layout(std430, binding = 7) writeonly buffer Output { uint words[]; };  // colours, then depths

layout(binding = 0) uniform usampler2DArray ids;  // a layer a camera
layout(location = 0) uniform ivec4 size;    // rows, cols, pixels of a camera padded to 4, cameras
layout(location = 1) uniform ivec2 layout_;  // views in the ring, all views
layout(location = 2) uniform float max_depth;
layout(location = 3) uniform vec2 tilt;  // cos, sin of the pitch

const float kUnseen = 1e-6;
const float kNearestPlane = 1e-6;

struct Hit {
  uint id;          // + 1; 0: none
  float inverse_t;
  float miss;       // least edge function over their sum: negative outside
};

vec3 corner(uint triangle, uint k, vec3 origin) {
  uint at = 9u * triangle + 3u * k;
  return vec3(corners[at], corners[at + 1u], corners[at + 2u]) - origin;
}

const float kFinePixels = 2.0;  // see kernels/resolve.h

struct Look {
  vec3 origin;
  vec3 ray;
  uint nearest_id;  // of the four around the ray, the one sampled nearest to it
  float area;       // of a pixel
};

Hit meet(uint id, Look look) {
  vec3 a = corner(id - 1u, 0u, look.origin);
  vec3 b = corner(id - 1u, 1u, look.origin);
  vec3 c = corner(id - 1u, 2u, look.origin);
  vec3 n = cross(b - a, c - a);
  float volume = dot(a, n);
  float side = volume < 0.0 ? -1.0 : 1.0;
  float e0 = side * dot(look.ray, cross(b, c));
  float e1 = side * dot(look.ray, cross(c, a));
  float e2 = side * dot(look.ray, cross(a, b));
  float sum = abs(e0) + abs(e1) + abs(e2);
  float facing = side * dot(look.ray, n);
  float inverse_t = facing / (side * volume);
  float miss = min(min(e0, e1), e2) / max(sum, 1e-30);
  bool fine = 0.5 * facing * inverse_t * inverse_t < kFinePixels * look.area;
  if (fine && id == look.nearest_id) miss = max(miss, 0.0);
  return Hit(id, inverse_t, miss);
}

int pick_view(int col, vec3 d) {
  if (layout_.y == layout_.x) return col * layout_.x / size.y;
  int best = 0;
  float most = -1.0;
  for (int i = 0; i < layout_.y; ++i) {
    float ahead = dot(views[i].forward.xyz, d);
    if (ahead > most) { most = ahead; best = i; }
  }
  return best;
}

void consider(uint id, Look look, inout Hit best) {
  Hit hit = meet(id, look);
  if (!(hit.inverse_t > 0.0)) return;
  bool inside = hit.miss >= 0.0;
  bool best_inside = best.miss >= 0.0;
  bool better = inside ? (!best_inside || hit.inverse_t > best.inverse_t)
                       : (!best_inside && hit.miss > best.miss);
  if (better) best = hit;
}

// The nearest triangle that the ray really meets among the four seen around it and, where those do not
// agree, the twelve around them; where it meets none (a gap in the mesh, or something thinner than a
// pixel), the one it misses by least.
Hit nearest_hit(int camera, int row, int col, vec3 d, vec3 origin, vec3 ray) {
  View view = views[pick_view(col, d)];
  vec2 at = vec2(dot(view.right.xyz, d), dot(view.up.xyz, d)) / dot(view.forward.xyz, d);
  vec2 extent = vec2(view.place.yz);
  vec2 pixel = (0.5 + 0.5 * at) * extent - 0.5;
  ivec2 low = clamp(ivec2(floor(pixel)), ivec2(1), view.place.yz - 3);
  ivec3 base = ivec3(low.x + view.place.x, low.y, camera);
  uint around[4];
  for (int i = 0; i < 4; ++i) around[i] = texelFetch(ids, base + ivec3(i & 1, i >> 1, 0), 0).x;
  bvec2 beyond = greaterThan(pixel - vec2(low), vec2(0.5));
  int nearest = (beyond.x ? 1 : 0) + (beyond.y ? 2 : 0);
  Look look = Look(origin, ray, around[nearest], rays[size.x + row]);
  Hit best = Hit(0u, 0.0, -1e30);
  for (int i = 0; i < 4; ++i) {
    bool repeated = around[i] == 0u || (i > 0 && around[i] == around[0]) ||
                    (i > 1 && around[i] == around[1]) || (i > 2 && around[i] == around[2]);
    if (!repeated) consider(around[i], look, best);
  }
  bool agreed = around[0] == around[1] && around[0] == around[2] && around[0] == around[3];
  if (!agreed || best.miss < 0.0) {
    for (int i = 0; i < 16; ++i) {
      uint id = texelFetch(ids, base + ivec3((i & 3) - 1, (i >> 2) - 1, 0), 0).x;
      bool known = id == 0u || id == around[0] || id == around[1] || id == around[2] ||
                   id == around[3];
      if (!known) consider(id, look, best);
    }
  }
  bool empty_around = around[0] == 0u || around[1] == 0u || around[2] == 0u || around[3] == 0u;
  if (best.miss < 0.0 && empty_around) best.id = 0u;
  return best;
}

vec3 unpack(uint color) {
  return vec3(color & 255u, (color >> 8) & 255u, (color >> 16) & 255u);
}

uvec3 bilinear(Triangle t, vec2 uv, float covered) {
  ivec2 info = textures[t.texture_index];
  int level = clamp(((floatBitsToInt(covered * 2.0) >> 23) - 127) >> 1, 0, info.y);
  int log2_side = info.y - level;
  int side = 1 << log2_side;
  int largest = 1 << info.y;
  int start = info.x + (4 * (largest * largest - side * side)) / 3;
  vec2 at = uv * float(side) - 0.5;
  ivec2 low = ivec2(floor(at));
  uvec2 w = uvec2((at - vec2(low)) * 256.0);
  ivec2 p0 = low & (side - 1);
  ivec2 p1 = (low + 1) & (side - 1);
  uint w11 = (w.x * w.y) >> 8;
  uint w10 = w.x - w11;
  uint w01 = w.y - w11;
  uint w00 = 256u - w.x - w01;
  uint t00 = texels[start + (p0.y << log2_side) + p0.x];
  uint t10 = texels[start + (p0.y << log2_side) + p1.x];
  uint t01 = texels[start + (p1.y << log2_side) + p0.x];
  uint t11 = texels[start + (p1.y << log2_side) + p1.x];
  uvec3 sum = uvec3(unpack(t00)) * w00 + uvec3(unpack(t10)) * w10 + uvec3(unpack(t01)) * w01 +
              uvec3(unpack(t11)) * w11;
  return sum >> 8;
}

uint shade(Hit hit, int row, vec3 origin, vec3 ray, float t) {
  Triangle triangle = triangles[hit.id - 1u];
  vec3 p = origin + t * ray;
  float b1 = clamp(dot(p, triangle.g1.xyz) + triangle.g1.w, 0.0, 1.0);
  float b2 = clamp(dot(p, triangle.g2.xyz) + triangle.g2.w, 0.0, 1.0 - b1);
  vec2 uv = triangle.uv0_duv1.xy + b1 * triangle.uv0_duv1.zw + b2 * triangle.duv2;
  vec3 c0 = unpack(triangle.color0);
  vec3 color = c0 + b1 * (unpack(triangle.color1) - c0) + b2 * (unpack(triangle.color2) - c0);
  vec3 normal = vec3(triangle.nx, triangle.ny, triangle.nz);
  float height = max(abs(triangle.plane - dot(normal, origin)), kNearestPlane);
  float footprint = t * t * t * rays[size.x + row];
  uvec3 texel = bilinear(triangle, uv, footprint * (triangle.texel_density / height));
  uvec3 rgb = uvec3(vec3(texel) * color * (1.0 / 255.0) + 0.5);
  return rgb.r | rgb.g << 8 | rgb.b << 16;
}

void main() {
  int quad = int(gl_GlobalInvocationID.x);
  int camera = int(gl_GlobalInvocationID.y);
  if (4 * quad >= size.z) return;
  vec3 origin = cameras[camera].origin.xyz;
  vec2 turn = cameras[camera].turn.xy;
  uint colors[4];
  float depths[4];
  for (int i = 0; i < 4; ++i) {
    int pixel = min(4 * quad + i, size.x * size.y - 1);
    int row = pixel / size.y;
    int col = pixel - row * size.y;
    float y = rays[row];
    float z = rays[2 * size.x + size.y + col];
    vec3 d = vec3(rays[2 * size.x + col], y * tilt.x - z * tilt.y, y * tilt.y + z * tilt.x);
    vec3 ray = vec3(d.x * turn.x + d.z * turn.y, d.y, d.z * turn.x - d.x * turn.y);
    Hit hit = nearest_hit(camera, row, col, d, origin, ray);
    float t = 1.0 / max(hit.inverse_t, kUnseen);
    bool seen = hit.id != 0u && hit.inverse_t > kUnseen;
    colors[i] = seen ? shade(hit, row, origin, ray, t) : 0u;
    depths[i] = seen ? min(t * length(d), max_depth) : 0.0;
    if (seen && triangles[hit.id - 1u].glass > 0.0) depths[i] = -depths[i];  // so marked
  }
  uint color_at = uint(camera) * uint(size.z / 4 * 3) + uint(3 * quad);
  words[color_at] = colors[0] | colors[1] << 24;
  words[color_at + 1u] = colors[1] >> 8 | colors[2] << 16;
  words[color_at + 2u] = colors[2] >> 16 | colors[3] << 8;
  uint depth_at = uint(size.w) * uint(size.z / 4 * 3) + uint(camera) * uint(size.z) + uint(4 * quad);
  for (int i = 0; i < 4; ++i) words[depth_at + uint(i)] = floatBitsToUint(depths[i]);
}
)";

}  // namespace bulletnav::sim
