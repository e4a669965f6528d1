
// The labs: controls, each with its values (given those before it) and their texts; figures; what
// to draw. `draw` returns a sentence and the curves of the last figure.

const choice = (key, label, values, text = value => value) => ({ key, label, values, text });
const slider = (key, label, values, text = String, start = () => 0) =>
  ({ key, label, values, text, start, range: true });
const middle = values => values.length >> 1;
const chooseWay = name => ({ ...choice("way", "Points", () => ways, way => way.name),
  start: values => Math.max(0, values.findIndex(way => way.name === name)) });
const chooseIntegrand = choice("integrand", "Integrand", () => Object.keys(integrands),
  name => integrands[name](0).name);
const angle = slider("angle", "Edge", ({ integrand }) =>
  integrand === "edge" ? range(19).map(i => 5 * i) : [], a => `${a}°`, () => 5);
const errorOf = (value, f) => `Estimate ${value.toPrecision(4)}, exact ${f.exact.toPrecision(4)}, ` +
  `error ${short(value - f.exact).replace("-", "−")}`;
const scientific = x => x < 1e5 ? String(x) : `${x / 10 ** Math.floor(Math.log10(x) + 1e-9)}·10` +
  superscript(Math.floor(Math.log10(x) + 1e-9));

/** Powers of 2, and products of powers of two bases. */
const productsOf = ([a, b]) => [...new Set([...powers(2, 1024), ...powers(a, 1024).flatMap(
  x => powers(b, 1024 / x).map(y => x * y))])].sort((a, b) => a - b);

