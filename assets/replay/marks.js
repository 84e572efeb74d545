// SPDX-License-Identifier: MIT
// What is drawn over the plan: paths, beliefs, start, goals, bodies.
"use strict";
const at = pose => toScreen(pose[0], pose[2]);

function line(pen, points) {
  pen.beginPath();
  for (const point of points) pen.lineTo(...point);
  pen.stroke();
}

function disc(pen, [x, y], radius) {
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
}

function drawPath(pen, result, step, ink) {
  const points = result.poses.map(at);
  const gone = Math.min(step, result.steps);
  pen.lineJoin = pen.lineCap = "round";
  pen.strokeStyle = ink;
  pen.globalAlpha = 0.3;
  pen.lineWidth = 1.5;
  line(pen, points.slice(gone));
  pen.globalAlpha = 1;
  pen.strokeStyle = colours.void;
  pen.lineWidth = 5;
  line(pen, points.slice(0, gone + 1));
  pen.strokeStyle = ink;
  pen.lineWidth = 2.6;
  line(pen, points.slice(0, gone + 1));
  pen.fillStyle = colours.bad;
  for (let i = 0; i < gone; ++i) {
    if (result.path.collided[i] !== "1") continue;
    disc(pen, points[i + 1], 2.4);
    pen.fill();
  }
}

function drawOdometry(pen, result, step, ink) {
  const points = [[0, 0], ...result.path.odometry].slice(0, step + 1)
    .map(([ahead, left]) => toScreen(...result.plane.at(ahead, left)));
  pen.strokeStyle = ink;
  pen.lineWidth = 1.5;
  pen.setLineDash([2, 4]);
  line(pen, points);
  pen.setLineDash([]);
}

function drawShortest(pen, result) {
  pen.strokeStyle = colours.good;
  pen.lineWidth = 2;
  pen.setLineDash([7, 5]);
  line(pen, result.path.shortest_path.map(at));
  pen.setLineDash([]);
}

/// How many goals were settled before a step: each stop settles one.
function goalAt(result, step) {
  const stops = (result.path.actions.slice(0, step).match(/S/g) || []).length;
  return Math.min(stops, result.path.goals.length - 1);
}

function star(pen, [x, y], radius) {
  pen.beginPath();
  for (let i = 0; i < 10; ++i) {
    const far = i % 2 ? 0.45 * radius : radius, turn = i * Math.PI / 5;
    pen.lineTo(x + far * Math.sin(turn), y - far * Math.cos(turn));
  }
  pen.closePath();
}

function drawGoals(pen, result, step) {
  const current = goalAt(result, step);
  result.path.goals.forEach((goal, i) => {
    pen.globalAlpha = i === current ? 1 : 0.45;
    pen.strokeStyle = pen.fillStyle = colours.good;
    pen.lineWidth = 1;
    pen.setLineDash([3, 3]);
    disc(pen, at(goal), run.success_distance * view.scale);
    pen.stroke();
    pen.setLineDash([]);
    star(pen, at(goal), 10);
    pen.fill();
    pen.strokeStyle = colours.void;
    pen.stroke();
  });
  pen.globalAlpha = 1;
  pen.strokeStyle = colours.ink;
  pen.fillStyle = colours.void;
  pen.lineWidth = 2.5;
  disc(pen, at(result.path.start), 5);
  pen.fill();
  pen.stroke();
}

/// A body as an arrowhead: it looks along -z at yaw 0.
function drawBody(pen, pose, ink) {
  const [x, y] = at(pose);
  pen.save();
  pen.translate(x, y);
  pen.rotate(-pose[3] - (view.turned ? Math.PI / 2 : 0));
  pen.fillStyle = ink;
  pen.strokeStyle = colours.void;
  pen.lineWidth = 2;
  pen.lineJoin = "round";
  pen.beginPath();
  for (const [u, v] of [[0, -13], [8.5, 9], [0, 4.5], [-8.5, 9]]) pen.lineTo(u, v);
  pen.closePath();
  pen.stroke();
  pen.fill();
  pen.restore();
}

/// Beliefs as they were at a step; null where none are known. A log of the end alone is of the end.
function beliefsAt(result, step) {
  const beliefs = result.beliefs;
  if (!beliefs || (beliefs.log.at_end && step < result.steps)) return null;
  beliefs.go(step);
  return beliefs;
}

function rgb(text) {
  const digits = text.slice(1);
  const value = parseInt(digits.length === 3 ? digits.replace(/./g, "$&$&") : digits, 16);
  return [value >> 16, value >> 8 & 255, value & 255];
}

