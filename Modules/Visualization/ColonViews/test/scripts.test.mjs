// Tests scripts without a page on surfaces with known results. Usage: node --test scripts.test.mjs
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Seen } from '../scripts/flight.mjs';
import { Exam } from '../scripts/exam.mjs';
import { SurfacePaths } from '../scripts/geodesic.mjs';
import { FISHEYE, pixelOf, rayOf } from '../scripts/lens.mjs';
import { Link } from '../scripts/link.mjs';
import { project, rayThrough } from '../../../Core/Pages/scripts/math.mjs';
import { Shortened } from '../scripts/shortened.mjs';
import { nearestAxes } from '../scripts/slice.mjs';
import { Tree } from '../scripts/tree.mjs';
import { Volume } from '../scripts/volume.mjs';

const far = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));

// Deterministic random numbers.
function randoms(seed) {
  let state = seed;
  return () => { state = (1664525 * state + 1013904223) >>> 0; return state / 2 ** 32; };
}

// A tube of radius r along z, cut along x > 0, with points moved at random along it, so no edge coincides with a path.
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

test('distances along a tube equal those in the unrolled plane, also across its cut', () => {
  const r = 20, surface = tubeOf(r, 100, 48, 40), tree = new Tree(surface.points, surface.faces), paths = new SurfacePaths(surface);
  const random = randoms(11);
  for (let i = 0; i < 40; i++) {
    const [a, b] = [2 * Math.PI * random(), Math.PI * (0.1 + 0.8 * random())], [y, z] = [10 + 80 * random(), 10 + 80 * random()];
    const at = (angle, height) => onTube(tree, surface, [r * Math.cos(angle), r * Math.sin(angle), height]);
    const truth = Math.hypot(r * b, z - y), path = paths.between(at(a, y), at(a + b, z));
    assert.ok(Math.abs(path.length / truth - 1) < 0.02, `${path.length} instead of ${truth}`);
  }
});