const views = {
  1: {
    title: "Lab 1: an offset costs digits",
    task: "Predict first: with ten times the offset, how many digits does each algorithm lose? At " +
      "which offset has the textbook formula none left?",
    controls: [choice("data", "Data", () => [...new Set(of(1).map(one => one.data))]),
      choice("name", "Algorithm", ({ data }) => of(1).filter(one => one.data === data).map(
        one => one.name)), slider("offset", "Offset", () => of(1)[0].offsets, scientific, () => 10)],
    figures: [["table", "Each variance. Struck out: wrong digits."],
      ["svg", "Correct digits against the offset."]],
    draw({ data, name, offset }, [table]) {
      const all = of(1).filter(one => one.data === data), i = all[0].offsets.indexOf(offset);
      const digits = (way, i) => way.values[i] === null || !(way.values[i] > 0) ? 0 :
        Math.max(0, Math.min(16, -Math.log10(Math.abs(way.values[i] / way.exact[i] - 1))));
      const row = (name, value, right) => {
        const text = value === null ? "NaN" : value.toPrecision(14);
        let end = 0;
        for (let found = 0; end < text.length && found < right; end++) found += /\d/.test(text[end]);
        return html("tr", {}, html("th", { scope: "row" }, name),
          html("td", {}, text.slice(0, end), html("s", {}, text.slice(end))));
      };
      table.replaceChildren(row("exact", all[0].exact[i], 99),
        ...all.map(way => row(way.name, way.values[i], Math.floor(digits(way, i)))));
      return {
        now: `Offset ${scientific(offset)}: ` + all.map(
          way => `${way.name} ${Math.floor(digits(way, i))}`).join(", ") + " correct digits.",
        chart: { now: offset, limits: [0, 16], label: "Correct digits against the offset",
          curves: all.map(way => ({ name: way.name, chosen: way.name === name,
            points: way.offsets.map((x, k) => [x, digits(way, k)]) })) } };
    } },
  2: {
    title: "Lab 2: error bars and their coverage",
    task: "Before you move N: how much shorter are the bars at four times as many samples? Then " +
      "change the integrand: where do the bars lie, and does a larger N help?",
    controls: [choice("integrand", "Integrand", () => of(2).filter(one => one.mean !== undefined),
      one => one.name), slider("level", "Level", ({ integrand }) => integrand.levels,
      level => `${100 * level} %`, () => 4), slider("n", "N", ({ integrand }) => integrand.sizes,
      n => n, () => 2)],
    figures: [["svg", "100 estimates with their intervals; the line is the exact mean. Thick with a " +
      "dot: the interval misses it."], ["svg", "Coverage (percent) against N."]],
    draw({ integrand, level, n }, [bars]) {
      const z = one => one.z[one.levels.indexOf(level)];
      const covers = one => (value, i) => Math.abs(value - one.mean) <= z(one) * one.errors[i];
      const at = (one, k) => ({ ...one, values: one.values.slice(100 * k, 100 * k + 100),
        errors: one.errors.slice(100 * k, 100 * k + 100) });
      const coverage = one => one.values.filter(covers(one)).length;
      const one = at(integrand, integrand.sizes.indexOf(n)), error = rms(one.values.map(
        value => value - one.mean));
      const width = Math.max(300, bars.clientWidth), height = 320;
      bars.setAttribute("viewBox", `0 0 ${width} ${height}`);
      bars.style.height = `${height}px`;
      const reach = 5 * median(one.errors) || 3 * error || 1;
      const py = value => height / 2 - 150 * Math.max(-1, Math.min(1, (value - one.mean) / reach));
      bars.replaceChildren(...one.values.flatMap((value, i) => {
        const x = (i + .5) * width / 100, half = z(one) * one.errors[i];
        const kind = covers(one)(value, i) ? "way" : "miss";
        return [svg("line", { class: kind, x1: x, x2: x, y1: py(value - half), y2: py(value + half) }),
          ...(kind === "miss" ? [svg("circle", { class: kind, cx: x, cy: py(value), r: 2 })] : [])];
      }), svg("line", { class: "cursor", x1: 0, x2: width, y1: height / 2, y2: height / 2 }));
      bars.setAttribute("aria-label", `100 intervals, of which ${coverage(one)} cover the mean`);
      return {
        now: `N = ${n}: ${coverage(one)} of 100 intervals cover the mean, ${100 * level} expected. ` +
          `Mean half-length ${short(mean(one.errors) * z(one))}; RMSE ${short(error)}.`,
        chart: { now: n, limits: [0, 100], label: "Coverage against N",
          curves: of(2).filter(all => all.mean !== undefined).map(all => ({ name: all.name,
            chosen: all === integrand,
            points: all.sizes.map((size, k) => [size, coverage(at(all, k))]) })) } };
    } },
  3: {
    title: "Lab 3: strata and edges",
    task: "Turn the edge. How many strata does it cross, and which error do the others make? Guess " +
      "the slope of jittered points first, then for the smooth integrand.",
    controls: [chooseWay("jittered"), chooseIntegrand, angle,
      slider("n", "N", () => sizes, String, () => 3), slider("set", "Set", ({ way }) => range(way.sets),
      k => `${k + 1}`)],
    figures: [["canvas", "The points in √N × √N strata. Filled: strata that the edge crosses."],
      ["svg", "RMSE of 16 sets against N, both logarithmic."]],
    draw({ way, integrand, angle, n, set }, [canvas]) {
      const f = integrands[integrand](angle), side = Math.sqrt(n), step = sizes.indexOf(n);
      const points = way.set(Math.min(step, way.known - 1), set);
      const crossed = (column, row) => integrand === "edge" && new Set([0, 1, 2, 3].map(corner =>
        f.g((column + corner % 2) / side, (row + (corner >> 1)) / side))).size > 1;
      const cells = range(n).map(() => 0);
      points[0].forEach((x, i) => cells[part(x, side) + side * part(points[1][i], side)]++);
      drawPoints(canvas, points, f, side, side, crossed);
      canvas.setAttribute("aria-label", `${points[0].length} points, ${way.name}`);
      const count = range(n).filter(i => crossed(i % side, Math.floor(i / side))).length;
      return {
        now: `${errorOf(estimate(points, f), f)}. ${cells.filter(c => c === 0).length} of ${n} ` +
          `strata are empty` + (integrand === "edge" ? `; the edge crosses ${count}.` : "."),
        chart: { now: n, label: "RMSE against N", curves: ways.map(one => curveOf(one, f, one === way)) } };
    } },
  4: {
    title: "Lab 4: the spectrum of a pattern",
    task: "Compare the points by eye, then by spectrum. Which have no power at low frequencies, " +
      "which a ring of much power? Average more sets: what remains, what was noise?",
    controls: [chooseWay("best candidate"), slider("n", "N", () => sizes.slice(2, 6), String, () => 2),
      slider("sets", "Sets", ({ way }) => range(way.sets).map(k => k + 1), String, () => 7)],
    figures: [["canvas", "The first set."],
      ["canvas", "Its periodogram, frequency 0 in the middle: ground 0, full color 3 and more."],
      ["svg", "Mean power over rings against frequency / √N."]],
    draw({ way, n, sets }, [pattern, picture]) {
      const step = sizes.indexOf(n), most = Math.min(48, 2 * Math.sqrt(n)), width = 2 * most + 1;
      const known = ways.filter(one => one.known > step), shown = known.includes(way) ? way : known[0];
      const points = shown.set(step, 0), power = spectrum(shown, step, sets, most);
      drawPoints(pattern, points, { g: () => 0 }, 1, 1, () => false);
      const [ground, full] = [rgb("--ground"), rgb("--accent")];
      paint(picture, width, width, (column, row) => {
        const i = row * width + column;
        return mix(ground, full, i === power.length >> 1 ? 0 : Math.min(1, power[i] / 3));
      });
      pattern.setAttribute("aria-label", `${points[0].length} points, ${shown.name}`);
      picture.setAttribute("aria-label", `periodogram of ${shown.name}`);
      const curves = known.map(one => ({ name: one.name, chosen: one === shown,
        points: rings(spectrum(one, step, sets, most), most).map((p, k) =>
          [(k + 1) / Math.sqrt(n), p]) }));
      const mine = curves.find(one => one.chosen).points;
      const peak = mine.reduce((a, b) => b[1] > a[1] ? b : a);
      return {
        now: `${shown.name}, N = ${n}, ${sets} ${sets > 1 ? "sets" : "set"}: mean power ` +
          `${short(mean(mine.filter(([f]) => f <= .5).map(([, p]) => p)))} at frequencies up to √N/2, ` +
          `largest ${short(peak[1])} at ${short(peak[0])} √N. Independent points have 1 everywhere.`,
        chart: { ticks: [0, .5, 1, 1.5, 2], limits: [0, 2], label: "Radial power", curves } };
    } },
  5: {
    title: "Lab 5: elementary intervals",
    task: "Change the shape of the intervals, then N: when does every interval hold its share of the " +
      "points? Try bases 29 and 31, then scramble.",
    controls: [choice("kind", "Points", () => [...(has("base 2", "base 3") ? ["Halton"] : []),
      ...(has("base 2", "Sobol' 1") ? ["Sobol'"] : [])]),
    choice("bases", "Bases", ({ kind }) => kind === "Halton" ? [[2, 3], [3, 5], [5, 7], [29, 31]].filter(
      pair => has(...pair.map(b => `base ${b}`))) : [[2, 2]], pair => pair.join(" and ")),
    slider("scramble", "Scramble", () => range(scrambles + 1), k => k ? `seed ${k}` : "none"),
    slider("n", "N", ({ bases }) => productsOf(bases), String,
      values => values.includes(216) ? values.indexOf(216) : middle(values)),
    slider("shape", "Intervals", ({ bases: [a, b], n }) => powers(a, n).map(x => [x,
      powers(b, n / x).at(-1)]), ([x, y]) => `1/${x} × 1/${y}`,
      values => Math.max(0, values.findIndex(([x]) => x === 8))), chooseIntegrand],
    figures: [["canvas", "The points in elementary intervals. Filled: an interval without its share."],
      ["svg", "RMSE of 16 scrambled sets against N; of points without scramble, their error."]],
    draw({ kind, bases, scramble, n, shape: [nx, ny], integrand }, [canvas]) {
      const f = integrands[integrand](25);
      const pair = kind === "Halton" ? bases.map(b => columns[`base ${b}`])
        : [columns["base 2"], columns["Sobol' 1"]];
      const points = first(pair.map(column => column[scramble]), n), cells = range(nx * ny).map(() => 0);
      points[0].forEach((x, i) => cells[part(x, nx) + nx * part(points[1][i], ny)]++);
      const share = n / (nx * ny), wrong = count => Math.abs(count - share) >= 1;
      drawPoints(canvas, points, f, nx, ny, (column, row) => wrong(cells[column + nx * row]));
      canvas.setAttribute("aria-label", `${n} points in ${nx} times ${ny} intervals`);
      const sets = scramble ? range(scrambles).map(k => k + 1) : [0];
      // At all N of the slider: between two of them, a line would pass through no error.
      const mine = { name: "these points", chosen: true, points: productsOf(bases).map(size => [size,
        rms(sets.map(k => estimate(first(pair.map(c => c[k]), size), f) - f.exact))]) };
      return {
        now: `${nx * ny} intervals, ${short(share)} point${short(share) === "1" ? "" : "s"} each: ` +
          `${cells.filter(wrong).length} differ, ` +
          `${cells.filter(count => count === 0).length} are empty. ${errorOf(estimate(points, f), f)}.`,
        chart: { now: n, label: "RMSE against N", xs: sizes,
          curves: [mine, ...ways.map(one => curveOf(one, f, false))] } };
    } },
  6: {
    title: "Lab 6: samplers and their pictures",
    task: "Rank the samplers at one sample per pixel, then at 64. Which one needs how many samples " +
      "for the error that another has at 16?",
    controls: [choice("kind", "Sampler", () => of(6).filter(one => one.images), one => one.name),
      slider("spp", "Samples per pixel", ({ kind }) => kind.sizes, String, () => 2)],
    figures: [["canvas", "The picture: a penumbra."], ["canvas", "Its error: orange too bright, blue " +
      "too dark, full color at 10 % of white."], ["svg", "RMSE against samples per pixel, in parts of white."]],
    draw({ kind, spp }, [picture, difference]) {
      const pixels = (one, k) => decoded(one.images[k], 2), exact = decoded(of(6)[0].exact, 2);
      const now = pixels(kind, kind.sizes.indexOf(spp)), { width } = kind, height = now.length / width;
      const error = one => rms(Array.from(one, (value, i) => value - exact[i]));
      paint(picture, width, height, (x, y) => Array(3).fill(255 * now[y * width + x] ** (1 / 2.2)));
      const [ground, bright, dark] = ["--ground", "--other", "--accent"].map(rgb);
      paint(difference, width, height, (x, y) => {
        const e = 10 * (now[y * width + x] - exact[y * width + x]);
        return mix(ground, e > 0 ? bright : dark, Math.min(1, Math.abs(e)));
      });
      picture.setAttribute("aria-label", `a penumbra by ${kind.name} at ${spp} samples per pixel`);
      difference.setAttribute("aria-label", "the error of each pixel");
      return {
        now: `${kind.name}, ${spp} ${spp > 1 ? "samples" : "sample"} per pixel: RMSE ${short(error(now))} ` +
          "of white.",
        chart: { now: spp, label: "RMSE against samples per pixel", curves: of(6).filter(
          one => one.images).map(one => ({ name: one.name, chosen: one === kind,
          points: one.sizes.map((size, k) => [size, error(pixels(one, k))]) })) } };
    } },
};

