// Takes the candidates of sr-ohif.dcm as measurements of OHIF, labels and deletes some, saves a report as a reader does, and converts
// it to verdicts.
// usage: PACKAGE=folder for OHIF SERIES=folder EXAM=folder REPORT=sr-ohif.dcm TOOL=DicomResultsToColon WORK=folder to write to
//   PYTHON=python3 [SHOTS=folder for pictures] node --test reading.test.mjs
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch } from '../Browser/browser.mjs';
import { missing, serve } from './ohif.mjs';
import { open, press } from './viewer.mjs';

const { PACKAGE, SERIES, EXAM, REPORT, TOOL, WORK, PYTHON = 'python3', SHOTS } = process.env;
const HERE = dirname(fileURLToPath(import.meta.url));
const HALF = 0.5; // of a pixel or a slice: largest distance of a measurement from its place
const sent = join(WORK, 'sent');
const SAVE_TIME = 60000; // milliseconds
const pause = () => new Promise((done) => { setTimeout(done, 100); });

// ---- functions that run in the page ----
const show = (uid) => {
  const displaySetInstanceUIDs = [helpers.setOf(uid).displaySetInstanceUID];
  services.viewportGridService.setDisplaySetsForViewport({ viewportId: helpers.viewportId(), displaySetInstanceUIDs });
};
// Answers yes to "Do you want to continue tracking measurements for this study?".
const isTaken = (uid) => {
  document.querySelector('[data-cy="yes-hydrate-btn"]')?.click();
  return helpers.setOf(uid).isHydrated;
};
const hasMeasurements = (count) => services.measurementService.getMeasurements().length === count;
const measurements = () => services.measurementService.getMeasurements()
  .map(({ label, points }) => ({ label, points: points.map((point) => [...point]) }));
const rename = (index, label) => {
  const one = services.measurementService.getMeasurements()[index];
  services.measurementService.update(one.uid, { ...one, label }, true);
};
const remove = (index) => services.measurementService.remove(services.measurementService.getMeasurements()[index].uid);
// ---- end of the functions that run in the page ----

function expectations() {
  rmSync(sent, { recursive: true, force: true });
  mkdirSync(sent, { recursive: true });
  copyFileSync(REPORT, join(sent, 'sr-ohif.dcm'));
  const { stdout, stderr } = spawnSync(PYTHON, [join(HERE, 'expected.py'), SERIES, sent], { encoding: 'utf8', maxBuffer: 1 << 28 });
  return stdout ? JSON.parse(stdout) : { reason: stderr.trim().split('\n').pop() };
}

// The middle of each line is the center of its candidate.
function checkPlaces(taken, groups, axes) {
  taken.forEach(({ label, points }, i) => {
    const middle = points[0].map((x, axis) => (x + points[1][axis]) / 2);
    const offset = middle.map((x, axis) => x - groups[i].place[axis]);
    const steps = axes.map(({ direction, spacing }) => direction.reduce((sum, d, axis) => sum + d * offset[axis], 0) / spacing);
    assert.ok(steps.every((step) => Math.abs(step) <= HALF), `${groups[i].identifier}: ${middle} is not ${groups[i].place}`);
    assert.equal(label, `candidate ${i + 1}`);
  });
}

// Saves with the panel of measurements and its dialog: into the series that it proposes, or a new one of this name. Returns the file
// that arrives in Orthanc.
async function saveReport({ page, server }, name) {
  const before = await server.files();
  await press(page, 'trackedMeasurements-btn');
  await press(page, 'Create SR');
  if (name) {
    await press(page, 'combobox');
    await press(page, 'Create new series');
    await press(page, 'Report name');
    for (const letter of name) await page.key(letter);
  }
  if (SHOTS) await page.screenshot(join(SHOTS, `dialog${name}.png`));
  await press(page, 'Save');
  for (const end = Date.now() + SAVE_TIME; Date.now() < end; await pause()) {
    const added = (await server.files()).find((file) => !before.includes(file));
    if (added) return server.fileOf(added);
  }
  throw new Error('OHIF has not stored the report');
}

// Returns the number of candidates. The report is saved as `returned`.
async function readInOhif(expected, name, returned) {
  const [{ uid, groups, axes }] = expected.objects;
  const server = await serve(PACKAGE, join(WORK, 'orthanc'));
  const page = await launch({ width: 1400, height: 900 });
  try {
    for (const file of readdirSync(SERIES)) await server.store(join(SERIES, file));
    await server.store(join(sent, 'sr-ohif.dcm'));
    await open({ page, server, expected });
    await page.evaluate(show, uid);
    await page.until(isTaken, undefined, uid);
    await page.until(hasMeasurements, undefined, groups.length);
    checkPlaces(await page.evaluate(measurements), groups, axes);
    await page.evaluate(rename, 0, 'Polyp, broad');
    await page.evaluate(rename, 1, 'not a polyp');
    await page.evaluate(remove, 2);
    writeFileSync(returned, await saveReport({ page, server }, name));
  } finally {
    await page.close();
    await server.close();
  }
  return groups.length;
}

async function becomesVerdicts(expected, name) {
  assert.equal(expected.reason, undefined);
  const returned = join(WORK, `returned${name}.dcm`);
  const count = await readInOhif(expected, name, returned);
  const bytes = readFileSync(returned);
  assert.equal(bytes.includes(expected.objects[0].uid), !name, 'a report in the series of the candidates names its predecessor');
  assert.ok(bytes.includes(name));
  const verdicts = join(WORK, `verdicts${name}.json`);
  const { status, stderr } = spawnSync(TOOL, [returned, SERIES, '--verdicts', verdicts, '--exam', EXAM], { encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  const { candidates, findings } = JSON.parse(readFileSync(verdicts, 'utf8'));
  const words = Array.from({ length: count }, (_, i) => ({ 0: 'polyp', 1: 'not a polyp' })[i] || 'unread');
  const ids = words.map((_, i) => `${i + 1}`);
  assert.deepEqual(candidates.map(({ id }) => id), ids.filter((id) => id !== '3'));
  assert.deepEqual(candidates.map(({ verdict }) => verdict), words.filter((_, i) => i !== 2));
  assert.equal(candidates[0].note, 'broad');
  assert.ok(candidates.every(({ size }) => size === null), 'no size was changed');
  assert.deepEqual(findings, []);
}

const expected = expectations();
const reason = (/No module named/.test(expected.reason) && expected.reason) || missing(PACKAGE);
if (reason) console.log(`skipped: ${reason}`);
else {
  test('candidates are read in OHIF, saved in their series, and become verdicts', () => becomesVerdicts(expected, ''));
  test('candidates are read in OHIF, saved in a new series, and become verdicts', () => becomesVerdicts(expected, 'Reader'));
}
