// SPDX-License-Identifier: MIT
// The house in 3D with the paths in it, by WebGL: walls raised from the plan.
"use strict";
const kWallHeight = 1.6;  // metres: cut there, to look in
const solid = {gl: null, canvas: null, storey: null, count: 0, turn: 0, tilt: 1, zoom: 1};

const kVertexProgram = `
attribute vec3 at; attribute vec3 up; attribute vec4 ink; attribute vec2 spot;
uniform mat4 matrix; varying vec4 tint; varying vec2 place;
void main() {
  float light = length(up) < 0.1 ? 1.0 : 0.62 + 0.38 * max(dot(up, normalize(vec3(0.4, 0.8, 0.45))), 0.0) + 0.08 * up.x;
  tint = vec4(ink.rgb * light, ink.a);
  place = spot;
  gl_Position = matrix * vec4(at, 1.0);
}`;
const kPixelProgram = `
precision mediump float;
varying vec4 tint; varying vec2 place; uniform sampler2D picture;
void main() {
  vec4 over = texture2D(picture, place);
  if (place.x >= 0.0 && over.a < 0.5) discard;
  gl_FragColor = place.x < 0.0 ? tint : vec4(over.rgb, 1.0);
}`;

function compile(gl) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, kVertexProgram], [gl.FRAGMENT_SHADER, kPixelProgram]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  return gl.getProgramParameter(program, gl.LINK_STATUS) ? program : null;
}

/// Twelve numbers a corner: place, normal (0: no light), colour, place in the picture (-1: none).
class Surfaces {
  constructor() { this.numbers = []; }
  corner(at, up, ink, spot = [-1, -1]) { this.numbers.push(...at, ...up, ...ink, ...spot); }
  quad([a, b, c, d], up, ink) { for (const at of [a, b, c, a, c, d]) this.corner(at, up, ink); }
  triangle(corners, up, ink) { for (const at of corners) this.corner(at, up, ink); }
  /// A box over a line: a wall from `low` to `high`.
  wall([ax, az, bx, bz], thickness, low, high, ink) {
    const length = Math.hypot(bx - ax, bz - az) || 1, half = Math.max(thickness, 0.04) / 2;
    const u = (bx - ax) / length, v = (bz - az) / length, n = [-v * half, u * half];
    const ring = [[ax + n[0], az + n[1]], [bx + n[0], bz + n[1]], [bx - n[0], bz - n[1]], [ax - n[0], az - n[1]]];
    const ups = [[-v, 0, u], [u, 0, v], [v, 0, -u], [-u, 0, -v]];
    ring.forEach(([x, z], i) => {
      const [x2, z2] = ring[(i + 1) % 4];
      this.quad([[x, low, z], [x2, low, z2], [x2, high, z2], [x, high, z]], ups[i], ink);
    });
    this.quad(ring.map(([x, z]) => [x, high, z]), [0, 1, 0], ink);
  }
  /// A flat ribbon along points x, z.
  ribbon(points, y, width, ink) {
    for (let i = 0; i + 1 < points.length; ++i) {
      const [[ax, az], [bx, bz]] = [points[i], points[i + 1]], length = Math.hypot(bx - ax, bz - az);
      if (length < 1e-6) continue;
      const n = [-(bz - az) / length * width / 2, (bx - ax) / length * width / 2];
      this.quad([[ax + n[0], y, az + n[1]], [bx + n[0], y, bz + n[1]], [bx - n[0], y, bz - n[1]], [ax - n[0], y, az - n[1]]], [0, 0, 0], ink);
    }
  }
}

const inkOfTheme = (name, alpha = 1) => [...rgb(colours[name]).map(part => part / 255), alpha];

/// The parts of a wall that its openings leave: below, above and between them.
function addWall(surfaces, wall, holes, ink) {
  const [ax, az, bx, bz, thickness] = wall;
  const length = Math.hypot(bx - ax, bz - az), u = [(bx - ax) / length, (bz - az) / length];
  const along = (x, z) => (x - ax) * u[0] + (z - az) * u[1];
  const point = at => [ax + u[0] * at, az + u[1] * at];
  const inside = holes.map(hole => ({from: along(hole[0], hole[1]), to: along(hole[2], hole[3]), low: hole[5], high: hole[6],
    off: Math.max(...[[hole[0], hole[1]], [hole[2], hole[3]]].map(([x, z]) => Math.abs((x - ax) * u[1] - (z - az) * u[0])))}))
    .map(one => ({...one, from: Math.min(one.from, one.to), to: Math.max(one.from, one.to)}))
    .filter(one => one.off < 0.2 && one.to > 0.01 && one.from < length - 0.01).sort((a, b) => a.from - b.from);
  let at = 0;
  for (const hole of inside) {
    if (hole.from > at) surfaces.wall([...point(at), ...point(hole.from)], thickness, 0, kWallHeight, ink);
    const span = [...point(hole.from), ...point(hole.to)];
    if (hole.low > 0.01) surfaces.wall(span, thickness, 0, hole.low, ink);
    if (hole.high < kWallHeight) surfaces.wall(span, thickness, hole.high, kWallHeight, ink);
    at = Math.max(at, hole.to);
  }
  if (at < length) surfaces.wall([...point(at), bx, bz], thickness, 0, kWallHeight, ink);
}

