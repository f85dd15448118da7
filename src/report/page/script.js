"use strict";
(() => {
const byId = id => document.getElementById(id);
const form = byId("/filters"), table = document.querySelector(".matrix");
// A large matrix comes as runs of equal cells: letters, and how often they stand side by side.
const shapes = { HP: "h p", HE: "h e", H: "h", FC: "f e", F: "f", N: "n", U: "u" };
for (const runs of [...table.querySelectorAll("td.runs")]) {
  const row = runs.parentNode;
  for (const run of runs.textContent.split(" ")) {
    const [, letters, w, x, n] = /^([A-Z]+|\.)(w?)(x?)(?:\*(\d+))?$/.exec(run);
    for (let k = 0; k < (n || 1); k++) {
      const cell = row.insertCell();
      if (letters === ".") continue;
      cell.className = [shapes[letters], w, x].filter(Boolean).join(" ");
      cell.textContent = letters + w + x;
    }
  }
  runs.remove();
}
const rows = [...table.tBodies[0].rows], heads = [...table.tHead.rows[0].cells].slice(1);
const names = rows.map(r => r.cells[0].textContent), motions = heads.map(h => h.textContent);

// ---- the address: #anchor?verdict=h,f&claim=…&trajectory=… ----
const read = () => {
  const hash = decodeURIComponent(location.hash.slice(1)), at = hash.indexOf("?");
  const q = new URLSearchParams(at < 0 ? "" : hash.slice(at + 1));
  return { anchor: at < 0 ? hash : hash.slice(0, at), verdict: (q.get("verdict") || "").split(",").filter(Boolean),
    claim: q.get("claim") || "", trajectory: q.get("trajectory") || "" };
};
const write = s => {
  const q = [];
  if (s.verdict.length) q.push("verdict=" + s.verdict.join(","));
  for (const k of ["claim", "trajectory"]) if (s[k]) q.push(k + "=" + encodeURIComponent(s[k]));
  return "#" + s.anchor + (q.length ? "?" + q.join("&") : "");
};

// A pair is `claim@trajectory` in the address, and /p, row and column on the page.
const placeOf = anchor => {
  const at = anchor.lastIndexOf("@");
  return at < 0 ? anchor : `/p${names.indexOf(anchor.slice(0, at))}-${motions.indexOf(anchor.slice(at + 1))}`;
};
const numbers = place => { const m = /^\/p(\d+)-(\d+)$/.exec(place); return m && names[m[1]] && motions[m[2]] ? [+m[1], +m[2]] : null; };
const addressOf = place => { const n = numbers(place); return n ? `${names[n[0]]}@${motions[n[1]]}` : place; };

// ---- filters ----
for (const [list, all] of [["/claim-names", names], ["/trajectory-names", motions]])
  for (const value of all) byId(list).appendChild(document.createElement("option")).value = value;
// A cell of no pair is empty.
const passes = (cell, s) => cell.textContent && (!s.verdict.length || s.verdict.some(v => cell.classList.contains(v)));
const like = (name, part) => !part || name.toLowerCase().includes(part.toLowerCase());
function filter(s) {
  const columns = motions.map(m => like(m, s.trajectory)), used = columns.map(() => false);
  let shown = 0;
  const kept = new Set();
  rows.forEach((row, i) => {
    let any = false;
    const named = like(names[i], s.claim);
    for (let j = 0; j < columns.length; j++) {
      const cell = row.cells[j + 1], on = named && columns[j] && passes(cell, s);
      cell.classList.toggle("off", !on);
      if (on) { any = used[j] = true; shown++; }
    }
    row.hidden = !any;
    if (any) kept.add(names[i]);
  });
  const all = !s.verdict.length && !s.claim && !s.trajectory;
  heads.forEach((h, j) => { h.hidden = !all && !used[j]; });
  rows.forEach(r => columns.forEach((_, j) => { r.cells[j + 1].hidden = !all && !used[j]; }));
  byId("/none").hidden = shown > 0;
  byId("/shown").textContent = all ? "" : shown + (shown === 1 ? " verdict" : " verdicts") + " shown";
  const words = { h: "holds", f: "fails", n: "not-applicable", u: "undecided" };
  for (const article of document.querySelectorAll("article.claim")) {
    // A claim over ranges has no row, and no verdict on a trajectory.
    const alone = !names.includes(article.id) && !s.verdict.length && !s.trajectory && like(article.id, s.claim);
    article.hidden = !all && !kept.has(article.id) && !alone;
  }
  for (const family of document.querySelectorAll(".family"))
    family.hidden = ![...family.querySelectorAll("article.claim")].some(a => !a.hidden);
  for (const group of document.querySelectorAll(".verdicts")) {
    group.hidden = s.verdict.length > 0 && !s.verdict.some(v => group.classList.contains(words[v] ?? v));
  }
  for (const row of document.querySelectorAll(".verdicts tbody tr[id]"))
    row.hidden = !like(motions[numbers(row.id)[1]], s.trajectory);
}
function fill(s) {
  for (const box of form.elements.verdict) box.checked = s.verdict.includes(box.value);
  form.elements.claim.value = s.claim;
  form.elements.trajectory.value = s.trajectory;
}
let state = read();
const asked = () => ({ anchor: "/matrix", verdict: [...form.elements.verdict].filter(b => b.checked).map(b => b.value),
  claim: form.elements.claim.value.trim(), trajectory: form.elements.trajectory.value.trim() });
form.addEventListener("input", () => { state = asked(); history.replaceState(null, "", write(state)); filter(state); });
form.addEventListener("reset", () => setTimeout(() => { state = asked(); history.replaceState(null, "", write(state)); filter(state); }));
form.addEventListener("submit", e => e.preventDefault());

// Links keep the filters in the address.
document.addEventListener("click", e => {
  const link = e.target.closest && e.target.closest('a[href^="#"]');
  if (!link || e.ctrlKey || e.metaKey || e.shiftKey) return;
  e.preventDefault();
  const to = write({ ...state, anchor: addressOf(decodeURIComponent(link.getAttribute("href").slice(1))) });
  if (to === decodeURIComponent(location.hash)) go(); else location.hash = to;
});
function go() {
  state = read();
  fill(state);
  filter(state);
  const place = placeOf(state.anchor), target = state.anchor && byId(place), n = numbers(place);
  // A pair may stand in a table that is still folded away.
  const away = !target && n && byId(names[n[0]]) ? [...byId(names[n[0]]).querySelectorAll("details[data-k]")] : [];
  if (away.length) unpacked().then(() => { away.forEach(unfold); if (byId(place)) go(); }, () => {});
  if (!target) return;
  for (let e = target; e; e = e.parentElement) { if (e.tagName === "DETAILS") e.open = true; if (e.hidden) e.hidden = false; }
  for (const old of document.querySelectorAll("tr.here")) old.classList.remove("here");
  if (target.tagName === "TR") { target.classList.add("here"); open(target); }
  if (!target.matches("a,input,button,summary")) target.tabIndex = -1;
  target.focus({ preventScroll: true });
  target.scrollIntoView({ block: "start" });
}
addEventListener("hashchange", go);

// The letters of a cell as words; the caption says what they mean.
const meaning = new Map([...table.caption.querySelectorAll("[data-l]")].map(e => [e.dataset.l, e.textContent.split(": ")[1]]));
const inWords = cell => /^([A-Z]*)(w?)(x?)$/.exec(cell.textContent).slice(1).filter(Boolean).map(l => meaning.get(l)).join(", ");
// What a cell is, for those who point at it.
table.addEventListener("mouseover", e => {
  const cell = e.target.closest("tbody td, tbody th");
  if (!cell || cell.title || cell.cellIndex && !cell.textContent) return;
  const name = names[rows.indexOf(cell.parentNode)];
  cell.title = cell.cellIndex ? `${name} on ${motions[cell.cellIndex - 1]}: ${inWords(cell)}` : name;
});

// ---- cells lead to their pairs; keys in the matrix: one stop, arrows inside ----
const leads = cell => {
  const i = rows.indexOf(cell.parentNode), j = cell.cellIndex - 1;
  const to = write({ ...state, anchor: `${names[i]}@${motions[j]}` });
  if (to === decodeURIComponent(location.hash)) go(); else location.hash = to;
};
table.addEventListener("click", e => {
  const cell = e.target.closest("tbody td[class]");
  if (cell && !cell.classList.contains("off")) leads(cell);
});
const cells = () => rows.filter(r => !r.hidden).map(r => [...r.cells].slice(1).filter(c => !c.hidden));
const first = table.querySelector("tbody td[class]");
if (first) first.tabIndex = 0;
table.addEventListener("keydown", e => {
  const here = e.target.closest("td");
  if (here && e.key === "Enter") leads(here);
  const step = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0] }[e.key];
  if (!step || !here) return;
  const grid = cells();
  let y = grid.findIndex(r => r.includes(here)), x = y < 0 ? -1 : grid[y].indexOf(here);
  for (;;) {
    y += step[0]; x += step[1];
    const cell = grid[y] && grid[y][x];
    if (!cell) break;
    if (cell.className && !cell.classList.contains("off")) {
      for (const old of table.querySelectorAll('td[tabindex="0"]')) old.tabIndex = -1;
      cell.tabIndex = 0;
      cell.focus();
      break;
    }
  }
  e.preventDefault();
});

