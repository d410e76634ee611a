// Tests scripts without a page. Usage: node --test scripts.test.mjs
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { equalization, HeatAxis, rangeOfCounts } from '../scripts/axis.mjs';
import { shownBox } from '../scripts/cuts.mjs';
import { History } from '../scripts/history.mjs';
import { lineAround, lineNear } from '../scripts/line-search.mjs';
import {
  binOf, linesOfBins, lowerEdge, NUMBER_OF_BINS, rounded, savedFromText, savedText, volumeProperty, withLine,
} from '../scripts/lines.mjs';
import {
  binsOfObject, chainOf, classesOf, labelsOf, objectOfClick, objectsToSave, shortVolume, shownObjects, stylesOf, stylesOfSaved,
} from '../scripts/objects.mjs';
import { contentsOf } from '../scripts/rendering.mjs';

// Deterministic random numbers.
function randoms(seed) {
  let state = seed;
  return () => { state = (1664525 * state + 1013904223) >>> 0; return state / 2 ** 32; };
}

const line = (lower, upper, color = '#ff0000', opacity = 0.5) => ({ lower, upper, color, opacity, isOn: true });

test('bins tile the heat from 0 to 1', () => {
  assert.equal(lowerEdge(1), 2 ** -16);
  assert.equal(lowerEdge(NUMBER_OF_BINS), 1);
  for (let bin = 1; bin < NUMBER_OF_BINS; bin++) {
    assert.equal(binOf(lowerEdge(bin)), bin);
    assert.equal(binOf((lowerEdge(bin) + lowerEdge(bin + 1)) / 2), bin);
  }
  assert.deepEqual([0, 1e-6, 1, 2].map(binOf), [0, 0, NUMBER_OF_BINS - 1, NUMBER_OF_BINS - 1]);
});

test('a cut hides the voxels before or behind its plane', () => {
  const size = [10, 20, 30], cut = (through, hides, at) => ({ through, hides, at });
  assert.deepEqual(shownBox([cut(2, 0, 7), cut(0, 0, 3)], size), { low: [0, 0, 0], high: [9, 19, 29] });
  assert.deepEqual(shownBox([cut(2, 1, 7), cut(1, -1, 4), cut(0, 0, 3)], size), { low: [0, 0, 7], high: [9, 4, 29] });
});

test('numbers match %g of C', () => { // printf("%.9g"), including ties to even
  const pairs = [
    [0.1005859375, '0.100585938'], [0.2001953125, '0.200195312'], [1e-5, '1e-05'], [0.00012345678912, '0.000123456789'],
    [123456789, '123456789'],
    [1234567890, '1.23456789e+09'], [0.5, '0.5'], [100, '100'], [0.1, '0.1'], [999999999.6, '1e+09'], [0, '0'], [2.5e-300, '2.5e-300'],
  ];
  for (const [x, text] of pairs) assert.equal(rounded(x, 9), text);
  assert.deepEqual([0.12345, 2 / 3, 1, 0.00005].map((x) => rounded(x, 4)), ['0.1235', '0.6667', '1', '5e-05']);
  assert.equal(rounded(0.125, 2), '0.12');
  assert.equal(rounded(0.375, 2), '0.38');
});

test('a volume property has ramps at the ends of lines, but not between adjacent lines', () => {
  const rows = volumeProperty([line(0.25, 0.5), line(0.5, 0.75, '#00ff00', 1)], 1).split('\n');
  assert.deepEqual(rows.slice(0, 6), ['0', '1', '0.6', '0.3', '0.2', '10']);
  assert.equal(rows[6], '14 0 0 0.2499375 0 0.25 0.5 0.4999375 0.5 0.5 1 0.7499375 1 0.75 0');
  assert.equal(rows[7], '4 0 1 1 1');
  assert.equal(rows[8], '16 0.25 1 0 0 0.4999375 1 0 0 0.5 0 1 0 0.7499375 0 1 0');
  assert.equal(volumeProperty([line(0.25, 0.5)], 400).split('\n')[7], '4 0 1 400 1');
});