/// The map's cells as a picture; made again when they or the colours have changed.
function cellPicture(beliefs) {
  const key = beliefs.version + document.documentElement.dataset.theme;
  if (beliefs.painted === key) return beliefs.canvas;
  if (!beliefs.canvas) beliefs.canvas = document.createElement("canvas");
  Object.assign(beliefs.canvas, {width: beliefs.size, height: beliefs.size});
  const pen = beliefs.canvas.getContext("2d");
  const image = pen.createImageData(beliefs.size, beliefs.size);
  const inks = [null, [...rgb(colours.free), 95], [...rgb(colours.solid), 150], [...rgb(colours.solid), 230]];
  beliefs.cells.forEach((kind, i) => { if (kind) image.data.set(inks[kind], 4 * i); });
  pen.putImageData(image, 0, 0);
  beliefs.painted = key;
  return beliefs.canvas;
}

function drawBeliefMap(pen, result, step) {
  const beliefs = beliefsAt(result, step);
  if (!beliefs || !beliefs.size) return;
  pen.save();
  pen.transform(...viewMatrix());
  pen.transform(...result.plane.matrix);
  pen.imageSmoothingEnabled = false;
  const side = beliefs.size * beliefs.cell;
  pen.drawImage(cellPicture(beliefs), ...beliefs.low, side, side);
  pen.restore();
}

function drawNode(pen, place, ghost, score) {
  const radius = ghost ? 4 + 3 * Math.max(0, Math.min(score ?? 0, 1)) : 5;
  disc(pen, place, radius);
  pen.fillStyle = ghost ? colours.void : colours.graph;
  pen.fill();
  pen.lineWidth = ghost ? 2 : 1.5;
  pen.strokeStyle = ghost ? colours.graph : colours.void;
  pen.setLineDash(ghost ? [3, 2] : []);
  pen.stroke();
  pen.setLineDash([]);
}

function drawGraph(pen, result, step) {
  const beliefs = beliefsAt(result, step);
  if (!beliefs) return;
  const places = beliefs.nodes.map(([ahead, left]) => toScreen(...result.plane.at(ahead, left)));
  pen.strokeStyle = colours.graph;
  pen.lineWidth = 1.2;
  pen.globalAlpha = 0.75;
  for (const [i, j] of beliefs.edges) line(pen, [places[i], places[j]]);
  pen.globalAlpha = 1;
  pen.lineWidth = 3.5;
  line(pen, beliefs.way.map(i => places[i]).filter(Boolean));
  beliefs.nodes.forEach(([, , ghost, score], i) => drawNode(pen, places[i], ghost, score));
  if (!beliefs.target) return;
  const [x, y] = toScreen(...result.plane.at(...beliefs.target));
  for (const [ink, width] of [[colours.void, 5], [colours.graph, 2.5]]) {
    pen.strokeStyle = ink;
    pen.lineWidth = width;
    line(pen, [[x - 6, y - 6], [x + 6, y + 6]]);
    line(pen, [[x - 6, y + 6], [x + 6, y - 6]]);
  }
}

/// What the marks mean: those that are in sight.
function legendItems(results, step, layers) {
  const main = results[0];
  if (!main) return [];
  const items = results.map((one, i) => [`${titleOf(one.row.agent)}`, i ? "b" : "a", "arrow"]);
  items.push(["start", "ink", "ring"], ["goal, and how near counts", "good", "star"]);
  if (results.some(one => one.path.collided.slice(0, step).includes("1"))) items.push(["collision", "bad", "dot"]);
  if (layers.shortest) items.push(["shortest path", "good", "dash"]);
  if (layers.odometry) items.push(["where odometry believed to be", "a", "dots"]);
  const beliefs = layers.beliefs ? beliefsAt(main, step) : null;
  if (beliefs && beliefs.size) items.push(["its map: free", "free", "patch"], ["its map: occupied", "solid", "patch"]);
  if (beliefs && beliefs.nodes.some(node => !node[2])) items.push(["node of its graph", "graph", "dot"]);
  if (beliefs && beliefs.nodes.some(node => node[2])) items.push(["ghost: a place to explore", "graph", "ghost"]);
  if (beliefs && beliefs.target) items.push(["where it is heading", "graph", "cross"]);
  return items;
}

function drawLegend(results, step, layers) {
  const glyphs = {arrow: "➤", ring: "○", star: "★", dot: "●", dash: "╌", dots: "┈", patch: "■", ghost: "◌", cross: "✕"};
  byId("legend").replaceChildren(...legendItems(results, step, layers).map(([text, ink, glyph]) => {
    const item = document.createElement("div");
    const mark = document.createElement("b");
    mark.textContent = glyphs[glyph];
    mark.style.color = `var(--${ink})`;
    item.append(mark, text);
    return item;
  }));
}
