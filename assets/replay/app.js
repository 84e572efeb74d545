// SPDX-License-Identifier: MIT
// What is chosen and shown, time, keys, and the link that leads back to it.
"use strict";
// eslint-disable-next-line no-var
var now = {row: null, step: 0, one: null, two: null, timer: null, solid: false};
const kStepMs = 60;

function told(row, name) {
  const line = document.createElement("div");
  line.className = "told";
  const dot = document.createElement("span");
  dot.className = "dot " + name;
  const who = document.createElement("b");
  who.textContent = titleOf(row.agent);
  const pill = document.createElement("span");
  pill.className = "pill" + (row.ok ? " ok" : "");
  pill.textContent = row.ok ? "reached" : row.why;
  const facts = cell("facts", `SPL ${numbered(row.spl, 2)} · ${row.steps} steps · walked ` +
    `${numbered(row.path_length, 1)} m, shortest ${numbered(row.start_distance, 1)} m · ` +
    `${numbered(row.distance_to_goal, 2)} m left · ${row.collisions} collisions` +
    (row.goals > 1 ? ` · ${row.reached} of ${row.goals} goals` : "") +
    (row.failure ? ` · ${row.failure}` : ""));
  line.append(dot, who, pill, facts);
  return line;
}

const kSwatches = {
  line: (name, dash) => `<line x1="1" y1="7" x2="21" y2="7" stroke="var(--${name})" stroke-width="2.5" stroke-dasharray="${dash || ""}"/>`,
  dot: (name, fill) => `<circle cx="11" cy="7" r="4.5" fill="var(--${fill || name})" stroke="var(--${name})" stroke-width="1.5"/>`,
  star: name => `<path d="M11 1l1.8 4.2 4.6.4-3.5 3 1 4.4-3.9-2.4-3.9 2.4 1-4.4-3.5-3 4.6-.4z" fill="var(--${name})"/>`,
  box: name => `<rect x="3" y="2" width="16" height="10" fill="var(--${name})" opacity=".5"/>`,
};

function legendOf() {
  const {one, two} = now;
  const list = [[kSwatches.line("a"), "path of " + titleOf(one.row.agent)]];
  if (two) list.push([kSwatches.line("b"), "path of " + titleOf(two.row.agent)]);
  if (layers.odometry) list.push([kSwatches.line("a", "2 4"), "where odometry believed to be"]);
  if (layers.shortest) list.push([kSwatches.line("good", "6 4"), "shortest path"]);
  list.push([kSwatches.dot("ink", "card"), "start"], [kSwatches.star("goal"), "goal"]);
  if (one.beliefs && layers.beliefs) {
    if (one.beliefs.size) list.push([kSwatches.box("free"), "its map: free"], [kSwatches.box("solid"), "its map: obstacle"]);
    list.push([kSwatches.dot("graph"), "its nodes"], [kSwatches.dot("graph", "card"), "ghost nodes, scores"]);
    if (one.beliefs.log.at_end) list.push(["", "(beliefs: at the last step alone)"]);
  }
  return list.map(([swatch, text]) => {
    const line = document.createElement("div");
    line.innerHTML = `<svg width="22" height="14">${swatch}</svg>`;
    line.append(text);
    return line;
  });
}

function layerButtons() {
  const entries = [["beliefs", "Beliefs", "B"], ["odometry", "Odometry", "O"], ["shortest", "Shortest", "S"]];
  const buttons = entries.map(([name, title, key]) => {
    const button = document.createElement("button");
    button.textContent = title;
    button.title = `${title} (${key})`;
    button.className = layers[name] ? "on" : "";
    button.onclick = () => toggle(name);
    return button;
  });
  const solid_button = document.createElement("button");
  solid_button.id = "solid";
  solid_button.textContent = "3D";
  solid_button.title = "The house in 3D (3)";
  solid_button.className = now.solid ? "on" : "";
  solid_button.onclick = toggleSolid;
  byId("layers").replaceChildren(...buttons, solid_button);
}

