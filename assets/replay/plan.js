// SPDX-License-Identifier: MIT
// The floor plan: a storey drawn once for a size and theme, and over it what moves.
"use strict";
const layers = {beliefs: true, odometry: false, shortest: true};
const base = {canvas: document.createElement("canvas"), key: ""};
const mapImage = {canvas: document.createElement("canvas"), of: null, version: -1};

function color(name) {
  return getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
}

/// From world x, z to pixels of a canvas that a storey fills.
function fitted(storey, width, height) {
  const margin = 18;
  const [w, h] = storey.size;
  const scale = Math.min((width - 2 * margin) / w, (height - 2 * margin) / h);
  return {scale, x: (width - scale * w) / 2 - scale * storey.low[0],
          z: (height - scale * h) / 2 - scale * storey.low[1]};
}

function outline(ctx, flat) {
  ctx.beginPath();
  for (let i = 0; i < flat.length; i += 2) ctx.lineTo(flat[i], flat[i + 1]);
}

function fillOutline(ctx, flat, name) {
  outline(ctx, flat);
  ctx.closePath();
  ctx.fillStyle = color(name);
  ctx.fill();
}

function strokeBetween(ctx, [ax, az, bx, bz], width, name) {
  ctx.beginPath();
  ctx.moveTo(ax, az);
  ctx.lineTo(bx, bz);
  ctx.lineWidth = width;
  ctx.strokeStyle = color(name);
  ctx.stroke();
}

function drawFloor(ctx, storey) {
  for (const room of storey.rooms || []) fillOutline(ctx, room, "room");
  ctx.beginPath();
  for (let i = 0; i < storey.walk.length; i += 6) {
    const w = storey.walk;
    ctx.moveTo(w[i], w[i + 1]);
    ctx.lineTo(w[i + 2], w[i + 3]);
    ctx.lineTo(w[i + 4], w[i + 5]);
    ctx.closePath();
  }
  ctx.fillStyle = ctx.strokeStyle = color("walk");
  ctx.lineWidth = 0.02;
  ctx.fill();
  ctx.stroke();
}

function drawWalls(ctx, storey) {
  ctx.lineCap = "square";
  for (const wall of storey.walls || []) strokeBetween(ctx, wall, wall[4], "wall");
  ctx.lineCap = "butt";
  for (const hole of storey.holes || []) {
    strokeBetween(ctx, hole, hole[4] + 0.02, hole[7] ? "room" : "window");
  }
  for (const leaf of storey.leaves || []) fillOutline(ctx, leaf, "leaf");
  if (storey.walls) return;
  for (let i = 0; i < storey.cuts.length; i += 4) {
    strokeBetween(ctx, storey.cuts.slice(i, i + 4), 0.04, "wall");
  }
}

function drawNames(ctx, storey, view) {
  ctx.fillStyle = color("label");
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  ctx.font = "11.5px system-ui, sans-serif";
  for (const [text, x, z] of storey.names || []) {
    ctx.fillText(text, view.x + view.scale * x, view.z + view.scale * z);
  }
}

/// The storey without anything that moves, drawn anew only if something about it changed.
function baseOf(storey, number, width, height, ratio) {
  const theme = document.documentElement.dataset.theme || "light";
  const key = [number, width, height, ratio, theme].join();
  const view = fitted(storey, width, height);
  if (base.key === key) return view;
  base.key = key;
  base.canvas.width = width * ratio;
  base.canvas.height = height * ratio;
  const ctx = base.canvas.getContext("2d");
  const s = view.scale * ratio;
  ctx.setTransform(s, 0, 0, s, view.x * ratio, view.z * ratio);
  drawFloor(ctx, storey);
  ctx.globalAlpha = 0.75;
  ctx.drawImage(storey.image, storey.low[0], storey.low[1], storey.size[0], storey.size[1]);
  ctx.globalAlpha = 1;
  drawWalls(ctx, storey);
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
  drawNames(ctx, storey, view);
  return view;
}

