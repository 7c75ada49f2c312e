// What is shown and what may be changed; every change ends in update().
const byId = (id) => document.getElementById(id);
const PLOT = { grid: "#2a3644", ink: "#93a3b5", text: "#e4e9ef", jump: "#ff6b5e" };
const PATHS = ["#3fb6ff", "#5ed380"], IDLE = "#ffc94d", AXES = ["#ff7b72", "#7ee787", "#79c0ff"];
const copy = (value) => JSON.parse(JSON.stringify(value));

let move = copy(D.join);   // join.json as it stands; its result is computed when it is saved
let selected = 0;          // index of a control point
let axes = [0, 1];         // of the plane that is shown
let view = null;           // {x, y, scale}: what is in its middle, pixels per mm
let shown = null;          // what update() computed

const number = (v) => {
  if (Math.abs(v) < 1e-9) return "0";
  const a = Math.abs(v);
  return a >= 1e5 || a < 1e-3 ? v.toExponential(1).replace("e+", "e") : String(+v.toPrecision(3));
};
function ticks(low, high, count) {
  const raw = (high - low) / count, p = Math.pow(10, Math.floor(Math.log10(raw)));
  const step = [1, 2, 5, 10].find((m) => m * p >= raw) * p, all = [];
  for (let v = Math.ceil(low / step) * step; v <= high + step * 1e-9; v += step) all.push(Math.abs(v) < step * 1e-6 ? 0 : v);
  return all;
}
function surface(canvas) {
  const ratio = window.devicePixelRatio || 1, w = canvas.clientWidth, h = canvas.clientHeight;
  canvas.width = Math.round(w * ratio); canvas.height = Math.round(h * ratio);
  const g = canvas.getContext("2d");
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  g.font = "11px system-ui, sans-serif"; g.lineJoin = g.lineCap = "round";
  return { g, w, h };
}
function stroke(g, points, colour, width) {
  g.strokeStyle = colour; g.lineWidth = width; g.beginPath();
  points.forEach((p) => g.lineTo(...p)); g.stroke();
}

// Rows of {s, joint, v, a} along the idle move; two at every control point.
function sample(path, course) {
  const rows = [];
  path.pieces.forEach((_, piece) => {
    for (let k = 0; k <= 80; ++k) {
      const s = path.path(piece, k / 80);
      rows.push({ s, ...path.at(piece, k / 80), v: course.speed(s), a: course.acceleration(s) });
    }
  });
  return rows;
}

function compute() {
  const path = new PathTable(piecesOf(move));
  const course = speedCourse(move.speed, move.start.feed, move.end.feed, path.length);
  const working = D.stretches.map((rows, side) => rows.map((row) =>
    ({ ...row, s: row.s + (side ? path.length : 0), v: row.feed, a: 0 })));
  const result = compareJoins(move);
  let blocks = "", flaw = flawOfPoints(move);
  try { blocks = idleGcode(move); } catch (error) { flaw = error.message; }
  return { path, idle: sample(path, course), working, result, own: result.find((r) => r.move === move.fit), blocks, flaw };
}

function boundsOf() {
  const points = [...shown.idle.map((r) => r.position), ...move.points, ...D.stretches.flat().map((r) => r.position)];
  return axes.map((a) => points.reduce(([low, high], p) => [Math.min(low, p[a]), Math.max(high, p[a])], [Infinity, -Infinity]));
}
function showAll() {
  const canvas = byId("plane"), [bx, by] = boundsOf();
  const scale = 0.82 * Math.min(canvas.clientWidth / (bx[1] - bx[0] || 1), canvas.clientHeight / (by[1] - by[0] || 1));
  view = { x: (bx[0] + bx[1]) / 2, y: (by[0] + by[1]) / 2, scale };
}
const toScreen = (p, canvas = byId("plane")) =>
  [canvas.clientWidth / 2 + (p[axes[0]] - view.x) * view.scale, canvas.clientHeight / 2 - (p[axes[1]] - view.y) * view.scale];
const ARROW = 38;
const arrowTips = () => {
  const p = move.points[selected];
  if (!p) return [];
  const [x, y] = toScreen(p);
  return [[x + ARROW, y], [x, y - ARROW]];
};

function drawArrow(g, from, to, colour) {
  const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
  stroke(g, [from, to], colour, 2);
  g.fillStyle = colour; g.beginPath(); g.moveTo(...to);
  for (const turn of [2.6, -2.6]) g.lineTo(to[0] + 10 * Math.cos(angle + turn), to[1] + 10 * Math.sin(angle + turn));
  g.fill();
}