// The page.

const states = Object.fromEntries(Object.keys(views).map(lab => [lab, {}]));
const touched = new Set();  // labs with a control that was moved
let present = [], lab, shown = [], inputs = [];

/** Draws data. What was chosen stays, by its text: there may be more or fewer values now. */
function take(data, remarks) {
  for (const one of present) {
    const chosen = choose(one).filter(({ value }) => value !== undefined).map(
      ({ control, value }) => [control.key, String(control.text(value))]);
    states[one] = touched.has(one)
      ? { ...states[one], ...Object.fromEntries(chosen), ...wishes(one) } : {};
  }
  const before = [lab, ...present].join();
  read(data);
  present = Object.keys(views).filter(lab => views[lab].controls[0].values({}).length > 0);
  find();
  if (lab && before === [lab, ...present].join()) update(); else build();
  if (remarks !== undefined) at("remarks").innerHTML = remarks;
}

/** The choices of a lab that the data lacked since they were made: they may come back. */
const wishes = lab => Object.fromEntries(Object.entries(states[lab]).filter(
  ([, state]) => typeof state === "string"));

/** The controls of a lab with their values; a state is an index, or the text of a value. */
function choose(lab) {
  const chosen = {}, state = states[lab];
  return views[lab].controls.map(control => {
    const { key } = control, values = control.values(chosen), start = control.start?.(values) ?? 0;
    state[key] ??= start;
    const found = values.findIndex(value => String(control.text(value)) === state[key]);
    const index = typeof state[key] === "number" ? Math.min(state[key], values.length - 1)
      : found < 0 ? start : found;
    chosen[key] = values[index];
    return { control, values, index, value: values[index] };
  });
}

