// SPDX-License-Identifier: GPL-3.0-or-later
// The interactive part of a page: control points to drag, sliders for the parameters, the limit curve with its comb.
//
// A scheme is what an emitted evaluator defines, as one object, and its shift p as a fraction:
//   {arity, lowest, size, start, next, mask, shift: [numerator, denominator]}
//   start(v0, ...), next(v, ...), mask(levels..., constants..., locals...)
// Settings are numbers for its parameters, in the order of the evaluator, and what lies beyond the ends of a polygon:
//   {levels: [v0, ...], constants: [...], locals: [{offsets, rest, values}, ...], ends, beyond}
// Settings of a scheme on vertices with derivatives have `vertices` beside: [{p, r, sigma}, ...] (hermite2010).
// A local parameter has one value an edge: an edge parameter (with `rest`, its value at edges that touch no vertex of
// the data) or a knot interval (without; halved at every step, and taken from the points: centripetal).
// Points are arrays of coordinates.
//
// Ends, as `twoscale refine --closed` and `--open ENDS` have them:
//   "closed"  none: indices wrap
//   "linear"  p_{-h} = 2 p_0 - p_h at every level, mirrored after the last point; so are knots and edge parameters
//   "given"   beyond = [left, right] points before and after the curve are part of the polygon (of vertices none)
// Of an open polygon come out the points whose parameters (j + p)/m^k lie between those of its first and last point.
"use strict";

// ---- Refinement

const around = (list, index) => list[((index % list.length) + list.length) % list.length];

const finite = (points) => points.every((p) => p.every(Number.isFinite));

const isClosed = (ends) => ends === "closed";
const edgeCount = (points, ends) => (isClosed(ends) ? points.length : points.length - 1);

// Point j, also beyond the ends of a polygon; one of few points has no more to mirror than its other end.
function pointAt(points, j, ends) {
  const last = points.length - 1;
  const mirrored = (end, other) => points[end].map((x, c) => 2 * x - points[other][c]);
  if (isClosed(ends)) return around(points, j);
  if (j < 0) return mirrored(0, Math.min(-j, last));
  return j > last ? mirrored(last, Math.max(2 * last - j, 0)) : points[j];
}

// The value of edge e of a local parameter.
function edgeAt(parameter, e, ends) {
  const {values, rest} = parameter, count = values.length;
  if (isClosed(ends) || (e >= 0 && e < count)) return around(values, e);
  const value = values[Math.max(0, Math.min(e < 0 ? -1 - e : 2 * count - 1 - e, count - 1))];
  return rest === undefined ? value : 1 - value;
}

// The points f^{k+1}_i = sum_j a_{i - m j} f^k_j for first <= i <= last; at(j) is f^k_j.
function uniformStep(scheme, mask, at, first, last) {
  const m = scheme.arity, highest = scheme.lowest + scheme.size - 1, fine = [];
  for (let i = first; i <= last; ++i) {
    const sum = at(Math.ceil((i - highest) / m)).map(() => 0);
    for (let j = Math.ceil((i - highest) / m); m * j <= i - scheme.lowest; ++j) {
      const weight = mask[i - m * j - scheme.lowest];
      at(j).forEach((x, c) => { sum[c] += weight * x; });
    }
    fine.push(sum);
  }
  return fine;
}

function refineUniformly(scheme, settings, points, levels) {
  const {arity: m, lowest, shift} = scheme, {ends} = settings, highest = lowest + scheme.size - 1;
  const [left, right] = ends === "given" ? settings.beyond : [0, 0];
  const count = points.length - left - right;  // of the points that an open curve runs between
  if (count < 2) return [];
  const inside = (k) => [Math.ceil(shift[0] * (m ** k - 1) / shift[1]),
    m ** k * (count - 1) + Math.floor(shift[0] * (m ** k - 1) / shift[1])];
  let v = settings.levels.length > 0 ? [].concat(scheme.start(...settings.levels)) : [];
  let start = -left;  // the index of points[0]
  for (let k = 0; k < levels; ++k) {
    const n = points.length;
    const [first, last] = isClosed(ends) ? [0, m * n - 1] : ends === "linear" ? inside(k + 1)
      : [m * (start - 1) + highest + 1, m * (start + n) + lowest - 1];
    const missing = Math.max(start - Math.ceil((first - highest) / m), Math.floor((last - lowest) / m) - (start + n - 1));
    if (ends === "linear" && missing >= n) return [];
    const coarse = points, from = start;
    points = uniformStep(scheme, scheme.mask(...v, ...settings.constants), (j) => pointAt(coarse, j - from, ends), first, last);
    start = first;
    if (v.length > 0) v = [].concat(scheme.next(...v));
  }
  if (ends !== "given") return points;
  const [first, last] = inside(levels);
  return points.slice(first - start, last - start + 1);
}