function drawPlane() {
  const { g, w, h } = surface(byId("plane"));
  g.fillStyle = PLOT.ink;
  const [x0, x1] = [view.x - w / 2 / view.scale, view.x + w / 2 / view.scale];
  const [y0, y1] = [view.y - h / 2 / view.scale, view.y + h / 2 / view.scale];
  g.textAlign = "center";
  for (const x of ticks(x0, x1, 8)) { const px = w / 2 + (x - view.x) * view.scale; stroke(g, [[px, 0], [px, h]], PLOT.grid, 1); g.fillText(number(x), px, h - 6); }
  g.textAlign = "left";
  for (const y of ticks(y0, y1, 6)) { const py = h / 2 - (y - view.y) * view.scale; stroke(g, [[0, py], [w, py]], PLOT.grid, 1); g.fillText(number(y), 6, py - 4); }
  D.paths.forEach((path, i) => stroke(g, path.map((p) => toScreen(p)), PATHS[i], 2.2));
  g.setLineDash([3, 5]);
  stroke(g, [move.start.position, ...move.points, move.end.position].map((p) => toScreen(p)), PLOT.ink, 1);
  g.setLineDash([]);
  stroke(g, shown.idle.map((r) => toScreen(r.position)), IDLE, 2.8);
  [[move.start.position, "1", PATHS[0]], [move.end.position, "2", PATHS[1]]].forEach(([p, text, colour]) => {
    const [x, y] = toScreen(p);
    g.fillStyle = colour; g.fillRect(x - 5, y - 5, 10, 10); g.fillStyle = PLOT.text; g.fillText(text, x + 9, y - 9);
  });
  if (move.points[selected]) {
    const from = toScreen(move.points[selected]);
    arrowTips().forEach((tip, i) => drawArrow(g, from, tip, AXES[axes[i]]));
  }
  move.points.forEach((p, i) => {
    const [x, y] = toScreen(p);
    g.fillStyle = i === selected ? IDLE : PLOT.text; g.strokeStyle = "#10171f"; g.lineWidth = 2;
    g.beginPath(); g.arc(x, y, 7, 0, 7); g.fill(); g.stroke();
    g.fillStyle = "#10171f"; g.textAlign = "center"; g.fillText(i + 1, x, y + 4);
  });
}

const turn = { turn: -0.9, tilt: 0.55 };
function drawSpace() {
  const { g, w, h } = surface(byId("space"));
  const ct = Math.cos(turn.turn), st = Math.sin(turn.turn), ci = Math.cos(turn.tilt), si = Math.sin(turn.tilt);
  const flat = (p) => [p[0] * ct - p[1] * st, -(p[2] * ci + (p[0] * st + p[1] * ct) * si)];
  const near = [...shown.idle.map((r) => r.position), ...D.stretches.flat().map((r) => r.position)].map(flat);
  const box = [0, 1].map((k) => near.reduce(([a, b], p) => [Math.min(a, p[k]), Math.max(b, p[k])], [Infinity, -Infinity]));
  const scale = 0.8 * Math.min(w / (box[0][1] - box[0][0] || 1), h / (box[1][1] - box[1][0] || 1));
  const screen = (p) => { const f = flat(p); return [w / 2 + (f[0] - (box[0][0] + box[0][1]) / 2) * scale, h / 2 + (f[1] - (box[1][0] + box[1][1]) / 2) * scale]; };
  D.paths.forEach((path, i) => stroke(g, path.map(screen), PATHS[i], 2));
  stroke(g, shown.idle.map((r) => screen(r.position)), IDLE, 2.4);
  for (const p of move.points) { g.fillStyle = PLOT.text; g.beginPath(); g.arc(...screen(p), 3, 0, 7); g.fill(); }
  ["X", "Y", "Z"].forEach((name, a) => {
    const unit = [0, 0, 0]; unit[a] = 26;
    const f = flat(unit);
    stroke(g, [[34, h - 34], [34 + f[0], h - 34 + f[1]]], AXES[a], 2);
    g.fillStyle = AXES[a]; g.fillText(name, 32 + f[0] * 1.35, h - 30 + f[1] * 1.35);
  });
}