function rgba(name, alpha) {
  const hex = color(name);
  return [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16)).concat(alpha);
}

/// The believed map as a picture of one pixel a cell.
function updateMapImage(beliefs) {
  if (mapImage.of === beliefs && mapImage.version === beliefs.version) return;
  mapImage.of = beliefs;
  mapImage.version = beliefs.version;
  const {canvas} = mapImage;
  canvas.width = canvas.height = beliefs.size;
  const ctx = canvas.getContext("2d");
  const image = ctx.createImageData(beliefs.size, beliefs.size);
  const colors = [null, rgba("free", 70), rgba("solid", 150), rgba("solid", 255)];
  beliefs.cells.forEach((kind, i) => { if (kind) image.data.set(colors[kind], 4 * i); });
  ctx.putImageData(image, 0, 0);
}

/// Draws into pixels what lies in world x, z: points are given as such.
class Pen {
  constructor(ctx, view) {
    this.ctx = ctx;
    this.view = view;
  }
  at([x, z]) { return [this.view.x + this.view.scale * x, this.view.z + this.view.scale * z]; }
  line(points, name, width, dash = []) {
    const {ctx} = this;
    ctx.beginPath();
    for (const point of points) ctx.lineTo(...this.at(point));
    ctx.setLineDash(dash);
    ctx.lineWidth = width;
    ctx.lineJoin = ctx.lineCap = "round";
    ctx.strokeStyle = color(name);
    ctx.stroke();
    ctx.setLineDash([]);
  }
  dot(point, radius, fill, stroke) {
    const {ctx} = this;
    ctx.beginPath();
    ctx.arc(...this.at(point), radius, 0, 2 * Math.PI);
    ctx.fillStyle = color(fill);
    ctx.fill();
    ctx.lineWidth = 1.6;
    ctx.strokeStyle = color(stroke);
    ctx.stroke();
  }
  /// Corners in pixels around a point, turned by an angle.
  shape(point, corners, fill, turned = 0) {
    const {ctx} = this;
    const [x, z] = this.at(point);
    const s = Math.sin(turned), c = Math.cos(turned);
    ctx.beginPath();
    for (const [u, v] of corners) ctx.lineTo(x + c * u - s * v, z + s * u + c * v);
    ctx.closePath();
    ctx.fillStyle = color(fill);
    ctx.fill();
    ctx.lineWidth = 1.5;
    ctx.strokeStyle = color("card");
    ctx.stroke();
  }
  text(point, words, name, dx, dz) {
    const {ctx} = this;
    const [x, z] = this.at(point);
    ctx.font = "10.5px system-ui, sans-serif";
    ctx.textAlign = "left";
    ctx.fillStyle = color(name);
    ctx.fillText(words, x + dx, z + dz);
  }
}

const kStar = Array.from({length: 10}, (_, i) => {
  const r = i % 2 ? 4.4 : 10;
  return [r * Math.sin(i * Math.PI / 5), -r * Math.cos(i * Math.PI / 5)];
});
const kBody = [[0, -10], [7, 8], [0, 4], [-7, 8]];
const kDiamond = [[0, -7], [7, 0], [0, 7], [-7, 0]];
const kCross = [[-4, -4], [0, -1.4], [4, -4], [1.4, 0], [4, 4], [0, 1.4], [-4, 4], [-1.4, 0]];
const floorOf = pose => [pose[0], pose[2]];

function drawMap(pen, one, ratio) {
  const beliefs = one.beliefs;
  if (!beliefs.size) return;
  updateMapImage(beliefs);
  const {ctx, view} = pen;
  const [a, b, c, d, e, f] = one.plane.matrix;
  ctx.save();
  ctx.imageSmoothingEnabled = false;
  const s = view.scale * ratio;
  ctx.setTransform(s, 0, 0, s, view.x * ratio, view.z * ratio);
  ctx.transform(a, b, c, d, e, f);
  const extent = beliefs.size * beliefs.cell;
  ctx.drawImage(mapImage.canvas, beliefs.low[0], beliefs.low[1], extent, extent);
  ctx.restore();
}

