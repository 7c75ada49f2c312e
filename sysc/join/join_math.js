// The idle move's mathematics, as in ref/join and ref/curve/fit of the sources; a test holds both to
// the same numbers. Vectors are arrays [x, y, z]; mm, s, rad.
const GRAVITY = 9806.65;
const FITS = ["cubic", "moments", "c2", "quintic"];
const SPEED_LAWS = ["smooth", "even"];
const GCODE_FORMS = ["exact", "tolerance", "step"];
const JOIN_VERSION = 1;

const combine = (f) => (a, b) => [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2])];
const plus = combine((a, b) => a + b), minus = combine((a, b) => a - b);
const times = (k, a) => [k * a[0], k * a[1], k * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.sqrt(dot(a, a));
const angleBetween = (a, b) => Math.atan2(norm(cross(a, b)), dot(a, b));

// Slopes by the parabola through three neighbours ([Petrakov] (1)).
function besselSlopes(y, t) {
  const n = y.length - 1, d = [], s = [];
  for (let i = 0; i < n; ++i) { d.push(t[i + 1] - t[i]); s.push(times(1 / d[i], minus(y[i + 1], y[i]))); }
  if (n === 1) return [s[0], s[0]];
  const end = (near, far, a, b) => times(1 / (near + far), minus(times(2 * near + far, a), times(near, b)));
  const m = [end(d[0], d[1], s[0], s[1])];
  for (let i = 1; i < n; ++i) m.push(times(1 / (d[i - 1] + d[i]), plus(times(d[i], s[i - 1]), times(d[i - 1], s[i]))));
  m.push(end(d[n - 1], d[n - 2], s[n - 1], s[n - 2]));
  return m;
}

// Slopes of the C2 spline with the given slopes at both ends.
function smoothSlopes(y, t, first, last) {
  const n = y.length - 1, above = [0], m = [first];
  for (let i = 1; i < n; ++i) {
    const d0 = t[i] - t[i - 1], d1 = t[i + 1] - t[i];
    const right = times(3, plus(times(d1 / d0, minus(y[i], y[i - 1])), times(d0 / d1, minus(y[i + 1], y[i]))));
    const diagonal = 2 * (d0 + d1) - d1 * above[i - 1];
    above.push(d0 / diagonal);
    m.push(times(1 / diagonal, minus(right, times(d1, m[i - 1]))));
  }
  m.push(last);
  for (let i = n - 1; i > 0; --i) m[i] = minus(m[i], times(above[i], m[i + 1]));
  return m;
}

// Bernstein's form over h of t: [Petrakov] (2); (3)-(5) with the divided difference; the quintic.
function pieceOf(fit, h, y0, y1, m0, m1, second0, second1) {
  const chord = minus(y1, y0);
  if (fit === "quintic") {
    const out = times(h / 5, m0), into = times(h / 5, m1);
    return { h, points: [y0, plus(y0, out), plus(plus(y0, times(2, out)), times(h * h / 20, second0)),
                         plus(minus(y1, times(2, into)), times(h * h / 20, second1)), minus(y1, into), y1] };
  }
  let out = times(h, m0), into = times(h, m1);
  if (fit === "moments") {
    const a = times(h * h / 6, second0), b = times(h * h / 6, second1);
    out = minus(chord, plus(times(2, a), b));
    into = plus(chord, plus(a, times(2, b)));
  }
  return { h, points: [y0, plus(y0, times(1 / 3, out)), minus(y1, times(1 / 3, into)), y1] };
}

// Slopes m and second derivatives of the quintic spline whose third and fourth derivatives go on at
// every inner point; those of the ends are given. ref/join/quintic_slopes.cpp has the equations.
function quinticSlopes(y, t, m, second) {
  const size = 2 * y.length, z = y.flatMap((_, i) => [m[i], second[i]]);
  const a = z.map(() => new Float64Array(size)), right = z.map(() => [0, 0, 0]);
  for (let i = 0; i + 1 < y.length; ++i) {
    const h = t[i + 1] - t[i], chord = minus(y[i + 1], y[i]);
    const part = [[192 / h, 36, 168 / h, -24], [36, 9 * h, 24, -3 * h], [168 / h, 24, 192 / h, -36], [-24, -3 * h, -36, 9 * h]];
    part.forEach((row, r) => row.forEach((v, c) => { a[2 * i + r][2 * i + c] += v / (h * h); }));
    [360 / h, 60, 360 / h, -60].forEach((v, r) => { right[2 * i + r] = plus(right[2 * i + r], times(v / (h * h * h), chord)); });
  }
  const end = size - 2, behind = (k) => Math.min(k + 4, end);  // rows and columns 2 .. end - 1, three beside the diagonal
  for (let k = 2; k < end; ++k) {
    for (const j of [0, 1, end, end + 1]) right[k] = minus(right[k], times(a[k][j], z[j]));
  }
  for (let k = 2; k < end; ++k) {
    for (let i = k + 1; i < behind(k); ++i) {
      const share = a[i][k] / a[k][k];
      for (let j = k; j < behind(k); ++j) a[i][j] -= share * a[k][j];
      right[i] = minus(right[i], times(share, right[k]));
    }
  }
  for (let k = end - 1; k > 1; --k) {
    let sum = right[k];
    for (let j = k + 1; j < behind(k); ++j) sum = minus(sum, times(a[k][j], z[j]));
    z[k] = times(1 / a[k][k], sum);
  }
  return [z.filter((_, k) => k % 2 === 0), z.filter((_, k) => k % 2 === 1)];
}

function piecesOf(move) {
  const y = [move.start.position, ...move.points, move.end.position], t = move.t;
  let m;
  if (move.fit === "c2") m = smoothSlopes(y, t, move.start.tangent, move.end.tangent);
  else {
    m = besselSlopes(y, t);
    m[0] = move.start.tangent; m[m.length - 1] = move.end.tangent;
  }
  let second = besselSlopes(m, t);
  second[0] = move.start.curvature; second[second.length - 1] = move.end.curvature;
  if (move.fit === "quintic") [m, second] = quinticSlopes(y, t, m, second);
  return y.slice(1).map((_, i) =>
    pieceOf(move.fit, t[i + 1] - t[i], y[i], y[i + 1], m[i], m[i + 1], second[i], second[i + 1]));
}

// Position and derivatives by t at 0 <= u <= 1, by de Casteljau.
function bezierAt(piece, u) {
  let level = piece.points;
  const n = level.length - 1, h = piece.h, point = {};
  const reduce = (to) => {
    while (level.length > to) level = level.slice(1).map((p, i) => plus(times(1 - u, level[i]), times(u, p)));
  };
  reduce(3); point.d2 = times(n * (n - 1) / (h * h), plus(minus(level[2], times(2, level[1])), level[0]));
  reduce(2); point.d1 = times(n / h, minus(level[1], level[0]));
  reduce(1); point.r = level[0];
  return point;
}

const GAUSS = [[0, 0.5688888888888889], [0.5384693101056831, 0.47862867049936647], [-0.5384693101056831, 0.47862867049936647],
               [0.906179845938664, 0.23692688505618908], [-0.906179845938664, 0.23692688505618908]];
const PARTS = 32;

class PathTable {
  constructor(pieces) {
    this.pieces = pieces;
    this.knots = [0];
    for (let i = 0; i < pieces.length; ++i) {
      for (let k = 0; k < PARTS; ++k) this.knots.push(this.knots[this.knots.length - 1] + this.part(i, k / PARTS, (k + 1) / PARTS));
    }
  }
  get length() { return this.knots[this.knots.length - 1]; }
  starts() { return this.knots.filter((_, i) => i % PARTS === 0); }
  part(piece, from, to) {
    const bezier = this.pieces[piece], middle = (from + to) / 2, half = (to - from) / 2;
    return half * GAUSS.reduce((sum, [x, w]) => sum + w * bezier.h * norm(bezierAt(bezier, middle + half * x).d1), 0);
  }
  // Path length at a place.
  path(piece, u) {
    const k = Math.min(Math.floor(u * PARTS), PARTS - 1);
    return this.knots[piece * PARTS + k] + this.part(piece, k / PARTS, u);
  }
  place(s) {
    let knot = 0;
    while (knot + 2 < this.knots.length && this.knots[knot + 1] <= s) ++knot;
    const piece = Math.floor(knot / PARTS), low = knot % PARTS / PARTS;
    const wanted = s - this.knots[knot], whole = this.knots[knot + 1] - this.knots[knot];
    const clamp = (v, a, b) => Math.min(Math.max(v, a), b);
    let u = low + clamp(whole > 0 ? wanted / whole : 0, 0, 1) / PARTS;
    for (let i = 0; i < 20; ++i) {
      const speed = this.pieces[piece].h * norm(bezierAt(this.pieces[piece], u).d1);
      if (!(speed > 0)) break;
      const next = clamp(u + (wanted - this.part(piece, low, u)) / speed, low, low + 1 / PARTS);
      if (Math.abs(next - u) < 1e-13) break;
      u = next;
    }
    return [piece, u];
  }
  at(piece, u) {
    const { r, d1, d2 } = bezierAt(this.pieces[piece], u), square = dot(d1, d1);
    const joint = { position: r, tangent: [0, 0, 0], curvature: [0, 0, 0] };
    if (square > 0) {
      joint.tangent = times(1 / Math.sqrt(square), d1);
      joint.curvature = times(1 / (square * square), cross(cross(d1, d2), d1));
    }
    return joint;
  }
}

// Speed along the move and its rate dv/dt.
function speedCourse(law, v0, v1, length) {
  const even = law === "even";
  const speed = (s) => {
    const x = s / length;
    return even ? Math.sqrt(v0 * v0 + (v1 * v1 - v0 * v0) * x) : v0 + (v1 - v0) * x * x * x * (10 + x * (6 * x - 15));
  };
  const acceleration = (s) => {
    const x = s / length;
    return even ? (v1 * v1 - v0 * v0) / (2 * length) : speed(s) * (v1 - v0) * 30 * x * x * (1 - x) * (1 - x) / length;
  };
  return { speed, acceleration };
}

const aboveRounding = (v) => v < 1e-9 ? 0 : v;
function jump(working, idle, acceleration) {
  const curvature = aboveRounding(norm(minus(idle.curvature, working.curvature)));
  return { slope_rad: aboveRounding(angleBetween(working.tangent, idle.tangent)), curvature,
           across_g: working.feed * working.feed * curvature / GRAVITY, along_g: Math.abs(acceleration) / GRAVITY };
}

function jumpsOf(name, move, length, first, last) {
  const course = speedCourse(move.speed, move.start.feed, move.end.feed, length);
  return { move: name, length_mm: length, start: jump(move.start, first, course.acceleration(0)),
           end: jump(move.end, last, course.acceleration(length)) };
}

// A straight line, the arc that leaves along the first tangent, every fit through the same points.
function compareJoins(move) {
  const chord = minus(move.end.position, move.start.position), length = norm(chord), along = times(1 / length, chord);
  const mirrored = (v) => minus(v, times(2 * dot(along, v), along));
  const line = { tangent: along, curvature: [0, 0, 0] }, tangent = move.start.tangent;
  const first = { tangent, curvature: times(2 / dot(chord, chord), minus(chord, times(dot(tangent, chord), tangent))) };
  const last = { tangent: times(-1, mirrored(tangent)), curvature: mirrored(first.curvature) };
  const angle = angleBetween(tangent, along), arc = Math.sin(angle) > 1e-9 ? length * angle / Math.sin(angle) : length;
  return [jumpsOf("line", move, length, line, line), jumpsOf("arc", move, arc, first, last),
          ...FITS.map((fit) => {
            const path = new PathTable(piecesOf({ ...move, fit }));
            return jumpsOf(fit, move, path.length, path.at(0, 0), path.at(path.pieces.length - 1, 1));
          })];
}

// What shall be small: second or third derivatives at Gauss's four points, a row of three axes each.
const LEAST = ["curvature", "jerk"];
const GAUSS_4 = [[0.3399810435848563, 0.6521451548625461], [0.8611363115940526, 0.34785484513745385]];
function bends(pieces, least) {
  return pieces.flatMap((piece) => {
    const n = piece.points.length - 1;
    const difference = { h: piece.h, points: piece.points.slice(1).map((p, i) => times(n / piece.h, minus(p, piece.points[i]))) };
    return GAUSS_4.flatMap(([x, w]) => [x, -x].map((at) => {
      const u = (1 + at) / 2;
      return times(Math.sqrt(w * piece.h / 2), bezierAt(least === "curvature" ? piece : difference, u).d2);
    }));
  });
}

// What must be zero: slope and second derivative at both ends, off the joints'.
function misses(move, pieces) {
  const first = bezierAt(pieces[0], 0), last = bezierAt(pieces[pieces.length - 1], 1);
  return [minus(first.d1, move.start.tangent), minus(first.d2, move.start.curvature),
          minus(last.d1, move.end.tangent), minus(last.d2, move.end.curvature)];
}

// Solves rows of [coefficients.., right sides..] by elimination with full pivots; what is free is 0.
function solve(rows, unknowns) {
  const order = [], left = rows.map((row) => [...row]), done = [];
  for (let k = 0; k < unknowns; ++k) {
    let best = 0, at = null;
    left.forEach((row, i) => {
      for (let j = 0; j < unknowns; ++j) if (!order.includes(j) && Math.abs(row[j]) > best) { best = Math.abs(row[j]); at = [i, j]; }
    });
    if (best < 1e-12) break;
    const [row] = left.splice(at[0], 1), pivot = row[at[1]];
    for (const other of [...left, ...done]) {
      const share = other[at[1]] / pivot;
      row.forEach((v, j) => { other[j] -= share * v; });
    }
    order.push(at[1]); done.push(row);
  }
  const found = Array.from({ length: unknowns }, () => [0, 0, 0]);
  order.forEach((j, k) => { found[j] = done[k].slice(unknowns).map((v) => v / done[k][j]); });
  return found;
}

// The control points of ref/join/least.hpp, by Lagrange's multipliers; null: too few of them.
function leastPoints(move, least) {
  const pieces = piecesOf(move), bend = bends(pieces, least), miss = misses(move, pieces), n = move.points.length;
  const by = move.points.map((_, i) => {
    const points = move.points.map((p, k) => k === i ? [p[0] + 1, p[1], p[2]] : p), other = piecesOf({ ...move, points });
    return { bend: bends(other, least).map((row, k) => row[0] - bend[k][0]),
             miss: misses(move, other).map((row, k) => row[0] - miss[k][0]) };
  });
  // Conditions that some point has a hold on, made orthogonal.
  const conditions = [];
  miss.forEach((row, k) => {
    let a = by.map((b) => b.miss[k]), right = times(-1, row);
    const size = Math.hypot(...a);
    for (const c of conditions) {
      const share = c.a.reduce((sum, v, i) => sum + v * a[i], 0);
      a = a.map((v, i) => v - share * c.a[i]); right = minus(right, times(share, c.right));
    }
    const length = Math.hypot(...a);
    if (length > 1e-9 * Math.max(1, size)) conditions.push({ a: a.map((v) => v / length), right: times(1 / length, right) });
  });
  const rows = by.map((b, i) => [...by.map((c) => b.bend.reduce((sum, v, k) => sum + v * c.bend[k], 0)),
    ...conditions.map((c) => c.a[i]), ...[0, 1, 2].map((axis) => -b.bend.reduce((sum, v, k) => sum + v * bend[k][axis], 0))]);
  for (const c of conditions) rows.push([...c.a, ...conditions.map(() => 0), ...c.right]);
  const change = solve(rows, n + conditions.length);
  const points = move.points.map((p, i) => plus(p, change[i])), met = { ...move, points };
  return misses(met, piecesOf(met)).every((row) => norm(row) < 1e-5) ? points : null;
}

// G-code: words with up to nine decimals.
function word(letter, value) {
  const text = value.toFixed(9).replace(/\.?0+$/, "");
  return " " + letter + (text === "-0" ? "0" : text);
}
const feedWord = (feed) => word("F", feed * 60);
const pointWords = (p, withZ) => word("X", p[0]) + word("Y", p[1]) + (withZ ? word("Z", p[2]) : "");
const isPlane = (pieces) => pieces.every((piece) => piece.points.every((p) => Math.abs(p[2] - pieces[0].points[0][2]) <= 1e-9));

function exactBlocks(path, course) {
  const space = !isPlane(path.pieces), starts = path.starts();
  return path.pieces.map(({ points }, i) => {
    const feed = feedWord(course.speed((starts[i] + starts[i + 1]) / 2));
    if (points.length === 4) {
      const out = minus(points[1], points[0]), into = minus(points[2], points[3]);
      return "G5" + pointWords(points[3], space) + word("I", out[0]) + word("J", out[1]) + (space ? word("K", out[2]) : "") +
        word("P", into[0]) + word("Q", into[1]) + (space ? word("R", into[2]) : "") + feed + "\n";
    }
    return "G5.2" + pointWords(points[1], space) + " L" + points.length + feed + "\n" +
      points.slice(2).map((p) => pointWords(p, space).slice(1) + "\n").join("") + "G5.3\n";
  }).join("");
}

// Even chords of a piece that are nowhere farther than the tolerance from it: h^2 max |r''| / 8.
function chordsFor({ points }, tolerance) {
  const n = points.length - 1;
  let widest = 0;
  for (let i = 0; i + 2 < points.length; ++i) widest = Math.max(widest, norm(plus(minus(points[i + 2], times(2, points[i + 1])), points[i])));
  return Math.max(1, Math.ceil(Math.sqrt(n * (n - 1) * widest / (8 * tolerance))));
}

const chord = (to, feed) => "G1" + pointWords(to, true) + feedWord(feed) + "\n";
const MOST_CHORDS = 1e6;

function chordBlocks(path, course, gcode) {
  const blocks = [], end = path.pieces[path.pieces.length - 1].points.slice(-1)[0];
  if (gcode.form === "step") {
    const count = Math.max(1, Math.ceil(path.length / gcode.size_mm - 1e-9));
    if (count > MOST_CHORDS) throw new Error("more than " + MOST_CHORDS + " chords");
    for (let k = 1; k <= count; ++k) {
      const to = k === count ? end : path.at(...path.place(path.length * k / count)).position;
      blocks.push(chord(to, course.speed(path.length * (k - 0.5) / count)));
    }
    return blocks.join("");
  }
  const starts = path.starts(), counts = path.pieces.map((piece) => chordsFor(piece, gcode.size_mm));
  if (counts.reduce((a, b) => a + b) > MOST_CHORDS) throw new Error("more than " + MOST_CHORDS + " chords");
  path.pieces.forEach((piece, i) => {
    let from = piece.points[0], s = starts[i];
    for (let k = 1; k <= counts[i]; ++k) {
      const to = k === counts[i] ? piece.points[piece.points.length - 1] : bezierAt(piece, k / counts[i]).r;
      const length = norm(minus(to, from));
      blocks.push(chord(to, course.speed(Math.min(s + length / 2, path.length))));
      s += length; from = to;
    }
  });
  return blocks.join("");
}

function idleGcode(move) {
  const path = new PathTable(piecesOf(move)), course = speedCourse(move.speed, move.start.feed, move.end.feed, path.length);
  return move.gcode.form === "exact" ? exactBlocks(path, course) : chordBlocks(path, course, move.gcode);
}

// What is wrong with a loaded file; empty: nothing.
function flawOf(file, here) {
  const numbers = (a, n) => Array.isArray(a) && a.length === n && a.every(Number.isFinite);
  if (file === null || typeof file !== "object" || !("curvecore_join" in file)) return "this is no file of curvecore join";
  if (file.curvecore_join !== JOIN_VERSION) return `version ${file.curvecore_join}: this page reads version ${JOIN_VERSION}`;
  for (const [side, name] of [["start", "start"], ["end", "end"]]) {
    const joint = file[side];
    if (!joint || !numbers(joint.position, 3) || !numbers(joint.tangent, 3)) return `the ${name} is missing`;
    if (norm(minus(joint.position, here[side].position)) > 1e-6 || norm(minus(joint.tangent, here[side].tangent)) > 1e-6) {
      return `it was made for another ${name}`;
    }
  }
  if (!FITS.includes(file.fit) || !SPEED_LAWS.includes(file.speed)) return "its fit or its speed is unknown";
  if (!file.gcode || !GCODE_FORMS.includes(file.gcode.form)) return "its G-code is unknown";
  if (file.gcode.form !== "exact" && !(file.gcode.size_mm >= 1e-6)) return "its G-code has no size";
  if (!Array.isArray(file.points) || file.points.length > 100 || !file.points.every((p) => numbers(p, 3))) return "its points are no points";
  return flawOfPoints(file);
}

function flawOfPoints(move) {
  const all = [move.start.position, ...move.points, move.end.position];
  const name = (i) => i === 0 ? "the start" : i + 1 < all.length ? "control point " + i : "the end";
  if (!Array.isArray(move.t) || move.t.length !== all.length || move.t[0] !== 0) return "t does not fit its points";
  for (let i = 1; i < all.length; ++i) {
    if (!(move.t[i] - move.t[i - 1] >= 1e-6)) return "t does not ascend";
    if (norm(minus(all[i], all[i - 1])) < 1e-9) return `${name(i - 1)} and ${name(i)} coincide`;
  }
  return "";
}