// Old vertices stay; in the middle of the edge j a new one appears, by the rule at the parameters of the edges around.
// The first and the last `skipped` edges have no new vertex, and go.
function knotStep(scheme, settings, points, skipped) {
  const {ends, locals} = settings, fine = [], end = edgeCount(points, ends) - skipped;
  for (let j = skipped; j < end; ++j) {
    const here = locals.flatMap((p) => p.offsets.map((o) => edgeAt(p, j + o, ends)));
    const weights = scheme.mask(...settings.constants, ...here);
    const sum = points[j].map(() => 0);
    for (let i = 0; i < scheme.size; ++i)
      pointAt(points, j + scheme.lowest + i, ends).forEach((x, c) => { sum[c] += weights[i] * x; });
    fine.push(points[j], sum);
  }
  if (!isClosed(ends)) fine.push(points[end]);
  return fine;
}

// The parameters of the two halves of every edge but the first and last `skipped` ones; the edge at place 0 has the
// index `first`, and `data` is the number of edges between two vertices of the data.
function halved(parameter, data, first, skipped) {
  const {values, rest} = parameter;
  return {...parameter, values: values.slice(skipped, values.length - skipped).flatMap((value, place) => {
    if (rest === undefined) return [value / 2, value / 2];
    const j = first + skipped + place, left = j % data === 0, right = (j + 1) % data === 0;
    return [left ? value : rest, right ? value : rest];
  })};
}

function centripetal(points, ends) {
  return points.slice(0, edgeCount(points, ends))
    .map((p, j) => Math.sqrt(Math.hypot(...p.map((x, c) => around(points, j + 1)[c] - x))));
}

function refineOnKnots(scheme, settings, points, levels) {
  const {ends} = settings;
  // A step takes half of what is given beyond the ends, and leaves twice as many points there as are left.
  const beyond = ends === "given" ? settings.beyond[0] : 0, skipped = beyond / 2;
  if (points.length < 2 * beyond + 2) return [];
  let locals = settings.locals.map((p) =>
    ({...p, values: p.values ? p.values.slice(0, edgeCount(points, ends)) : centripetal(points, ends)}));
  for (let k = 0, first = 0; k < levels; ++k, first = 2 * (first + skipped)) {
    points = knotStep(scheme, {...settings, locals}, points, skipped);
    locals = locals.map((p) => halved(p, 2 ** k, first, skipped));
  }
  return points.slice(beyond, points.length - beyond);
}

// A vertex of hermite2010 with its angular parameter increased by 2 pi: the derivatives p, r in t = (1 + tan(sigma/4))/2
// change so that those in sigma stay.
function turned(vertex) {
  const rates = (sigma) => {
    const alpha = Math.tan(sigma / 4);
    return [(1 + alpha * alpha) / 8, alpha * (1 + alpha * alpha) / 16];
  };
  const [before, bent] = rates(vertex.sigma), [after, bentAfter] = rates(vertex.sigma + 2 * Math.PI);
  const p = vertex.p.map((x) => x * before / after);
  const r = vertex.r.map((x, c) => (x * before * before + vertex.p[c] * bent - p[c] * bentAfter) / (after * after));
  return {...vertex, p, r, sigma: vertex.sigma + 2 * Math.PI};
}

