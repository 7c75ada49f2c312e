// SPDX-License-Identifier: Apache-2.0
// Pictures of the demo: the path with chords beside it, and values over path length or time.
"use strict";

const colour = (name) => getComputedStyle(document.getElementById("demo"))
  .getPropertyValue(name).trim();
const number = (v) => v === 0 ? "0" : String(+v.toPrecision(3));

/// A canvas made as sharp as the screen is.
function surface(canvas) {
  const scale = window.devicePixelRatio || 1, w = canvas.clientWidth, h = canvas.clientHeight;
  canvas.width = Math.round(w * scale);
  canvas.height = Math.round(h * scale);
  const g = canvas.getContext("2d");
  g.scale(scale, scale);
  g.font = "11px system-ui, sans-serif";
  return { g, w, h };
}

/// Round numbers from low to high, some five of them.
function steps(low, high) {
  const rough = (high - low) / 5, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].find((n) => n * power >= rough) * power, found = [];
  for (let n = Math.ceil(low / step); n * step <= high; ++n) found.push(n * step);
  return found;
}

/// Where the path is looked at: axes to the right and up, a centre in mm, and pixels a mm; scale 0:
/// the whole part.
const HOME = { axes: [0, 1], x: 0, y: 0, scale: 0 };
const view = { ...HOME };

function boxOf(data) {
  const span = (values) => values.reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)],
                                         [Infinity, -Infinity]);
  const [right, up] = view.axes.map((axis) => data["xyz"[axis]]);
  return { x: span(right), y: span(up) };
}

function homeOf(data, w, h) {
  const box = boxOf(data), room = (a) => box[a][1] - box[a][0] || 1e-3;
  return { x: (box.x[0] + box.x[1]) / 2, y: (box.y[0] + box.y[1]) / 2,
           scale: 0.9 * Math.min(w / room("x"), h / room("y")) };
}

function drawGrid(g, w, h, at) {
  g.strokeStyle = colour("--line");
  g.fillStyle = colour("--soft");
  for (const x of steps(at.x - w / 2 / at.scale, at.x + w / 2 / at.scale)) {
    const px = w / 2 + (x - at.x) * at.scale;
    g.beginPath(); g.moveTo(px, 0); g.lineTo(px, h); g.stroke();
    if (at.scale < 5e3) g.fillText(number(x), px + 3, h - 5);
  }
  for (const y of steps(at.y - h / 2 / at.scale, at.y + h / 2 / at.scale)) {
    const py = h / 2 - (y - at.y) * at.scale;
    g.beginPath(); g.moveTo(0, py); g.lineTo(w, py); g.stroke();
    if (at.scale < 5e3) g.fillText(number(y), 4, py - 3);
  }
}

function drawLine(g, count, point) {
  g.beginPath();
  for (let n = 0; n < count; ++n) g.lineTo(...point(n));
  g.stroke();
}

/// Draws path and chords; returns how long a bar of some 80 px is, mm.
function drawPath(canvas, data) {
  const { g, w, h } = surface(canvas);
  if (view.scale === 0) Object.assign(view, homeOf(data, w, h));
  drawGrid(g, w, h, view);
  const place = (x, y) => [w / 2 + (x - view.x) * view.scale, h / 2 - (y - view.y) * view.scale];
  const corners = data.traffic.corners, [right, up] = view.axes;
  const across = data["xyz"[right]], upward = data["xyz"[up]], beside = data.traffic.beside || [];
  g.lineWidth = 1.8;
  g.lineJoin = "round";
  g.strokeStyle = colour("--path");
  drawLine(g, data.x.length, (n) => place(across[n], upward[n]));
  const near = view.scale > 3 * homeOf(data, w, h).scale;
  if (near) {
    g.lineWidth = 1.4;
    g.strokeStyle = g.fillStyle = colour("--chord");
    drawLine(g, corners.length, (n) => place(corners[n][right], corners[n][up]));
    for (const corner of corners) {
      const [px, py] = place(corner[right], corner[up]);
      if (px > -5 && px < w + 5 && py > -5 && py < h + 5) g.fillRect(px - 2.5, py - 2.5, 5, 5);
    }
  }
  g.strokeStyle = colour("--path");  // the path's own points are too far apart where a chord is near
  g.lineWidth = 1.8;
  if (near) drawLine(g, beside.length, (n) => place(beside[n][right], beside[n][up]));
  const bar = steps(0, 120 / view.scale).filter((v) => v * view.scale < 120).pop() || 0;
  g.strokeStyle = g.fillStyle = colour("--ink");
  g.lineWidth = 2;
  g.beginPath(); g.moveTo(w - 14 - bar * view.scale, 14); g.lineTo(w - 14, 14); g.stroke();
  g.textAlign = "right";
  g.fillText(bar < 0.1 ? number(bar * 1e3) + " um" : number(bar) + " mm", w - 14, 30);
  return near;
}

/// Values in bins: a number or [low, high] each; `limits` are lines or bins of their own.
function drawChart(canvas, { bins, limits, width, unit, what }) {
  const { g, w, h } = surface(canvas), left = 52, right = 10, top = 10, bottom = 24;
  const low = (bin) => bin.length ? bin[0] : 0, high = (bin) => bin.length ? bin[1] : bin;
  let least = 0, most = 0;
  for (const bin of bins) {
    if (bin === null) continue;
    least = Math.min(least, low(bin));
    most = Math.max(most, high(bin));
  }
  const greatest = limits.reduce((a, v) => Math.max(a, v), 0), reached = most;
  const shown = greatest > 0 && greatest < 4 * most;  // a limit far above is named, not drawn
  if (shown) most = Math.max(most, greatest);
  most += (most - least) * 0.08 || 1;
  const px = (part) => left + part * (w - left - right);
  const py = (v) => h - bottom - (v - least) / (most - least) * (h - top - bottom);
  g.strokeStyle = colour("--line");
  g.fillStyle = colour("--soft");
  g.textAlign = "right";
  for (const v of steps(least, most)) {
    g.beginPath(); g.moveTo(left, py(v)); g.lineTo(w - right, py(v)); g.stroke();
    g.fillText(number(v), left - 6, py(v) + 4);
  }
  g.textAlign = "center";
  for (const v of steps(0, width * 0.9)) g.fillText(number(v), px(v / width), h - 8);
  g.textAlign = "right";
  g.fillText(unit, w - right, h - 8);
  g.fillStyle = colour("--path");
  const step = (w - left - right) / bins.length;
  bins.forEach((bin, n) => {
    if (bin === null) return;
    const y = py(high(bin));
    g.fillRect(left + n * step, y - 0.7, step + 0.6, py(low(bin)) - y + 1.4);
  });
  g.strokeStyle = g.fillStyle = colour("--bound");
  g.setLineDash([5, 4]);
  g.lineWidth = 1.4;
  if (shown) {
    g.beginPath();
    limits.forEach((v, n) => {
      g.lineTo(px(n / limits.length), py(v));
      g.lineTo(px((n + 1) / limits.length), py(v));
    });
    g.stroke();
  } else if (greatest > 0) {
    g.textAlign = "left";
    g.fillText("limit " + number(greatest) + ", above this scale", left + 8, top + 10);
  }
  const against = greatest > 0 ? `, limit ${number(greatest)}` : "";
  canvas.setAttribute("aria-label", `${what}: at most ${number(reached)}${against}`);
}
