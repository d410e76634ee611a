// node RunViewer.js REPORT.html
//
// Runs the script of a report of a cube on the sphere on a page and a canvas that are made up, moves the view with the mouse,
// and checks what is painted: in the stereographic picture circles of neighbours touch before and after.
'use strict';
const assert = require('assert');
const html = require('fs').readFileSync(process.argv[2], 'utf8');
const size = 800;
const edges = [];
const data = JSON.parse(html.match(/<script type="application\/json" id="graph0">([^<]*)<\/script>/)[1]);
const nodeAt = i => data.nodes.slice(4*i, 4*i + 3);
for (let a = 0; a < 8; ++a) for (let b = 0; b < a; ++b) {
  const dot = nodeAt(a).reduce((sum, x, k) => sum + x*nodeAt(b)[k], 0);
  if (Math.abs(Math.acos(dot) - data.nodes[4*a + 3] - data.nodes[4*b + 3]) < 1e-6) edges.push([a, b]);
}
assert.strictEqual(edges.length, 12);

let arcs = [];
let current = null;
const context = new Proxy({}, {
  get: (target, name) => name === 'arc' ? (x, y, r) => { current = [x, y, r]; }
    : name === 'beginPath' ? () => { current = null; }
    : name === 'stroke' ? () => { if (current && target.strokeStyle === '#c62828') arcs.push(current); }
    : name in target ? target[name] : () => {},
  set: (target, name, value) => { target[name] = value; return true; } });
const handlers = {};
const caption = { textContent: '' };
const canvas = { dataset: { graph: 'graph0' }, clientWidth: size, parentNode: { querySelector: () => caption },
  getContext: () => context, addEventListener: (name, handler) => { handlers[name] = handler; },
  getBoundingClientRect: () => ({ left: 0, top: 0 }), setPointerCapture: () => {} };
const boxes = [...html.matchAll(/name="([^"]+)"( checked="checked")?/g)].map(found =>
  ({ name: found[1], checked: found[2] !== undefined && found[1] !== 'nodes', addEventListener: () => {} }));
const chooser = { value: 'flat', addEventListener: () => {} };
const group = { querySelectorAll: what => what === 'canvas' ? [canvas] : boxes,
  querySelector: what => what.endsWith('select') ? chooser : { addEventListener: () => {} } };
global.document = { querySelectorAll: () => [group],
  getElementById: () => ({ textContent: JSON.stringify(data) }) };
global.window = { devicePixelRatio: 1, addEventListener: () => {} };
global.requestAnimationFrame = paint => { arcs = []; paint(); };

function checkTangency(when) {
  assert.strictEqual(arcs.length, 8, when + ': circles');
  for (const [a, b] of edges) {
    const [x, y, r] = arcs[a], [u, v, s] = arcs[b], distance = Math.hypot(x - u, y - v);
    const gap = Math.min(Math.abs(distance - r - s), Math.abs(distance - Math.abs(r - s))); // one may be around the rest
    assert.ok(gap < 1e-4*(r + s), `${when}: circles ${a} and ${b} miss by ${gap} pixels`);
  }
}
function drag(from, to, shiftKey) {
  const event = p => ({ clientX: p[0], clientY: p[1], shiftKey, pointerId: 1 });
  handlers.pointerdown(event(from));
  handlers.pointermove(event(to));
  handlers.pointerup(event(to));
}

new Function(html.match(/<script>\/\/<!\[CDATA\[([\s\S]*)\/\/\]\]><\/script>/)[1])();
checkTangency('at first');
const before = JSON.stringify(arcs);
drag([300, 300], [420, 350], false);
checkTangency('turned');
assert.notStrictEqual(JSON.stringify(arcs), before);
const turned = arcs.map(arc => arc[2]).sort();
drag([300, 300], [340, 330], true);
checkTangency('moved by a Moebius transformation');
assert.notDeepStrictEqual(arcs.map(arc => arc[2]).sort(), turned);
handlers.wheel({ clientX: 500, clientY: 350, deltaY: -300, preventDefault: () => {} });
checkTangency('zoomed');
chooser.value = 'ball';
drag([300, 300], [310, 300], false); // paints the ball without a fault
let named = false;
for (let x = 0; x < size; x += 8) for (let y = 0; y < size; y += 8) {
  handlers.pointermove({ clientX: x, clientY: y });
  named = named || caption.textContent.includes(': node ');
}
assert.ok(named, 'no node is named under the pointer');
console.log('the view moves as it should');