/// Floor with the furniture's picture, walls.
function houseSurfaces(storey) {
  const surfaces = new Surfaces(), floor = inkOfTheme("room"), wall = inkOfTheme("solid-wall");
  const [x, z] = storey.low, [width, depth] = storey.size;
  const corner = (u, v) => surfaces.corner([x + u * width, 0, z + v * depth], [0, 0, 0], floor, [u, v]);
  for (const [u, v] of [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]]) corner(u, v);
  for (const one of storey.walls || []) addWall(surfaces, one, storey.holes || [], wall);
  for (let i = 0; !storey.walls && i < storey.cuts.length; i += 4) {
    surfaces.wall(storey.cuts.slice(i, i + 4), 0.05, 0, kWallHeight, wall);
  }
  return surfaces.numbers;
}

/// What moves: paths so far, bodies, goals, the graph.
function movingSurfaces(scene) {
  const surfaces = new Surfaces();
  scene.results.forEach((result, i) => {
    const ink = inkOfTheme(i ? "b" : "a"), gone = Math.min(scene.step, result.steps);
    surfaces.ribbon(result.poses.slice(0, gone + 1).map(p => [p[0], p[2]]), 0.06 + 0.01 * i, 0.1, ink);
    const [x, , z, yaw] = result.poses[gone], s = Math.sin(yaw), c = Math.cos(yaw);
    const spot = (ahead, left, y) => [x - s * ahead - c * left, y, z - c * ahead + s * left];
    const top = spot(0, 0, 0.9), ring = [spot(0.4, 0, 0.1), spot(-0.25, 0.25, 0.1), spot(-0.25, -0.25, 0.1)];
    ring.forEach((one, k) => surfaces.triangle([one, ring[(k + 1) % 3], top], [k - 1, 0.3, 0.3], ink));
  });
  const main = scene.results[0], good = inkOfTheme("good");
  for (const goal of main.path.goals) surfaces.wall([goal[0] - 0.08, goal[2], goal[0] + 0.08, goal[2]], 0.16, 0, 2.4, good);
  if (layers.shortest) surfaces.ribbon(main.path.shortest_path.map(p => [p[0], p[2]]), 0.05, 0.05, good);
  const beliefs = layers.beliefs ? beliefsAt(main, scene.step) : null;
  if (beliefs) {
    const ink = inkOfTheme("graph"), places = beliefs.nodes.map(([ahead, left]) => main.plane.at(ahead, left));
    for (const [i, j] of beliefs.edges) surfaces.ribbon([places[i], places[j]], 0.09, 0.04, ink);
    places.forEach(([x, z], i) => surfaces.wall([x - 0.09, z, x + 0.09, z], 0.18, 0, beliefs.nodes[i][2] ? 0.1 : 0.5, ink));
  }
  return surfaces.numbers;
}

function product(a, b) {
  const out = new Float32Array(16);
  for (let i = 0; i < 4; ++i) for (let j = 0; j < 4; ++j) for (let k = 0; k < 4; ++k) out[4 * j + i] += a[4 * k + i] * b[4 * j + k];
  return out;
}

/// World to clip coordinates: looks at the house's middle from a turn and a tilt.
function cameraMatrix(storey, aspect) {
  const far = 1.25 * Math.hypot(...storey.size) / solid.zoom / Math.min(aspect, 1.2);
  const [x, z] = [storey.low[0] + storey.size[0] / 2, storey.low[1] + storey.size[1] / 2];
  const s = Math.sin(solid.turn), c = Math.cos(solid.turn), st = Math.sin(solid.tilt), ct = Math.cos(solid.tilt);
  const move = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -x, -0.8, -z, 1];
  const turn = [c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1];
  const tilt = [1, 0, 0, 0, 0, ct, st, 0, 0, -st, ct, 0, 0, 0, -far, 1];
  const focal = 1.9, near = 0.1, end = 400;
  const lens = [focal / aspect, 0, 0, 0, 0, focal, 0, 0, 0, 0, (end + near) / (near - end), -1, 0, 0, 2 * end * near / (near - end), 0];
  return product(lens, product(tilt, product(turn, move)));
}

