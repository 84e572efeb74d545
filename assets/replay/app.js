// SPDX-License-Identifier: MIT
// What is chosen and shown now; buttons, keys, links.
"use strict";
const layers = {beliefs: true, odometry: false, shortest: true};
const now = {row: null, results: [], storey: null, step: 0, length: 0, playing: 0, solid: false, asked: 0};

function isDark() { return document.documentElement.dataset.theme === "dark"; }

function setTheme(dark) {
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  readColours();
  show();
  if (!byId("charts").hidden) drawCharts();
}

/// Why there is nothing to play back for a result, and what to do.
function excuse(row) {
  if (row.has_path) return "";
  return `The path of this episode was not kept, so there is nothing to play back.\n` +
    `To see it, play it again and make a page of that:\n\n` +
    `./bulletnav run ${run.folder}/config.yaml --only ${row.episode} --beliefs --out results/again\n` +
    `./bulletnav replay results/again` + (run.to_play_again ? `\n\n${run.to_play_again}` : "");
}

/// A line over the plan, of what went wrong; none for "".
function say(text) {
  byId("message").textContent = text;
}

/// Shows a result, and beside it that of the agent to compare with.
async function choose(row, step = 0) {
  pause();
  say("");
  const asked = ++now.asked;
  now.row = row;
  drawRows();
  const twin = twinOf(row);
  let storey = null, trouble = "";
  const results = [];
  try {
    for (const one of [row, twin]) {
      const result = one ? await loadResult(one) : null;
      if (result) results.push(result);
    }
    storey = row.scene_block >= 0 ? await storeyOf(row.scene_block) : null;
  } catch (error) {
    trouble = `Episode ${row.episode}: ${error.message}`;
  }
  if (asked !== now.asked) return;  // another was chosen meanwhile
  say(trouble);
  Object.assign(now, {results, storey, twin});
  Object.assign(view, {zoom: 1, x: 0, z: 0});
  now.length = Math.max(0, ...results.map(one => one.steps));
  byId("step").max = now.length;
  byId("step").disabled = byId("play").disabled = !now.length;
  byId("empty").textContent = excuse(row);
  drawVerdict();
  await useHouse(now.solid);
  goTo(step);
}

function goTo(step) {
  now.step = Math.max(0, Math.min(Math.trunc(step), now.length));
  byId("step").value = now.step;
  show();
  keepLink();
}

function told(row, name) {
  const line = document.createElement("div");
  line.className = "told";
  const dot = Object.assign(document.createElement("span"), {className: "dot " + name});
  const title = Object.assign(document.createElement("b"), {textContent: titleOf(row.agent)});
  const pill = Object.assign(document.createElement("span"), {className: "pill" + (row.ok ? " ok" : "")});
  pill.textContent = row.ok ? "reached" : row.why;
  const facts = [`SPL ${numbered(row.spl, 2)}`, `${row.steps} steps`, `walked ${numbered(row.path_length, 1)} m`,
                 `ended ${numbered(row.distance_to_goal, 1)} m from the goal`];
  if (row.goals > 1) facts.unshift(`${row.reached} of ${row.goals} goals`);
  if (row.collisions) facts.push(`${row.collisions} collisions`);
  if (row.failure) facts.unshift(row.failure);
  const rest = Object.assign(document.createElement("span"), {className: "facts", textContent: facts.join(" · ")});
  rest.title = rest.textContent;
  line.append(dot, title, pill, rest);
  return line;
}

function drawVerdict() {
  const row = now.row;
  const lines = [told(row, "a")];
  if (now.twin) lines.push(told(now.twin, "b"));
  const where = document.createElement("div");
  where.className = "told";
  where.append(Object.assign(document.createElement("span"), {className: "facts",
    textContent: `${row.episode} · ${row.difficulty || "several goals"} · ${sceneName(row.scene)} · goal ${numbered(row.start_distance, 1)} m away · ${settingOf(row)}`}));
  byId("verdict").replaceChildren(where, ...lines);
}

/// Draws all that depends on the step.
function show() {
  byId("layers").hidden = !now.results.length;
  for (const name of Object.keys(layers)) byId("layer_" + name).classList.toggle("on", layers[name]);
  byId("layer_solid").classList.toggle("on", now.solid);
  drawLegend(now.solid ? [] : now.results, now.step, layers);
  drawEvents();
  drawViews();
  if (now.solid) drawHouse(now);  // last: what is below takes its room first
  else drawPlan(byId("plan"), {...now, layers});
  const main = now.results[0];
  byId("now").textContent = main ? `step ${now.step} of ${now.length} · ${actionAt(main, now.step)}` : "";
  byId("play").textContent = now.playing ? "❚❚" : "▶";
}

function actionAt(result, step) {
  if (step >= result.steps) return "end";
  return {F: "forward", L: "turn left", R: "turn right", S: "stop"}[result.path.actions[step]] || "";
}