test('a new line removes its heat range from the lines that it overlaps', () => {
  const ranges = (lines) => lines.map((l) => [l.lower, l.upper]);
  assert.deepEqual(ranges(withLine([line(0.2, 0.6)], line(0.3, 0.4))), [[0.2, 0.3], [0.3, 0.4], [0.4, 0.6]]);
  assert.deepEqual(ranges(withLine([line(0.2, 0.3), line(0.3, 0.5)], line(0.1, 0.4))), [[0.1, 0.4], [0.4, 0.5]]);
  const numbers = linesOfBins([line(lowerEdge(100), lowerEdge(103)), { ...line(lowerEdge(103), lowerEdge(105)), isOn: false }]);
  assert.deepEqual([...numbers.subarray(98, 106)], [0, 0, 1, 1, 1, 0, 0, 0]);
});

test('saved lines are read back, and invalid ones rejected', () => {
  const lines = [line(lowerEdge(3001), lowerEdge(3100)), line(0.5, 1, '#05bffa', 0.05)];
  const text = savedText(lines, 'heat', 100);
  assert.deepEqual(savedFromText(text, 'heat'), { lines, objects: [] });
  const other = [['0.5,', '2.5,'], ['#05bffa', 'blue'], ['"version": 1', '"version": 9']].map((pair) => text.replace(...pair));
  for (const wrong of ['', '{}', ...other]) {
    assert.throws(() => savedFromText(wrong, 'heat'), /This file is not a transfer function/);
  }
  assert.throws(() => savedFromText(text, 'density'), /for heat, not for density/);
});

// 1 contains 2 and 4, 2 contains 5; 3 is alone.
const objects = [0, 1, 0, 1, 2].map((parent, i) => ({ number: i + 1, parent, voxels: 100 - i, volume: 10 ** (5 - i), probability: 0.5 }));
const colors = ['#ff0000', '#00ff00', '#0000ff'];

test('objects are climbed, and hold the labels in them', () => {
  assert.deepEqual([0, 3, 4, 5].map((number) => chainOf(objects, number)), [[], [3], [4, 1], [5, 2, 1]]);
  assert.deepEqual([1, 2, 3].map((number) => labelsOf(objects, number)), [[1, 2, 4, 5], [2, 5], [3]]);
  assert.deepEqual([181, 999.9, 12345, 1e9].map(shortVolume), ['180 mm³', '1000 mm³', '12.3 ml', '1000000 ml']);
});

test('a click selects the best object that is not excluded', () => {
  const scored = [3, 5, 1, 4, 5].map((score, i) => ({ ...objects[i], score, isOffer: i === 2 }));
  assert.deepEqual([0, 1, 2, 3, 4, 5].map((label) => objectOfClick(scored, label)), [0, 1, 2, 3, 4, 5]);
  assert.deepEqual([4, 5].map((label) => objectOfClick(scored, label, (n) => n === label)), [1, 2]);
  assert.equal(objectOfClick(scored, 3, (n) => n === 3), 0);
  assert.deepEqual(stylesOf(scored, colors).map(({ isOn }) => isOn), [true, true, false, true, true]);
  const shown = stylesOf(scored, colors).map((style) => ({ ...style, isOn: true }));
  assert.deepEqual(objectsToSave(scored, shown).map(({ number }) => number), [1, 2, 4, 5]);
  assert.deepEqual([...shownObjects(scored, shown, [2, 4])], [0, 0, 2, 0, 4, 2]);
});

