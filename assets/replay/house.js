// SPDX-License-Identifier: MIT
// The house in 3D, when asked for: the floor as the plan shows it, walls cut at breast height, paths.
"use strict";
const kCut = 1.3;        // metres, where walls end so that one can look in
const kPathHeight = 0.12;
const eye = {turn: 0.6, tilt: 0.9, far: 1.0};
const solid = {gl: null, program: null, of: null, parts: []};

const kVertex = `attribute vec3 at; attribute vec2 uv; attribute vec3 tone; uniform mat4 view;
varying vec2 where; varying vec3 color;
void main() { where = uv; color = tone; gl_Position = view * vec4(at, 1.0); }`;
const kFragment = `precision mediump float; uniform sampler2D floor_picture;
varying vec2 where; varying vec3 color;
void main() {
  gl_FragColor = where.x < 0.0 ? vec4(color, 1.0) : texture2D(floor_picture, where);
  if (gl_FragColor.a < 0.5) discard;
}`;

function makeProgram(gl) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, kVertex], [gl.FRAGMENT_SHADER, kFragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  return program;
}

/// Starts WebGL once; null where there is none.
function startSolid() {
  if (solid.gl === null) {
    solid.gl = byId("house").getContext("webgl", {antialias: true}) || undefined;
    if (solid.gl) solid.program = makeProgram(solid.gl);
  }
  return solid.gl || null;
}

function toneOf(name, light) { return rgba(name, 255).slice(0, 3).map(value => value / 255 * light); }

/// Appends a quad of corners [x, y, z], with one tone.
function quad(list, corners, tone) {
  for (const i of [0, 1, 2, 0, 2, 3]) list.push(...corners[i], -1, -1, ...tone);
}

/// A wall's piece along a to b, from one height to another.
function block(list, [ax, az], [bx, bz], thickness, low, high) {
  if (high - low < 0.01) return;
  const length = Math.hypot(bx - ax, bz - az) || 1;
  const nx = -(bz - az) / length * thickness / 2, nz = (bx - ax) / length * thickness / 2;
  const corners = [[ax + nx, az + nz], [bx + nx, bz + nz], [bx - nx, bz - nz], [ax - nx, az - nz]];
  const at = (i, y) => [corners[i][0], y, corners[i][1]];
  quad(list, [0, 1, 2, 3].map(i => at(i, high)), toneOf("wall", 1));
  for (let i = 0; i < 4; ++i) {
    const k = (i + 1) % 4;
    quad(list, [at(i, low), at(k, low), at(k, high), at(i, high)], toneOf("wall", i % 2 ? 0.62 : 0.8));
  }
}

/// Shares of a wall's length that openings take: [from, to, bottom, top].
function openingsOf(wall, holes) {
  const [ax, az, bx, bz, thickness] = wall;
  const length = Math.hypot(bx - ax, bz - az) || 1;
  const ux = (bx - ax) / length, uz = (bz - az) / length;
  const along = (x, z) => (x - ax) * ux + (z - az) * uz;
  const off = (x, z) => Math.abs((x - ax) * uz - (z - az) * ux);
  return holes.filter(([x, z, u, v]) => off(x, z) < thickness && off(u, v) < thickness &&
                      along(x, z) > -0.1 && along(x, z) < length + 0.1)
    .map(([x, z, u, v, , bottom, top]) => [Math.min(along(x, z), along(u, v)), Math.max(along(x, z), along(u, v)), bottom, top])
    .sort((one, other) => one[0] - other[0]);
}

function wallPieces(list, wall, holes) {
  const [ax, az, bx, bz, thickness] = wall;
  const length = Math.hypot(bx - ax, bz - az) || 1;
  const point = s => [ax + (bx - ax) * s / length, az + (bz - az) * s / length];
  let done = 0;
  for (const [from, to, bottom, top] of openingsOf(wall, holes)) {
    block(list, point(done), point(Math.max(done, from)), thickness, 0, kCut);
    block(list, point(from), point(to), thickness, 0, Math.min(bottom, kCut));
    block(list, point(from), point(to), thickness, Math.min(top, kCut), kCut);
    done = Math.max(done, to);
  }
  block(list, point(done), point(length), thickness, 0, kCut);
}

function floorPicture(storey) {
  const canvas = document.createElement("canvas");
  const [u, v] = storey.size.map(size => 1024 / size);
  canvas.width = canvas.height = 1024;
  const ctx = canvas.getContext("2d");
  ctx.setTransform(u, 0, 0, v, -u * storey.low[0], -v * storey.low[1]);
  drawFloor(ctx, storey);
  ctx.drawImage(storey.image, ...storey.low, ...storey.size);
  return canvas;
}

function meshOf(storey) {
  const [x, z] = storey.low, [wide, deep] = storey.size;
  const list = [];
  const corner = (u, v) => [x + u * wide, 0, z + v * deep, u, v, 0, 0, 0];
  for (const [u, v] of [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]]) list.push(...corner(u, v));
  for (const wall of storey.walls || []) wallPieces(list, wall, storey.holes || []);
  const cuts = storey.walls ? [] : storey.cuts;
  for (let i = 0; i < cuts.length; i += 4) {
    block(list, [cuts[i], cuts[i + 1]], [cuts[i + 2], cuts[i + 3]], 0.05, 0, kCut);
  }
  return new Float32Array(list);
}