function toggle(name) {
  layers[name] = !layers[name];
  draw();
}

function toggleSolid() {
  if (!now.solid && !startSolid()) {
    say("This browser has no WebGL: the plan is all there is.");
    return;
  }
  now.solid = !now.solid;
  draw();
}

function say(text) {
  const note = document.createElement("p");
  note.textContent = text;
  byId("notes").replaceChildren(note);
}

/// Draws one of the pictures below each other in a strip.
function drawPicture(id, strip, which) {
  const canvas = byId(id);
  const ctx = canvas.getContext("2d");
  if (!strip) {
    ctx.clearRect(0, 0, canvas.width, canvas.height);
    return;
  }
  const height = strip.width / 4;
  canvas.width = strip.width;
  canvas.height = height;
  ctx.drawImage(strip, 0, which * height, strip.width, height, 0, 0, strip.width, height);
}

function drawViews() {
  const {one} = now;
  const seen = one && one.seen ? one.row.seen : [];
  byId("views").className = one && (one.seen || one.goal) ? "" : "none";
  if (!one) return;
  let which = 0;
  seen.forEach((step, i) => { if (step <= now.step) which = i; });
  drawPicture("sees", one.seen, which);
  byId("sees_title").textContent = seen.length ? `Sees, at step ${seen[which]}` : "Sees";
  const goal = goalAt(one, now.step);
  drawPicture("goal", one.goal, goal);
  byId("goal_title").textContent = one.path.goals.length > 1 ? `Goal ${goal + 1} of ${one.path.goals.length}` : "Goal";
}

function drawEvents() {
  const canvas = byId("events");
  canvas.width = canvas.clientWidth;
  canvas.height = 8;
  const ctx = canvas.getContext("2d");
  const last = Number(byId("step").max) || 1;
  const {one} = now;
  for (let i = 0; one && i < one.steps; ++i) {
    const is_stop = one.path.actions[i] === "S";
    if (!is_stop && one.path.collided[i] !== "1") continue;
    ctx.fillStyle = color(is_stop ? "goal" : "bad");
    ctx.fillRect((i + 1) / last * (canvas.width - 2), 0, 2, 8);
  }
}

const kActions = {F: "forward", L: "left", R: "right", S: "stop"};
function draw() {
  const {one} = now;
  byId("plan").hidden = now.solid;
  byId("house").hidden = !now.solid;
  byId("empty").textContent = one ? (one.row.scene_block < 0 && now.solid ? "the scene is not there" : "")
    : now.row ? "This result has no path to play back" : "Choose an episode on the left";
  byId("legend").replaceChildren(...(one && !now.solid ? legendOf() : []));
  layerButtons();
  drawViews();
  byId("step").value = now.step;
  const action = one && now.step > 0 ? one.path.actions[Math.min(now.step, one.steps) - 1] : "";
  byId("now").textContent = one ? `step ${now.step} of ${byId("step").max}${action ? " · " + kActions[action] : ""}` : "";
  (now.solid ? drawHouse() : drawPlan()).catch(error => say(String(error)));
}

function goTo(step) {
  now.step = Math.max(0, Math.min(step, Number(byId("step").max)));
  draw();
  keepLink();
}

function play(on) {
  clearInterval(now.timer);
  now.timer = null;
  const last = Number(byId("step").max);
  if (on && last > 0) {
    if (now.step >= last) now.step = 0;
    now.timer = setInterval(() => {
      goTo(now.step + 1);
      if (now.step >= last) play(false);
    }, kStepMs);
  }
  byId("play").textContent = now.timer ? "❚❚" : "▶";
}

/// Shows a result, at its last step unless another is given.
async function choose(row, step) {
  play(false);
  now.row = row;
  drawRows();
  const twin = twinOf(row);
  let results = [null, null];
  try {
    results = await Promise.all([loadResult(row), twin ? loadResult(twin) : null]);
  } catch (error) {
    say(`${row.episode}: ${error.message}`);
  }
  if (now.row !== row) return;
  [now.one, now.two] = results;
  const last = Math.max(0, ...results.map(one => one ? one.steps : 0));
  byId("step").max = last;
  now.step = Math.min(step ?? last, last);
  byId("verdict").replaceChildren(told(row, "a"), ...(twin ? [told(twin, "b")] : []));
  drawEvents();
  draw();
  keepLink();
}

