// SPDX-License-Identifier: MIT
// The list of results: filters, order, and as many rows as are in sight.
"use strict";
const kRowHeight = 30;
const filter = {agent: 0, outcome: "", difficulty: "", other: -1, setting: "", scene: -1, reason: "", gain: ""};
const order = {column: "spl", down: false};
let shown = [];
const others = new Map();  // agent, then task: row
for (const row of run.rows) {
  if (!others.has(row.agent)) others.set(row.agent, new Map());
  others.get(row.agent).set(row.task, row);
}

const titleOf = agent => run.agents[agent][1];
const twinOf = row => filter.other < 0 || filter.other === row.agent
  ? null : others.get(filter.other).get(row.task) || null;
function gainOf(row) {
  const twin = twinOf(row);
  return twin && row.spl !== null && twin.spl !== null ? row.spl - twin.spl : null;
}
const sceneName = scene => run.scene_names[scene];
const numbered = (value, digits) => value === null ? "–" : value.toFixed(digits);

/// By which of these results differ; all others have it in common.
const variety = ["setting", "condition", "seed"].filter(name => run.rows.some(row => row[name] !== run.rows[0][name]));
const variantOf = row => variety.map(name => name === "seed" ? `seed ${row.seed}` : row[name].replace("_", " ")).join(", ");
if (variety.length) {
  const letters = run.rows.reduce((most, row) => Math.max(most, variantOf(row).length), 7);
  byId("left").parentNode.className = "varied";
  byId("left").style.setProperty("--variant", `${Math.min(7 * letters, 130)}px`);
}

const columns = [
  {key: "", title: "", of: () => 0},
  {key: "episode", title: "Episode", of: row => row.episode},
  {key: "variant", title: "Setting", of: variantOf},
  {key: "why", title: "Outcome", of: row => row.ok ? "~" : row.why},
  {key: "spl", title: "SPL", num: true,
   of: row => (row.spl ?? -1) + 1e-3 * (row.soft_spl ?? 0) - 1e-6 * (row.distance_to_goal ?? 999)},
  {key: "steps", title: "Steps", num: true, of: row => row.steps},
  {key: "left", title: "To goal, m", num: true, of: row => row.distance_to_goal ?? Infinity},
  {key: "gain", title: "Δ SPL", num: true, of: row => gainOf(row) ?? Infinity},
];

function passes(row) {
  return (filter.agent < 0 || row.agent === filter.agent) &&
    (!filter.outcome || (filter.outcome === "ok") === row.ok) &&
    (!filter.difficulty || row.difficulty === filter.difficulty) &&
    (!filter.setting || settingOf(row) === filter.setting) &&
    (filter.scene < 0 || row.scene === filter.scene) &&
    (!filter.reason || row.why === filter.reason) && passesGain(row);
}

/// By how much better or worse the agent is than the one to compare with.
function passesGain(row) {
  if (filter.other < 0 || !filter.gain) return true;
  const gain = gainOf(row);
  if (gain === null) return false;
  return {better: gain > 0, worse: gain < 0, much_better: gain > 0.5, much_worse: gain < -0.5}[filter.gain];
}

function settingOf(row) { return `${row.setting}, ${row.condition.replace("_", " ")}, seed ${row.seed}`; }

function updateTable() {
  const column = columns.find(one => one.key === order.column);
  const sign = order.down ? -1 : 1;
  shown = run.rows.filter(passes).map(row => [column.of(row), row]);
  shown.sort(([a, x], [b, y]) => sign * (a < b ? -1 : a > b ? 1 : 0) || x.number - y.number);
  shown = shown.map(([, row]) => row);
  byId("space").style.height = shown.length * kRowHeight + "px";
  const ok = shown.filter(row => row.ok).length;
  const spl = shown.reduce((sum, row) => sum + (row.spl ?? 0), 0);
  byId("total").textContent = shown.length
    ? `${shown.length} shown · ${(100 * ok / shown.length).toFixed(0)}% reached · SPL ${(spl / shown.length).toFixed(3)}`
    : "No episode passes these filters";
  drawColumns();
  drawRows();
}