// Curves over path length: lines [{of(row), colour, width}]; jumps [text at path 1, at path 2].
function drawChart(id, lines, jumps) {
  const canvas = byId(id), { g, w, h } = surface(canvas), left = 52, right = 12, top = 16, bottom = 22;
  const parts = [shown.working[0], shown.idle, shown.working[1]], rows = parts.flat();
  let [low, high] = [0, 0];
  for (const row of rows) for (const line of lines) { const v = line.of(row); low = Math.min(low, v); high = Math.max(high, v); }
  const pad = (high - low || 1) * 0.1;
  high += pad; if (low < 0) low -= pad;
  const s0 = rows[0].s, s1 = rows[rows.length - 1].s, length = shown.path.length;
  const px = (s) => left + (s - s0) / (s1 - s0) * (w - left - right), py = (v) => h - bottom - (v - low) / (high - low) * (h - top - bottom);
  g.fillStyle = PLOT.ink; g.textAlign = "right";
  for (const v of ticks(low, high, 4)) { stroke(g, [[left, py(v)], [w - right, py(v)]], PLOT.grid, 1); g.fillText(number(v), left - 6, py(v) + 4); }
  g.textAlign = "center";
  for (const s of ticks(s0, s1, 8)) g.fillText(number(s), px(s), h - 6);
  g.fillStyle = "rgba(255,201,77,0.06)"; g.fillRect(px(0), top, px(length) - px(0), h - top - bottom);
  for (const line of lines) {
    parts.forEach((part, i) => {
      g.globalAlpha = i === 1 ? 1 : 0.65;
      stroke(g, part.map((r) => [px(r.s), py(line.of(r))]), line.colour, line.width || 1.6);
    });
    g.globalAlpha = 1;
  }
  g.setLineDash([4, 4]);
  for (const s of [0, length]) stroke(g, [[px(s), top], [px(s), h - bottom]], PLOT.ink, 1);
  g.setLineDash([]);
  [0, 1].forEach((side) => {
    const row = side ? shown.idle[shown.idle.length - 1] : shown.idle[0];
    const other = side ? shown.working[1][0] : shown.working[0][shown.working[0].length - 1];
    for (const line of lines) if (other && Math.abs(line.of(row) - line.of(other)) > 1e-7 * (high - low)) {
      stroke(g, [[px(row.s), py(line.of(row))], [px(row.s), py(line.of(other))]], PLOT.jump, 4);
    }
    if (!jumps) return;
    g.fillStyle = PLOT.jump; g.textAlign = side ? "right" : "left"; g.fillText(jumps[side], px(row.s) + (side ? -6 : 6), top - 4);
  });
}

const alongG = (r) => r.a / GRAVITY, acrossG = (r) => r.v * r.v * norm(r.curvature) / GRAVITY;
function drawCharts() {
  const text = (of, unit) => [of(shown.own.start), of(shown.own.end)].map((v) => v > 1e-9 ? "jump " + number(v) + unit : "");
  const perAxis = (of) => [0, 1, 2].map((a) => ({ of: (r) => of(r)[a], colour: AXES[a] }));
  drawChart("slope", perAxis((r) => r.tangent), text((j) => j.slope_rad * 180 / Math.PI, " degrees"));
  drawChart("second", perAxis((r) => r.curvature), text((j) => j.curvature, "/mm"));
  drawChart("curvature", [{ of: (r) => norm(r.curvature), colour: IDLE }], text((j) => j.curvature, "/mm"));
  drawChart("velocity", [{ of: (r) => r.v * 0.06, colour: IDLE }]);
  drawChart("acceleration", [{ of: acrossG, colour: AXES[1] }, { of: alongG, colour: AXES[2] },
    { of: (r) => Math.hypot(acrossG(r), alongG(r)), colour: IDLE, width: 2.2 }], text((j) => Math.hypot(j.across_g, j.along_g), " g"));
}

