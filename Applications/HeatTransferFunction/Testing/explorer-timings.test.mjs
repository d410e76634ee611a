// Response times on a full-size volume on an idle machine, in a headless Chromium without a graphics card.
// usage: REPORT=folder of explorer.html node --test explorer-timings.test.mjs
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch } from '../../../Testing/Browser/browser.mjs';

const figures = {};
let page;

before(async () => {
  page = await launch({ width: 1280, height: 720 });
  const started = Date.now();
  await page.open(`${process.env.REPORT}/explorer.html`);
  await page.until(() => Boolean(window.explorer) || document.body.classList.contains('failed'));
  await page.evaluate(() => explorer.idle());
  figures.open = Date.now() - started;
});
after(async () => {
  await page.close();
  console.log(JSON.stringify(figures));
});

// Milliseconds until the lines of the report, with this opacity, are painted coarsely, and until the fine frame.
const pick = (opacity) => page.evaluate(async (o) => {
  const started = performance.now();
  explorer.change({ lines: explorer.lines.map((line) => ({ ...line, opacity: o, isOn: true })) });
  await explorer.idle(true);
  const repaint = performance.now() - started;
  await explorer.idle();
  return { repaint: Math.round(repaint), frame: Math.round(explorer.times.fine) };
}, opacity);

test('a change is painted within one second, and its fine frame within three', async () => {
  assert.deepEqual(await page.evaluate(() => [explorer.lines.length > 0, ...explorer.info.volume.size]), [true, 256, 256, 256]);
  figures.picks = [];
  for (const opacity of [1, 0.5, 0.1, 0.02]) figures.picks.push(await pick(opacity));
  assert.ok(figures.picks.every(({ repaint, frame }) => repaint < 1000 && frame < 3000), JSON.stringify(figures.picks));
});