/// Collisions and stops as marks over the slider; the second agent's below the first's.
function drawEvents() {
  const canvas = byId("events");
  const pen = fitted(canvas);
  const width = canvas.clientWidth, height = canvas.clientHeight / Math.max(now.results.length, 1);
  now.results.forEach((one, i) => {
    for (let step = 0; step < one.steps; ++step) {
      const stop = one.path.actions[step] === "S";
      if (!stop && one.path.collided[step] !== "1") continue;
      pen.fillStyle = stop ? colours.ink : colours.bad;
      pen.fillRect((step + 1) / now.length * width - 1, i * height, stop ? 3 : 1.5, height - 1);
    }
  });
}

/// One panorama of a strip, with a mark straight ahead.
function drawStrip(canvas, strip, count, place) {
  const pen = fitted(canvas);
  if (!strip) return;
  const height = strip.height / count;
  pen.drawImage(strip, 0, place * height, strip.width, height, 0, 0, canvas.clientWidth, canvas.clientHeight);
  pen.fillStyle = "#ffffffcc";
  const middle = canvas.clientWidth / 2;
  pen.beginPath();
  pen.moveTo(middle - 5, 0); pen.lineTo(middle + 5, 0); pen.lineTo(middle, 6);
  pen.fill();
}

function drawViews() {
  const main = now.results[0];
  const has = Boolean(main && (main.seen || main.goal));
  byId("views").className = has ? "" : "none";
  if (!has) return;
  const steps = main.row.seen;
  let place = steps.findIndex(step => step > now.step) - 1;
  if (place < -1) place = steps.length - 1;
  place = Math.max(place, 0);
  byId("sees_title").textContent = `What ${titleOf(main.row.agent)} sees (step ${steps[place] ?? "–"}; the middle is ahead)`;
  drawStrip(byId("sees"), main.seen, steps.length, place);
  const goals = main.path.goals.length, goal = goalAt(main, now.step);
  byId("goal_title").textContent = goals > 1 ? `Goal ${goal + 1} of ${goals}` : "The goal's picture";
  drawStrip(byId("goal"), main.goal, goals, goal);
}

function pause() {
  cancelAnimationFrame(now.playing);
  now.playing = 0;
}

/// Plays an episode in 8 to 25 seconds, from the start if it stands at the end.
function play() {
  if (!now.length) return;
  if (now.step >= now.length) now.step = 0;
  const rate = Math.max(10, now.length / 25) / 1000;
  let before = null, at = now.step;  // the first frame's time may be one before this moment
  const tick = time => {
    at += Math.max(0, time - (before ?? time)) * rate;
    before = time;
    if (Math.floor(at) !== now.step) { now.step = Math.min(Math.floor(at), now.length); byId("step").value = now.step; }
    now.playing = now.step < now.length ? requestAnimationFrame(tick) : 0;
    show();
    if (!now.playing) keepLink();
  };
  now.playing = requestAnimationFrame(tick);
  show();
}

function togglePlay() {
  if (now.playing) { pause(); goTo(now.step); } else play();
}

/// Switches between plan and 3D; without WebGL says so and stays with the plan.
async function useHouse(solid) {
  now.solid = solid && now.results.length > 0 && openHouse(byId("house"), now);
  byId("plan").hidden = now.solid;
  byId("house").hidden = !now.solid;
  byId("no_webgl").hidden = !(solid && now.results.length && !now.solid);
}

async function toggleHouse() {
  await useHouse(!now.solid);
  goTo(now.step);
}

function toggleLayer(name) {
  layers[name] = !layers[name];
  show();
}

function showCharts(charts) {
  byId("charts").hidden = !charts;
  byId("left").hidden = charts;
  byId("tab_charts").classList.toggle("on", charts);
  byId("tab_list").classList.toggle("on", !charts);
  if (charts) drawCharts();
  else drawRows();
  keepLink();
}

/// The result above or below in the list.
function move(by) {
  const place = shown.indexOf(now.row);
  const row = shown[Math.max(0, Math.min(place < 0 ? 0 : place + by, shown.length - 1))];
  if (!row) return;
  revealRow(shown.indexOf(row));
  choose(row);
}

/// After a change of filters, what is shown is in the list: the same row, or the same episode by
/// the agent that was chosen, or the first row.
function followList() {
  if (!now.row || !shown.length) return;
  const row = shown.includes(now.row) ? now.row
    : shown.find(one => one.agent === filter.agent && one.task === now.row.task) || shown[0];
  revealRow(shown.indexOf(row));
  if (row !== now.row) choose(row);
  else drawRows();
}

function revealRow(place) {
  const list = byId("list"), top = place * kRowHeight;
  if (top < list.scrollTop) list.scrollTop = top;
  if (top + kRowHeight > list.scrollTop + list.clientHeight) list.scrollTop = top + kRowHeight - list.clientHeight;
}

const keys = {
  " ": togglePlay, Home: () => goTo(0), End: () => goTo(now.length),
  ArrowLeft: event => { pause(); goTo(now.step - (event.shiftKey ? 10 : 1)); },
  ArrowRight: event => { pause(); goTo(now.step + (event.shiftKey ? 10 : 1)); },
  ArrowUp: () => move(-1), ArrowDown: () => move(1),
  b: () => toggleLayer("beliefs"), o: () => toggleLayer("odometry"), s: () => toggleLayer("shortest"),
  3: toggleHouse, c: () => showCharts(byId("charts").hidden), t: () => setTheme(!isDark()),
  "?": () => byId("keys").showModal(),
};