function tableRows(id, rows) {
  byId(id).replaceChildren(...rows.map(({ cells, kind }) => {
    const tr = document.createElement("tr");
    tr.className = kind || "";
    cells.forEach((text, i) => {
      const cell = document.createElement(kind === "head" ? "th" : "td");
      cell.textContent = text; if (i) cell.className = "n"; tr.append(cell);
    });
    return tr;
  }));
}
const degrees = (rad) => rad < 1e-7 ? "0" : number(rad * 180 / Math.PI);
const small = (v) => v < 1e-7 ? "0" : number(v);
function fillTables() {
  const { start, end } = shown.own;
  tableRows("joints", [{ kind: "head", cells: ["jump of", "path 1", "path 2"] },
    { cells: ["slope, degrees", degrees(start.slope_rad), degrees(end.slope_rad)] },
    { cells: ["curvature, 1/mm", small(start.curvature), small(end.curvature)] },
    { cells: ["acceleration across, g", small(start.across_g), small(end.across_g)] },
    { cells: ["acceleration along, g", small(start.along_g), small(end.along_g)] }]);
  const pair = (row, of) => of(row.start) + " | " + of(row.end);
  tableRows("others", [{ kind: "head", cells: ["move", "length, mm", "slope, degrees", "curvature, 1/mm", "across, g"] },
    ...shown.result.map((r) => ({ kind: r.move === move.fit ? "chosen" : "", cells: [r.move, number(r.length_mm),
      pair(r, (j) => degrees(j.slope_rad)), pair(r, (j) => small(j.curvature)), pair(r, (j) => small(j.across_g))] }))]);
  const corner = Math.max(start.slope_rad, end.slope_rad) > 1e-6, bend = Math.max(start.across_g, end.across_g) > 1e-6;
  byId("badge").textContent = corner ? "corners at the joints" : bend ? "curvature jumps" : "smooth";
  byId("badge").style.background = corner || bend ? "var(--bad)" : "var(--good)";
}
function fillPoints() {
  byId("points").replaceChildren(...move.points.map((point, i) => {
    const tr = document.createElement("tr"), name = document.createElement("td");
    name.textContent = i + 1; name.onclick = () => { selected = i; update(); };
    tr.append(name); tr.className = i === selected ? "on" : "";
    point.forEach((value, a) => {
      const input = document.createElement("input"), cell = document.createElement("td");
      input.value = +value.toFixed(6); input.id = `point${i + 1}${"xyz"[a]}`;
      input.onfocus = () => { if (selected !== i) { selected = i; drawPlane(); } };
      input.onchange = () => {
        const typed = Number(input.value);
        if (input.value.trim() !== "" && Number.isFinite(typed) && Math.abs(typed) <= 1e6) move.points[i][a] = typed;
        update();
      };
      cell.append(input); tr.append(cell);
    });
    return tr;
  }));
}
function say(text, good) { byId("message").textContent = text; byId("message").className = good ? "good" : ""; }

function update(keepPoints) {
  shown = compute();
  if (!view) showAll();
  drawPlane(); drawSpace(); drawCharts(); fillTables();
  if (!keepPoints) fillPoints();
  byId("fit").value = move.fit; byId("speed").value = move.speed; byId("form").value = move.gcode.form;
  byId("sizeLabel").style.visibility = move.gcode.form === "exact" ? "hidden" : "";
  if (document.activeElement !== byId("size")) byId("size").value = move.gcode.size_mm ?? "";
  byId("blocks").value = shown.blocks.length > 20000 ? shown.blocks.slice(0, 20000) + ".." : shown.blocks;
  const space = move.gcode.form === "exact" && !isPlane(shown.path.pieces);
  byId("count").textContent = shown.blocks.split("\n").length - 1 + " lines" + (space ? "; G5 with Z is curvecore's own" : "");
  say(shown.flaw);
}

const jsonText = () => JSON.stringify({ ...move, result: shown.result }, null, 2) + "\n";
const gcodeText = () => D.program.head + shown.blocks + D.program.tail;
function save(name, text) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
  link.download = name; link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
function load(text) {
  let file = null, flaw = "this is no JSON";
  try { file = JSON.parse(text); flaw = flawOf(file, D.join); } catch (error) { file = null; }
  if (flaw) return say("not loaded: " + flaw);
  move = { ...move, fit: file.fit, speed: file.speed, gcode: file.gcode, t: file.t, points: file.points };
  selected = 0; view = null; update(); say("loaded", true);
}