function build() {
  at("labs").replaceChildren(...present.map(one => html("a", { href: `#${one}`,
    ...(one === lab ? { "aria-current": "page" } : {}) }, `Lab ${one}`)));
  const view = views[lab] ?? { title: "Nothing is measured yet", task: "", controls: [], figures: [] };
  at("title").textContent = view.title;
  at("task").textContent = view.task;
  inputs = view.controls.map(control => {
    const input = html(control.range ? "input" : "select", { id: `${control.key}-control`,
      ...(control.range ? { type: "range", min: 0, step: 1 } : {}) });
    input.addEventListener("input", () => {
      touched.add(lab);
      for (const [i, { key }] of view.controls.entries()) {
        if (!inputs[i].parentElement.hidden) states[lab][key] = +inputs[i].value;
      }
      update();
    });
    return input;
  });
  at("controls").replaceChildren(...view.controls.map((control, i) => html("div",
    { class: control.range ? "range" : "" }, html("label", { for: `${control.key}-control` }, control.label),
    inputs[i], ...(control.range ? [html("output", { for: `${control.key}-control` })] : []))));
  shown = view.figures.map(([kind]) => kind === "svg" ? svg("svg", { role: "img" })
    : html(kind, kind === "canvas" ? { role: "img" } : {}));
  at("figures").replaceChildren(...view.figures.map(([, caption], i) =>
    html("figure", {}, shown[i], html("figcaption", {}, caption))));
  update();
}

