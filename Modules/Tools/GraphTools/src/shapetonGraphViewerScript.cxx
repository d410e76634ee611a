#include "shapetonGraphViewerScript.h"

namespace shapeton
{
const char *
GraphViewerStyle()
{
  return R"(
body { max-width: 84rem; }
.graphs { display: flex; flex-wrap: wrap; gap: 1rem; }
.graphs figure { margin: 0; flex: 1 1 20rem; max-width: 48rem; }
.graphs canvas { width: 100%; aspect-ratio: 1; border: 1px solid #ddd; touch-action: none; cursor: grab; display: block; }
.graphs figcaption { min-height: 1.5em; }
.switches label, .switches button, .switches select { margin-right: 1rem; }
)";
}

// Geometry as in shapetonModelSpace.cxx. On the sphere a Moebius transformation is a Lorentz matrix: points are
// light-like vectors (x, y, z, 1), caps de Sitter vectors (c / sin r, cos r / sin r).
const char *
GraphViewerScript()
{
  return R"__JS__(
'use strict';
for (const group of document.querySelectorAll('.graph-group')) (() => { // graphs of one geometry, moved together
const views = Array.from(group.querySelectorAll('canvas')).map(canvas => ({
  canvas, caption: canvas.parentNode.querySelector('figcaption'), context: canvas.getContext('2d'),
  data: JSON.parse(document.getElementById(canvas.dataset.graph).textContent) }));
const geometry = views[0].data.geometry;
const isSphere = geometry === 'spherical', isPlane = geometry === 'euclidean';
const show = {};
for (const box of group.querySelectorAll('.switches input')) {
  show[box.name] = box.checked;
  box.addEventListener('change', () => { show[box.name] = box.checked; redraw(); });
}
const chooser = group.querySelector('.switches select');
if (chooser) chooser.addEventListener('change', redraw);
group.querySelector('.switches button').addEventListener('click', () => { reset(); redraw(); });
let state;
function reset() {
  state = { lorentz: [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], a: [1,0], b: [0,0], scale: 1, turn: 0, x: 0, y: 0 };
  if (isSphere) { turnSphere(0.9, 0.5); }
}
// ---- complex numbers ----
const mul = (p, q) => [p[0]*q[0] - p[1]*q[1], p[0]*q[1] + p[1]*q[0]];
const conj = p => [p[0], -p[1]];
const div = (p, q) => { const n = q[0]*q[0] + q[1]*q[1]; return [(p[0]*q[0] + p[1]*q[1])/n, (p[1]*q[0] - p[0]*q[1])/n]; };
const add = (p, q) => [p[0] + q[0], p[1] + q[1]];
function moved(m, p) { return div(add(mul(m.a, p), m.b), add(mul(conj(m.b), p), conj(m.a))); }
function product(m, n) {
  return { a: add(mul(m.a, n.a), mul(m.b, conj(n.b))), b: add(mul(m.a, n.b), mul(m.b, conj(n.a))) };
}
function toPoint(p) { const s = 1/Math.sqrt(1 - p[0]*p[0] - p[1]*p[1]); return { a: [s, 0], b: [s*p[0], s*p[1]] }; }
function inverse(m) { return { a: conj(m.a), b: [-m.b[0], -m.b[1]] }; }
// ---- the sphere ----
function times(m, n) {
  const r = new Array(16).fill(0);
  for (let i = 0; i < 4; ++i) for (let j = 0; j < 4; ++j) for (let k = 0; k < 4; ++k) r[4*i + j] += m[4*i + k]*n[4*k + j];
  return r;
}
function apply(v) {
  const m = state.lorentz;
  return [0, 1, 2, 3].map(i => m[4*i]*v[0] + m[4*i + 1]*v[1] + m[4*i + 2]*v[2] + m[4*i + 3]*v[3]);
}
function turnSphere(dx, dy) {
  const c = Math.cos(dx), s = Math.sin(dx), d = Math.cos(dy), e = Math.sin(dy);
  state.lorentz = times([1,0,0,0, 0,d,-e,0, 0,e,d,0, 0,0,0,1], times([c,0,s,0, 0,1,0,0, -s,0,c,0, 0,0,0,1], state.lorentz));
}
function boost(u, rapidity) {
  const c = Math.cosh(rapidity), s = Math.sinh(rapidity), m = [];
  for (let i = 0; i < 3; ++i) { for (let j = 0; j < 3; ++j) m.push((i === j ? 1 : 0) + (c - 1)*u[i]*u[j]); m.push(s*u[i]); }
  m.push(s*u[0], s*u[1], s*u[2], c);
  state.lorentz = times(m, state.lorentz);
}
const isFlat = () => chooser.value === 'flat';
// A point of the model on the screen, with z in front of or behind it.
function spherePoint(p) {
  const v = apply([p[0], p[1], p[2], 1]), q = [v[0]/v[3], v[1]/v[3], v[2]/v[3]];
  return q;
}
function onScreen(view, q) {
  const R = view.R;
  if (!isSphere) return [view.c + R*q[0], view.c - R*q[1]];
  if (isFlat()) { const s = 0.45*R/Math.max(1e-9, 1 + q[2]); return [view.c + s*q[0], view.c - s*q[1]]; }
  return [view.c + R*q[0], view.c - R*q[1]];
}
const isSeen = q => !isSphere || (isFlat() ? q[2] > -0.995 : q[2] >= 0);
function between(p, q, t) {
  if (isSphere) {
    const dot = Math.min(1, Math.max(-1, p[0]*q[0] + p[1]*q[1] + p[2]*q[2])), angle = Math.acos(dot);
    if (angle < 1e-6) return p;
    const f = Math.sin((1 - t)*angle)/Math.sin(angle), g = Math.sin(t*angle)/Math.sin(angle);
    return [0, 1, 2].map(i => f*p[i] + g*q[i]);
  }
  const m = toPoint(p), w = moved(inverse(m), q), n = Math.hypot(w[0], w[1]);
  if (n < 1e-9) return p;
  const k = Math.tanh(t*Math.atanh(Math.min(n, 1 - 1e-15)))/n;
  return moved(m, [k*w[0], k*w[1]]);
}
const isKlein = () => !isSphere && !isPlane && chooser.value === 'klein';
// The motion of a tile: from places of the data to places that onScreen takes.
function placer(view, tile) {
  if (isSphere) return spherePoint;
  if (isPlane) {
    const u = view.unit*state.scale, t = [u*Math.cos(state.turn), u*Math.sin(state.turn)];
    return p => add(mul(t, [p[0] + tile.b[0] - view.middle[0], p[1] + tile.b[1] - view.middle[1]]), [state.x, state.y]);
  }
  const m = product({ a: state.a, b: state.b }, tile);
  return p => moved(m, p);
}
function shown(q) { // of the disk
  if (isPlane || isSphere) return q;
  const s = isKlein() ? 2/(1 + q[0]*q[0] + q[1]*q[1]) : 1;
  return [s*state.scale*q[0], s*state.scale*q[1]];
}
function trace(view, segments, place, step) {
  const g = view.context;
  g.beginPath();
  for (let i = 0; i < segments.length; i += 2*step) {
    const p = place(segments.slice(i, i + step)), q = place(segments.slice(i + step, i + 2*step));
    if (!isSeen(p) || !isSeen(q)) continue;
    const s = onScreen(view, shown(p)), e = onScreen(view, shown(q)), length = Math.hypot(e[0] - s[0], e[1] - s[1]);
    if (length < 0.4) continue;
    const pieces = isPlane || isKlein() ? 1 : Math.min(16, Math.ceil(length/25));
    g.moveTo(s[0], s[1]);
    for (let k = 1; k < pieces; ++k) { const r = onScreen(view, shown(between(p, q, k/pieces))); g.lineTo(r[0], r[1]); }
    g.lineTo(e[0], e[1]);
  }
  g.stroke();
}
// The circle as a path; returns its size in pixels, 0 when it is not seen.
function circle(view, c, r, place) {
  const g = view.context;
  g.beginPath();
  if (isSphere) {
    const v = apply([c[0]/Math.sin(r), c[1]/Math.sin(r), c[2]/Math.sin(r), Math.cos(r)/Math.sin(r)]);
    const n = Math.hypot(v[0], v[1], v[2]), u = [v[0]/n, v[1]/n, v[2]/n], s = Math.atan2(1, v[3]);
    if (isFlat()) return flatCap(view, u, s);
    const size = view.R*Math.sin(s);
    if (size < 0.3 || u[2] < -Math.sin(s)) return 0;
    if (s < 1.57 && u[2] > Math.sin(s)) {
      g.ellipse(view.c + view.R*Math.cos(s)*u[0], view.c - view.R*Math.cos(s)*u[1], size, size*Math.abs(u[2]),
                -Math.atan2(u[1], u[0]) - Math.PI/2, 0, 2*Math.PI);
      return size;
    }
    return partOfCap(view, u, s);
  }
  const q = place(c);
  if (isPlane) {
    const s = r*view.unit*state.scale*view.R, p = onScreen(view, q);
    if (s < 0.3 || p[0] < -s || p[1] < -s || p[0] > 2*view.c + s || p[1] > 2*view.c + s) return 0;
    g.arc(p[0], p[1], s, 0, 2*Math.PI);
    return s;
  }
  const n = Math.hypot(q[0], q[1]), d = 2*Math.atanh(Math.min(n, 1 - 1e-15));
  const far = Math.tanh((d + r)/2), near = Math.tanh((d - r)/2), size = view.R*state.scale*(far - near)/2;
  if (size < 0.3) return 0;
  const direction = n > 0 ? [q[0]/n, q[1]/n] : [1, 0];
  if (!isKlein()) {
    const p = onScreen(view, shown([direction[0]*(far + near)/2, direction[1]*(far + near)/2]));
    g.arc(p[0], p[1], size, 0, 2*Math.PI);
    return size;
  }
  const m = toPoint(q), t = Math.tanh(r/2);
  for (let k = 0; k < 28; ++k) {
    const p = onScreen(view, shown(moved(m, [t*Math.cos(k*Math.PI/14), t*Math.sin(k*Math.PI/14)])));
    k ? g.lineTo(p[0], p[1]) : g.moveTo(p[0], p[1]);
  }
  g.closePath();
  return size;
}
function flatCap(view, u, s) {
  const theta = Math.acos(Math.max(-1, Math.min(1, u[2]))), k = 0.45*view.R, h = Math.hypot(u[0], u[1]) || 1;
  const far = Math.tan((theta + s)/2), near = Math.tan((theta - s)/2), size = k*Math.abs(far - near)/2;
  if (size < 0.3 || size > 1e5) return 0;
  view.context.arc(view.c + k*(far + near)/2*u[0]/h, view.c - k*(far + near)/2*u[1]/h, size, 0, 2*Math.PI);
  return theta + s > Math.PI ? -size : size; // its inside is the outside there
}
function partOfCap(view, u, s) {
  const x0 = Math.abs(u[0]) < 0.7 ? [1 - u[0]*u[0], -u[0]*u[1], -u[0]*u[2]] : [-u[1]*u[0], 1 - u[1]*u[1], -u[1]*u[2]];
  const n = Math.hypot(...x0), x = x0.map(t => t/n);
  const y = [u[1]*x[2] - u[2]*x[1], u[2]*x[0] - u[0]*x[2], u[0]*x[1] - u[1]*x[0]], g = view.context;
  const number = 64, points = [];
  for (let k = 0; k < number; ++k) {
    const c = Math.cos(2*Math.PI*k/number), d = Math.sin(2*Math.PI*k/number);
    points.push([0, 1, 2].map(i => Math.cos(s)*u[i] + Math.sin(s)*(c*x[i] + d*y[i])));
  }
  const start = points.findIndex((p, k) => p[2] >= 0 && points[(k + number - 1) % number][2] < 0);
  if (start < 0) return 0;
  let last = null;
  for (let k = 0; k < number; ++k) {
    const p = points[(start + k) % number];
    if (p[2] < 0) break;
    const q = onScreen(view, p);
    last ? g.lineTo(q[0], q[1]) : g.moveTo(q[0], q[1]);
    last = p;
  }
  const first = points[start], a = Math.atan2(last[1], last[0]), b = Math.atan2(first[1], first[0]);
  const mid = t => Math.cos(t)*u[0] + Math.sin(t)*u[1] - Math.cos(s);
  const turn = (b - a + 4*Math.PI) % (2*Math.PI);
  g.arc(view.c, view.c, view.R, -a, -b, mid(a + turn/2) > 0); // along the limb, inside the cap
  return view.R*Math.sin(s);
}
function colorOf(data, node) { return data.colors ? data.colors[node] : '#f3b3ac'; }
function paintTile(view, tile, index) {
  const g = view.context, data = view.data, place = placer(view, tile), step = isSphere ? 3 : 2;
  const nodes = data.nodes, count = nodes.length/(step + 1);
  g.lineWidth = view.line;
  if (show.nodeCircles) {
    g.strokeStyle = '#c62828';
    for (let i = 0; i !== count; ++i) {
      const o = i*(step + 1), size = circle(view, nodes.slice(o, o + step), nodes[o + step], place);
      if (size > 0) { g.fillStyle = colorOf(data, i); g.fill(); }
      if (size) g.stroke();
    }
  }
  if (show.faceCircles) {
    g.strokeStyle = '#2e7d32';
    for (let o = 0; o !== data.faces.length; o += step + 1)
      if (circle(view, data.faces.slice(o, o + step), data.faces[o + step], place)) g.stroke();
  }
  if (show.graph) { g.strokeStyle = '#212121'; trace(view, data.edges, place, step); }
  if (show.dual) { g.strokeStyle = '#2e7d32'; trace(view, data.dual, place, step); }
  if (show.nodes || show.labels) paintNodes(view, place, step, index);
}
function paintNodes(view, place, step, index) {
  const g = view.context, data = view.data, nodes = data.nodes;
  g.font = '12px sans-serif';
  for (let o = 0, i = 0; o !== nodes.length; o += step + 1, ++i) {
    const q = place(nodes.slice(o, o + step));
    if (!isSeen(q)) continue;
    const p = onScreen(view, shown(q));
    if (show.nodes) {
      g.fillStyle = '#c62828';
      const rim = isPlane || isSphere ? 1 : 1 - q[0]*q[0] - q[1]*q[1], size = view.dot*rim;
      if (size > 0.4) { g.beginPath(); g.arc(p[0], p[1], size, 0, 2*Math.PI); g.fill(); }
    }
    if (show.labels && index === 0) { g.fillStyle = '#000'; g.fillText(data.names[i], p[0] + 5, p[1] - 5); }
  }
}
const pastel = ['#fff3c4', '#cfe8ff', '#ffd9d4', '#d6f5d6', '#eadcff', '#ffe3c2', '#d2f4f0', '#ffd6ec', '#e8f0c8', '#dfe3ee'];
function paintDomain(view, tile, index) {
  const g = view.context, d = view.data.domain, place = placer(view, tile);
  if (!show.tiles || d.length === 0) return;
  g.beginPath();
  for (let i = 0; i !== d.length; i += 2) {
    const p = onScreen(view, shown(place([d[i], d[i + 1]])));
    i ? g.lineTo(p[0], p[1]) : g.moveTo(p[0], p[1]);
  }
  g.closePath();
  g.fillStyle = pastel[index % pastel.length];
  g.strokeStyle = index ? '#b0a890' : '#8d6e00';
  g.fill();
  g.stroke();
}
function isTileSeen(view, tile) {
  if (isSphere) return true;
  const n = view.data.nodes, q = placer(view, tile)([n[0], n[1]]);
  if (isPlane) return Math.hypot(q[0], q[1]) < 8*Math.max(1, state.scale);
  return view.R*state.scale*(1 - q[0]*q[0] - q[1]*q[1]) > 3;
}
function paint(view) {
  const canvas = view.canvas, g = view.context, ratio = window.devicePixelRatio || 1;
  const size = canvas.clientWidth;
  canvas.width = canvas.height = Math.round(size*ratio);
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  g.lineJoin = 'round';
  view.c = size/2;
  view.R = 0.48*size;
  const elements = view.data.edges.length + 1;
  view.line = Math.max(0.3, Math.min(1.3, 60/Math.sqrt(elements)));
  view.dot = Math.max(1, Math.min(4, 90/Math.sqrt(elements)));
  view.unit = 1/view.data.extent;
  view.middle = view.data.middle;
  g.clearRect(0, 0, size, size);
  const tiles = [];
  for (let i = 0; i !== view.data.tiles.length; i += 4) {
    const t = view.data.tiles, tile = { a: [t[i], t[i + 1]], b: [t[i + 2], t[i + 3]] };
    if (isTileSeen(view, tile)) tiles.push([tile, i/4]);
  }
  for (const [tile, index] of tiles.slice().reverse()) paintDomain(view, tile, index);
  if (!isPlane && !(isSphere && isFlat())) {
    g.beginPath();
    g.arc(view.c, view.c, view.R*(isSphere ? 1 : state.scale), 0, 2*Math.PI);
    g.strokeStyle = '#9e9e9e';
    g.stroke();
  }
  for (const [tile, index] of tiles) paintTile(view, tile, index);
}
let isWaiting = false;
function redraw() {
  if (isWaiting) return;
  isWaiting = true;
  requestAnimationFrame(() => { isWaiting = false; views.forEach(paint); });
}
// ---- the mouse ----
function pointer(view, event) { // in units of the ball or disk
  const box = view.canvas.getBoundingClientRect();
  return [(event.clientX - box.left - view.c)/view.R, -(event.clientY - box.top - view.c)/view.R];
}
function underPointer(view, p) { // a unit vector of the sphere
  if (isFlat()) { const x = p[0]/0.45, y = p[1]/0.45, n = x*x + y*y; return [2*x/(1 + n), 2*y/(1 + n), (1 - n)/(1 + n)]; }
  const n = Math.hypot(p[0], p[1]);
  return n < 1 ? [p[0], p[1], Math.sqrt(1 - n*n)] : [p[0]/n, p[1]/n, 0];
}
function clamped(p) { const n = Math.hypot(p[0], p[1])/0.97; return n > 1 ? [p[0]/n, p[1]/n] : p; }
function drag(view, from, to, isShift) {
  const d = [to[0] - from[0], to[1] - from[1]], length = Math.hypot(d[0], d[1]);
  if (length === 0) return;
  if (isSphere) {
    isShift ? boost([d[0]/length, d[1]/length, 0], 1.2*length) : turnSphere(d[0], -d[1]);
  } else if (isShift) {
    const angle = Math.atan2(to[1], to[0]) - Math.atan2(from[1], from[0]);
    state.turn += angle;
    const r = { a: [Math.cos(angle/2), Math.sin(angle/2)], b: [0, 0] };
    const m = product(r, state); state.a = m.a; state.b = m.b;
    const p = mul([Math.cos(angle), Math.sin(angle)], [state.x, state.y]); state.x = p[0]; state.y = p[1];
  } else if (isPlane) {
    state.x += d[0]; state.y += d[1];
  } else {
    const s = state.scale, klein = p => { const n = p[0]*p[0] + p[1]*p[1], k = 1/(1 + Math.sqrt(Math.max(0, 1 - n))); return [k*p[0], k*p[1]]; };
    const at = p => { const q = clamped([p[0]/s, p[1]/s]); return isKlein() ? klein(q) : q; };
    const m = product(product(toPoint(at(to)), inverse(toPoint(at(from)))), state), n = Math.sqrt(m.a[0]**2 + m.a[1]**2 - m.b[0]**2 - m.b[1]**2);
    state.a = [m.a[0]/n, m.a[1]/n]; state.b = [m.b[0]/n, m.b[1]/n];
  }
}
function zoom(view, p, amount) {
  if (isSphere) { boost(underPointer(view, p), -amount); return; }
  const f = Math.exp(amount);
  state.scale = Math.min(1e6, Math.max(0.05, state.scale*f));
  if (isPlane) { state.x = p[0] + (state.x - p[0])*f; state.y = p[1] + (state.y - p[1])*f; }
}
function nameUnder(view, p) {
  const data = view.data, step = isSphere ? 3 : 2, place = placer(view, { a: [1, 0], b: [0, 0] });
  let best = 0.03, name = '';
  for (let o = 0, i = 0; o !== data.nodes.length; o += step + 1, ++i) {
    const q = place(data.nodes.slice(o, o + step));
    if (!isSeen(q)) continue;
    const s = onScreen(view, shown(q)), gap = Math.hypot((s[0] - view.c)/view.R - p[0], -(s[1] - view.c)/view.R - p[1]);
    if (gap < best) { best = gap; name = data.names[i]; }
  }
  return name;
}
for (const view of views) {
  let last = null;
  view.canvas.addEventListener('pointerdown', event => { last = pointer(view, event); view.canvas.setPointerCapture(event.pointerId); });
  view.canvas.addEventListener('pointerup', () => { last = null; });
  view.canvas.addEventListener('pointermove', event => {
    const p = pointer(view, event);
    if (last) { drag(view, last, p, event.shiftKey); last = p; redraw(); return; }
    const name = nameUnder(view, p);
    view.caption.textContent = view.data.title + (name ? ': node ' + name : '');
  });
  view.canvas.addEventListener('wheel', event => {
    event.preventDefault();
    zoom(view, pointer(view, event), -0.0015*event.deltaY);
    redraw();
  }, { passive: false });
}
window.addEventListener('resize', redraw);
reset();
redraw();
})();
)__JS__";
}
} // namespace shapeton
