"use strict";
// The page's end of sysc/panel/page_server.hpp.
const byId = (id) => document.getElementById(id);
const OUTPUTS = ["spindle", "ccw", "mist", "flood", "P0", "P1", "P2", "P3"];
const ENDS = new Set(["drawn", "stopped", "fault", "lost"]);
let asked = null;  // the path for which points came last
let points = [], thinned = 0;  // [x, y, z, s, line], mm; of a board, which knows no mm, steps
let status = null, control = false, open = false, fetching = false;
let turn = [0, 0], zoom = 1;   // of the view: about z and about the screen's x axis

function add(parent, tag, text, name) {
  const e = document.createElement(tag);
  if (text !== undefined) e.textContent = text;
  if (name) e.className = name;
  parent.append(e);
  return e;
}

// What is shown ------------------------------------------------------------------------------------
const minutes = (s) => Math.floor(Math.ceil(s) / 60) + ":" + String(Math.ceil(s) % 60).padStart(2, "0");

// Of the path, drawn and known: of a board the way of its axes.
const drawn = () => status.way_steps ?? status.path_mm, known = () => status.way_steps ?? status.planned_mm;

function figures() {
  if (status.figures) return Object.entries(status.figures);
  const so_far = status.all_planned ? "" : " so far", least = status.all_planned ? "" : "at least ";
  return [
    ["feed", status.feed_mm_min.toFixed(0) + " mm/min"],
    ["rate of time", status.rate_percent.toFixed(0) + " %"],
    ["line", status.line],
    ["path", status.path_mm.toFixed(2) + " of " + status.planned_mm.toFixed(2) + " mm" + so_far],
    ["left", least + minutes(status.left_s)],
    ...(status.from ? [["went on --from", status.from]] : []),
    ["faults", status.faults || "none"],
  ];
}

function rows(parent, all, tags) {
  parent.replaceChildren();
  for (const row of all) row.forEach((text, n) => add(parent, tags[n], text));
}

function showStatus() {
  const ended = ENDS.has(status.state) || status.state === "off", gone = !open && !ENDS.has(status.state);
  const badge = byId("state");  // stream ends with its program: then nothing is to be connected
  badge.textContent = gone ? status.state + " - no connection" : status.state;
  badge.style.background = gone || status.faults ? "var(--bad)" : status.state === "runs" || status.state === "drawn" ? "var(--good)" : "var(--soft)";
  byId("dro").replaceChildren();
  for (const axis of status.axes) {
    const tr = add(byId("dro"), "tr"), error = axis.following_mm;
    add(tr, "td", axis.name);
    const place = add(tr, "td", axis.place_mm === undefined ? axis.steps : axis.place_mm.toFixed(3));
    if (error !== undefined) add(place, "small", " " + error.toFixed(4) + " off");
  }
  rows(byId("figures"), figures(), ["dt", "dd"]);
  byId("outputs").replaceChildren();
  if (status.outputs) {
    OUTPUTS.forEach((name, bit) => add(byId("outputs"), "li", name, status.outputs.bits >> bit & 1 ? "on" : ""));
    add(byId("outputs"), "li", "power " + (100 * status.outputs.power).toFixed(0) + " %", status.outputs.power > 0 ? "on" : "");
  }
  byId("queues").replaceChildren();
  for (const queue of status.queues || []) {
    add(byId("queues"), "div", queue.name + ": " + queue.waiting + " of " + queue.words);
    const meter = add(byId("queues"), "meter");
    meter.max = queue.words; meter.value = queue.waiting;
    meter.setAttribute("aria-label", queue.name);
  }
  byId("percent").textContent = status.override_percent;
  if (document.activeElement !== byId("rate")) byId("rate").value = status.override_percent;
  for (const e of document.querySelectorAll("[data-wish], #rate")) e.disabled = !control || !open || ended;
  byId("may").textContent = control ? "" : "read only: the address that stream printed, with what is behind #, may ask";
  byId("rest").hidden = !status.rest;
  byId("why").textContent = status.state === "lost" ? "The board does not answer. Is it still on? " : "";
  byId("options").textContent = status.rest || "";
  fetchPoints();
  draw();
}

async function fetchPoints() {
  const goal = known();
  if (fetching || !open || (points.length && asked === goal)) return;
  fetching = true;
  try {
    const more = await (await fetch("/points?from=" + points.length)).json();
    if (more.thinned !== thinned) {
      const all = await (await fetch("/points?from=0")).json();
      points = all.points; thinned = all.thinned;
    } else {
      points = points.concat(more.points);
    }
    asked = goal;
    draw();
  } catch (gone) { /* The web socket says so. */ }
  fetching = false;
}

// The path -----------------------------------------------------------------------------------------
function turned(p) {
  const [cz, sz, cx, sx] = [Math.cos(turn[0]), Math.sin(turn[0]), Math.cos(turn[1]), Math.sin(turn[1])];
  const x = cz * p[0] - sz * p[1], y = sz * p[0] + cz * p[1];
  return [x, cx * y + sx * p[2]];
}

