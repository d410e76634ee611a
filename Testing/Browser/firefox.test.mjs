// Tests views without WebGL in Firefox. usage: VIEWER=folder of viewer.html SPHERE=folder of index.html
// HEAT=folder of explorer.html [SHOTS=folder] node --test firefox.test.mjs
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launchFirefox } from './firefox.mjs';

const { VIEWER, SPHERE, HEAT, SHOTS } = process.env, FLAT_VIEWS = ['flat', 'axial', 'coronal', 'sagittal'];
let page;

before(async () => { page = await launchFirefox(); });
after(() => page.close());
const shot = async (name) => { if (SHOTS) await page.screenshot(`${SHOTS}/${name}.png`); };

test('without WebGL 2 the colon viewer shows a notice, and its 2D views still work', async () => {
  await page.open(`${VIEWER}/viewer.html`);
  await page.until(() => Boolean(window.viewer));
  assert.match(await page.evaluate(() => document.getElementById('notices').textContent), /no WebGL 2/);
  const idle = () => page.evaluate(() => viewer.idle());
  for (const name of FLAT_VIEWS) {
    const [x, y, w, h] = await page.evaluate((n) => {
      const r = document.querySelector(`[data-view=${n}]`).getBoundingClientRect();
      return [r.x, r.y, r.width, r.height];
    }, name);
    const at = [Math.round(x + 0.4 * w), Math.round(y + 0.6 * h)];
    await page.click(...at);
    await idle();
    const shown = await page.evaluate(() => Object.fromEntries(viewer.panels[0].views.map((v) => [v.box.dataset.view, v.shown])));
    for (const view of FLAT_VIEWS) assert.ok(shown[view], `${view} after a click on ${name}`);
    assert.ok(Math.hypot(shown[name][0] + x - at[0], shown[name][1] + y - at[1]) < 1.5, `${name}: the crosshair is at the click`);
    const colors = await page.evaluate((n) => {
      const { canvas, context } = viewer.panels[0].views.find((v) => v.box.dataset.view === n);
      return new Set(new Uint32Array(context.getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size;
    }, name);
    assert.ok(colors > 50, `${name} shows a picture`);
  }
  await page.key('n');
  await idle();
  assert.match(await page.evaluate(() => document.getElementById('status').textContent), /mm \(LPS\)/);
  await shot('firefox-viewer');
});

test('a click on a node of a graph page selects it', async () => {
  await page.open(`${SPHERE}/index.html`);
  await page.evaluate(() => graphPage.idle());
  const at = await page.evaluate(() => {
    const { box, picture: { tiles: [tile] } } = graphPage.views[0], { x, y } = box.getBoundingClientRect();
    const [a, b] = tile.pixelOf([0, 1, 2, 3, 4, 5, 6, 7].find((i) => tile.isSeen(i)));
    return [x + a, y + b];
  });
  await page.click(...at);
  await page.evaluate(() => graphPage.idle());
  assert.match(await page.evaluate(() => document.getElementById('summary').textContent), /^node \d+ of .* degree 3/);
  await shot('firefox-graph');
});

test('without WebGL 2 the heat explorer shows a notice, and a pick on the histogram colors the slices', async () => {
  await page.open(`${HEAT}/explorer.html`);
  await page.until(() => Boolean(window.explorer));
  assert.match(await page.evaluate(() => document.getElementById('notices').textContent), /no WebGL 2/);
  const pictures = () => page.evaluate(() => explorer.idle().then(() => explorer.slices.map((slice) => slice.canvas.toDataURL())));
  const at = await page.evaluate(() => { // center of a line found by the report
    const { axis, lines: [{ lower, upper }], histogramView: { canvas, plot } } = explorer, { x, y } = canvas.getBoundingClientRect();
    return [x + plot.left + axis.positionOf((lower + upper) / 2) * (plot.width - 1), y + plot.top + 0.6 * plot.height];
  });
  await page.evaluate(() => explorer.change({ lines: [] }));
  const empty = await pictures();
  await page.click(...at);
  const picked = await pictures();
  assert.equal(await page.evaluate(() => explorer.lines.length), 1);
  assert.notDeepEqual(picked, empty);
  await shot('firefox-explorer');
});
