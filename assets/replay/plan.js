// SPDX-License-Identifier: MIT
// The floor plan with what happened on it: a still layer, drawn once a view, and a moving one.
"use strict";
const view = {zoom: 1, x: 0, z: 0, turned: false, scale: 1, left: 0, top: 0, still: null};

const colour = name => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
let colours = {};
function readColours() {
  colours = {};
  for (const name of ["a", "b", "good", "bad", "card", "room", "walk", "wall", "window", "leaf", "void", "graph",
                      "free", "solid", "solid-wall", "label", "ink", "soft"]) colours[name] = colour(name);
}

/// Fits a canvas to its place on the screen; returns its context in CSS pixels.
function fitted(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
  return pen;
}

/// What is to be in sight, world x, z: the house, or the paths where it is not known.
function extent(storey, results) {
  if (storey) return {low: storey.low, size: storey.size};
  const at = results.flatMap(one => [...one.poses, ...one.path.goals]);
  const xs = at.map(p => p[0]), zs = at.map(p => p[2]);
  const low = [Math.min(...xs) - 1, Math.min(...zs) - 1];
  return {low, size: [Math.max(...xs) + 1 - low[0], Math.max(...zs) + 1 - low[1]]};
}

function placeView(canvas, storey, results) {
  const {low, size} = extent(storey, results);
  const width = canvas.clientWidth, height = canvas.clientHeight;
  const margin = 24;
  const fit = (wide, deep) => Math.min((width - 2 * margin) / wide, (height - 2 * margin) / deep);
  const straight = fit(size[0], size[1]), across = fit(size[1], size[0]);
  view.turned = across > 1.15 * straight;
  view.scale = Math.max(view.turned ? across : straight, 1e-3) * view.zoom;
  view.left = view.top = 0;
  const [x, y] = toScreen(low[0] + size[0] / 2 + view.x, low[1] + size[1] / 2 + view.z);
  view.left = width / 2 - x;
  view.top = height / 2 - y;
}

/// World x, z to the canvas. Long houses lie on their side where more of them fits then.
function viewMatrix() {
  const s = view.scale;
  return view.turned ? [0, -s, s, 0, view.left, view.top] : [s, 0, 0, s, view.left, view.top];
}
function toScreen(x, z) {
  const s = view.scale;
  return view.turned ? [view.left + z * s, view.top - x * s] : [view.left + x * s, view.top + z * s];
}
/// A way on the canvas as one in the world.
function toWorld(u, v) {
  return view.turned ? [-v / view.scale, u / view.scale] : [u / view.scale, v / view.scale];
}

function polygon(pen, flat, close = true) {
  pen.beginPath();
  for (let i = 0; i < flat.length; i += 2) pen.lineTo(...toScreen(flat[i], flat[i + 1]));
  if (close) pen.closePath();
}

/// A wall or an opening in it as a band.
function band(pen, [ax, az, bx, bz], thickness) {
  pen.lineWidth = Math.max(thickness * view.scale, 1.5);
  pen.beginPath();
  pen.moveTo(...toScreen(ax, az));
  pen.lineTo(...toScreen(bx, bz));
  pen.stroke();
}

function drawFloor(pen, storey) {
  pen.fillStyle = colours.room;
  for (const room of storey.rooms || []) { polygon(pen, room); pen.fill(); }
  pen.fillStyle = colours.walk;
  pen.beginPath();
  for (let i = 0; i < storey.walk.length; i += 6) {
    pen.moveTo(...toScreen(storey.walk[i], storey.walk[i + 1]));
    pen.lineTo(...toScreen(storey.walk[i + 2], storey.walk[i + 3]));
    pen.lineTo(...toScreen(storey.walk[i + 4], storey.walk[i + 5]));
  }
  pen.fill();
  pen.save();
  pen.globalAlpha = document.documentElement.dataset.theme === "dark" ? 0.45 : 0.85;
  pen.transform(...viewMatrix());
  pen.drawImage(storey.image, ...storey.low, ...storey.size);
  pen.restore();
}

