// Loads the DICOM results of a run in OHIF, and compares what it holds and draws with what pydicom reads. A run of two positions has
// two series and two folders, joined by "+"; all are loaded in one study.
// usage: PACKAGE=folder for OHIF SERIES=folder[+second] RESULTS=folder[+second],... WORK=folder to write to PYTHON=python3
//   [SHOTS=folder for pictures] node --test results.test.mjs
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch } from '../Browser/browser.mjs';
import { missing, serve } from './ohif.mjs';
import { load, look, open } from './viewer.mjs';

const { PACKAGE, SERIES, RESULTS, WORK, PYTHON = 'python3', SHOTS } = process.env;
const HERE = dirname(fileURLToPath(import.meta.url));
const NEAR_TIP = 12; // pixels around the tip of an arrow
const COLORFUL = 60; // difference between the channels of a pixel that is not CT
const TINT = 20; // least change of a pixel by a segment, of 255
const DISTINCT = 30; // least distance of two colors
const SAME_HUE = 0.95; // cosine between the change and the way to the color of the segment
const HALF = 0.5; // of a pixel or a slice: largest distance of a measurement from its place

// Pairs of series and results, for each position.
const runs = RESULTS.split(',').map((run) => run.split('+').map((folder, i) => [SERIES.split('+')[i], folder]));
const expectations = runs.map((pairs) => {
  const options = { encoding: 'utf8', maxBuffer: 1 << 28 };
  const { status, stdout, stderr } = spawnSync(PYTHON, [join(HERE, 'expected.py'), ...pairs.flat()], options);
  return status === 0 ? JSON.parse(stdout) : { reason: stderr.trim().split('\n').pop() };
});
const nameOf = ([[, folder]]) => basename(folder);
const reason = expectations.map((one) => one.reason).find((text) => /No module named/.test(text || '')) || missing(PACKAGE);
if (reason) console.log(`skipped: ${reason}`);
else runs.forEach((pairs, i) => test(`results in ${nameOf(pairs)}`, (context) => check(context, pairs, expectations[i])));

async function check(context, pairs, expected) {
  assert.equal(expected.reason, undefined);
  const server = await serve(PACKAGE, join(WORK, 'orthanc'));
  const page = await launch({ width: 1400, height: 900 });
  try {
    for (const path of pairs.flat()) {
      for (const file of readdirSync(path).filter((name) => name.endsWith('.dcm'))) await server.store(join(path, file));
    }
    const viewer = { page, server, expected, name: nameOf(pairs) };
    await open(viewer);
    await context.test('every object is listed, and marked if OHIF cannot show it', () => listed(viewer));
    for (let i = 0; i < pairs.length; ++i) await checkSegmentations(context, viewer, i);
    for (const one of expected.objects.filter(({ groups }) => groups)) {
      await context.test(`${one.file}: every measurement is in its place`, () => isInPlace(viewer, one));
    }
    await context.test('OHIF logs no errors', () => assert.deepEqual(page.errors, []));
  } finally {
    await page.close();
    await server.close();
  }
}

// Loads the segmentations of a position; those of the position before must keep their voxels.
async function checkSegmentations(context, viewer, position) {
  const all = viewer.expected.objects.filter((one) => one.segments && one.position <= position);
  viewer.loaded = all.filter((one) => one.position === position);
  for (const one of viewer.loaded) await context.test(`${one.file}: loads`, () => load(viewer, one.uid));
  for (const one of all) await context.test(`${one.file}: every segment has its voxels`, () => hasVoxels(viewer, one));
  for (const one of viewer.loaded) await context.test(`${one.file}: every segment is drawn in its color`, () => isDrawn(viewer, one));
}

// ---- functions that run in the page ----
// Returns the voxels of each segment: their number, and a SHA-256 of the mask of each slice.
const voxelsOf = async (uid) => {
  const { segments, representationData } = services.segmentationService.getSegmentation(helpers.setOf(uid).displaySetInstanceUID);
  const none = Object.values(segments).map(({ segmentIndex, label }) => [segmentIndex, { label, voxels: 0, slices: {} }]);
  const found = Object.fromEntries(none);
  for (const imageId of representationData.Labelmap.imageIds) {
    const image = cornerstone.cache.getImage(imageId);
    const slice = helpers.sliceOf(image.referencedImageId);
    image.voxelManager.getScalarData().forEach((label, i, labels) => {
      if (!label) return;
      const one = found[label];
      one.slices[slice] ||= new Uint8Array(labels.length);
      one.voxels += 1 - one.slices[slice][i];
      one.slices[slice][i] = 1;
    });
  }
  const hex = (bytes) => [...new Uint8Array(bytes)].map((byte) => byte.toString(16).padStart(2, '0')).join('');
  for (const { slices } of Object.values(found)) {
    for (const slice of Object.keys(slices)) slices[slice] = hex(await crypto.subtle.digest('SHA-256', slices[slice]));
  }
  return found;
};

// Scrolls to the slice; returns the page coordinates of its pixels, or of points of the patient, once they are in the viewport.
const goTo = async (slice, pixels, places) => {
  const viewport = helpers.viewport();
  await viewport.setImageIdIndex(viewport.getImageIds().findIndex((imageId) => helpers.sliceOf(imageId) === slice));
  viewport.render();
  const { left, top } = viewport.canvas.getBoundingClientRect();
  const { imageToWorldCoords } = cornerstone.utilities;
  const points = places || pixels.map(([column, row]) => imageToWorldCoords(viewport.getCurrentImageId(), [column + 0.5, row + 0.5]));
  const onPage = points.map((point) => viewport.worldToCanvas(point)).map(([x, y]) => [left + x, top + y]);
  return onPage.every(([x, y]) => document.elementsFromPoint(x, y).includes(viewport.canvas)) && onPage;
};

