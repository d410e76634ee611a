// Tests scripts of graph pages without a page, on graphs with known results. Usage: node --test scripts.test.mjs
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { changesBetween } from '../scripts/compare.mjs';
import { Disk } from '../scripts/disk.mjs';
import { PageGraph } from '../scripts/graph.mjs';
import { Plane } from '../scripts/plane.mjs';
import { nodesNamed, Selection } from '../scripts/selection.mjs';
import { Sphere } from '../scripts/sphere.mjs';
import { edgeUnder, nodeUnder, Tile } from '../scripts/tile.mjs';

const far = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));
const frame = { c: 400, R: 384, middle: [0, 0], extent: 1 }, tile = { a: [1, 0], b: [0, 0] };

// Deterministic random numbers.
function randoms(seed) {
  let state = seed;
  return () => { state = (1664525 * state + 1013904223) >>> 0; return state / 2 ** 32; };
}

// Two tangent circles in each geometry, as [positions, radii].
const hyperbolic = (d) => Math.tanh(d / 2);
const TOUCHING = [
  [() => new Sphere([0, 0, 1]), [0.6, 0, 0.8, 0, 0.6, 0.8], (() => { const a = Math.acos(0.64); return [0.3 * a, 0.7 * a]; })()],
  [() => new Plane(), [0.1, 0.2, 0.4, 0.6], [0.2, 0.3]],
  [() => new Disk(), [0, 0, hyperbolic(1.1), 0], [0.5, 0.6]],
];

// The circles as they are painted: [x, y, radius].
function arcsOf(model, places, radii) {
  const arcs = [], g = { arc: (x, y, r) => arcs.push([x, y, r]) }, move = model.mover(frame, tile);
  radii.forEach((r, i) => model.circle(g, frame, move, places, model.step * i, r));
  return arcs;
}

test('tangent circles stay tangent after any motion', () => {
  const random = randoms(5), any = () => [random() - 0.5, random() - 0.5];
  for (const [make, places, radii] of TOUCHING) {
    const model = make();
    let checked = 0;
    if (model.step === 3) model.choice = 'flat';
    for (let i = 0; i < 60; i++) {
      if (i % 3 === 0) model.drag(any(), any(), false);
      if (i % 3 === 1) model.drag(any(), any(), true);
      if (i % 3 === 2) model.zoom(any(), 0.2 * (random() - 0.5));
      const arcs = arcsOf(model, places, radii);
      if (arcs.length < 2) continue; // outside the picture
      const [[x, y, r], [u, v, s]] = arcs, gap = Math.hypot(x - u, y - v);
      assert.ok(Math.min(Math.abs(gap - r - s), Math.abs(gap - Math.abs(r - s))) < 1e-6 * (r + s), `${model.constructor.name}, step ${i}`);
      checked++;
    }
    assert.ok(checked > 30);
  }
});

test('a dragged point stays under the pointer, on plane and disk', () => {
  for (const model of [new Plane(), new Disk(), Object.assign(new Disk(), { choice: 'klein' })]) {
    model.zoom([0.1, 0.1], 0.3);
    const units = (q) => { const [x, y] = model.pixel(frame, q); return [(x - frame.c) / frame.R, (frame.c - y) / frame.R]; };
    const place = [0.2, -0.1], before = units(model.mover(frame, tile)(place, 0)), to = [-0.3, 0.25];
    model.drag(before, to, false);
    assert.ok(far(units(model.mover(frame, tile)(place, 0)), to) < 1e-9, model.constructor.name);
  }
});

test('zooming fixes the point under the pointer, on sphere and plane', () => {
  for (const model of [new Sphere([0, 0, 1]), Object.assign(new Sphere([0, 0, 1]), { choice: 'flat' }), new Plane()]) {
    const place = model.step === 3 ? [0.36, 0.48, 0.8] : [0.3, 0.2], at = () => model.pixel(frame, model.mover(frame, tile)(place, 0));
    const [x, y] = at();
    model.zoom([(x - frame.c) / frame.R, (frame.c - y) / frame.R], 0.4);
    assert.ok(far(at(), [x, y]) < 1e-9);
  }
});