function drawGraph(pen, one) {
  const {nodes, edges, way} = one.beliefs;
  const place = node => one.plane.at(node[0], node[1]);
  for (const [i, j] of edges) pen.line([place(nodes[i]), place(nodes[j])], "graph", 1.2);
  if (way.length > 1) pen.line(way.map(i => place(nodes[i])), "graph", 4);
  for (const node of nodes) {
    const is_ghost = node[2] === 1;
    pen.dot(place(node), is_ghost ? 4 : 5, is_ghost ? "card" : "graph", "graph");
    if (node.length > 3) pen.text(place(node), node[3].toFixed(2), "graph", 7, 4);
  }
}

function drawBeliefs(pen, one, ratio) {
  if (!one.beliefs || !layers.beliefs) return;
  if (one.beliefs.log.at_end && now.step < one.steps) return;
  one.beliefs.go(one.beliefs.log.at_end ? 0 : Math.min(now.step, one.steps));
  drawMap(pen, one, ratio);
  drawGraph(pen, one);
  const {target} = one.beliefs;
  if (target) pen.shape(one.plane.at(...target), kDiamond, "graph");
}

function drawPath(pen, one, name) {
  const step = Math.min(now.step, one.steps);
  const points = one.poses.map(floorOf);
  pen.ctx.globalAlpha = 0.25;
  pen.line(points.slice(step), name, 1.5);
  pen.ctx.globalAlpha = 1;
  pen.line(points.slice(0, step + 1), name, 3);
  for (let i = 0; i < step; ++i) {
    if (one.path.collided[i] === "1") pen.shape(points[i + 1], kCross, "bad");
  }
  if (layers.odometry) {
    const believed = one.path.odometry.slice(0, step).map(([x, y]) => one.plane.at(x, y));
    pen.line([points[0], ...believed], name, 1.5, [3, 4]);
  }
  pen.shape(points[step], kBody, name, -one.poses[step][3]);
}

/// Which goal is looked for at a step: each stop but the last one goes on to the next.
function goalAt(one, step) {
  let goal = 0;
  for (let i = 0; i < step && i < one.steps; ++i) goal += one.path.actions[i] === "S" ? 1 : 0;
  return Math.min(goal, one.path.goals.length - 1);
}

async function drawPlan() {
  const {one, two} = now;
  const canvas = byId("plan");
  const ratio = window.devicePixelRatio || 1;
  const width = canvas.clientWidth, height = canvas.clientHeight;
  const storey = one && one.row.scene_block >= 0 ? await storeyOf(one.row.scene_block) : null;
  if (one !== now.one) return;  // another was chosen meanwhile
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  const ctx = canvas.getContext("2d");
  if (!one || !width) return;
  const view = storey ? baseOf(storey, one.row.scene_block, width, height, ratio)
                      : fitted(extentOf(one), width, height);
  if (storey) ctx.drawImage(base.canvas, 0, 0);
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
  const pen = new Pen(ctx, view);
  drawBeliefs(pen, one, ratio);
  if (layers.shortest) pen.line(one.path.shortest_path.map(floorOf), "good", 2, [7, 5]);
  if (two) drawPath(pen, two, "b");
  drawPath(pen, one, "a");
  pen.dot(floorOf(one.path.start), 5.5, "card", "ink");
  const goal = goalAt(one, now.step);
  one.path.goals.forEach((pose, i) => pen.shape(floorOf(pose), kStar, i === goal ? "goal" : "faint"));
}

/// Of a path whose scene is gone, as a storey has it.
function extentOf(one) {
  const points = [...one.poses.map(floorOf), ...one.path.goals.map(floorOf)];
  const xs = points.map(p => p[0]), zs = points.map(p => p[1]);
  const low = [Math.min(...xs) - 1, Math.min(...zs) - 1];
  return {low, size: [Math.max(...xs) + 1 - low[0], Math.max(...zs) + 1 - low[1]]};
}
