// The scripts of the page that need no page, on surfaces whose truth is known. usage: node --test scripts.test.mjs
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Seen } from '../scripts/flight.mjs';
import { SurfacePaths } from '../scripts/geodesic.mjs';
import { project, rayThrough } from '../../PageKit/scripts/math.mjs';
import { nearestAxes } from '../scripts/slice.mjs';
import { Tree } from '../scripts/tree.mjs';

const far = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));

// Random numbers that are the same in each run.
function randoms(seed) {
  let state = seed;
  return () => { state = (1664525 * state + 1013904223) >>> 0; return state / 2 ** 32; };
}

// A tube of radius r along z, cut along x > 0, with points moved at random along it, so that no edge lies where a path would.
function tubeOf(r, length, around, rows) {
  const random = randoms(7), points = [], source = [], faces = [], shift = new Map();
  for (let j = 0; j <= rows; j++) {
    for (let i = 0; i <= around; i++) {
      const key = j * around + (i % around), isRim = j === 0 || j === rows;
      if (!shift.has(key)) shift.set(key, [random() - 0.5, isRim ? 0 : random() - 0.5]);
      const [da, dz] = shift.get(key), a = (2 * Math.PI * ((i % around) + 0.5 * da)) / around;
      points.push(r * Math.cos(a), r * Math.sin(a), (length * (j + 0.5 * dz)) / rows);
      source.push(j * (around + 1) + (i % around));
      if (i && j) {
        const d = j * (around + 1) + i, c = d - 1, b = d - around - 1, e = b - 1;
        faces.push(e, b, d, e, d, c);
      }
    }
  }
  return { points: new Float32Array(points), source: new Uint32Array(source), faces: new Uint32Array(faces) };
}

const onTube = (tree, surface, p) => {
  const { face, weights } = tree.nearest(p), { points: P, faces: F } = surface;
  const wall = [0, 1, 2].map((k) => [0, 1, 2].reduce((s, j) => s + weights[j] * P[3 * F[3 * face + j] + k], 0));
  return { face, wall };
};

test('distances along a tube are those of its plane, across its cut, too', () => {
  const r = 20, surface = tubeOf(r, 100, 48, 40), tree = new Tree(surface.points, surface.faces), paths = new SurfacePaths(surface);
  const random = randoms(11);
  for (let i = 0; i < 40; i++) {
    const [a, b] = [2 * Math.PI * random(), Math.PI * (0.1 + 0.8 * random())], [y, z] = [10 + 80 * random(), 10 + 80 * random()];
    const at = (angle, height) => onTube(tree, surface, [r * Math.cos(angle), r * Math.sin(angle), height]);
    const truth = Math.hypot(r * b, z - y), path = paths.between(at(a, y), at(a + b, z));
    assert.ok(Math.abs(path.length / truth - 1) < 0.02, `${path.length} in place of ${truth}`);
  }
});

test('rays and nearest points are those of a search through all triangles', () => {
  const surface = tubeOf(15, 60, 30, 24), tree = new Tree(surface.points, surface.faces), random = randoms(3);
  for (let i = 0; i < 200; i++) {
    const o = [20 * (random() - 0.5), 20 * (random() - 0.5), 60 * random()], d = [random() - 0.5, random() - 0.5, random() - 0.5];
    const all = Array.from({ length: surface.faces.length / 3 }, (_, f) => f);
    const hits = all.map((f) => tree.hit(f, o, d, Infinity)).filter(Boolean).map(({ t }) => t);
    assert.equal(tree.ray(o, d)?.t ?? null, hits.length ? Math.min(...hits) : null);
    const squared = Math.min(...all.map((f) => tree.nearestOf(f, o).squared));
    assert.equal(tree.nearest(o).squared, squared);
  }
});

test('a pixel of a point and the ray through this pixel belong together', () => {
  const camera = { eye: [3, -200, 40], at: [0, 5, 2], up: [0, 0, 1], fov: 0.75, near: 1, far: 999 }, random = randoms(5);
  for (let i = 0; i < 100; i++) {
    const p = [80 * (random() - 0.5), 80 * (random() - 0.5), 80 * (random() - 0.5)], [x, y] = project(camera, 640, 480, p);
    const d = rayThrough(camera, 640, 480, x, y), l = far(p, camera.eye);
    assert.ok(far(p, camera.eye.map((e, k) => e + l * d[k])) < 1e-6);
  }
});

test('oblique and permuted axes of an image find those of the patient', () => {
  const [c, s] = [Math.cos(0.3), Math.sin(0.3)];
  assert.deepEqual(nearestAxes([[1, 0, 0], [0, 1, 0], [0, 0, 1]]), [0, 1, 2]);
  assert.deepEqual(nearestAxes([[c, s, 0], [-s, c, 0], [0, 0, -1]]), [0, 1, 2]);
  assert.deepEqual(nearestAxes([[0, -c, s], [0, s, c], [1, 0, 0]]), [2, 0, 1]);
});

test('what is seen from inside a tube is what a search through all triangles finds', () => {
  const surface = tubeOf(15, 200, 30, 60), tree = new Tree(surface.points, surface.faces), n = surface.faces.length / 3;
  const exam = {
    ...surface, wall: tree, arc: Float32Array.from({ length: surface.points.length / 3 }, (_, i) => surface.points[3 * i + 2]),
    isSynthetic: () => false, facesBefore: (arc) => (arc < 0 ? 0 : arc > 200 ? n : Math.floor((n * arc) / 200)),
  };
  const seen = new Seen(exam), camera = { eye: [4, 1, 100], at: [4, 1, 101], up: [0, 1, 0], fov: 1.6, near: 0.3, far: 600 };
  seen.look(camera, 1.2);
  while (seen.work(50));
  for (let f = 0; f < n; f++) {
    const middle = [0, 1, 2].map((k) => seen.middles[3 * f + k]), d = middle.map((x, k) => x - camera.eye[k]), z = d[2];
    const high = Math.tan(0.8), inside = z > 0 && Math.abs(d[1]) < high * z && Math.abs(d[0]) < 1.2 * high * z;
    const hits = Array.from({ length: n }, (_, g) => tree.hit(g, camera.eye, d, 0.998)).filter(Boolean);
    assert.equal(seen.marks[f] === 1, inside && hits.length === 0, `face ${f}`);
  }
  assert.ok(seen.share > 0.2 && seen.share < 0.5);
});