test('any point can be centered; a sphere initially shows its front', () => {
  const random = randoms(9);
  for (const [make] of TOUCHING) {
    const model = make();
    for (let i = 0; i < 20; i++) {
      const p = [random() - 0.5, random() - 0.5, random() - 0.5], place = model.step === 3 ? p.map((x) => x / Math.hypot(...p)) : p;
      model.center(model.mover(frame, tile)(place, 0));
      const moved = model.mover(frame, tile)(place, 0);
      assert.ok(far(model.pixel(frame, moved), [frame.c, frame.c]) < 1e-6 && model.isSeen(moved));
    }
  }
  for (const front of [[0.6, -0.48, 0.64], [0, 0, -1]]) {
    const [x, y, z] = new Sphere(front).mover()(front, 0);
    assert.ok(far([x, y, z], [0, 0, 1]) < 1e-12);
  }
});

test('interpolated points on the disk divide the distance proportionally', () => {
  const model = new Disk(), p = [0.3, 0.4], q = [-0.5, 0.6], complex = (a, b) => [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]];
  const gap = (a, b) => {
    const w = complex([a[0], -a[1]], b), d = Math.hypot(1 - w[0], w[1]);
    return 2 * Math.atanh(far(a, b) / d);
  };
  const r = model.between(p, q, 0.3);
  assert.ok(Math.abs(gap(p, r) - 0.3 * gap(p, q)) < 1e-9 && Math.abs(gap(r, q) - 0.7 * gap(p, q)) < 1e-9);
});

// A random graph with parallel edges and loops at random positions on the sphere; circles touch at the midpoints of edges.
function randomGraph(seed, nodes, edges, names) {
  const random = randoms(seed), unit = (p) => p.map((x) => x / Math.hypot(...p));
  const at = Array.from({ length: nodes }, () => unit([random() - 0.5, random() - 0.5, random() - 0.5]));
  const ends = Array.from({ length: 2 * edges }, () => Math.floor(nodes * random()));
  const halves = ends.map((node, h) => unit(at[node].map((x, k) => x + at[ends[h ^ 1]][k] + 1e-3)));
  return new PageGraph({
    title: `graph ${seed}`, geometry: 'spherical', names: names || at.map((_, i) => `n${i}`), radii: at.map(() => 0.1),
    places: at.flat(), ends, starts: ends, touches: halves.flat(), edgeOf: ends.map((_, h) => h >> 1),
  });
}

test('edges around nodes and edges of other graphs match an exhaustive search', () => {
  const graph = randomGraph(3, 12, 40), { ends } = graph.data;
  for (let node = 0; node < graph.nodes; node++) {
    const all = ends.flatMap((n, h) => (n === node ? [h >> 1] : []));
    assert.deepEqual([...graph.edgesAt(node)], all);
    assert.equal(graph.degree(node), all.length);
    assert.deepEqual(new Set(graph.neighbors(node)), new Set(ends.flatMap((n, h) => (n === node ? [ends[h ^ 1]] : []))));
  }
  for (let edge = 0; edge < graph.edges; edge++) {
    assert.deepEqual([...graph.halvesOf(edge)], [2 * edge, 2 * edge + 1]);
    assert.equal(graph.edgeOf(graph.keyOfEdge(edge)), edge);
  }
});

test('a selection is found in other graphs by name or by number, and described as text', () => {
  const a = randomGraph(3, 5, 9), b = randomGraph(3, 5, 9, ['n4', 'n3', 'n2', 'n1', 'x']), selection = new Selection([a, b]);
  selection.chooseNode(a, 4);
  assert.deepEqual(selection.marksIn(a).near, a.neighbors(4).filter((n) => n !== 4));
  assert.equal(selection.marksIn(b).node, 0);
  assert.match(selection.describe(), /^node n4 of graph 3 · degree \d+ · radius 0\.1 rad · .* · in both graphs$/);
  selection.chooseNode(a, 0);
  assert.equal(selection.marksIn(b), null);
  assert.match(selection.describe(), /not in graph 3$/);
  b.keys = [0, 1, 2, 3, 4];
  a.keys = [4, 3, 2, 1, 0];
  [a, b].forEach((graph) => { graph.numbers = null; });
  selection.chooseNode(a, 0);
  assert.equal(selection.marksIn(b).node, 4);
  assert.match(selection.describe(), /in graph 3: x$/);
  selection.clear();
  assert.equal(selection.marksIn(a), null);
});