test('the smallest shown object colors a voxel, or the selected one only', () => {
  const styles = stylesOf(objects, colors), hide = (...numbers) => styles.map((s, i) => ({ ...s, isOn: !numbers.includes(i + 1) }));
  assert.deepEqual(styles.map(({ color, isOn }) => [color, isOn]), [0, 1, 2, 0, 1].map((i) => [colors[i], true]));
  assert.ok(styles[0].opacity < styles[3].opacity && styles[1].opacity < styles[4].opacity && styles[2].opacity === styles[4].opacity);
  assert.deepEqual([...shownObjects(objects, styles, [])], [0, 1, 2, 3, 4, 5]);
  assert.deepEqual([...shownObjects(objects, hide(2, 3, 5), [])], [0, 1, 1, 0, 4, 1]);
  assert.deepEqual([...shownObjects(objects, hide(2), [2])], [0, 0, 2, 0, 0, 2]);
  const labels = Uint16Array.of(0, 1, 5, 2, 0), bins = Uint16Array.of(7, 7, 8, 20, 0);
  assert.deepEqual([...classesOf(labels, [0, 0, 0, 0, 0, 9], bins, Array(21).fill(0).fill(1, 7, 9), new Uint16Array(5))], [1, 1, 9, 0, 0]);
  assert.deepEqual([binsOfObject(objects, 2, labels, bins), binsOfObject(objects, 1, labels, bins)], [[8, 20], [7, 20]]);
});

test('saved objects are read back; those of another page and other kinds are rejected', () => {
  const styles = stylesOf(objects, colors).map((style, i) => ({ ...style, isOn: i === 1 || i === 2 }));
  const saved = objectsToSave(objects, styles);
  assert.deepEqual(saved.map(({ number, labels, voxels }) => [number, labels, voxels]), [[2, [2, 5], 99], [3, [3], 98]]);
  const text = savedText([], 'heat', 100, saved);
  assert.equal(JSON.parse(text).version, 2);
  assert.deepEqual(savedFromText(text, 'heat'), { lines: [], objects: saved });
  assert.deepEqual(stylesOfSaved(saved, objects, stylesOf(objects, colors)), styles);
  for (const wrong of [[{ ...saved[0], voxels: 98 }], [{ ...saved[0], labels: [2] }], [{ ...saved[0], number: 6 }]]) {
    assert.throws(() => stylesOfSaved(wrong, objects, styles), /colors other objects/);
  }
  assert.throws(() => stylesOfSaved(saved, [], []), /colors other objects/);
  for (const pair of [['"version": 2', '"version": 1'], ['"opacity": 0.3', '"opacity": 3']]) {
    assert.throws(() => savedFromText(text.replace(...pair), 'heat'), /not a transfer function/);
  }
});

test('the axis is equalized in the full and in each opened range, and is invertible', () => {
  const random = randoms(5), rows = 3, counts = new Uint32Array(rows * NUMBER_OF_BINS);
  for (let i = 0; i < counts.length; i++) counts[i] = 1000 * random() ** 8;
  const shares = equalization(counts), whole = rangeOfCounts(counts);
  assert.ok(Math.abs(shares[NUMBER_OF_BINS] - 1) < 1e-12);
  for (const isEqualized of [true, false]) {
    for (const range of [whole, [lowerEdge(2000), lowerEdge(2300)], [lowerEdge(2100), lowerEdge(2103)]]) {
      const axis = new HeatAxis(shares, isEqualized, range);
      assert.deepEqual([axis.positionOf(range[0]), axis.positionOf(range[1])], [0, 1]);
      for (let i = 1; i < 50; i++) assert.ok(Math.abs(axis.positionOf(axis.heatAt(i / 50)) - i / 50) < 1e-9);
    }
  }
  // Equalized: each tenth of the axis has a tenth of the counts of the range; rows have equal weight.
  const [a, b] = [2000, 2300], axis = new HeatAxis(shares, true, [lowerEdge(a), lowerEdge(b)]), middle = binOf(axis.heatAt(0.5));
  const sum = (from, to) => shares[to] - shares[from];
  assert.ok(Math.abs(sum(a, middle) / sum(a, b) - 0.5) < 0.02);
  const empty = new HeatAxis(equalization(new Uint32Array(NUMBER_OF_BINS)), true, [0.25, 0.5]);
  assert.ok(empty.positionOf(0.4) > empty.positionOf(0.3));
});

