// Follows a run on its preview page, in a headless Chromium.
// usage: TOOL=ShapetonDiffusion INPUT=volume WORK=folder to write to [SHOTS=folder for pictures] node --test preview.test.mjs
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, rmSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { launch } from '../../../Testing/Browser/browser.mjs';

const { TOOL, INPUT, WORK, SHOTS } = process.env;
const OPTIONS = ['--preset', 'published', '--shapetons', '20000',
  '--distance', '0.03', '--preview', `${WORK}/now.html`, '--previewEvery', '0.3', '--quiet'];
let page, run;

before(async () => {
  rmSync(WORK, { recursive: true, force: true });
  mkdirSync(WORK, { recursive: true });
  page = await launch();
});
after(async () => {
  run?.kill();
  await page.close();
});

const open = async () => {
  await page.open(`${WORK}/now.html`);
  await page.until(() => Boolean(window.explorer) || document.body.classList.contains('failed'));
  assert.equal(await page.evaluate(() => document.getElementById('notices').textContent), '');
};
const sleep = (ms) => new Promise((done) => { setTimeout(done, ms); });
const step = () => page.evaluate(() => explorer.step);
const nextStep = async () => {
  const old = await step();
  await page.until((s) => explorer.step > s && !explorer.busy, 60000, old);
  return step();
};

test('the page follows the growing density and keeps the picked lines', async () => {
  run = spawn(TOOL, [INPUT, `${WORK}/density.nrrd`, '--timeSteps', '100000000', ...OPTIONS], { stdio: 'ignore' });
  for (let i = 0; i < 600 && !existsSync(`${WORK}/now-data/live.js`); i++) await sleep(50);
  await open();
  const first = await step(), second = await nextStep();
  assert.ok(second > first);
  assert.match(await page.evaluate(() => document.getElementById('progress').textContent), /^Step .*coverage/);
  await page.evaluate(async () => { explorer.pickPlaces(0.6, 0.9); await explorer.idle(true); });
  const picked = await page.evaluate(() => JSON.stringify(explorer.lines));
  await nextStep();
  await nextStep();
  assert.equal(await page.evaluate(() => JSON.stringify(explorer.lines)), picked);
  await page.evaluate(() => explorer.idle(true));
  if (SHOTS) await page.screenshot(`${SHOTS}/live.png`);
  assert.deepEqual(page.errors, []);
});

test('a killed run leaves a complete page and no partial files', async () => {
  const gone = new Promise((done) => { run.on('exit', done); });
  run.kill();
  await gone;
  assert.deepEqual(readdirSync(WORK).sort(), ['now-data', 'now.html']);
  assert.deepEqual(readdirSync(`${WORK}/now-data`).sort(), ['gray.js', 'info.js', 'live.js']);
  await open();
  assert.ok(await step() > 0);
});

test('a finished run leaves its last state, marked as finished', async () => {
  const { status, stderr } = spawnSync(TOOL, [INPUT, `${WORK}/density.nrrd`, '--timeSteps', '400', ...OPTIONS], { encoding: 'utf8' });
  assert.deepEqual({ status, stderr }, { status: 0, stderr: '' });
  await open();
  assert.equal(await step(), 400);
  assert.match(await page.evaluate(() => document.getElementById('progress').textContent), /, finished$/);
  assert.deepEqual(page.errors, []);
});