// ---- the curves of a pair ----
const DIGITS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%()*+,-./:;=?@[]^_{|", ONE_DIGIT = 60;
const digit = new Map([...DIGITS].map((c, i) => [c, i]));
// The data are packed: base 85 of a zlib stream of JSON. They are not unpacked before a curve is asked for.
let data, numbered, ready;
const unpacked = () => ready ||= (async () => {
  const text = byId("/data").textContent, bytes = new Uint8Array(Math.floor(text.length * 4 / 5));
  for (let i = 0, at = 0; i < text.length; i += 5, at += 4) {
    let word = 0;
    for (let k = 0; k < 5; k++) word = word * 85 + (i + k < text.length ? digit.get(text[i + k]) : 84);
    for (let k = 0; k < 4 && at + k < bytes.length; k++) bytes[at + k] = Math.floor(word / 256 ** (3 - k)) % 256;
  }
  data = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).json();
  // Pairs are numbered as they come.
  let pair = 0;
  numbered = new Map(data.pairs.map(([claim, columns]) => [claim, new Map(columns.map(c => [c, pair++]))]));
})();
const stored = x => Array.isArray(x) ? x.map(stored).join("") : typeof x === "number" ? data.strings[x] : x;
// A column: the changes of places among so many steps over the range, even numbers up, odd ones down; what is at 0 has no value.
const unpack = (packed, low, high, steps) => {
  const text = stored(packed), out = [];
  for (let i = 0, place = 0; i < text.length; i++) {
    let n = digit.get(text[i]);
    if (n >= ONE_DIGIT) n = ONE_DIGIT + (n - ONE_DIGIT) * DIGITS.length + digit.get(text[++i]);
    place += n % 2 ? -(n + 1) / 2 : n / 2;
    out.push(place ? low + (high - low) * (place - 1) / (steps - 1) : -Infinity);
  }
  return out;
};
const STEPS = { time: 1020, side: 255, logarithm: 85 };
const pairOf = place => {
  const n = numbers(place), k = n ? numbered.get(names[n[0]])?.get(n[1]) : undefined;
  const row = columns => columns[0][k] === null ? null : columns.map(c => c[k]);
  return k === undefined ? undefined : [row(data.curves), row(data.worst), row(data.witness), data.excluded[k]];
};
const SVG = "http://www.w3.org/2000/svg";
const add = (parent, name, attributes, text) => {
  const e = document.createElementNS(SVG, name);
  for (const k in attributes) e.setAttribute(k, attributes[k]);
  if (text !== undefined) e.textContent = text;
  return parent.appendChild(e);
};
const element = (parent, name, attributes, text) => {
  const e = document.createElement(name);
  for (const k in attributes || {}) e.setAttribute(k, attributes[k]);
  if (text !== undefined) e.textContent = text;
  return parent.appendChild(e);
};
const nice = (low, high, n) => {
  const raw = (high - low) / n || 1, power = 10 ** Math.floor(Math.log10(raw)), f = raw / power;
  const step = (f > 5 ? 10 : f > 2 ? 5 : f > 1 ? 2 : 1) * power, out = [];
  for (let x = Math.ceil(low / step - 1e-9) * step; x <= high + step * 1e-9; x += step) out.push(Math.abs(x) < step * 1e-9 ? 0 : x);
  return out;
};
// Numbers as the rest of the page has them: −0.25, 1.2·10⁻¹⁴.
const numeral = text => {
  const [, digits, power] = /^([^e]*)(?:e\+?(-?\d+))?$/.exec(text) || [0, text], high = c => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c];
  const short = power ? digits.replace(/\.0$/, "") : digits;
  return (power ? (Math.abs(+short) === 1 ? short.replace("1", "") : short + "·") + "10" + [...power].map(high).join("") : short).replace("-", "−");
};
const shown = x => { const a = Math.abs(x); return x === 0 ? "0" : numeral(a >= 1e5 || a < 1e-3 ? x.toExponential(1) : String(+x.toPrecision(4))); };
// As finely as curves are drawn: a value, and one of which the logarithm is drawn.
const short = x => shown(+x.toPrecision(3)), power = x => Number.isFinite(x) ? numeral((10 ** x).toExponential(1)) : "0";
// On a narrow screen the drawing is narrow, not its letters small.
const W = Math.min(640, Math.max(340, innerWidth - 50)), H = 300, L = 76, R = 14, T = 12, B = 46;
function frame(svg, { title, describe, label }, time, range, ticks) {
  svg.replaceChildren();
  add(svg, "title", {}, title);
  add(svg, "desc", {}, describe);
  const X = t => L + (W - L - R) * (t - time[0]) / (time[1] - time[0] || 1);
  const Y = y => H - B - (H - T - B) * Math.min(1, Math.max(0, (y - range[0]) / (range[1] - range[0] || 1)));
  for (const [y, text] of ticks) {
    add(svg, "line", { class: "grid", x1: L, x2: W - R, y1: Y(y), y2: Y(y) });
    add(svg, "text", { x: L - 6, y: Y(y) + 4, "text-anchor": "end", "font-size": 13 }, text);
  }
  for (const t of nice(time[0], time[1], W < 500 ? 4 : 6)) {
    add(svg, "line", { class: "axis", x1: X(t), x2: X(t), y1: H - B, y2: H - B + 5 });
    add(svg, "text", { x: X(t), y: H - B + 19, "text-anchor": "middle", "font-size": 13 }, shown(t));
  }
  add(svg, "path", { class: "axis", d: `M${L},${T}V${H - B}H${W - R}` });
  add(svg, "text", { x: (L + W - R) / 2, y: H - 8, "text-anchor": "middle", "font-size": 13 }, "t" + (data.unit ? ` (${data.unit})` : ""));
  add(svg, "text", { x: 14, y: (T + H - B) / 2, "text-anchor": "middle", "font-size": 13, transform: `rotate(-90 14 ${(T + H - B) / 2})` }, label);
  return { svg, X, Y };
}
const six = x => Number.isFinite(+x) ? numeral(String(+(+x).toPrecision(6))) : x;
let clips = 0;
// A drawing that can be asked: values under the pointer or the arrow keys, a stretch by dragging or + and −, lines one by one.
// `lines` are [name, words, values, value as text]; `paint` draws all else.
function plot(box, words, whole, range, ticks, t, lines, draw, paint) {
  const figure = element(box, "figure"), svg = add(figure, "svg", { viewBox: `0 0 ${W} ${H}`, role: "img", tabindex: 0 });
  const legend = element(figure, "p", { class: "keys" }), told = element(figure, "output", { class: "quiet" });
  const clip = "/clip" + ++clips;
  let time = whole, p, at = -1, from = null;
  const off = new Set();
  const redraw = () => {
    p = frame(svg, words, time, range, ticks);
    paint(p, time);
    const inside = t.map((x, i) => i).filter(i => (i + 1 < t.length ? t[i + 1] : t[i]) >= time[0] && (i ? t[i - 1] : t[i]) <= time[1]);
    for (const [name, , ys] of lines) if (!off.has(name)) draw(p, inside.map(i => t[i]), inside.map(i => ys[i]), name);
    add(add(svg, "clipPath", { id: clip }), "rect", { x: L, width: W - L - R, y: 0, height: H });
    for (const e of svg.querySelectorAll(".curve, .event")) e.setAttribute("clip-path", `url(#${clip})`);
    if (at >= 0) tell(at);
  };
  const tell = i => {
    at = Math.min(t.length - 1, Math.max(0, i));
    svg.querySelector(".here")?.remove();
    if (t[at] >= time[0] && t[at] <= time[1]) add(svg, "line", { class: "here", x1: p.X(t[at]), x2: p.X(t[at]), y1: T, y2: H - B });
    told.textContent = `t = ${shown(+t[at].toPrecision(4))}: ` + lines.filter(l => !off.has(l[0])).map(l => `${l[1]} ${l[3](l[2][at])}`).join(", ");
  };
  const timeAt = e => {
    const r = svg.getBoundingClientRect(), x = (e.clientX - r.left) * W / r.width;
    return time[0] + (time[1] - time[0]) * Math.min(1, Math.max(0, (x - L) / (W - L - R)));
  };
  const nearest = x => t.reduce((best, v, i) => Math.abs(v - x) < Math.abs(t[best] - x) ? i : best, 0);
  const zoom = stretch => { time = stretch && stretch[1] - stretch[0] > (whole[1] - whole[0]) / 1e4 ? stretch : whole; redraw(); };
  const about = factor => {
    const middle = at < 0 ? (time[0] + time[1]) / 2 : t[at], half = (time[1] - time[0]) * factor / 2;
    const left = Math.max(whole[0], Math.min(middle - half, whole[1] - 2 * half));
    zoom(factor > 1 && 2 * half >= whole[1] - whole[0] ? null : [left, left + 2 * half]);
  };
  svg.addEventListener("pointerdown", e => { from = timeAt(e); });
  svg.addEventListener("pointermove", e => tell(nearest(timeAt(e))));
  svg.addEventListener("pointerup", e => {
    const to = timeAt(e), [a, b] = [Math.min(from ?? to, to), Math.max(from ?? to, to)];
    from = null;
    if (b - a > (time[1] - time[0]) / 50) zoom([a, b]);
  });
  svg.addEventListener("dblclick", () => zoom(null));
  svg.addEventListener("keydown", e => {
    const keys = { ArrowLeft: () => tell(at < 0 ? t.length - 1 : at - 1), ArrowRight: () => tell(at + 1), "+": () => about(.5), "-": () => about(2), Escape: () => zoom(null) };
    if (!keys[e.key]) return;
    keys[e.key]();
    e.preventDefault();
  });
  for (const [name, text] of lines) {
    const key = element(legend, "button", { type: "button", "aria-pressed": "true" });
    element(key, "span", { class: "key " + name, "aria-hidden": "true" });
    key.append(text);
    key.addEventListener("click", () => {
      const hide = !off.has(name);
      if (hide) off.add(name); else off.delete(name);
      key.setAttribute("aria-pressed", String(!hide));
      redraw();
    });
  }
  element(legend, "span", { class: "quiet" }, "Point or ← → for values, drag or + for a stretch, Esc for all.");
  redraw();
  return figure;
}
const grey = (p, stretches, time) => {
  for (const [a, b] of stretches || []) {
    const x0 = p.X(Math.max(a, time[0])), x1 = p.X(Math.min(b, time[1]));
    if (x1 >= x0) add(p.svg, "rect", { class: "outside", x: x0 - 1, width: x1 - x0 + 2, y: T, height: H - T - B });
  }
};
function open(row) {
  const next = row.nextElementSibling;
  if (next && next.classList.contains("pair")) return;
  const detail = document.createElement("tr");
  detail.className = "pair";
  const box = element(detail, "td", { colspan: row.cells.length });
  row.after(detail);
  const [i, j] = numbers(row.id), head = element(box, "p");
  element(head, "a", { href: "#" + names[i] }, names[i]);
  head.append(" on ");
  element(head, "a", { href: "#/trajectory/" + motions[j] }, motions[j]);
  head.append(": ");
  element(head, "b", {}, inWords(rows[i].cells[j + 1]));
  head.append(".");
  unpacked().then(() => {
    const pair = pairOf(row.id) || [];
    if (pair[0]) curves(box, pair, addressOf(row.id));
    else element(box, "p", { class: "quiet" }, "No curve: two sides were not compared at more than one time. The row above says what was found, and how.");
    if (pair[2]) witness(box, pair[2]);
    if (row.classList.contains("here")) row.scrollIntoView({ block: "start" });
  }, () => element(box, "p", { class: "quiet" }, "This browser cannot unpack the curves. The numbers are in report.json."));
}
// A smooth line through samples, without values beyond theirs (tangents: harmonic means of slopes); events are points, each with its time marked below.
const line = (p, xs, ys, name) => {
  const X = xs.map(p.X), Y = ys.map(p.Y), n = X.length;
  const slope = X.slice(1).map((x, i) => (Y[i + 1] - Y[i]) / (x - X[i] || 1));
  const m = X.map((_, i) => {
    const a = slope[Math.max(0, i - 1)], b = slope[Math.min(n - 2, i)];
    return a * b > 0 ? 2 * a * b / (a + b) : 0;
  });
  const at = (x, y) => x.toFixed(1) + "," + y.toFixed(1);
  const part = i => { const h = (X[i + 1] - X[i]) / 3; return `C${at(X[i] + h, Y[i] + m[i] * h)} ${at(X[i + 1] - h, Y[i + 1] - m[i + 1] * h)} ${at(X[i + 1], Y[i + 1])}`; };
  add(p.svg, "path", { class: "curve " + name, d: "M" + at(X[0], Y[0]) + slope.map((_, i) => part(i)).join("") });
};
const points = (p, xs, ys, name) => xs.forEach((x, i) => {
  if (!Number.isFinite(ys[i])) return;
  const cx = p.X(x).toFixed(1), cy = p.Y(ys[i]).toFixed(1);
  add(p.svg, "path", { class: "event " + name, d: name === "left" ? `M${cx} ${cy}m-4 0a4 4 0 108 0a4 4 0 10-8 0` : `M${cx} ${cy}m-4-4l8 8m0-8l-8 8` });
});
const marked = (p, xs) => xs.forEach(x => add(p.svg, "line", { class: "when", x1: p.X(x), x2: p.X(x), y1: T, y2: H - B }));
function curves(box, [packed, w, found, left_out], id) {
  const [formula, samples, [low, high], span, decades, at, lefts, rights, residuals, bounds, pass] = packed;
  const t = unpack(at, ...span, STEPS.time), time = [...span], sought = pass === 0;
  const event = data.events[id.slice(0, id.lastIndexOf("@"))], draw = event === undefined ? line : points;
  for (const [a, b] of left_out || []) { time[0] = Math.min(time[0], a); time[1] = Math.max(time[1], b); }
  const d = unpack(residuals, ...decades, STEPS.logarithm), b = unpack(bounds, ...decades, STEPS.logarithm);
  const head = element(box, "p", {}, sought ? "Looked for: " : "Compared: ");
  head.insertAdjacentHTML("beforeend", stored(formula));
  if (event !== undefined) head.insertAdjacentHTML("beforeend", ", each time " + stored(event) + ".");
  const times = event === undefined ? (sought && found ? [found[1]] : []) : t;
  const log = x => Math.log10(x);
  const all = [...d, ...b].filter(Number.isFinite);
  if (pass) all.push(log(pass));
  if (w && w[1] > 0) all.push(log(w[1]));
  if (!all.length) all.push(-16, 0);
  let bottom = Math.floor(Math.min(...all) - .3), top = Math.ceil(Math.max(...all, bottom + 2) + .3);
  const every = Math.max(1, Math.ceil((top - bottom) / 7)), ticks = [];
  for (let e = Math.ceil(bottom / every) * every; e <= top; e += every) ticks.push([e, "10" + [...String(e)].map(c => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]).join("")]);
  const what = event === undefined ? "samples" : "events";
  const worst = !w ? "" : sought ? `The sides come closest at t = ${shown(w[0])}: ${shown(w[1])} apart, error bound ${shown(w[2])}.`
    : `The worst point, in units of its bound, is at t = ${shown(w[0])}: residual ${shown(w[1])}, bound ${shown(w[2])}.`;
  const drawn = `${t.length} of ${samples} ${what} are drawn${stored(formula).includes("±") ? ", with the sign of ± that does best at each" : ""}`;
  const when = event !== undefined ? ` Upright lines mark the events: t = ${t.map(shown).join(", ")}.` : times.length ? ` The upright line marks where it was found, t = ${shown(times[0])}.` : "";
  const name = sought ? "distance" : "residual";
  let words = { title: "Residual of " + id, describe: `${drawn}, on a logarithmic scale. ${worst}${when}`, label: name };
  const lines = [["left", name, d, power], ["bound", "error bound", b, power]];
  let figure = plot(box, words, time, [bottom, top], ticks, t, lines, draw, (p, time) => {
    grey(p, left_out, time);
    marked(p, times.filter(x => x >= time[0] && x <= time[1]));
    if (pass) line(p, time, [log(pass), log(pass)], "pass");
    if (w && w[1] > 0 && w[0] >= time[0] && w[0] <= time[1]) add(p.svg, "circle", { class: "worst", cx: p.X(w[0]), cy: p.Y(log(w[1])), r: 6 });
  });
  const [one, two] = event === undefined ? ["solid", "dashed"] : ["circles", "crosses"];
  const rule = sought ? `How far the sides are apart (${one}) and the error bound of that (${two}): the relation is looked for, so a small distance is a find.`
    : `Residual (${one}) and its error bound (${two})` + (pass ? "; an equation passes where the residual is below its bound and the bound below the dotted line, the precision asked for." : ".");
  element(figure, "figcaption", {}, `${rule} ${worst}${when}${left_out ? " Grey: times left out." : ""} ${drawn}.`);
  const l = unpack(lefts, low, high, STEPS.side), r = rights === null ? l : unpack(rights, low, high, STEPS.side);
  const pad = (high - low) * .06 || Math.abs(high) * .1 || 1, range = [low - pad, high + pad];
  words = { title: "Both sides of " + id, describe: `The left side (${one}), the right side (${two}).`, label: "both sides" };
  const sides = [["left", "left side", l, short], ["right", "right side", r, short]];
  figure = plot(box, words, time, range, nice(range[0], range[1], 5).map(y => [y, shown(y)]), t, sides, draw, (q, time) => {
    grey(q, left_out, time);
    marked(q, times.filter(x => x >= time[0] && x <= time[1]));
  });
  element(figure, "figcaption", {}, `Left side (${one}) and right side (${two})` + (l === r ? ": they agree to the width of the line." : "."));
  numbersOf(box, t, l, r, d, b, what);
}
// What is drawn, for those who do not see it.
function numbersOf(box, t, l, r, d, b, what) {
  const more = element(box, "details");
  element(more, "summary", {}, `The ${what} that are drawn, as numbers`);
  more.addEventListener("toggle", () => {
    if (more.lastChild.tagName === "DIV") return;
    const scroll = element(more, "div", { class: "scroll", tabindex: 0, role: "group", "aria-label": "Numbers of the curves" }), table = element(scroll, "table");
    const head = element(element(table, "thead"), "tr"), body = element(table, "tbody");
    for (const name of ["t", "left side", "right side", "residual", "error bound"]) element(head, "th", { scope: "col" }, name);
    t.forEach((x, i) => {
      const row = element(body, "tr");
      for (const text of [short(x), short(l[i]), short(r[i]), power(d[i]), power(b[i])]) element(row, "td", { class: "number" }, text);
    });
    element(more, "p", { class: "quiet" }, "As finely as they are drawn: sides to some thousandths of the height, residual and bound to a hundredth.");
  });
}
function witness(box, [label, t, left, right, bound, names, values]) {
  const p = element(box, "p", {}, `At t = ${six(t)} the left side is ${six(left)}, the right side ${six(right)}, with an error bound of ${six((+bound).toPrecision(2))}: `);
  p.insertAdjacentHTML("beforeend", stored(label));
  element(box, "pre", { tabindex: 0 }, stored(names).split("\n").map((name, i) => `${name} = ${values[i]}\n`).join("") + `left = ${left}\nright = ${right}`);
}