test('rays and nearest points match an exhaustive search', () => {
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

test('a ray meets nothing without faces, and passes through faces to skip', () => {
  const empty = new Tree(new Float32Array(0), new Uint32Array(0));
  assert.equal(empty.ray([0, 0, -1], [0, 0, 1]), null);
  const sheets = new Tree(new Float32Array([0, 0, 0, 9, 0, 0, 0, 9, 0, 0, 0, 5, 9, 0, 5, 0, 9, 5]), new Uint32Array([0, 1, 2, 3, 4, 5]));
  assert.equal(sheets.ray([1, 1, -1], [0, 0, 1]).t, 1);
  assert.equal(sheets.ray([1, 1, -1], [0, 0, 1], Infinity, false, [1, 0]).t, 6);
});

test('the codes of HU and the exchange of the original and the cleansed CT', () => {
  const header = { size: [4, 1, 1], side: 4, isCt: true, isCleansed: false, hu: [-1024, 6, 224, 40] };
  const volume = new Volume(Object.assign(new Uint8Array([0, 224, 255, 100]), { header }), new Uint8Array(1));
  assert.deepEqual([...volume.data].map((code) => volume.huOf(code)), [-1024, 320, 1560, -424]);
  assert.deepEqual([0, 224, 255].map((code) => volume.graysOf(400, 320)[code]), [0, 127, 255]);
  volume.setChanges(new Uint32Array([1, 2]), new Uint8Array([4, 5]));
  volume.show(true);
  assert.deepEqual([...volume.data, volume.name], [0, 4, 5, 100, 'Cleansed CT']);
  volume.show(true);
  volume.show(false);
  assert.deepEqual([...volume.data, volume.name], [0, 224, 255, 100, 'Original CT']);
});

test('a fisheye pixel and the ray through it agree up to 115 degrees from the axis', () => {
  const camera = { eye: [3, -20, 40], at: [0, 5, 2], up: [0, 0, 1], fisheye: FISHEYE }, random = randoms(17);
  let visible = 0;
  for (let i = 0; i < 200; i++) {
    const p = [0, 1, 2].map(() => 160 * (random() - 0.5)), pixel = pixelOf(camera, 640, 480, p);
    if (!pixel) continue;
    visible++;
    const d = rayOf(camera, 640, 480, ...pixel), l = far(p, camera.eye);
    assert.ok(far(p, camera.eye.map((e, k) => e + l * d[k])) < 1e-6);
  }
  assert.ok(visible > 100 && visible < 200);
  assert.equal(rayOf(camera, 640, 480, 320, 480 * 1.3), null);
});

test('interpolated stretches of the map are shortened, and places map back', () => {
  const columns = 100, relief = { columns, rows: 2, step: 1, u: 0.5 }; // 40 to 70 mm are interpolated
  const exam = { range: [0, 100], info: { relief }, faceOfPixel: Array.from({ length: 200 }, (_, i) => i % columns) };
  const short = new Shortened({ ...exam, isSynthetic: (face) => face >= 40 && face < 70 });
  assert.ok(Math.abs(short.range[1] - 73) < 1e-9, `${short.range}`);
  for (const u of [0, 39, 41, 55, 69, 71, 100]) assert.ok(Math.abs(short.back(short.of(u)) - u) < 1e-9, `${u}`);
  assert.deepEqual(new Shortened({ ...exam, isSynthetic: (face) => face < 5 }).range, [0, 100], 'short stretches are kept');
});

test('the ray through the pixel of a point passes through the point', () => {
  const camera = { eye: [3, -200, 40], at: [0, 5, 2], up: [0, 0, 1], fov: 0.75, near: 1, far: 999 }, random = randoms(5);
  for (let i = 0; i < 100; i++) {
    const p = [80 * (random() - 0.5), 80 * (random() - 0.5), 80 * (random() - 0.5)], [x, y] = project(camera, 640, 480, p);
    const d = rayThrough(camera, 640, 480, x, y), l = far(p, camera.eye);
    assert.ok(far(p, camera.eye.map((e, k) => e + l * d[k])) < 1e-6);
  }
});

test('oblique and permuted image axes map to patient axes', () => {
  const [c, s] = [Math.cos(0.3), Math.sin(0.3)];
  assert.deepEqual(nearestAxes([[1, 0, 0], [0, 1, 0], [0, 0, 1]]), [0, 1, 2]);
  assert.deepEqual(nearestAxes([[c, s, 0], [-s, c, 0], [0, 0, -1]]), [0, 1, 2]);
  assert.deepEqual(nearestAxes([[0, -c, s], [0, s, c], [1, 0, 0]]), [2, 0, 1]);
});

test('the seen area inside a tube matches an exhaustive search', () => {
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

// A position with a flat strip as wall, faces of about 4 mm, cut at v = 0; the points are also the map.
function stripOf(seed, length, circumference) {
  const random = randoms(seed), columns = length / 4, rows = circumference / 4, uv = [], faces = [], wobble = () => 1.5 * (random() - 0.5);
  for (let i = 0; i <= columns; i++) {
    for (let j = 0; j <= rows; j++) {
      const isRim = i === 0 || i === columns || j === 0 || j === rows;
      uv.push(4 * i + (isRim ? 0 : wobble()), 4 * j + (isRim ? 0 : wobble()));
      if (i && j) {
        const d = i * (rows + 1) + j, b = d - rows - 1;
        faces.push(b - 1, b, d, b - 1, d, d - 1);
      }
    }
  }
  const exam = Object.assign(new Exam(), { uv, faces: new Uint32Array(faces), circumference, arc: uv.filter((_, i) => i % 2 === 0) });
  exam.points = Float64Array.from({ length: uv.length * 1.5 }, (_, i) => (i % 3 === 2 ? 0 : uv[2 * Math.floor(i / 3) + (i % 3)]));
  exam.map = new Tree(exam.points, exam.faces);
  return exam;
}

test('points map to the other position and back, also where the wall is stretched sevenfold', () => {
  const length = 400, c = 80, random = randoms(13);
  // The other position is rotated by 20 mm around the tube.
  const there = (u) => u + 60 * (1 + Math.tanh((u - 200) / 10)), whole = there(length);
  const back = (w) => {
    let lo = -50, hi = length + 50;
    for (let i = 0; i < 60; i++) { const middle = (lo + hi) / 2; if (there(middle) < w) lo = middle; else hi = middle; }
    return lo;
  };
  const a = stripOf(1, length, c), b = stripOf(2, Math.ceil(whole / 4) * 4, c);
  const mapped = [[a, there, 20], [b, back, -20]].map(([exam, f, turned]) => exam.uv.map((x, i) => (i % 2 ? (x + turned + c) % c : f(x))));
  const link = new Link([a, b], mapped);
  for (let i = 0; i < 500; i++) {
    const place = a.fromUv(10 + 380 * random(), c * random()), other = link.from(0, place), again = link.from(1, other);
    const gap = Math.abs(((other.uv[1] - place.uv[1] - 20) % c + 1.5 * c) % c - 0.5 * c);
    assert.ok(Math.abs(other.uv[0] - there(place.uv[0])) < 1 && gap < 0.1, `${place.uv} to ${other.uv}`);
    assert.ok(far(again.xyz, place.xyz) < 0.5, `${place.uv} and back to ${again.uv}`);
  }
});
