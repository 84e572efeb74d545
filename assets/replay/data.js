// SPDX-License-Identifier: MIT
// Blocks of the page, unpacked when they are asked for, and what results tell of themselves.
"use strict";
const run = JSON.parse(document.getElementById("run").textContent);
run.rows = run.rows.map((values, number) => {
  const row = {number};
  run.columns.forEach((name, i) => { row[name] = values[i]; });
  row.ok = row.reached === row.goals && !row.failure;
  row.why = reasonOf(row);
  row.task = [row.setting, row.condition, row.seed, row.scene, row.episode].join("\n");
  return row;
});

function byId(id) { return document.getElementById(id); }

/// Why an episode failed, in two or three words; empty for a success.
function reasonOf(row) {
  if (row.ok) return "";
  if (row.failure) return "agent broke down";
  if (row.goals > 1) return "not all goals";
  const left = row.distance_to_goal;
  const ended = row.steps < run.max_steps * row.goals;
  if (left === null) return "cut off from goal";
  if (left <= run.success_distance) return "at goal, no stop";
  if (!ended) return "out of steps";
  return left < 3 ? "stopped short" : "stopped far away";
}

async function unpack(id) {
  const block = byId(id);
  if (!block) return null;
  const bytes = Uint8Array.from(atob(block.textContent), c => c.charCodeAt(0));
  const plain = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return JSON.parse(await new Response(plain).text());
}

function picture(source) {
  return new Promise((resolve, reject) => {
    const image = new Image();
    image.onload = () => resolve(image);
    image.onerror = () => reject(new Error("a picture is damaged"));
    image.src = source;
  });
}

function pictureOf(id) {
  const block = byId(id);
  return block ? picture(`data:${block.type};base64,${block.textContent}`) : Promise.resolve(null);
}

const storeys = new Map();
/// A storey with its picture, unpacked once.
function storeyOf(number) {
  if (!storeys.has(number)) {
    storeys.set(number, unpack("s" + number).then(async storey => {
      storey.number = number;
      storey.image = await picture(storey.picture);
      return storey;
    }));
  }
  return storeys.get(number);
}

/// The agent's plane as seen from the start: metres ahead and left to world x, z.
function planeOf(start) {
  const [x, , z, yaw] = start;
  const s = Math.sin(yaw), c = Math.cos(yaw);
  return {yaw, at: (ahead, left) => [x - s * ahead - c * left, z - c * ahead + s * left],
          matrix: [-s, -c, -c, s, x, z]};
}

/// What an agent believed, step for step. Goes back by starting again.
class Beliefs {
  constructor(log) {
    this.log = log;
    this.size = log.size;
    this.cell = log.cell;
    this.cells = new Uint8Array(log.size * log.size);
    this.reset();
  }
  reset() {
    this.done = 0;
    this.version = (this.version || 0) + 1;
    this.cells.fill(0);
    Object.assign(this, {pose: null, target: null, low: [0, 0], nodes: [], edges: [], way: []});
  }
  go(step) {
    const wanted = Math.min(step + 1, this.log.frames.length);
    if (wanted < this.done) this.reset();
    while (this.done < wanted) this.take(this.log.frames[this.done++]);
  }
  take(frame) {
    if (frame.p) this.pose = frame.p;
    if (frame.t !== undefined) this.target = frame.t;
    if (frame.low) { this.low = frame.low; this.cells.fill(0); }
    if (frame.m) {
      this.version++;
      for (let i = 0, at = 0; i < frame.m.length; i += 2) {
        at += frame.m[i];
        const length = frame.m[i + 1] >> 2;
        this.cells.fill(frame.m[i + 1] & 3, at, at + length);
        at += length;
      }
    }
    if (frame.n) this.nodes = frame.n;
    if (frame.e) this.edges = frame.e;
    if (frame.w) this.way = frame.w;
  }
}

/// The belief at the end, as trajectories have it, as a log of one frame; null if there is none.
function logOfEnd(belief) {
  if (!belief || !(belief.map || belief.graph || belief.target)) return null;
  const frame = {p: belief.pose, t: belief.target ? belief.target.slice(0, 2) : null};
  const log = {cell: 0, size: 0, frames: [frame], at_end: true};
  if (belief.map) {
    log.cell = belief.map.cell;
    log.size = belief.map.size;
    frame.low = [belief.map.low_x, belief.map.low_y];
    frame.m = [];
    for (const row of belief.map.rows) {
      for (const [, length, kind] of row.matchAll(/(\d+)([?.#!])/g)) {
        frame.m.push(0, 4 * Number(length) + "?.#!".indexOf(kind));
      }
    }
  }
  if (belief.graph) {
    frame.n = belief.graph.nodes;
    frame.e = belief.graph.edges;
    frame.w = belief.graph.path || [];
  }
  return log;
}

/// All that is shown of a result. Null if it has no path.
async function loadResult(row) {
  if (!row.has_path) return null;
  const path = await unpack("e" + row.number);
  const log = row.has_beliefs ? await unpack("b" + row.number) : logOfEnd(path.belief);
  return {row, path, plane: planeOf(path.start), poses: [path.start, ...path.poses],
          steps: path.poses.length, beliefs: log ? new Beliefs(log) : null,
          seen: row.seen.length ? await pictureOf("i" + row.number) : null,
          goal: row.goal_block >= 0 ? await pictureOf("g" + row.goal_block) : null};
}
