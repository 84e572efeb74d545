// SPDX-License-Identifier: MIT
// Charts of the results that the other filters than agent and outcome let through.
"use strict";
const kInks = ["#4477dd", "#e07b39", "#2a9d78", "#a564c4", "#c9a227", "#d1495b", "#5f7f8c", "#8d6e63"];
const kReasonInks = {"reached": "var(--good)", "stopped far away": "#d1495b", "stopped short": "#e9954f", "out of steps": "#7d8796",
                     "at goal, no stop": "#c9a227", "agent broke down": "#7a1f2b", "cut off from goal": "#8d6e63", "not all goals": "#d1495b"};

const inkOf = agent => kInks[agent % kInks.length];
const safe = text => String(text).replace(/[&<"]/g, c => ({"&": "&amp;", "<": "&lt;", '"': "&quot;"})[c]);
const share = (part, whole) => whole ? part / whole : 0;
const mean = values => share(values.reduce((sum, value) => sum + value, 0), values.length);

function chart(title, note, height, content) {
  return `<h2>${safe(title)}</h2><p>${safe(note)}</p>` +
    `<svg viewBox="0 0 460 ${height}" role="img" aria-label="${safe(title)}">${content}</svg>`;
}

const words = (x, y, text, anchor = "start", kind = "") =>
  `<text x="${x}" y="${y}" text-anchor="${anchor}" class="${kind}">${safe(text)}</text>`;
const box = (x, y, width, height, ink, tip) =>
  `<rect x="${x}" y="${y}" width="${Math.max(width, 0)}" height="${height}" fill="${ink}" rx="2"><title>${safe(tip)}</title></rect>`;

/// Success and SPL of each agent.
function scoreChart(byAgent) {
  let content = "", y = 16;
  for (const [agent, rows] of byAgent) {
    const ok = share(rows.filter(row => row.ok).length, rows.length), spl = mean(rows.map(row => row.spl ?? 0));
    content += words(0, y, titleOf(agent), "start", "title");
    content += box(0, y + 6, 360 * ok, 11, inkOf(agent), `success ${ok.toFixed(3)} of ${rows.length}`);
    content += words(360 * ok + 6, y + 16, `${(100 * ok).toFixed(0)}% reached`);
    content += `<g opacity=".55">${box(0, y + 19, 360 * spl, 11, inkOf(agent), `SPL ${spl.toFixed(3)}`)}</g>`;
    content += words(360 * spl + 6, y + 29, `SPL ${spl.toFixed(3)}`);
    y += 52;
  }
  return chart("Success and SPL", "Strong: share of goals reached. Pale: weighted by the length of the path.", y - 14, content);
}

/// How the episodes of each agent ended.
function reasonChart(byAgent, rows) {
  const reasons = ["reached", ...unique(rows.map(row => row.why)).filter(one => one).sort()];
  let content = "", y = 16;
  for (const [agent, ones] of byAgent) {
    content += words(0, y, titleOf(agent), "start", "title");
    let x = 0;
    for (const reason of reasons) {
      const count = ones.filter(row => (row.why || "reached") === reason).length, width = 460 * share(count, ones.length);
      if (count) content += box(x, y + 6, width - 1, 18, kReasonInks[reason] || "#7d8796", `${reason}: ${count} of ${ones.length}`);
      if (width > 26) content += `<text x="${x + width / 2}" y="${y + 19}" text-anchor="middle" style="fill:#fff">${count}</text>`;
      x += width;
    }
    y += 44;
  }
  let x = 0;
  for (const reason of reasons) {
    const width = 24 + 6.4 * reason.length;
    if (x + width > 460) { x = 0; y += 18; }
    content += box(x, y - 9, 10, 10, kReasonInks[reason] || "#7d8796", reason) + words(x + 15, y, reason);
    x += width;
  }
  return chart("How episodes ended", "Number of episodes by outcome.", y + 10, content);
}

/// Success by how far away the goal is.
function distanceChart(byAgent, rows) {
  const far = Math.max(1, ...rows.map(row => row.start_distance ?? 0));
  const bins = 5, high = 170;
  let content = "";
  for (let i = 0; i <= 4; ++i) {
    const y = 12 + high * (1 - i / 4);
    content += `<line x1="42" x2="455" y1="${y}" y2="${y}" stroke="var(--line)"/>` + words(38, y + 4, `${25 * i}%`, "end");
  }
  for (let i = 0; i <= bins; ++i) content += words(42 + 413 * i / bins, high + 28, `${(far * i / bins).toFixed(0)} m`, i === bins ? "end" : "middle");
  for (const [agent, ones] of byAgent) {
    const points = [];
    for (let i = 0; i < bins; ++i) {
      const inside = ones.filter(row => Math.min(bins - 1, Math.floor((row.start_distance ?? 0) / far * bins)) === i);
      if (!inside.length) continue;
      const ok = share(inside.filter(row => row.ok).length, inside.length);
      points.push([42 + 413 * (i + 0.5) / bins, 12 + high * (1 - ok), `${titleOf(agent)}: ${(100 * ok).toFixed(0)}% of ${inside.length}`]);
    }
    content += `<polyline points="${points.map(([x, y]) => x + "," + y).join(" ")}" fill="none" stroke="${inkOf(agent)}" stroke-width="2"/>`;
    for (const [x, y, tip] of points) content += `<circle cx="${x}" cy="${y}" r="3.5" fill="${inkOf(agent)}"><title>${safe(tip)}</title></circle>`;
  }
  let y = high + 48;
  for (const [agent] of byAgent) {
    content += box(34, y - 9, 10, 10, inkOf(agent), titleOf(agent)) + words(50, y, titleOf(agent));
    y += 16;
  }
  return chart("Success by distance to the goal", "Length of the shortest path from the start.", y, content);
}

/// SPL of two agents on the same episodes; a dot can be clicked.
function pairChart() {
  const pairs = run.rows.filter(row => row.agent === filter.agent && passesBesides(row)).map(row => [row, twinOf(row)])
    .filter(([row, twin]) => twin && row.spl !== null && twin.spl !== null);
  if (!pairs.length) return "";
  const place = value => 34 + 300 * value;
  let content = `<rect x="34" y="10" width="300" height="300" fill="none" stroke="var(--line)"/>` +
    `<line x1="42" y1="310" x2="334" y2="10" stroke="var(--line)"/>`;
  for (const [row, twin] of pairs) {
    content += `<circle data-row="${row.number}" cx="${place(row.spl)}" cy="${344 - place(twin.spl)}" r="5" fill="${row.spl >= twin.spl ? "var(--a)" : "var(--b)"}"` +
      ` fill-opacity=".55" style="cursor:pointer"><title>${safe(`${row.episode}: ${numbered(row.spl, 2)} and ${numbered(twin.spl, 2)}`)}</title></circle>`;
  }
  content += words(184, 328, `SPL of ${titleOf(filter.agent)} →`, "middle") +
    `<text x="-160" y="24" transform="rotate(-90)" text-anchor="middle">SPL of ${safe(titleOf(filter.other))} →</text>`;
  return chart("Two agents, episode by episode", "Below the line the first is better. Click a dot to see the episode.", 336, content);
}

function passesBesides(row) {
  return (!filter.difficulty || row.difficulty === filter.difficulty) &&
    (!filter.setting || settingOf(row) === filter.setting) && (filter.scene < 0 || row.scene === filter.scene);
}

function drawCharts() {
  const rows = run.rows.filter(passesBesides);
  const byAgent = new Map();
  for (const row of rows) {
    if (!byAgent.has(row.agent)) byAgent.set(row.agent, []);
    byAgent.get(row.agent).push(row);
  }
  const settings = unique(rows.map(settingOf));
  const note = settings.length > 1 ? `<p>All settings together: ${safe(settings.join("; "))}. Choose one in the list's filters.</p>` : "";
  const charts = byId("charts");
  charts.innerHTML = note + scoreChart(byAgent) + reasonChart(byAgent, rows) + distanceChart(byAgent, rows) + pairChart();
  for (const dot of charts.querySelectorAll("[data-row]")) dot.onclick = () => choose(run.rows[Number(dot.dataset.row)]);
}
