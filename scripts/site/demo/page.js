// SPDX-License-Identifier: Apache-2.0
// The demo's page: what is asked for goes to a worker, what comes back is shown.
"use strict";

const byId = (id) => document.getElementById(id);
const workerSource = URL.createObjectURL(new Blob([WORKER], { type: "text/javascript" }));
let worker = null, turn = 0, shown = null, timer = 0;

/// Error that words so wide are planned for, nm: before rounding 0.1 with 30 bits, and half a unit.
const errorOf = (bits) => 0.5 + 0.1 * 2 ** Math.max(0, 30 - bits);

function say(text, wrong) {
  byId("status").textContent = text;
  byId("status").classList.toggle("wrong", Boolean(wrong));
}

/// Selects the line of the editor that a message names.
function showLine(reason) {
  const line = /^[^:]*:(\d+): /.exec(reason);
  if (!line) return;
  const lines = byId("text").value.split("\n"), n = +line[1] - 1;
  const start = lines.slice(0, n).join("\n").length + (n > 0 ? 1 : 0);
  byId("text").setSelectionRange(start, start + (lines[n] || "").length);
  const tall = parseFloat(getComputedStyle(byId("text")).lineHeight);
  byId("text").scrollTop = Math.max(0, (n - 3) * tall);
}

function row(list, name, value, note) {
  const cell = document.createElement("div");
  for (const [tag, text] of [["span", name], ["strong", value], ["small", note]]) {
    const part = document.createElement(tag);
    part.textContent = text;
    cell.append(part);
  }
  list.append(cell);
}

function showFigures(data) {
  const list = byId("figures"), traffic = data.traffic, nm = data.unit_mm * 1e6;
  const words = traffic.segment_words + traffic.profile_words;
  const count = (n) => n.toLocaleString("en");
  list.replaceChildren();
  row(list, "worst error", `${number(data.worst * nm)} nm`,
      `of a derived bound of ${number(data.bound * nm)} nm, before positions are rounded to 1 nm`);
  row(list, "chords of equal traffic", `${number(traffic.chords_off_mm * 1e6)} nm`,
      `off the path: ${count(traffic.chords)} chords of ${traffic.chord_bits} bits`);
  row(list, "traffic", `${count(words)} words`,
      `${count(traffic.segment_words)} of ${count(traffic.segments)} segments, ` +
      `${count(traffic.profile_words)} of the feed profile, 48 bits each`);
  row(list, "time", `${number(data.duration_s)} s`,
      `${number(data.path_mm)} mm, ${count(data.samples)} samples, each checked`);
}

function showCharts(data) {
  const nm = data.unit_mm * 1e6, scaled = (values) => values.map((v) => v * nm);
  const time = { width: data.duration_s, unit: "s" };
  drawChart(byId("error"), { bins: scaled(data.errors), limits: scaled(data.bounds),
                             width: data.path_mm, unit: "mm", what: "error in nm" });
  drawChart(byId("speed"), { bins: data.speed, limits: [data.velocity], ...time,
                             what: "speed in mm/s" });
  const window = data.window;
  drawChart(byId("acceleration"), { bins: window ? data.total : data.acceleration, ...time,
                                    limits: window ? [window.acceleration] : [],
                                    what: "acceleration in mm/s2" });
  drawChart(byId("jerk"), { bins: window ? data.jerk : [], ...time,
                            limits: window ? [window.jerk] : [], what: "jerk in mm/s3" });
  if (!window) return;
  const mean = `mean over ${number(window.ms)} ms; dashed: allowed over it`;
  byId("accelerationNote").textContent = `of the path as a vector, mm/s\u00b2 over time, ${mean}`;
  byId("jerkNote").textContent = `of the path as a vector, mm/s\u00b3 over time, ${mean}`;
}

function drawView() {
  if (!shown) return;
  const near = drawPath(byId("path"), shown.data), letters = view.axes.map((axis) => "XYZ"[axis]);
  byId("viewTitle").textContent = "Path, " + letters.join(" ");
  byId("scale").textContent = near ? "" : "(zoom in to tell them apart)";
}

function drawAll() {
  if (!shown) return;
  drawView();
  showCharts(shown.data);
}

function show(answer) {
  const first = !shown || shown.name !== answer.name;
  if (first) Object.assign(view, HOME);
  shown = answer;
  const data = answer.data, warnings = data.warnings || [];
  const checks = data.checks.filter(([, held]) => !held).map(([name]) => name);
  say(checks.length ? "failed: " + checks.join(", ")
                    : ["Every check held.", ...warnings.slice(0, 3)].join("\n"), checks.length);
  showFigures(data);
  drawAll();
  byId("report").disabled = byId("samples").disabled = false;
}