/// The floor and what stands on it as a picture; clear outside the house.
function floorPicture(storey) {
  const canvas = document.createElement("canvas");
  Object.assign(canvas, {width: 1024, height: 1024});
  const pen = canvas.getContext("2d");
  const kept = {...view};
  Object.assign(view, {turned: false, scale: 1, left: -storey.low[0], top: -storey.low[1]});
  pen.scale(1024 / storey.size[0], 1024 / storey.size[1]);
  drawFloor(pen, storey);
  Object.assign(view, kept);
  return canvas;
}

/// Makes ready to draw; false without WebGL or without the house.
function openHouse(canvas, scene) {
  if (!solid.gl) {
    solid.gl = canvas.getContext("webgl", {antialias: true, preserveDrawingBuffer: true});
    if (!solid.gl) return false;
    solid.program = compile(solid.gl);
    if (!solid.program) { solid.gl = null; return false; }
    solid.still = solid.gl.createBuffer();
    solid.moving = solid.gl.createBuffer();
    solid.canvas = canvas;
    addTurning(canvas);
  }
  return Boolean(scene.storey);
}

/// Looks at a house so that its long side lies across.
function faceHouse(storey) {
  Object.assign(solid, {turn: storey.size[1] > storey.size[0] ? 1.25 : 0.32, tilt: 1, zoom: 1});
}

function fillHouse(storey) {
  const gl = solid.gl, key = storey.number + document.documentElement.dataset.theme;
  if (solid.key === key) return;
  if (solid.storey !== storey) faceHouse(storey);
  solid.texture = solid.texture || gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, solid.texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, floorPicture(storey));
  for (const [name, value] of [[gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE], [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE],
                               [gl.TEXTURE_MIN_FILTER, gl.LINEAR]]) gl.texParameteri(gl.TEXTURE_2D, name, value);
  const numbers = new Float32Array(houseSurfaces(storey));
  gl.bindBuffer(gl.ARRAY_BUFFER, solid.still);
  gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
  Object.assign(solid, {key, storey, count: numbers.length / 12});
}

function drawBuffer(buffer, count) {
  const gl = solid.gl;
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  for (const [name, size, first] of [["at", 3, 0], ["up", 3, 3], ["ink", 4, 6], ["spot", 2, 10]]) {
    const place = gl.getAttribLocation(solid.program, name);
    if (place < 0) continue;
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, size, gl.FLOAT, false, 48, 4 * first);
  }
  gl.drawArrays(gl.TRIANGLES, 0, count);
}

function drawHouse(scene) {
  const gl = solid.gl, canvas = solid.canvas, ratio = window.devicePixelRatio || 1;
  fillHouse(scene.storey);
  canvas.width = Math.round(canvas.clientWidth * ratio);
  canvas.height = Math.round(canvas.clientHeight * ratio);
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.clearColor(...inkOfTheme("void"));
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.enable(gl.DEPTH_TEST);
  gl.useProgram(solid.program);
  gl.uniformMatrix4fv(gl.getUniformLocation(solid.program, "matrix"), false, cameraMatrix(scene.storey, canvas.width / canvas.height));
  drawBuffer(solid.still, solid.count);
  const numbers = new Float32Array(movingSurfaces(scene));
  gl.bindBuffer(gl.ARRAY_BUFFER, solid.moving);
  gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.DYNAMIC_DRAW);
  drawBuffer(solid.moving, numbers.length / 12);
  gl.depthFunc(gl.GREATER);  // what walls hide shows faintly
  gl.enable(gl.BLEND);
  gl.blendColor(0, 0, 0, 0.35);
  gl.blendFunc(gl.CONSTANT_ALPHA, gl.ONE_MINUS_CONSTANT_ALPHA);
  drawBuffer(solid.moving, numbers.length / 12);
  gl.disable(gl.BLEND);
  gl.depthFunc(gl.LESS);
}

/// Dragging turns and tilts, the wheel goes nearer.
function addTurning(canvas) {
  let last = null;
  canvas.onpointerdown = event => { last = event; canvas.setPointerCapture(event.pointerId); };
  canvas.onpointerup = () => { last = null; };
  canvas.onpointermove = event => {
    if (!last) return;
    solid.turn += (event.clientX - last.clientX) / 200;
    solid.tilt = Math.max(0.1, Math.min(1.55, solid.tilt + (event.clientY - last.clientY) / 200));
    last = event;
    show();
  };
  canvas.onwheel = event => {
    event.preventDefault();
    solid.zoom = Math.max(0.4, Math.min(8, solid.zoom * Math.exp(-event.deltaY / 600)));
    show();
  };
  canvas.ondblclick = () => { faceHouse(solid.storey); show(); };
}