function hit(at) {
  const close = (p, reach) => Math.hypot(p[0] - at[0], p[1] - at[1]) <= reach;
  const tip = arrowTips().findIndex((p) => close(p, 12));
  if (tip >= 0) return { point: selected, only: axes[tip] };
  const point = move.points.findIndex((p) => close(toScreen(p), 12));
  return point >= 0 ? { point } : null;
}
const plane = byId("plane");
let drag = null;
plane.addEventListener("pointerdown", (e) => {
  plane.setPointerCapture(e.pointerId);
  drag = { ...(hit([e.offsetX, e.offsetY]) || {}), at: [e.offsetX, e.offsetY] };
  if (drag.point !== undefined) { selected = drag.point; update(); }
});
plane.addEventListener("pointermove", (e) => {
  if (!drag) return;
  const by = [(e.offsetX - drag.at[0]) / view.scale, -(e.offsetY - drag.at[1]) / view.scale];
  drag.at = [e.offsetX, e.offsetY];
  if (drag.point === undefined) { view.x -= by[0]; view.y -= by[1]; drawPlane(); return; }
  axes.forEach((a, i) => { if (drag.only === undefined || drag.only === a) move.points[drag.point][a] += by[i]; });
  update();
});
plane.addEventListener("pointerup", () => { drag = null; });
plane.addEventListener("dblclick", () => { showAll(); drawPlane(); });
plane.addEventListener("wheel", (e) => { e.preventDefault(); view.scale *= Math.exp(-e.deltaY * 0.001); drawPlane(); }, { passive: false });
const space = byId("space");
space.addEventListener("pointermove", (e) => {
  if (!e.buttons) return;
  turn.turn -= e.movementX * 0.008;
  turn.tilt = Math.min(Math.PI / 2, Math.max(-Math.PI / 2, turn.tilt + e.movementY * 0.008));
  drawSpace();
});

const options = (id, names) => byId(id).append(...names.map((name) => new Option(name, name)));
options("fit", FITS); options("speed", SPEED_LAWS);
byId("form").append(new Option("exact: G5, G5.2", "exact"), new Option("chords by tolerance", "tolerance"), new Option("chords by step", "step"));
byId("fit").onchange = (e) => { move.fit = e.target.value; update(); };
byId("speed").onchange = (e) => { move.speed = e.target.value; update(); };
byId("form").onchange = (e) => {
  move.gcode = e.target.value === "exact" ? { form: "exact" } : { form: e.target.value, size_mm: e.target.value === "step" ? 0.5 : 0.001 };
  update();
};
byId("size").onchange = (e) => {
  const typed = Number(e.target.value);
  if (typed >= 1e-6 && typed <= 1e4) move.gcode.size_mm = typed;
  e.target.blur(); update();
};
byId("add").onclick = () => {  // in the middle of what follows the selected point
  if (move.points.length >= 100) return;
  const i = Math.min(selected + 1, move.points.length), path = shown.path;
  move.points.splice(i, 0, bezierAt(path.pieces[i], 0.5).r);
  move.t.splice(i + 1, 0, (move.t[i] + move.t[i + 1]) / 2);
  selected = i; update();
};
byId("remove").onclick = () => {
  if (!move.points[selected]) return;
  move.points.splice(selected, 1); move.t.splice(selected + 1, 1);
  selected = Math.max(0, selected - 1); update();
};
for (const least of LEAST) {
  byId("least_" + least).onclick = () => {
    const points = leastPoints(move, least);
    if (points) { move.points = points; update(); } else say("too few control points to meet tangent and curvature");
  };
}
byId("space_out").onclick = () => {
  const all = [move.start.position, ...move.points, move.end.position];
  move.t = [0];
  for (let i = 1; i < all.length; ++i) move.t.push(move.t[i - 1] + norm(minus(all[i], all[i - 1])));
  update();
};
byId("reset").onclick = () => { move = copy(D.join); selected = 0; view = null; update(); };
byId("save").onclick = () => save("join.json", jsonText());
byId("export").onclick = () => save("join.ngc", gcodeText());
byId("load").onclick = () => byId("file").click();
byId("file").onchange = async (e) => { if (e.target.files[0]) load(await e.target.files[0].text()); e.target.value = ""; };
for (const button of byId("planes").querySelectorAll("button")) {
  button.onclick = () => {
    axes = [...button.dataset.axes].map((name) => "xyz".indexOf(name));
    for (const other of byId("planes").querySelectorAll("button")) other.className = other === button ? "on" : "";
    view = null; update();
  };
}
const base = (name) => name.split("/").pop();
document.title = base(move.a) + " to " + base(move.b) + " - curvecore join";
byId("title").textContent = base(move.a) + " \u2192 " + base(move.b);
byId("by").textContent = "curvecore " + D.version + " join";
// The plane in which the move is widest.
const spans = [0, 1, 2].map((a) => { const all = [move.start.position, ...move.points, move.end.position].map((p) => p[a]); return Math.max(...all) - Math.min(...all); });
const least = spans.lastIndexOf(Math.min(...spans));
byId("planes").querySelectorAll("button")[2 - least].click();
window.addEventListener("resize", () => update(true));