test('nested ranges have the same axis as the pictures', () => { // HeatRanges.NestedAxesAreThoseOfTheExplorer
  const example = JSON.parse(readFileSync(new URL('../../HeatViews/test/nested-ranges.json', import.meta.url)));
  const counts = new Uint32Array(example.rows.length * NUMBER_OF_BINS), within = (c) => c - Math.floor(c);
  const heatAt = (c) => lowerEdge(Math.floor(c)) + within(c) * (lowerEdge(Math.floor(c) + 1) - lowerEdge(Math.floor(c)));
  example.rows.forEach((row, i) => row.forEach(([bin, count]) => { counts[i * NUMBER_OF_BINS + bin] = count; }));
  for (const { bins, places } of example.levels) {
    const axis = new HeatAxis(equalization(counts), true, bins.map(heatAt));
    for (const [bin, place] of places) assert.ok(Math.abs(axis.positionOf(heatAt(bin)) - place) < 1e-9, `${bins}: ${bin}`);
  }
});

test('a line is found with its slopes, despite noise, and separate from its neighbor', () => {
  const random = randoms(9), counts = new Uint32Array(NUMBER_OF_BINS);
  const peak = (middle, width, height) => { for (let i = -60; i <= 60; i++) counts[middle + i] += height * Math.exp(-((i / width) ** 2)); };
  peak(3000, 8, 5000);
  peak(3045, 6, 3000);
  for (let i = 2900; i < 3100; i++) counts[i] += 40 * random();
  const [lower, upper] = lineAround(counts, 3001).map(binOf);
  assert.ok(lower > 2975 && lower < 2992 && upper > 3008 && upper < 3027, `${lower} to ${upper}`);
  const axis = new HeatAxis(equalization(counts), true, rangeOfCounts(counts)), at = axis.positionOf(lowerEdge(3045));
  const [from, to] = lineNear(counts, axis, at, 0.002).map(binOf);
  assert.ok(from > 3020 && from < 3044 && to > 3047 && to < 3070, `${from} to ${to}`);
  const single = new Uint32Array(NUMBER_OF_BINS);
  single[500] = 70000;
  assert.deepEqual(lineAround(single, 500).map(binOf), [500, 501]);
  assert.equal(lineNear(single, new HeatAxis(equalization(single), false, [0, 1]), 0.9, 0.01), null);
});

test('undo and redo restore states; a slider move is one change', () => {
  const history = new History('a');
  history.change('b');
  history.change('c', 'slider');
  history.change('d', 'slider');
  history.undo();
  assert.equal(history.state, 'b');
  history.undo();
  history.undo();
  assert.equal(history.state, 'a');
  history.redo();
  history.redo();
  assert.equal(history.state, 'd');
  history.change('e');
  history.redo();
  assert.equal(history.state, 'e');
});

test('rays do not skip blocks that affect visible voxels', () => {
  const size = [21, 17, 18], random = randoms(3), bins = new Uint16Array(size[0] * size[1] * size[2]);
  const numbers = Uint8Array.from([0, 1, 2, 2]), colors = Uint32Array.from([0, 200 * 2 ** 24, 0, 0]); // the second line is invisible
  for (let i = 0; i < bins.length; i++) bins[i] = random() < 0.001 ? 1 : 2 + Math.round(random());
  const blocks = size.map((n) => Math.ceil(n / 8)), contents = contentsOf(bins, numbers, colors, size);
  const at = (x, y, z) => bins[(z * size[1] + y) * size[0] + x] === 1;
  for (let b = 0; b < contents.length; b++) {
    const low = [b % blocks[0], Math.floor(b / blocks[0]) % blocks[1], Math.floor(b / (blocks[0] * blocks[1]))].map((i) => 8 * i);
    let isSeen = false; // exhaustive search
    for (let z = low[2]; z <= Math.min(low[2] + 8, size[2] - 1); z++) {
      for (let y = low[1]; y <= Math.min(low[1] + 8, size[1] - 1); y++) {
        for (let x = low[0]; x <= Math.min(low[0] + 8, size[0] - 1); x++) isSeen ||= at(x, y, z);
      }
    }
    assert.equal(contents[b] > 0, isSeen, `block ${b}`);
  }
  colors.fill(99 * 2 ** 24);
  assert.ok(contentsOf(bins.map((bin) => Math.max(2, bin)), numbers, colors, size).every((content) => content === 2));
});