function update() {
  const chosen = {};
  for (const [i, { control, values, index, value }] of (lab ? choose(lab) : []).entries()) {
    const input = inputs[i], texts = values.map(control.text);
    chosen[control.key] = value;
    input.parentElement.hidden = values.length < 2;
    if (values.length === 0) continue;
    if (control.range) {
      input.max = values.length - 1;
      input.nextSibling.textContent = texts[index];
      input.setAttribute("aria-valuetext", texts[index]);
    } else if (texts.join() !== Array.from(input.options, option => option.text).join()) {
      input.replaceChildren(...texts.map((text, k) => new Option(text, k)));
    }
    input.value = index;
  }
  if (!lab) return at("now").replaceChildren(), at("numbers").replaceChildren();
  const { now, chart: drawn } = views[lab].draw(chosen, shown);
  at("now").textContent = now;
  chart(shown.at(-1), drawn);
  const xs = drawn.xs ?? [...new Set(drawn.curves.flatMap(curve => curve.points.map(([x]) => x)))].slice(0, 40);
  const few = xs.filter((_, i) => i % Math.ceil(xs.length / 8) === 0);
  at("numbers").replaceChildren(html("tr", {}, html("th", { scope: "col" }, drawn.label),
    ...few.map(x => html("th", { scope: "col" }, scientific(x)))), ...drawn.curves.map(curve =>
    html("tr", { class: curve.chosen ? "chosen" : "" }, html("th", { scope: "row" }, curve.name),
      ...few.map(x => html("td", {}, short(curve.points.find(([at]) => at === x)?.[1] ?? NaN))))));
}

/** The lab to show: as the address says. */
function find() {
  lab = [location.hash.slice(1), lab, present[0]].find(one => present.includes(one));
}
function go() {
  find();
  build();
}
addEventListener("hashchange", go);
addEventListener("resize", update);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", update);
addEventListener("keydown", event => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.tagName === "SELECT") return;
  if (present.includes(event.key)) location.hash = event.key;
  const move = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  const main = lab && inputs[views[lab].controls.findIndex(control => ["offset", "n", "spp"].includes(control.key))];
  if (!main || !move || event.target.tagName === "INPUT") return;
  main.value = +main.value + move;
  main.dispatchEvent(new Event("input"));
});
take(JSON.parse(at("data").textContent));
