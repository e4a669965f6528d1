"use strict";
let records, ways, columns, scrambles;  // what read() makes of the data
const of = lab => records.filter(record => record.lab === lab);
const at = id => document.getElementById(id);
const maker = space => (tag, attributes = {}, ...children) => {
  const made = document.createElementNS(space, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
};
const html = maker("http://www.w3.org/1999/xhtml"), svg = maker("http://www.w3.org/2000/svg");
const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const short = value => Number(value.toPrecision(3)).toString();
const sum = values => values.reduce((a, b) => a + b, 0);
const mean = values => sum(values) / values.length;
const median = values => values.toSorted((a, b) => a - b)[values.length >> 1];
const range = n => Array.from({ length: n }, (_, i) => i);
const powers = (factor, most) => range(40).map(i => factor ** i).filter(n => n <= most);

// The points: [x, y] of set k at N = sizes[step].

/** Numbers in [0, 1), each `characters` of 6 bits from "?" on. */
function decoded(text, characters) {
  const values = new Float64Array(text.length / characters);
  for (let i = 0, c = 0; i < values.length; i++) {
    let code = 0;
    for (let k = 0; k < characters; k++, c++) {
      const one = text.charCodeAt(c);
      code = code * 64 + (one === 33 ? 92 : one) - 63;
    }
    values[i] = (code + .5) / 64 ** characters;
  }
  return values;
}
/** Which of `count` equal parts of [0, 1) x is in; x was rounded, and may lie on an edge. */
const part = (x, count) => Math.min(count - 1, Math.floor(x * count + 1e-6));

const sizes = powers(4, 1024);
const first = (set, n) => set.map(column => column.subarray(0, n));
const sequence = (name, x, y) => ({ name, sets: scrambles, known: sizes.length,
  set: (step, k) => first([columns[x][k + 1], columns[y][k + 1]], sizes[step]) });
const has = (...names) => names.every(name => columns[name]);
function read(all) {
  records = all;
  ways = records.filter(record => record.points).map(({ name, sets, sequence, points }) => {
    const all = points.map(text => {
      const both = decoded(text, 3), n = both.length / 2;
      return [both.subarray(0, n), both.subarray(n)];
    });
    return { name, sets, known: points.length / (sequence ? sets / sizes.length : sets),
      set: (step, k) => sequence ? first(all[k], sizes[step]) : all[step * sets + k] };
  });
  columns = Object.fromEntries(of(5).filter(record => record.columns).map(
    ({ name, columns }) => [name, columns.map(text => decoded(text, 5))]));
  scrambles = Math.max(0, ...Object.values(columns).map(one => one.length - 1));
  if (has("base 2", "base 3")) ways.push(sequence("Halton", "base 2", "base 3"));
  if (has("base 2", "Sobol' 1")) ways.push(sequence("Sobol'", "base 2", "Sobol' 1"));
  spectra.clear();
}

// Integrands of the plane, and their means.

const wave = k => [Math.sin(k) / k, (1 - Math.cos(k)) / k];  // the mean of exp(ikx)
/** 1 below a line through (0.5, 0.4). */
function edge(degrees) {
  const a = degrees * Math.PI / 180, c = Math.max(Math.cos(a), 1e-3), s = Math.max(Math.sin(a), 1e-3);
  const d = .5 * c + .4 * s, square = x => Math.max(x, 0) ** 2;
  return { name: "edge: 1 below a line", g: (x, y) => x * c + y * s < d ? 1 : 0,
    exact: (square(d) - square(d - c) - square(d - s) + square(d - c - s)) / (2 * c * s) };
}
const integrands = { edge,
  smooth: () => ({ name: "smooth: exp(x + y)", g: (x, y) => Math.exp(x + y), exact: (Math.E - 1) ** 2 }),
  wave: () => ({ name: "wave: 1 + cos(40x + 23y)", g: (x, y) => 1 + Math.cos(40 * x + 23 * y),
    exact: 1 + wave(40)[0] * wave(23)[0] - wave(40)[1] * wave(23)[1] }) };
const estimate = ([x, y], { g }) => mean(Array.from(x, (_, i) => g(x[i], y[i])));
const rms = errors => Math.sqrt(mean(errors.map(error => error * error)));
const rmse = (way, step, f) =>
  rms(range(way.sets).map(k => estimate(way.set(step, k), f) - f.exact));
const curveOf = (way, f, chosen) => ({ name: way.name, chosen,
  points: range(way.known).map(step => [sizes[step], rmse(way, step, f)]) });

/** |Σ exp(-2πi k·x)|²/N for the frequencies -most … most, row by row. */
function periodogram([x, y], most) {
  const width = 2 * most + 1, power = new Float64Array(width * width);
  const re = new Float64Array(width * (most + 1)), im = re.slice();
  for (let i = 0; i < x.length; i++) {
    for (let row = 0, to = 0; row <= most; row++) {
      const step = 2 * Math.PI * x[i], start = 2 * Math.PI * row * y[i] - most * step;
      let c = Math.cos(start), s = Math.sin(start);
      const dc = Math.cos(step), ds = Math.sin(step);
      for (let column = 0; column < width; column++, to++) {
        re[to] += c;
        im[to] += s;
        [c, s] = [c * dc - s * ds, c * ds + s * dc];
      }
    }
  }
  re.forEach((c, i) => {  // the power at -k is that at k
    power[most * width + i] = power[most * width + width - 1 - i] = (c * c + im[i] ** 2) / x.length;
  });
  return power;
}
const spectra = new Map();
function spectrum(way, step, sets, most) {
  const key = [way.name, step, sets].join();
  if (!spectra.has(key)) {
    const all = range(sets).map(k => periodogram(way.set(step, k), most));
    spectra.set(key, all[0].map((_, i) => mean(all.map(one => one[i]))));
  }
  return spectra.get(key);
}
/** Means over rings round(|k|) = 1 … most. */
function rings(power, most) {
  const sums = range(most + 1).map(() => [0, 0]), width = 2 * most + 1;
  power.forEach((p, i) => {
    const ring = Math.round(Math.hypot(i % width - most, Math.floor(i / width) - most));
    if (ring <= most) { sums[ring][0] += p; sums[ring][1]++; }
  });
  return sums.slice(1).map(([total, count]) => total / count);
}

// Drawing.

const rgb = name => css(name).match(/\w\w/g).map(two => parseInt(two, 16));
/** Fills a canvas with width × height pixels, whose colors are lists of three. */
function paint(canvas, width, height, color) {
  const image = new ImageData(width, height);
  for (let i = 0; i < width * height; i++) {
    image.data.set([...color(i % width, Math.floor(i / width)), 255], 4 * i);
  }
  const small = new OffscreenCanvas(width, height);
  small.getContext("2d").putImageData(image, 0, 0);
  const scale = Math.max(1, Math.round(canvas.clientWidth * devicePixelRatio / width));
  canvas.width = width * scale;
  canvas.height = height * scale;
  const pen = canvas.getContext("2d");
  pen.imageSmoothingEnabled = false;
  pen.drawImage(small, 0, 0, canvas.width, canvas.height);
  return pen;
}
const mix = (from, to, share) => from.map((c, i) => c + (to[i] - c) * share);

/** Points over the integrand; nx × ny cells, of which `marked(column, row)` are filled. */
function drawPoints(canvas, [x, y], f, nx, ny, marked) {
  const shades = range(96 * 96).map(i => f.g((i % 96 + .5) / 96, 1 - (Math.floor(i / 96) + .5) / 96));
  const low = Math.min(...shades), high = Math.max(...shades);
  const pen = paint(canvas, 96, 96, (column, row) => Array(3).fill(+css("--low") +
    (css("--high") - css("--low")) * (shades[row * 96 + column] - low) / (high - low || 1)));
  const side = canvas.width;
  pen.fillStyle = css("--other") + "66";
  for (let row = 0; row < ny; row++) {
    for (let column = 0; column < nx; column++) {
      if (!marked(column, row)) continue;
      pen.fillRect(column * side / nx, side - (row + 1) * side / ny, side / nx, side / ny);
    }
  }
  pen.strokeStyle = css("--quiet");
  pen.lineWidth = devicePixelRatio * .6;
  pen.beginPath();
  for (let i = 1; i < nx; i++) { pen.moveTo(i * side / nx, 0); pen.lineTo(i * side / nx, side); }
  for (let i = 1; i < ny; i++) { pen.moveTo(0, i * side / ny); pen.lineTo(side, i * side / ny); }
  pen.stroke();
  const radius = Math.max(1.5 * devicePixelRatio, Math.min(side / 70, side / 6 / Math.sqrt(x.length)));
  pen.fillStyle = css("--accent");
  x.forEach((_, i) => {
    pen.beginPath();
    pen.arc(x[i] * side, (1 - y[i]) * side, radius, 0, 7);
    pen.fill();
  });
}

const dashes = ["", "9 4", "2 4", "12 4 2 4", "6 2", "16 6"];
const superscript = power => Array.from(String(power), c => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]).join("");
/** Curves [{name, points: [[x, y], …], chosen}], x logarithmic unless `ticks` are given, y unless
 * its `limits` are; a line at x = `now`. */