test('tracked nodes have colors of their own in all graphs, until they are tracked no longer', () => {
  const a = randomGraph(3, 5, 9), b = randomGraph(4, 5, 9, ['n4', 'n3', 'n2', 'n1', 'x']);
  const selection = new Selection([a, b], ['red', 'blue']);
  selection.track('n4');
  selection.track('n0');
  assert.deepEqual([...a.data.tracked], [[4, 'red'], [0, 'blue']]);
  assert.deepEqual([...b.data.tracked], [[0, 'red']]);
  selection.track('n4');
  selection.track('n1');
  assert.deepEqual([...a.data.tracked], [[0, 'blue'], [1, 'red']]);
  selection.track('n2');
  assert.equal(a.data.tracked.size, 3, 'more nodes than colors');
});

test('changes between two graphs match a comparison of sets', () => {
  const names = ['n2', 'n3', 'x', 'n0', 'n1', 'n5'], a = randomGraph(12, 6, 10), b = randomGraph(13, 6, 10, names);
  const ends = (graph) => {
    const counts = new Map();
    return Array.from({ length: graph.edges }, (_, e) => {
      const key = graph.ends(e).map((n) => graph.name(n)).sort().join(), which = counts.get(key) ?? 0;
      counts.set(key, which + 1);
      return `${key}#${which}`;
    });
  };
  const [of, into] = [ends(a), ends(b)], [gone, fresh] = changesBetween(a, b);
  const lost = of.flatMap((key, e) => (into.includes(key) ? [] : [e])), won = into.flatMap((key, e) => (of.includes(key) ? [] : [e]));
  assert.deepEqual([...gone.edges], lost);
  assert.deepEqual([...fresh.edges], won);
  const namesOf = (graph, edges) => edges.flatMap((e) => graph.ends(e).map((n) => graph.name(n)));
  const absent = (graph, other) => graph.data.names.filter((n) => other.nodeOf(n) < 0);
  const nodes = (graph, set) => new Set([...set].map((n) => graph.name(n)));
  assert.deepEqual(nodes(a, gone.nodes), new Set([...absent(a, b), ...namesOf(a, lost)]));
  const both = namesOf(a, lost).filter((n) => b.nodeOf(n) >= 0);
  assert.deepEqual(nodes(b, fresh.nodes), new Set([...absent(b, a), ...namesOf(b, won), ...both]));
});

test('keys step around a node and along an edge', () => {
  const graph = randomGraph(8, 6, 14), selection = new Selection([graph]), seen = [];
  selection.chooseNode(graph, 2);
  for (let i = 0; i < graph.degree(2); i++) { selection.stepAround(1); seen.push(selection.edge); }
  assert.deepEqual(seen, [...graph.edgesAt(2)]);
  selection.stepAround(1);
  assert.equal(selection.edge, seen[0]);
  selection.stepAround(-1);
  assert.equal(selection.edge, seen.at(-1));
  selection.follow();
  assert.equal(selection.node, graph.otherEnd(seen.at(-1), 2));
});

test('exact matches precede names that begin with the text and names that contain it', () => {
  const graph = { data: { names: ['xab', 'abc', 'AB', 'b', 'ab<d'] } };
  assert.deepEqual(nodesNamed(graph, ' ab'), [2, 1, 4, 0]);
  assert.deepEqual(nodesNamed(graph, ' '), []);
  assert.deepEqual(nodesNamed(graph, 'z'), []);
});

test('picking returns the object painted at a pixel', () => {
  const graph = randomGraph(21, 30, 50), tiles = [new Tile(new Sphere([0, 0, 1]), graph.data, frame, tile)];
  let edges = 0;
  for (let i = 0; i < graph.nodes; i++) assert.equal(nodeUnder(tiles, graph, tiles[0].pixelOf(i), 5), tiles[0].isSeen(i) ? i : -1);
  graph.data.edgeOf.forEach((edge, h) => {
    const line = tiles[0].half(h);
    if (!line) return;
    const at = line[line.length >> 1], found = edgeUnder(tiles, graph, at, 5);
    const lines = [...graph.halvesOf(found)].map((k) => tiles[0].half(k)).filter(Boolean);
    edges++;
    assert.ok(found === edge || lines.some((l) => l.some((p) => far(p, at) < 30)), `${found} instead of ${edge}`);
    assert.equal(edgeUnder(tiles, graph, [-50, -50], 5), -1);
  });
  assert.ok(edges > 20);
});