function receive({ data: answer }) {
  if (answer.turn !== turn) return;
  byId("demo").removeAttribute("aria-busy");
  if (!answer.data.refused) {
    show({ ...answer, name: byId("program").value });
    return;
  }
  say(answer.data.reason, true);
  showLine(answer.data.reason);
  if (answer.data.refused === "memory") endWorker();
}

function endWorker() {
  if (worker) worker.terminate();
  worker = null;
}

/// Draws what the page asks for now; what is still under way is given up.
function ask() {
  if (byId("demo").hasAttribute("aria-busy")) endWorker();
  if (!worker) {
    worker = new Worker(workerSource);
    worker.onmessage = receive;
    worker.onerror = (event) => {
      byId("demo").removeAttribute("aria-busy");
      say(event.message, true);
    };
  }
  byId("demo").setAttribute("aria-busy", "true");
  say("Planning and drawing ..");
  const bits = +byId("bits").value, unit = "1nm";
  const options = `--on kernel --unit ${unit} --set Order=${byId("order").value} --set ` +
    `CoefBits=${bits} --error ${errorOf(bits)}nm --holds ${byId("holds").value} ` +
    `--sample-period ${byId("period").value}`;
  worker.postMessage({ turn: ++turn, name: "part.ngc", text: byId("text").value, options });
}

function askSoon() {
  clearTimeout(timer);
  timer = setTimeout(ask, 300);
  document.querySelectorAll("#demo output").forEach((output) => {
    output.textContent = byId(output.htmlFor[0]).value;
  });
}

function zoom(factor) {
  view.scale = Math.min(view.scale * factor, 1e8);
  drawView();
}

/// Shows the chord that is off the most, its distance some 30 px, from where that is seen best.
function showWorst() {
  const traffic = shown && shown.data.traffic;
  if (!traffic || !traffic.beside) return;
  const { corners, worst_chord: n, beside } = traffic, place = beside[beside.length >> 1];
  const off = place.map((v, axis) => Math.abs(v - (corners[n][axis] + corners[n + 1][axis]) / 2));
  const flat = off.map((v, axis) => [Math.abs(corners[n + 1][axis] - corners[n][axis]) + v, axis])
    .sort((a, b) => a[0] - b[0])[0][1];
  const axes = [0, 1, 2].filter((axis) => axis !== flat);
  Object.assign(view, { axes, x: place[axes[0]], y: place[axes[1]],
                        scale: 30 / Math.max(traffic.chords_off_mm, 1e-6) });
  drawView();
}

async function take(file) {
  if (!file) return;
  byId("text").value = await file.text();
  byId("program").value = "";
  Object.assign(view, HOME);
  askSoon();
}

function save(content, type, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], { type }));
  if (name) link.download = name; else link.target = "_blank";
  link.click();
}

function listenToView() {
  const canvas = byId("path"), shift = (dx, dy) => {
    view.x -= dx / view.scale;
    view.y += dy / view.scale;
    drawView();
  };
  const keys = { ArrowLeft: [40, 0], ArrowRight: [-40, 0], ArrowUp: [0, 40], ArrowDown: [0, -40] };
  canvas.addEventListener("keydown", (event) => {
    if (keys[event.key]) shift(...keys[event.key]);
    else if (event.key === "+" || event.key === "=") zoom(1.5);
    else if (event.key === "-") zoom(1 / 1.5);
    else return;
    event.preventDefault();
  });
  canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    if (event.buttons) shift(event.movementX, event.movementY);
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(-event.deltaY * 0.002));
  }, { passive: false });
  byId("in").addEventListener("click", () => zoom(2));
  byId("out").addEventListener("click", () => zoom(0.5));
  byId("all").addEventListener("click", () => { Object.assign(view, HOME); drawView(); });
  byId("worst").addEventListener("click", showWorst);
}

function listen() {
  for (const name of Object.keys(PROGRAMS)) byId("program").add(new Option(name, name));
  byId("program").add(new Option("your own", ""));
  const load = () => {
    if (!byId("program").value) return;
    byId("text").value = PROGRAMS[byId("program").value];
    askSoon();
  };
  byId("program").addEventListener("change", load);
  byId("text").addEventListener("input", askSoon);
  for (const id of ["order", "bits", "period", "holds"]) byId(id).addEventListener("input", askSoon);
  byId("file").addEventListener("change", (event) => take(event.target.files[0]));
  byId("text").addEventListener("dragover", (event) => event.preventDefault());
  byId("text").addEventListener("drop", (event) => {
    event.preventDefault();
    take(event.dataTransfer.files[0]);
  });
  byId("report").addEventListener("click", () => save(shown.report, "text/html"));
  byId("samples").addEventListener("click", () => save(shown.samples, "text/csv", "samples.csv"));
  listenToView();
  window.addEventListener("resize", drawAll);
  new MutationObserver(drawAll).observe(document.body, { attributeFilter: ["data-md-color-scheme"] });
  load();
}

listen();
