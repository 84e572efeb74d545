// SPDX-License-Identifier: MIT
// Charts of the run, as SVG: success and SPL by difficulty and by distance, and why episodes fail.
"use strict";
const kChart = {width: 560, height: 200, left: 40, bottom: 26, top: 10};
const kSeries = ["#1f5fd6", "#c4570a", "#16794a", "#7b3fb5", "#b3261e", "#0e8a9a", "#8a6d00", "#5c6575"];

const sum = values => values.reduce((a, b) => a + b, 0);
const mean = values => values.length ? sum(values) / values.length : null;
const successOf = rows => mean(rows.map(row => row.ok ? 1 : 0));
const splOf = rows => mean(rows.map(row => row.spl ?? 0));

function svg(name, attributes, text) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  return element;
}

/// Rows of the chosen setting by who played them, in the order of the run.
function byAgent() {
  const rows = run.rows.filter(row => !filter.setting || settingOf(row) === filter.setting);
  return run.agents.map(([, title], agent) => ({
    title, color: kSeries[agent % kSeries.length], rows: rows.filter(row => row.agent === agent)
  })).filter(one => one.rows.length);
}

function frame(title) {
  const chart = svg("svg", {viewBox: `0 0 ${kChart.width} ${kChart.height}`, role: "img", "aria-label": title});
  for (let i = 0; i <= 4; ++i) {
    const y = yOf(i / 4);
    chart.append(svg("line", {x1: kChart.left, x2: kChart.width, y1: y, y2: y, stroke: "var(--line)"}),
                 svg("text", {x: kChart.left - 6, y: y + 4, "text-anchor": "end"}, (i / 4).toFixed(2)));
  }
  return chart;
}

const yOf = share => kChart.top + (1 - share) * (kChart.height - kChart.top - kChart.bottom);

/// Bars of `value` for groups of rows: [[name, test]].
function bars(title, groups, value) {
  const chart = frame(title);
  const agents = byAgent();
  const room = (kChart.width - kChart.left) / groups.length;
  groups.forEach(([name, test], g) => {
    const wide = room * 0.8 / agents.length;
    agents.forEach((agent, a) => {
      const share = value(agent.rows.filter(test));
      if (share === null) return;
      const bar = svg("rect", {x: kChart.left + g * room + room * 0.1 + a * wide, width: Math.max(1, wide - 2),
                               y: yOf(share), height: yOf(0) - yOf(share), fill: agent.color, rx: 1.5});
      bar.append(svg("title", {}, `${agent.title}, ${name}: ${share.toFixed(3)} of ${agent.rows.filter(test).length}`));
      chart.append(bar);
    });
    chart.append(svg("text", {x: kChart.left + (g + 0.5) * room, y: kChart.height - 8, "text-anchor": "middle"}, name));
  });
  return chart;
}

function reasonBars() {
  const agents = byAgent();
  const reasons = unique(run.rows.filter(row => !row.ok).map(row => row.why)).sort();
  const chart = svg("svg", {viewBox: `0 0 ${kChart.width} ${26 * agents.length + 6}`, role: "img", "aria-label": "Why"});
  agents.forEach((agent, a) => {
    chart.append(svg("text", {x: 0, y: 26 * a + 16}, agent.title));
    let x = 200;
    reasons.forEach((reason, r) => {
      const count = agent.rows.filter(row => row.why === reason).length;
      const wide = (kChart.width - 200) * count / agent.rows.length;
      if (!count) return;
      const bar = svg("rect", {x, width: Math.max(1, wide), y: 26 * a + 4, height: 18, fill: kSeries[r % kSeries.length]});
      bar.append(svg("title", {}, `${reason}: ${count} of ${agent.rows.length}`));
      chart.append(bar);
      x += wide;
    });
    if (x === 200) chart.append(svg("text", {x, y: 26 * a + 16}, "no failures"));
  });
  return [chart, key(reasons.map((reason, r) => [reason, kSeries[r % kSeries.length]]))];
}

function key(entries) {
  const list = document.createElement("div");
  list.className = "key";
  for (const [title, paint] of entries) {
    const entry = document.createElement("span");
    const dot = document.createElement("i");
    dot.style.background = paint;
    entry.append(dot, title);
    list.append(entry);
  }
  return list;
}

function distanceGroups() {
  const edges = [0, 2, 3, 4, 5, 7, 10, 15, 20, 40].filter((_, i, all) =>
    run.rows.some(row => row.start_distance >= all[i] && row.start_distance < (all[i + 1] ?? Infinity)));
  return edges.map((low, i) => {
    const high = edges[i + 1] ?? Infinity;
    const name = high === Infinity ? `from ${low} m` : `${low}–${high} m`;
    return [name, row => row.start_distance >= low && row.start_distance < high];
  });
}

function drawCharts() {
  const grades = unique(run.rows.map(row => row.difficulty).filter(one => one));
  const groups = [...["easy", "medium", "hard"].filter(one => grades.includes(one)),
                  ...grades.filter(one => !["easy", "medium", "hard"].includes(one))]
    .map(one => [one, row => row.difficulty === one]);
  if (groups.length !== 1) groups.push(["all", () => true]);
  const distances = distanceGroups();
  const parts = [];
  const add = (title, ...elements) => {
    const heading = document.createElement("h2");
    heading.textContent = title;
    parts.push(heading, ...elements);
  };
  parts.push(key(byAgent().map(agent => [agent.title, agent.color])));
  add("Success by difficulty", bars("Success by difficulty", groups, successOf));
  add("SPL by difficulty", bars("SPL by difficulty", groups, splOf));
  add("Success by distance to the goal", bars("Success by distance", distances, successOf));
  add("Why episodes failed, as a share of all", ...reasonBars());
  byId("charts").replaceChildren(...parts);
}