function chart(place, { curves, now, ticks, limits, label }) {
  const width = Math.max(300, place.clientWidth), height = Math.max(300, Math.min(460, width * .75));
  place.setAttribute("viewBox", `0 0 ${width} ${height}`);
  place.style.height = `${height}px`;
  place.replaceChildren();
  const left = 52, right = width - 132, top = 12, bottom = height - 34;
  const all = curves.flatMap(curve => curve.points), xs = all.map(([x]) => x);
  const ys = all.map(([, y]) => y).filter(y => y > 0);
  const xAxis = ticks ? x => x : Math.log10, yAxis = limits ? y => y : y => Math.log10(y);
  const [low, high] = limits ?? [Math.floor(Math.log10(Math.min(...ys))),
    Math.ceil(Math.log10(Math.max(...ys)))];
  const [start, end] = [Math.min(...xs), Math.max(...xs)].map(xAxis);
  const px = x => left + (right - left) * (xAxis(x) - start) / (end - start);
  const py = y => bottom - (bottom - top) * // what is below the frame (0, too) lies on its edge
    (Math.max(low, Math.min(high, y > 0 ? yAxis(y) : low)) - low) / (high - low);
  const lines = limits ? range(5).map(i => low + (high - low) * i / 4)
    : range(high - low + 1).map(i => 10 ** (low + i));
  for (const y of lines) {
    place.append(svg("line", { class: "grid", x1: left, x2: right, y1: py(y), y2: py(y) }),
      svg("text", { x: left - 6, y: py(y) + 5, "text-anchor": "end" },
        limits ? short(y) : "10" + superscript(Math.round(Math.log10(y)))));
  }
  const decades = range(17).map(i => 10 ** i).filter(x => x <= 10 ** end * 1.01 && x >= 10 ** start * .99);
  const marks = ticks ?? (end > 6 ? decades.filter((_, i) => i % 3 === 0) : powers(end > 3.5 && width < 500 ? 16 : 4,
    10 ** end * 1.01));
  for (const x of marks.filter(x => xAxis(x) >= start - 1e-9)) {
    place.append(svg("line", { class: "grid", x1: px(x), x2: px(x), y1: top, y2: bottom }),
      svg("text", { x: px(x), y: bottom + 18, "text-anchor": "middle" },
        x >= 1e5 ? "10" + superscript(Math.round(Math.log10(x))) : x));
  }
  place.append(svg("rect", { class: "frame", x: left, y: top, width: right - left,
    height: bottom - top }));
  const labels = curves.map((curve, k) => {
    const chosen = curve.chosen ? " chosen" : "";
    place.append(svg("polyline", { class: "way" + chosen, "stroke-dasharray": dashes[k % 6],
      points: curve.points.map(([x, y]) => `${px(x)},${py(y)}`).join(" ") }));
    return { curve, chosen, x: px(curve.points.at(-1)[0]), y: py(curve.points.at(-1)[1]) + 5, k };
  }).sort((a, b) => a.y - b.y);
  // One below the other, as near to the ends of their lines as they fit.
  labels.forEach((one, i) => { one.at = i ? Math.max(one.y, labels[i - 1].at + 17) : one.y; });
  labels.toReversed().forEach((one, i, all) => {
    one.at = Math.min(one.at, i ? all[i - 1].at - 17 : bottom + 8);
  });
  for (const { curve, chosen, x, y, at: row, k } of labels) {
    place.append(svg("line", { class: "way", x1: x + 2, y1: y - 5, x2: right + 12, y2: row - 5,
      "stroke-dasharray": dashes[k % 6] }));
    place.append(svg("text", { x: right + 15, y: row, class: chosen }, curve.name));
  }
  if (now !== undefined) {
    place.append(svg("line", { class: "cursor", x1: px(now), x2: px(now), y1: top, y2: bottom }));
    for (const { points } of curves.filter(curve => curve.chosen)) {
      const here = points.find(([x]) => x === now);
      if (here) place.append(svg("circle", { class: "at", cx: px(now), cy: py(here[1]), r: 8 }));
    }
  }
  place.setAttribute("aria-label", label + "; the curves as numbers are below");
}