/// A ribbon along the floor, wide enough to be seen from afar.
function ribbon(points, name) {
  const list = [];
  const tone = toneOf(name, 1);
  for (let i = 0; i + 1 < points.length; ++i) {
    const [ax, az] = points[i], [bx, bz] = points[i + 1];
    const length = Math.hypot(bx - ax, bz - az);
    if (length < 1e-4) continue;
    const nx = -(bz - az) / length * 0.035, nz = (bx - ax) / length * 0.035;
    quad(list, [[ax + nx, kPathHeight, az + nz], [bx + nx, kPathHeight, bz + nz],
                [bx - nx, kPathHeight, bz - nz], [ax - nx, kPathHeight, az - nz]], tone);
  }
  return list;
}

function post(list, [x, z], size, height, name) {
  const tone = toneOf(name, 1), dark = toneOf(name, 0.7);
  const at = [[x - size, z - size], [x + size, z - size], [x + size, z + size], [x - size, z + size]];
  quad(list, at.map(([u, v]) => [u, height, v]), tone);
  for (let i = 0; i < 4; ++i) {
    const [a, b] = [at[i], at[(i + 1) % 4]];
    quad(list, [[a[0], 0, a[1]], [b[0], 0, b[1]], [b[0], height, b[1]], [a[0], height, a[1]]], i % 2 ? tone : dark);
  }
}

function multiply(a, b) {  // column by column, as WebGL has them
  return Float32Array.from({length: 16}, (_, i) => {
    let value = 0;
    for (let k = 0; k < 4; ++k) value += a[4 * k + i % 4] * b[4 * (i >> 2) + k];
    return value;
  });
}

function viewOf(storey, aspect) {
  const extent = Math.max(...storey.size);
  const far = extent * 1.1 * eye.far, focal = 1.8;
  const s = Math.sin(eye.turn), c = Math.cos(eye.turn), t = Math.sin(eye.tilt), u = Math.cos(eye.tilt);
  const middle = storey.low.map((low, i) => low + storey.size[i] / 2);
  const lens = [focal / Math.max(1, aspect), 0, 0, 0, 0, focal * Math.min(1, aspect), 0, 0, 0, 0, -1.002, -1, 0, 0, -0.4, 0];
  const turned = [c, -s * t, s * u, 0, 0, u, t, 0, -s, -c * t, c * u, 0, 0, 0, -far, 1];
  const moved = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -middle[0], 0, -middle[1], 1];
  return multiply(lens, multiply(turned, moved));
}

function drawMesh(gl, numbers) {
  gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STREAM_DRAW);
  [["at", 3, 0], ["uv", 2, 12], ["tone", 3, 20]].forEach(([name, size, offset]) => {
    const place = gl.getAttribLocation(solid.program, name);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, size, gl.FLOAT, false, 32, offset);
  });
  gl.drawArrays(gl.TRIANGLES, 0, numbers.length / 8);
}

function movingParts(one, two) {
  const list = [];
  for (const [result, name] of [[one, "a"], [two, "b"]]) {
    if (!result) continue;
    const step = Math.min(now.step, result.steps);
    const points = result.poses.map(floorOf);
    list.push(...ribbon(points.slice(0, step + 1), name));
    post(list, points[step], 0.1, 1.5, name);
  }
  one.path.goals.forEach(pose => post(list, floorOf(pose), 0.08, 1.0, "goal"));
  return new Float32Array(list);
}

function setFloor(gl, storey) {
  const theme = document.documentElement.dataset.theme;
  if (solid.of === storey && solid.theme === theme) return;
  Object.assign(solid, {of: storey, theme, mesh: meshOf(storey)});
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, floorPicture(storey));
  gl.generateMipmap(gl.TEXTURE_2D);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
}

async function drawHouse() {
  const gl = startSolid();
  const {one, two} = now;
  if (!gl || !one || one.row.scene_block < 0) return;
  const storey = await storeyOf(one.row.scene_block);
  if (one !== now.one) return;
  const canvas = byId("house"), ratio = window.devicePixelRatio || 1;
  canvas.width = canvas.clientWidth * ratio;
  canvas.height = canvas.clientHeight * ratio;
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.clearColor(...rgba("void", 255).map(value => value / 255));
  gl.enable(gl.DEPTH_TEST);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.useProgram(solid.program);
  setFloor(gl, storey);
  const view = viewOf(storey, canvas.width / canvas.height);
  gl.uniformMatrix4fv(gl.getUniformLocation(solid.program, "view"), false, view);
  drawMesh(gl, solid.mesh);
  drawMesh(gl, movingParts(one, two));
}

byId("house").onpointermove = event => {
  if (!event.buttons) return;
  eye.turn -= event.movementX * 0.01;
  eye.tilt = Math.min(1.5, Math.max(0.15, eye.tilt + event.movementY * 0.01));
  drawHouse();
};
byId("house").onwheel = event => {
  event.preventDefault();
  eye.far = Math.min(3, Math.max(0.15, eye.far * Math.exp(event.deltaY * 0.001)));
  drawHouse();
};