// A picture of a motion can be asked, too: values under the pointer or the arrow keys, lines one by one.
const pictures = new WeakMap();
function ask(figure) {
  if (pictures.has(figure)) return pictures.get(figure);
  const svg = figure.querySelector("svg"), [x0, x1, y0, y1, a, b, c, d] = svg.dataset.axes.split(" ").map(Number);
  // The points of a path of lines, of which later ones are told from the one before.
  const points = text => {
    const out = [];
    let x = 0, y = 0;
    for (const [, kind, list] of text.matchAll(/([Mlhv])([^Mlhv]*)/g)) {
      const n = (list.match(/-?\d+/g) || []).map(Number);
      for (let i = 0; i < n.length; i += kind === "h" || kind === "v" ? 1 : 2) {
        if (kind === "M" && !i) [x, y] = n; else if (kind === "h") x += n[i]; else if (kind === "v") y += n[i]; else [x, y] = [x + n[i], y + n[i + 1]];
        out.push([x, y]);
      }
    }
    return out;
  };
  const keys = [...figure.querySelectorAll("figcaption .key")], lines = [...svg.querySelectorAll("path[class^=c]")];
  const of = lines.map(path => points(path.getAttribute("d"))), value = y => c + (d - c) * (y - y0) / (y1 - y0), time = x => a + (b - a) * (x - x0) / (x1 - x0);
  const told = element(figure, "output", { class: "quiet" }), plane = figure.classList.contains("curve");
  const name = k => keys[k]?.parentElement.textContent.trim() || "";
  let at = x0;
  const tell = (x, y) => {
    at = Math.min(x1, Math.max(x0, x));
    const near = k => of[k].reduce((best, p) => (plane ? Math.hypot(p[0] - x, p[1] - y) < Math.hypot(best[0] - x, best[1] - y) : Math.abs(p[0] - at) < Math.abs(best[0] - at)) ? p : best);
    const seen = lines.map((line, k) => k).filter(k => of[k].length && lines[k].style.display !== "none");
    told.textContent = plane ? seen.slice(0, 1).map(k => near(k)).map(p => `(${shown(time(p[0]))}, ${shown(value(p[1]))})`).join("")
      : `at ${shown(+time(at).toPrecision(4))}: ` + seen.map(k => `${name(k)} ${shown(+value(near(k)[1]).toPrecision(3))}`).join(", ");
  };
  keys.forEach((key, k) => {
    const button = document.createElement("button");
    button.type = "button";
    button.setAttribute("aria-pressed", "true");
    const name = key.parentElement;
    name.before(button);
    button.append(name);
    button.addEventListener("click", () => {
      const hide = button.getAttribute("aria-pressed") === "true";
      button.setAttribute("aria-pressed", String(!hide));
      for (const line of svg.querySelectorAll(".c" + k)) line.style.display = hide ? "none" : "";
    });
  });
  const place = e => {
    const r = svg.getBoundingClientRect(), box = svg.viewBox.baseVal;
    tell((e.clientX - r.left) * box.width / r.width, (e.clientY - r.top) * box.height / r.height);
  };
  svg.addEventListener("pointermove", place);
  svg.addEventListener("keydown", e => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[e.key];
    if (step && !plane) { tell(at + step * (x1 - x0) / 50, 0); e.preventDefault(); }
  });
  pictures.set(figure, tell);
  return tell;
}
for (const event of ["pointerover", "focusin"]) document.addEventListener(event, e => {
  const svg = e.target.closest?.("figure.picture svg[data-axes]");
  if (svg) ask(svg.parentElement);
});