// In the middle of every edge, in sigma, a new vertex: a 3x6 matrix acts on f, f, p, p, r, r of its ends.
function vertexStep(scheme, settings, vertices) {
  return vertices.flatMap((left, i) => {
    if (i === edgeCount(vertices, settings.ends)) return [left];
    const right = i + 1 < vertices.length ? vertices[i + 1] : turned(vertices[0]);
    const matrix = scheme.mask(...settings.constants, Math.tan(left.sigma / 8), Math.tan(right.sigma / 8));
    const columns = [left.f, right.f, left.p, right.p, left.r, right.r];
    const [f, p, r] = [0, 1, 2].map((row) => left.f.map((_, c) =>
      columns.reduce((sum, column, k) => sum + matrix[6 * row + k] * column[c], 0)));
    return [left, {f, p, r, sigma: (left.sigma + right.sigma) / 2}];
  });
}

// `levels` steps from `points`. Where a value is singular, points are not finite; none come out where those of an open
// polygon are too few.
function refine(scheme, settings, points, levels) {
  if (settings.vertices) {
    let vertices = points.map((f, j) => ({...settings.vertices[j], f}));
    for (let k = 0; k < levels; ++k) vertices = vertexStep(scheme, settings, vertices);
    return vertices.map((v) => v.f);
  }
  return (settings.locals.length > 0 ? refineOnKnots : refineUniformly)(scheme, settings, points, levels);
}

// ---- Measures of plane curves

// Every point with its neighbours, [before, point, after]; the ends of an open curve have but one.
function corners(points, closed) {
  const all = points.map((p, j) => [around(points, j - 1), p, around(points, j + 1)]);
  return closed ? all : all.slice(1, -1);
}

const difference = (p, q) => [q[0] - p[0], q[1] - p[1]];

// Signed curvature of the circle through the points of a corner, positive for a left turn; 0 where points coincide.
function curvature([a, b, c]) {
  const u = difference(a, b), w = difference(b, c);
  const sides = Math.hypot(...u) * Math.hypot(...w) * Math.hypot(...difference(a, c));
  return sides > 0 ? 2 * (u[0] * w[1] - u[1] * w[0]) / sides : 0;
}

// Unit normal, to the right of the direction.
function normal([a, , c]) {
  const [x, y] = difference(a, c), length = Math.hypot(x, y) || 1;
  return [y / length, -x / length];
}

// Sum of the absolute turning angles, in full turns.
function turning(list) {
  const angle = ([a, b, c]) => {
    const u = difference(a, b), w = difference(b, c);
    return Math.atan2(u[0] * w[1] - u[1] * w[0], u[0] * w[0] + u[1] * w[1]);
  };
  return list.reduce((sum, corner) => sum + Math.abs(angle(corner)), 0) / (2 * Math.PI);
}

// ---- The page

const view = {width: 760, height: 520, margin: 70};

function element(name, attributes, ...children) {
  const svg = ["svg", "path", "circle", "g"].includes(name);
  const e = svg ? document.createElementNS("http://www.w3.org/2000/svg", name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes || {})) e.setAttribute(key, value);
  e.append(...children);
  return e;
}

const shown = (x) => String(Number(x.toPrecision(6)));

// A slider and a number, which follow each other. `scale` maps the slider's 0..1 to values and back.
function control(label, value, scale, changed) {
  const slider = element("input", {type: "range", min: 0, max: 1, step: "any", value: scale.to(value), "aria-label": label});
  const number = element("input", {type: "number", step: "any", value: shown(value), "aria-label": label});
  const state = {value};
  slider.addEventListener("input", () => {
    state.value = Number(shown(scale.from(Number(slider.value))));
    number.value = state.value;
    changed();
  });
  number.addEventListener("input", () => {
    const typed = Number(number.value);
    if (number.value === "" || !Number.isFinite(typed)) return;
    state.value = typed;
    slider.value = scale.to(typed);
    changed();
  });
  state.set = (x) => {
    state.value = x;
    number.value = shown(x);
    slider.value = scale.to(x);
  };
  state.row = element("label", {}, element("span", {}, label), slider, number);
  return state;
}