function drawColumns() {
  const head = byId("columns");
  head.className = filter.other >= 0 ? "compared" : "";
  const hidden = [filter.other >= 0 ? "" : "gain", variety.length ? "" : "variant"].filter(Boolean);
  head.replaceChildren(...columns.filter(one => !hidden.includes(one.key)).map(one => {
    const cell = document.createElement("span");
    const on = one.key && one.key === order.column;
    cell.textContent = one.title + (on ? (order.down ? " ↓" : " ↑") : "");
    cell.className = (one.num ? "num" : "") + (on ? " on" : "");
    if (one.key) cell.onclick = () => {
      order.down = order.column === one.key ? !order.down : false;
      order.column = one.key;
      updateTable();
    };
    return cell;
  }));
}

function cell(name, text) {
  const span = document.createElement("span");
  span.className = name;
  span.textContent = text;
  span.title = text;
  return span;
}

function rowElement(row, place) {
  const element = document.createElement("div");
  element.className = "row" + (now.row === row ? " on" : "");
  element.style.top = place * kRowHeight + "px";
  element.dataset.number = row.number;
  const mark = document.createElement("i");
  if (row.ok) mark.className = "ok";
  const who = filter.agent < 0 ? " · " + titleOf(row.agent) : "";  // last: long names are cut
  const why = row.ok ? "reached" : row.why;
  element.append(mark, cell("", row.episode), ...(variety.length ? [cell("variant", variantOf(row))] : []),
                 cell("why", why + who), cell("num", numbered(row.spl, 2)),
                 cell("num", row.steps), cell("num", numbered(row.distance_to_goal, 1)));
  if (filter.other >= 0) {
    const gain = gainOf(row);
    const text = gain === null ? "–" : (gain > 0 ? "+" : gain < 0 ? "−" : "") + Math.abs(gain).toFixed(2);
    element.append(cell("num " + (gain > 0 ? "up" : gain < 0 ? "down" : ""), text));
  }
  element.onclick = () => choose(row);
  return element;
}

function drawRows() {
  const list = byId("list");
  list.className = filter.other >= 0 ? "compared" : "";
  const first = Math.max(0, Math.floor(list.scrollTop / kRowHeight) - 5);
  const last = Math.min(shown.length, first + Math.ceil(list.clientHeight / kRowHeight) + 10);
  for (const old of list.querySelectorAll(".row")) old.remove();
  for (let i = first; i < last; ++i) list.append(rowElement(shown[i], i));
}

function chips(id, items, key) {
  byId(id).replaceChildren(...items.map(([value, title]) => {
    const chip = document.createElement("button");
    chip.textContent = title;
    chip.className = filter[key] === value ? "on" : "";
    chip.onclick = () => { filter[key] = value; updateFilters(); updateTable(); followList(); };
    return chip;
  }));
}

function options(id, items, key, change) {
  const select = byId(id);
  select.replaceChildren(...items.map(([value, title]) => new Option(title, value)));
  select.value = filter[key];
  select.onchange = () => {
    filter[key] = typeof filter[key] === "number" ? Number(select.value) : select.value;
    if (change) change();
    updateTable();
    followList();
  };
}

const unique = values => [...new Set(values)];

function updateFilters() {
  const agents = run.agents.map(([, title], i) => [i, title]);
  chips("agents", agents.length > 1 ? [[-1, "All agents"], ...agents] : agents, "agent");
  chips("outcomes", [["", "All"], ["bad", "Failed"], ["ok", "Reached"]], "outcome");
  const grades = ["easy", "medium", "hard"].filter(one => run.rows.some(row => row.difficulty === one));
  chips("difficulties", grades.length > 1 ? [["", "Any"], ...grades.map(one => [one, one])] : [], "difficulty");
  options("other", [[-1, "no other"], ...agents], "other", () => {
    order.column = filter.other >= 0 ? "gain" : "spl";
    order.down = false;
    if (filter.other < 0) filter.gain = "";
    updateFilters();
    if (now.row) choose(now.row, now.step);
  });
  byId("gain_box").hidden = filter.other < 0;
  options("gain", [["", "any"], ["better", "better"], ["worse", "worse"], ["much_better", "better by 0.5"],
                   ["much_worse", "worse by 0.5"]], "gain");
  const settings = unique(run.rows.map(settingOf));
  byId("setting_box").hidden = settings.length < 2;
  options("setting", [["", "all"], ...settings.map(one => [one, one])], "setting");
  options("scene", [[-1, "all"], ...run.scenes.map((_, i) => [i, sceneName(i)])], "scene");
  const reasons = unique(run.rows.map(row => row.why)).filter(one => one).sort();
  options("reason", [["", "any"], ...reasons.map(one => [one, one])], "reason");
}