// The place on the path at s, between two points.
function at(s) {
  let low = 0, high = points.length - 1;
  while (low + 1 < high) {
    const middle = (low + high) >> 1;
    if (points[middle][3] <= s) low = middle; else high = middle;
  }
  const a = points[low], b = points[high], way = b[3] - a[3];
  const part = way > 0 ? Math.min(Math.max((s - a[3]) / way, 0), 1) : 1;
  return { before: low, point: [0, 1, 2].map((n) => a[n] + part * (b[n] - a[n])) };
}

function draw() {
  const canvas = byId("space"), ratio = window.devicePixelRatio || 1;
  const wide = canvas.clientWidth, high = canvas.clientHeight, pen = canvas.getContext("2d");
  if (canvas.width !== wide * ratio) { canvas.width = wide * ratio; canvas.height = high * ratio; }
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, wide, high);
  if (points.length < 2 || !status) return;
  const flat = points.map(turned);
  let [left, right, low, top] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const [x, y] of flat) { left = Math.min(left, x); right = Math.max(right, x); low = Math.min(low, y); top = Math.max(top, y); }
  const scale = zoom * Math.min((wide - 40) / Math.max(right - left, 1e-6), (high - 40) / Math.max(top - low, 1e-6));
  const on = ([x, y]) => [wide / 2 + scale * (x - (left + right) / 2), high / 2 - scale * (y - (low + top) / 2)];
  const style = getComputedStyle(document.documentElement), now = at(drawn());
  const board = status.way_steps !== undefined;  // all of its way is drawn, and its axes are the tool
  const tool = on(turned(board ? status.axes.map((axis) => axis.steps) : now.point));
  const line = (from, to, colour, first) => {
    pen.beginPath();
    if (first) pen.moveTo(...first);
    for (let n = from; n <= to; ++n) pen.lineTo(...on(flat[n]));
    if (to < flat.length - 1 || board) pen.lineTo(...tool);
    pen.strokeStyle = style.getPropertyValue(colour);
    pen.stroke();
  };
  pen.lineWidth = 1.5; pen.lineJoin = "round";
  if (!board) line(now.before + 1, flat.length - 1, "--todo", tool);
  pen.lineWidth = 2;
  line(0, board ? flat.length - 1 : now.before, "--done");
  pen.beginPath(); pen.arc(...tool, 6, 0, 2 * Math.PI);
  pen.fillStyle = style.getPropertyValue("--tool"); pen.fill();
  byId("place").textContent = board ? "the way of its axes since the drives were turned on" :
    status.path_mm.toFixed(3) + " mm along the path, line " + status.line;
}

// What is asked for --------------------------------------------------------------------------------
let socket = null;
const say = (message) => { if (socket && socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(message)); };
const ask = (wish) => { if (control) say({ wish }); };

function connect() {
  socket = new WebSocket("ws://" + location.host + "/live");
  socket.onopen = () => { open = true; say({ token: location.hash.slice(1) }); };
  socket.onclose = () => {
    open = false;
    if (status) showStatus(); else byId("state").textContent = "no connection";
    if (!status || !ENDS.has(status.state)) setTimeout(connect, 1000);
  };
  socket.onmessage = (event) => {
    const said = JSON.parse(event.data);
    if (said.hello) {
      points = [];
      byId("title").textContent = said.hello.program;
      document.title = said.hello.program + " - curvecore " + said.hello.command;
      byId("by").textContent = "curvecore " + said.hello.version + " " + said.hello.command;
      for (const e of document.querySelectorAll(".stream, .board")) e.hidden = !e.classList.contains(said.hello.command);
    }
    if (said.control !== undefined) control = said.control;
    if (said.log) { byId("log").textContent = said.log.join("\n"); byId("log").scrollTop = 1e9; }
    if (said.status) status = said.status;
    if (status) showStatus();
  };
}

byId("copy").onclick = async () => {
  getSelection().selectAllChildren(byId("options"));
  try {
    await navigator.clipboard.writeText(status.rest);
    byId("copy").textContent = "Copied";
  } catch (refused) { /* It is selected, at least. */ }
};
for (const button of document.querySelectorAll("[data-wish]")) button.onclick = () => ask(button.dataset.wish);
byId("rate").oninput = () => { byId("percent").textContent = byId("rate").value; ask("override " + byId("rate").value); };
const space = byId("space");
space.onpointermove = (event) => {
  if (!event.buttons) return;
  turn[0] += event.movementX / 150; turn[1] = Math.min(Math.max(turn[1] + event.movementY / 150, -Math.PI / 2), Math.PI / 2);
  draw();
};
space.onwheel = (event) => { event.preventDefault(); zoom = Math.min(Math.max(zoom * Math.exp(-event.deltaY / 500), 0.2), 200); draw(); };
space.ondblclick = () => { turn = [0, 0]; zoom = 1; draw(); };
space.onkeydown = (event) => {
  const way = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
  if (!way) return;
  event.preventDefault(); turn[0] += way[0]; turn[1] += way[1];
  draw();
};
window.onresize = draw;
connect();