// Returns the color of the segment.
const showSegment = (uid, number, isVisible) => {
  const one = [helpers.viewportId(), helpers.setOf(uid).displaySetInstanceUID, number];
  services.segmentationService.setSegmentVisibility(...one, isVisible, 'Labelmap');
  return services.segmentationService.getSegmentColor(...one).slice(0, 3);
};

const annotationsOf = () => cornerstoneTools.annotation.state.getAllAnnotations()
  .filter(({ metadata }) => metadata.toolName === 'DICOMSRDisplay')
  .map(({ data, metadata }) => ({
    uid: data.TrackingUniqueIdentifier, place: [...data.handles.points[0]],
    slice: metadata.referencedImageId && helpers.sliceOf(metadata.referencedImageId),
  }));

// ---- checks ----
const shoot = async ({ page, name }, picture) => { if (SHOTS) await page.screenshot(join(SHOTS, `${name}-${picture}.png`)); };

async function listed({ page, expected }) {
  const sets = Object.fromEntries(await page.evaluate(() => helpers.sets().map((set) => [helpers.uidOf(set), !set.unsupported])));
  const shown = expected.objects.filter(({ isShown }) => isShown);
  assert.deepEqual(shown.map(({ file, uid }) => [file, sets[uid]]), shown.map(({ file }) => [file, true]));
  const unsupported = Object.values(sets).filter((isShown) => !isShown).length;
  assert.equal(unsupported > 0, shown.length < expected.objects.length);
  const descriptions = await page.evaluate(() => helpers.sets().map(({ SeriesDescription }) => SeriesDescription));
  assert.deepEqual(descriptions.filter((text, i) => descriptions.indexOf(text) < i), [], 'series of the same description');
}

async function hasVoxels({ page }, { file, uid, segments }) {
  const found = await page.evaluate(voxelsOf, uid);
  const table = (get) => Object.fromEntries(segments.map((one) => [one.label, get(one)]));
  const counts = table(({ number }) => found[number]?.voxels), expected = table(({ voxels }) => voxels);
  const shares = segments.map(({ label, voxels }) => `${label} ${counts[label]} of ${voxels}`);
  console.log(`${file}, voxels in OHIF of those in the file: ${shares.join(', ')}`);
  assert.deepEqual(counts, expected);
  assert.deepEqual(table(({ number }) => found[number].slices), table(({ slices }) => slices));
  assert.deepEqual(table(({ number }) => found[number].label), table(({ label }) => label));
}

const length = (vector) => Math.hypot(...vector);
const difference = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);

async function isDrawn(viewer, { file, uid, segments }) {
  const { page, loaded } = viewer;
  await shoot(viewer, file);
  const all = loaded.flatMap((one) => one.segments.map(({ number }) => [one.uid, number]));
  for (const [one, number] of all) await page.evaluate(showSegment, one, number, false);
  const colors = {};
  for (const { number, label, slice, inside, outside } of segments) {
    const [middle, away] = await page.until(goTo, undefined, slice, [inside, outside]);
    const gray = [await look(page, middle, 0), await look(page, away, 0)].flat();
    colors[label] = await page.evaluate(showSegment, uid, number, true);
    const [shown, kept] = [await look(page, middle, 0), await look(page, away, 0)].flat();
    await page.evaluate(showSegment, uid, number, false);
    const change = difference(shown, gray[0]), toColor = difference(colors[label], gray[0]);
    const hue = dot(change, toColor) / (length(change) * length(toColor));
    assert.ok(length(change) > TINT && hue > SAME_HUE, `${label}: ${gray[0]} becomes ${shown}, although its color is ${colors[label]}`);
    assert.deepEqual(kept, gray[1], `${label}: a pixel outside`);
  }
  for (const [one, number] of all) await page.evaluate(showSegment, one, number, true);
  const pairs = segments.flatMap((one, i) => segments.slice(i + 1).map((other) => [one.label, other.label]));
  const similar = pairs.filter(([one, other]) => length(difference(colors[one], colors[other])) < DISTINCT);
  assert.deepEqual(similar, [], `similar colors: ${JSON.stringify(colors)}`);
}

async function isInPlace(viewer, { file, uid, axes, groups }) {
  const { page } = viewer;
  await open(viewer);
  await load(viewer, uid);
  const found = Object.fromEntries((await page.evaluate(annotationsOf)).map((one) => [one.uid, one]));
  assert.deepEqual(groups.filter((one) => !found[one.uid]).map(({ identifier }) => identifier), [], 'measurements that OHIF does not show');
  assert.equal(Object.keys(found).length, groups.length);
  let farthest = 0;
  for (const { uid: group, identifier, place } of groups) {
    const { place: shown, slice } = found[group];
    const distances = axes.map(({ direction, spacing }) => dot(direction, difference(shown, place)) / spacing);
    assert.ok(distances.every((pixels) => Math.abs(pixels) <= HALF), `${identifier}: at ${shown}, not ${place}`);
    farthest = Math.max(farthest, ...distances.slice(0, 2).map(Math.abs));
    const [tip] = await page.until(goTo, undefined, slice, [], [shown]);
    if (identifier === groups[0].identifier) await shoot(viewer, file);
    const colorful = (await look(page, tip, NEAR_TIP)).filter((pixel) => Math.max(...pixel) - Math.min(...pixel) > COLORFUL);
    assert.ok(colorful.length > 0, `${identifier}: no arrow at ${tip}`);
  }
  console.log(`${file}, ${groups.length} measurements, at most ${farthest.toFixed(4)} pixels from their places`);
}