function onKey(event) {
  if (event.ctrlKey || event.altKey || event.metaKey || byId("keys").open) return;
  if (event.target.tagName === "SELECT") return;
  const key = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (!key) return;
  event.preventDefault();
  key(event);
}

/// What is shown, as the end of the page's address: a link to share.
function linkText() {
  const link = new URLSearchParams();
  if (now.row) {
    const {agent, setting, condition, seed, scene, episode} = now.row;
    const words = {agent: run.agents[agent][0], setting, condition, seed, scene: run.scenes[scene], episode, step: now.step};
    for (const [name, value] of Object.entries(words)) link.set(name, value);
  }
  if (filter.other >= 0) link.set("with", run.agents[filter.other][0]);
  if (now.solid) link.set("view", "3d");
  if (!byId("charts").hidden) link.set("charts", "1");
  return "#" + link;
}

function keepLink() {
  try { history.replaceState(null, "", linkText()); } catch { /* a browser that lets no file do so */ }
}

/// Shows what a link tells; says so if there is no such result.
async function followLink() {
  const link = new URLSearchParams(location.hash.slice(1));
  const other = run.agents.findIndex(([name]) => name === link.get("with"));
  const agent = run.agents.findIndex(([name]) => name === link.get("agent"));
  Object.assign(filter, {outcome: "", difficulty: "", other, setting: "", scene: -1, reason: "", gain: ""});
  if (agent >= 0) filter.agent = agent;
  updateFilters();
  updateTable();
  const row = run.rows.find(one => one.agent === agent && one.setting === link.get("setting") &&
    one.condition === link.get("condition") && String(one.seed) === link.get("seed") &&
    run.scenes[one.scene] === link.get("scene") && one.episode === link.get("episode"));
  now.solid = link.get("view") === "3d";
  if (row) {
    revealRow(shown.indexOf(row));
    await choose(row, Number(link.get("step")) || 0);
  } else if (shown.length) {
    await choose(shown[0]);
    if (link.get("episode")) say("This page has no result of the link that was followed. The first of the list is shown.");
  }
  if (link.get("charts")) showCharts(true);
}

/// Dragging moves the plan, the wheel zooms about the pointer, a double click shows all.
function addPointer(canvas) {
  let last = null;
  canvas.onpointerdown = event => { last = event; canvas.setPointerCapture(event.pointerId); };
  canvas.onpointerup = () => { last = null; };
  canvas.onpointermove = event => {
    if (!last) return;
    const dx = event.clientX - last.clientX, dy = event.clientY - last.clientY;
    last = event;
    const [x, z] = toWorld(dx, dy);
    view.x -= x;
    view.z -= z;
    show();
  };
  canvas.onwheel = event => {
    event.preventDefault();
    const zoom = Math.max(0.5, Math.min(20, view.zoom * Math.exp(-event.deltaY / 600)));
    const box = canvas.getBoundingClientRect();
    const [x, z] = toWorld(event.clientX - box.left - canvas.clientWidth / 2,
                           event.clientY - box.top - canvas.clientHeight / 2);
    view.x += x * (1 - view.zoom / zoom);  // what is below the pointer stays there
    view.z += z * (1 - view.zoom / zoom);
    view.zoom = zoom;
    show();
  };
  canvas.ondblclick = () => { Object.assign(view, {zoom: 1, x: 0, z: 0}); show(); };
}

function start() {
  const agents = run.agents.length === 1 ? "1 agent" : `${run.agents.length} agents`;
  byId("name").textContent = run.name;
  byId("about").textContent = `${run.rows.length === 1 ? "1 result" : run.rows.length + " results"} · ${agents} · ${run.scenes.length === 1 ? "1 scene" : run.scenes.length + " scenes"}`;
  byId("notes").replaceChildren(...run.notes.map(note => Object.assign(document.createElement("p"), {textContent: note})));
  byId("tab_list").onclick = () => showCharts(false);
  byId("tab_charts").onclick = () => showCharts(true);
  byId("theme").onclick = () => setTheme(!isDark());
  byId("help").onclick = () => byId("keys").showModal();
  byId("play").onclick = togglePlay;
  byId("step").oninput = () => { pause(); goTo(Number(byId("step").value)); };
  byId("list").onscroll = drawRows;
  for (const name of Object.keys(layers)) byId("layer_" + name).onclick = () => toggleLayer(name);
  byId("layer_solid").onclick = toggleHouse;
  addPointer(byId("plan"));
  document.onkeydown = onKey;
  window.onresize = () => { drawRows(); show(); };
  window.onhashchange = followLink;
  setTheme(matchMedia("(prefers-color-scheme: dark)").matches);
  followLink().then(() => { document.documentElement.dataset.ready = "yes"; });
}
start();