function drawWalls(pen, storey) {
  pen.lineCap = "square";
  pen.strokeStyle = colours.wall;
  for (const wall of storey.walls || []) band(pen, wall, wall[4]);
  pen.lineCap = "butt";
  if (!storey.walls) {
    for (let i = 0; i < storey.cuts.length; i += 4) band(pen, storey.cuts.slice(i, i + 4), 0.02);
  }
  for (const hole of storey.holes || []) {
    pen.strokeStyle = hole[7] ? colours.room : colours.window;
    band(pen, hole, hole[4] + (hole[7] ? 0.02 : 0));
  }
  pen.fillStyle = colours.leaf;
  for (const leaf of storey.leaves || []) { polygon(pen, leaf); pen.fill(); }
}

function drawNames(pen, storey) {
  pen.font = "11px system-ui,'DejaVu Sans',sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.lineWidth = 3;
  pen.lineJoin = "round";
  for (const [text, x, z] of storey.names || []) {
    pen.strokeStyle = colours.walk;
    pen.strokeText(text, ...toScreen(x, z));
    pen.fillStyle = colours.label;
    pen.fillText(text, ...toScreen(x, z));
  }
}

/// A line of one, two, five ... metres.
function drawScale(pen, canvas) {
  const metres = [0.5, 1, 2, 5, 10, 20, 50].find(one => one * view.scale > 50) || 100;
  const right = canvas.clientWidth - 16, y = canvas.clientHeight - 14, left = right - metres * view.scale;
  pen.strokeStyle = pen.fillStyle = colours.soft;
  pen.lineWidth = 1.5;
  pen.beginPath();
  pen.moveTo(left, y - 4); pen.lineTo(left, y); pen.lineTo(right, y); pen.lineTo(right, y - 4);
  pen.stroke();
  pen.font = "11px system-ui,'DejaVu Sans',sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "alphabetic";
  pen.fillText(metres + " m", (left + right) / 2, y - 6);
}

/// The layer that does not move: drawn anew when the view, the house or the colours change.
function stillLayer(canvas, storey) {
  const ratio = window.devicePixelRatio || 1;
  const key = [storey && storey.number, canvas.width, canvas.height, view.left, view.top, view.scale, view.turned,
               document.documentElement.dataset.theme].join();
  if (view.still && view.still.key === key) return view.still.canvas;
  const still = document.createElement("canvas");
  Object.assign(still, {width: canvas.width, height: canvas.height});
  const pen = still.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  if (storey) {
    drawFloor(pen, storey);
    drawWalls(pen, storey);
    drawNames(pen, storey);
  }
  drawScale(pen, canvas);
  view.still = {key, canvas: still};
  return still;
}

/// All of the plan at a step. `scene`: {storey, results: [one or two], step, layers}.
function drawPlan(canvas, scene) {
  const pen = fitted(canvas);
  if (!scene.results.length && !scene.storey) return;
  placeView(canvas, scene.storey, scene.results);
  pen.drawImage(stillLayer(canvas, scene.storey), 0, 0, canvas.clientWidth, canvas.clientHeight);
  const main = scene.results[0];
  if (!main) return;
  if (scene.layers.beliefs) drawBeliefMap(pen, main, scene.step);
  if (scene.layers.shortest) drawShortest(pen, main);
  drawGoals(pen, main, scene.step);
  scene.results.slice().reverse().forEach(one => {
    const ink = one === main ? colours.a : colours.b;
    drawPath(pen, one, scene.step, ink);
    if (scene.layers.odometry) drawOdometry(pen, one, scene.step, ink);
  });
  if (scene.layers.beliefs) drawGraph(pen, main, scene.step);
  scene.results.slice().reverse().forEach(one => {
    drawBody(pen, one.poses[Math.min(scene.step, one.steps)], one === main ? colours.a : colours.b);
  });
}