/// The place in the address: who, where, when.
function keepLink() {
  if (!now.row) return;
  const {row} = now;
  const parts = {agent: run.agents[row.agent][0], episode: row.episode, setting: row.setting,
                 condition: row.condition, seed: row.seed, step: now.step};
  if (filter.other >= 0) parts.other = run.agents[filter.other][0];
  history.replaceState(null, "", "#" + new URLSearchParams(parts));
}

/// Of an address; the worst result of the list if it names none.
function followLink() {
  const link = new URLSearchParams(location.hash.slice(1));
  const agent = run.agents.findIndex(([name]) => name === link.get("agent"));
  const other = run.agents.findIndex(([name]) => name === link.get("other"));
  const wanted = run.rows.find(row => row.agent === agent && row.episode === link.get("episode") &&
    ["setting", "condition", "seed"].every(key => !link.has(key) || String(row[key]) === link.get(key)));
  if (wanted) filter.agent = agent;
  if (other >= 0) filter.other = other;
  updateFilters();
  updateTable();
  const first = wanted || shown[0];
  if (first) choose(first, wanted && link.has("step") ? Number(link.get("step")) : undefined);
}

function showTab(charts) {
  byId("left").hidden = charts;
  byId("charts").hidden = !charts;
  byId("tab_list").className = "tab" + (charts ? "" : " on");
  byId("tab_charts").className = "tab" + (charts ? " on" : "");
  if (charts) drawCharts(); else drawRows();
}

function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  mapImage.version = -1;
  drawEvents();
  draw();
}

/// The result so many rows further down the list.
function walkList(by) {
  const place = shown.indexOf(now.row);
  const next = shown[Math.max(0, Math.min(shown.length - 1, place + by))];
  if (!next) return;
  const list = byId("list"), top = shown.indexOf(next) * kRowHeight;
  if (top < list.scrollTop) list.scrollTop = top;
  if (top + kRowHeight > list.scrollTop + list.clientHeight) list.scrollTop = top + kRowHeight - list.clientHeight;
  choose(next);
}

const kKeys = {
  " ": () => play(!now.timer), ArrowLeft: shift => goTo(now.step - (shift ? 10 : 1)),
  ArrowRight: shift => goTo(now.step + (shift ? 10 : 1)), ArrowUp: () => walkList(-1), ArrowDown: () => walkList(1),
  Home: () => goTo(0), End: () => goTo(Infinity), b: () => toggle("beliefs"), o: () => toggle("odometry"),
  s: () => toggle("shortest"), 3: toggleSolid, c: () => showTab(byId("charts").hidden),
  t: () => setTheme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"),
  "?": () => byId("keys").showModal(),
};
document.onkeydown = event => {
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (event.ctrlKey || event.metaKey || event.target.tagName === "SELECT" || !kKeys[key]) return;
  event.preventDefault();
  kKeys[key](event.shiftKey);
};

byId("play").onclick = () => play(!now.timer);
byId("step").oninput = () => { play(false); goTo(Number(byId("step").value)); };
byId("tab_list").onclick = () => showTab(false);
byId("tab_charts").onclick = () => showTab(true);
byId("theme").onclick = () => kKeys.t();
byId("help").onclick = () => kKeys["?"]();
byId("list").onscroll = drawRows;
window.onresize = () => { drawRows(); drawEvents(); draw(); };
window.onhashchange = followLink;

byId("name").textContent = run.name;
byId("about").textContent = `${run.rows.length} results · ${run.agents.length} agents · ${run.scenes.length} houses`;
byId("notes").replaceChildren(...run.notes.map(text => {
  const note = document.createElement("p");
  note.textContent = text;
  return note;
}));
document.documentElement.dataset.theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
followLink();