// v^0 > -1, where most happens near -1, and much up to the thousands.
const tensionScale = {
  from: (s) => 10 ** (-1.7 + 5.7 * s) - 1,
  to: (v) => (Math.log10(Math.max(1 + v, 1e-9)) + 1.7) / 5.7,
};
const linearScale = (low, high) => ({from: (s) => low + (high - low) * s, to: (x) => (x - low) / (high - low)});

function scaleOf(p) {
  if (p.low !== undefined) return linearScale(p.low, p.high);
  return {from: (s) => p.scale * tensionScale.from(s) + p.offset, to: (x) => tensionScale.to((x - p.offset) / p.scale)};
}

// A choice among values, each with its words: {value: words, ...}.
function choice(label, words, changed) {
  const options = Object.entries(words).map(([value, text]) => element("option", {value}, text));
  const select = element("select", {"aria-label": label}, ...options);
  select.addEventListener("change", changed);
  return {
    get value() { return select.value; },
    set: (value) => { select.value = value; },
    row: element("label", {}, element("span", {}, label), select),
  };
}

// What the page calls the ends.
function endsInWords(config) {
  if (config.vertices) return {closed: "closed", given: "open"};
  const [left, right] = config.beyond, many = left === right ? left : `${left} and ${right}`;
  return {closed: "closed", linear: "open, mirrored at the ends", given: `open, ${many} points beyond each end`};
}