// What is folded comes into the page when it is asked for.
function unfold(details) {
  if (details.dataset.k === undefined) return;
  details.insertAdjacentHTML("beforeend", data.folds[details.dataset.k]);
  delete details.dataset.k;
  filter(state);
}
// Rows get a link to their curves when their table is opened.
document.addEventListener("toggle", e => {
  if (!e.target.open || !e.target.matches("details")) return;
  if (e.target.dataset.k !== undefined) unpacked().then(() => unfold(e.target), () => {});
  if (!e.target.matches(".verdicts")) return;
  unpacked().then(() => {
    for (const row of e.target.querySelectorAll("tbody tr[id]")) {
      if (!pairOf(row.id) || row.dataset.linked) continue;
      row.dataset.linked = "1";
      const cell = row.cells[row.cells.length - 1];
      cell.append(" ");
      element(cell, "a", { href: "#" + row.id, "aria-label": "Curves and numbers of " + addressOf(row.id) }, "curves");
    }
  }, () => {});
}, true);

// A formula that is wider than its place says so.
const wide = () => {
  for (const box of document.querySelectorAll(".formula")) {
    const hidden = box.scrollWidth > box.clientWidth + 1, note = box.nextElementSibling;
    const noted = note && note.classList.contains("more");
    if (hidden && !noted) { const p = document.createElement("p"); p.className = "more"; p.textContent = "→ the formula goes on: scroll it sideways"; box.after(p); }
    if (!hidden && noted) note.remove();
  }
};
addEventListener("resize", wide);
wide();
form.hidden = false;
go();
})();