// Fills `root` for a scheme. config: {command, points, beyond (see settings), vertices (or not: their p, r and sigma stay),
//   refinements, mostRefinements,
//   levels: [{name, label, value, low, high, fixed, scale, offset}], with value = scale*v^0 + offset,
//   constants: [{name, label, value, low, high}], locals: [{name, label, offsets, rest, low, high}]}.
function interactiveCurve(root, scheme, config) {
  let points = config.points.map((p) => p.slice());
  let selected = 0;  // an edge, for edge parameters
  const edgeValues = (count) => config.locals.map((p) => (p.rest === undefined ? undefined : Array(count).fill(p.rest)));
  let edges = edgeValues(points.length);

  const comb = element("path", {class: "comb"});
  const crown = element("path", {class: "crown"});
  const polygon = element("path", {class: "polygon"});
  const chosen = element("path", {class: "chosen"});
  const curve = element("path", {class: "limit"});
  const handles = element("g");
  const svg = element("svg", {viewBox: `0 0 ${view.width} ${view.height}`, role: "img",
    "aria-label": "control polygon and limit curve"}, comb, crown, polygon, chosen, curve, handles);
  const message = element("p", {class: "message", "aria-live": "polite"});
  const command = element("code", {});

  // Plane coordinates to pixels and back.
  let unit = 1, origin = [0, 0];
  const fit = () => {
    const low = [0, 1].map((c) => Math.min(...points.map((p) => p[c])));
    const high = [0, 1].map((c) => Math.max(...points.map((p) => p[c])));
    unit = Math.min((view.width - 2 * view.margin) / (high[0] - low[0] || 1),
      (view.height - 2 * view.margin) / (high[1] - low[1] || 1));
    origin = [view.width / 2 - unit * (low[0] + high[0]) / 2, view.height / 2 + unit * (low[1] + high[1]) / 2];
  };
  const toPixel = (p) => [origin[0] + unit * p[0], origin[1] - unit * p[1]];
  const fromEvent = (event) => {
    const box = svg.getBoundingClientRect();
    const pixel = [(event.clientX - box.left) * view.width / box.width, (event.clientY - box.top) * view.height / box.height];
    return [(pixel[0] - origin[0]) / unit, (origin[1] - pixel[1]) / unit];
  };
  const path = (list, closed = false) =>
    list.map((p, i) => (i === 0 ? "M" : "L") + toPixel(p).map((x) => x.toFixed(2)).join(" ")).join("") + (closed ? "Z" : "");

  const redraw = () => draw();
  const levels = config.levels.map((p) => control(p.label, p.value, scaleOf(p), redraw));
  const constants = config.constants.map((p) => control(p.label, p.value, scaleOf(p), redraw));
  const edgeControls = config.locals.map((p, i) => p.rest === undefined ? undefined
    : control(`${p.label} of the marked edge`, p.rest, linearScale(p.low, p.high), () => {
      edges[i][selected] = edgeControls[i].value;
      draw();
    }));
  const ends = choice("ends", endsInWords(config), () => select(Math.min(selected, edgeCount(points, ends.value) - 1)));
  const closed = () => isClosed(ends.value);
  const steps = control("levels", config.refinements, linearScale(0, config.mostRefinements), redraw);
  steps.row.querySelector("[type=range]").step = 1 / config.mostRefinements;
  const combLength = control("comb", 0.5, linearScale(0, 1), redraw);

  // Marks an edge; its edge parameters can be changed.
  function select(edge) {
    selected = edge;
    edgeControls.forEach((c, i) => c && c.set(edges[i][selected]));
    draw();
  }

  function settings() {
    return {vertices: config.vertices, ends: ends.value, beyond: config.beyond,
      levels: config.levels.map((p, i) => (levels[i].value - p.offset) / p.scale), constants: constants.map((c) => c.value),
      locals: config.locals.map((p, i) => ({offsets: p.offsets, rest: p.rest, values: edges[i]}))};
  }

  function draw() {
    const used = Math.max(0, Math.min(config.mostRefinements, Math.round(steps.value)));
    const fine = refine(scheme, settings(), points, used);
    const usable = fine.length > 0 && finite(fine);
    polygon.setAttribute("d", path(points, closed()));
    chosen.setAttribute("d", edgeControls.some(Boolean) ? path([points[selected], around(points, selected + 1)]) : "");
    curve.setAttribute("d", usable ? path(fine, closed()) : "");
    drawComb(usable ? fine : []);
    while (handles.childNodes.length > points.length) handles.lastChild.remove();
    while (handles.childNodes.length < points.length) handles.append(handle(handles.childNodes.length));
    const [left, right] = ends.value === "given" ? config.beyond : [0, 0];
    points.forEach((p, i) => {
      const [x, y] = toPixel(p);
      handles.childNodes[i].classList.toggle("beyond", i < left || i >= points.length - right);
      handles.childNodes[i].setAttribute("cx", x.toFixed(2));
      handles.childNodes[i].setAttribute("cy", y.toFixed(2));
    });
    const list = corners(fine, closed()), k = list.map(curvature);
    message.textContent = usable
      ? `${points.length} points become ${fine.length}. The curve turns by ${turning(list).toFixed(3)}; its curvature runs `
        + `from ${shown(Math.min(...k))} to ${shown(Math.max(...k))}.`
      : fine.length > 0 ? "The scheme does not exist at these values."
        : `These ends need more than ${points.length} points; a double click adds one.`;
    const at = config.levels.flatMap((p, i) => (p.fixed ? [] : [`${p.name}=${shown(levels[i].value)}`]))
      .concat(config.constants.map((p, i) => `${p.name}=${shown(constants[i].value)}`));
    const values = at.length > 0 ? ` --at ${at.join(",")}` : "", open = closed() ? "" : ` --open ${ends.value}`;
    command.textContent = `${config.command}${values}${open} --levels ${used} points.csv`;
  }

  // Teeth against the side the curve bends to, long where it bends much.
  function drawComb(fine) {
    const list = corners(fine, closed()), k = list.map(curvature), n = list.map(normal);
    const size = Math.min(view.width, view.height) / unit;
    const most = Math.max(...k.map(Math.abs), 1e-12);
    const length = 0.22 * size * combLength.value / most;
    const tips = list.map(([, p], i) => [p[0] + length * k[i] * n[i][0], p[1] + length * k[i] * n[i][1]]);
    const visible = combLength.value > 0 && list.length > 0;
    comb.setAttribute("d", visible ? list.map(([, p], i) => path([p, tips[i]])).join("") : "");
    crown.setAttribute("d", visible ? path(tips, closed()) : "");
  }

  function handle(index) {
    const circle = element("circle", {r: 7, tabindex: 0, class: "handle", "aria-label": `control point ${index + 1}`});
    circle.addEventListener("pointerdown", (event) => {
      circle.setPointerCapture(event.pointerId);
      event.preventDefault();
      circle.focus();
    });
    circle.addEventListener("pointermove", (event) => {
      if (!circle.hasPointerCapture(event.pointerId)) return;
      points[index] = fromEvent(event);
      draw();
    });
    circle.addEventListener("dblclick", (event) => {
      event.stopPropagation();
      if (points.length <= 3 || config.vertices) return;
      points.splice(index, 1);
      edges = edges.map((list) => list && list.filter((_, j) => j !== index));
      select(Math.min(selected, edgeCount(points, ends.value) - 1));
    });
    circle.addEventListener("keydown", (event) => {
      const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
      if (!step) return;
      event.preventDefault();
      points[index] = points[index].map((x, c) => x + 5 * step[c] / unit);
      draw();
    });
    return circle;
  }

  // The edge nearest to a point, and where on it that is: from 0 to 1.
  function nearestEdge(p) {
    let best = [0, 0], least = Infinity;
    points.slice(0, edgeCount(points, ends.value)).forEach((a, j) => {
      const b = around(points, j + 1), d = difference(a, b);
      const along = ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / (d[0] * d[0] + d[1] * d[1] || 1);
      const t = Math.max(0, Math.min(1, along));
      const distance = Math.hypot(a[0] + t * d[0] - p[0], a[1] + t * d[1] - p[1]);
      if (distance < least) [best, least] = [[j, t], distance];
    });
    return best;
  }
  svg.addEventListener("click", (event) => {
    if (event.target.classList.contains("handle") || !edgeControls.some(Boolean)) return;
    select(nearestEdge(fromEvent(event))[0]);
  });
  // A new point on its edge; an open polygon goes on from its ends.
  svg.addEventListener("dblclick", (event) => {
    if (config.vertices) return;
    const p = fromEvent(event), [j, t] = nearestEdge(p);
    const before = !closed() && j === 0 && t === 0, after = !closed() && j === points.length - 2 && t === 1;
    const place = before ? 0 : after ? points.length : j + 1;
    points.splice(place, 0, p);
    edges = edges.map((list) => list && [...list.slice(0, place), list[Math.max(place - 1, 0)], ...list.slice(place)]);
    draw();
  });

  const button = (label, action) => {
    const b = element("button", {type: "button"}, label);
    b.addEventListener("click", action);
    return b;
  };
  // Edge parameters stand in the line of the point at which their edge begins.
  const csv = () => {
    if (config.vertices)
      return "fx,fy,px,py,rx,ry,sigma\n"
        + points.map((f, j) => [...f, ...config.vertices[j].p, ...config.vertices[j].r, config.vertices[j].sigma] + "\n").join("");
    const names = config.locals.flatMap((p) => (p.rest === undefined ? [] : [p.name]));
    const values = edges.filter(Boolean);
    return [["x", "y", ...names], ...points.map((p, j) => [...p, ...values.map((list) => list[j])])]
      .map((line) => line.join(",") + "\n").join("");
  };
  const buttons = element("p", {class: "buttons"},
    button("fit", () => { fit(); draw(); }),
    button("reset", () => {
      points = config.points.map((p) => p.slice());
      edges = edgeValues(points.length);
      ends.set("closed");
      config.levels.forEach((p, i) => levels[i].set(p.value));
      config.constants.forEach((p, i) => constants[i].set(p.value));
      steps.set(config.refinements);
      combLength.set(0.5);
      fit();
      select(0);
    }),
    button("copy points.csv", () => navigator.clipboard.writeText(csv())));
  const controls = [...levels.filter((_, i) => !config.levels[i].fixed), ...constants, ...edgeControls.filter(Boolean), ends, steps,
    combLength].map((c) => c.row);
  root.replaceChildren(svg, element("div", {class: "controls"}, ...controls, buttons, message, element("p", {}, command)));
  fit();
  draw();
}
