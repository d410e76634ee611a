// Selects, colors and saves objects on the page of HeatObjects, in a headless Chromium, and passes the saved file to the tool.
// usage: PAGE=folder of explorer.html TABLE=objects.csv LABELS=volume INPUT=volume HEAT=volume OTHER=labels of other objects
//        FIND=HeatObjects DRAW=HeatTransferFunction WORK=folder to write to [SHOTS=folder for pictures] node --test objects.test.mjs
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { launch } from '../../../Testing/Browser/browser.mjs';

const { PAGE, TABLE, LABELS, INPUT, HEAT, OTHER, FIND, DRAW, WORK, SHOTS } = process.env;
const CTRL = 2, SHIFT = 8, BALL = [-15, 0, -8]; // LPS in mm, of the scene
const rows = readFileSync(TABLE, 'utf8').trim().split('\n').map((row) => row.split(','));
const table = rows.slice(1).map((row) => Object.fromEntries(rows[0].map((name, i) => [name, Number(row[i])])));
let page;

const idle = () => page.evaluate(() => explorer.idle(true));
const press = async (key, modifiers = 0) => { await page.key(key, modifiers); await idle(); };
const selected = () => page.evaluate(() => explorer.selected);
const status = () => page.evaluate(() => document.getElementById('status').textContent);
const shot = async (name) => {
  if (!SHOTS) return;
  await page.evaluate(() => explorer.idle());
  await page.screenshot(`${SHOTS}/${name}.png`);
};

// Clicks the voxel of a point in the axial slice through it.
async function clickAt(point, modifiers = 0) {
  const [x, y] = await page.evaluate((p) => {
    const { origin, axes, spacing } = explorer.volume, [slice] = explorer.slices;
    const index = axes.map((axis, k) => Math.round(axis.reduce((sum, c, i) => sum + c * (p[i] - origin[i]), 0) / spacing[k]));
    explorer.moveTo(explorer.place.map((i, k) => (k === slice.plane.through ? index[k] : i)));
    const { x: left, y: top } = slice.canvas.getBoundingClientRect(), [a, b] = slice.frame().at(index);
    return [left + a, top + b];
  }, point);
  await page.click(x, y, { modifiers });
  await idle();
  return [x, y];
}

// Operates a field in the list entry of an object.
const enter = async (number, selector, property, value) => {
  await page.evaluate((n, s, p, v) => {
    const field = document.querySelectorAll('#objects li')[n - 1].querySelector(s);
    field[p] = v;
    for (const type of ['input', 'change']) field.dispatchEvent(new Event(type));
  }, number, selector, property, value);
  await idle();
};
const show = (number, isShown) => enter(number, '[type=checkbox]', 'checked', isShown);

// Number of voxels of each class that the views show.
const voxelsOfClasses = () => page.evaluate(() => {
  const { values, numbers } = explorer.shown, out = {};
  for (const value of values) out[numbers[value]] = (out[numbers[value]] ?? 0) + 1;
  return out;
});

const saved = (name, key, modifiers = 0) => page.saved(name, () => press(key, modifiers));
const run = (tool, ...options) => {
  const { status: code, stderr } = spawnSync(tool, [...options, '--quiet'], { encoding: 'utf8' });
  return { code, stderr };
};
const runWell = (...options) => assert.deepEqual(run(...options), { code: 0, stderr: '' });

// Number of different pixels of two pictures of HeatTransferFunction, in the rendering and the slices; the legend differs.
const differences = (a, b) => page.evaluate(async (one, other) => {
  const dataOf = async (base64) => {
    const picture = new Image();
    picture.src = `data:image/png;base64,${base64}`;
    await picture.decode();
    const { width, height } = picture, context = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d');
    context.drawImage(picture, 0, 0);
    const parts = [[16, 64, 860, 620], [0, 690, width, height - 690]];
    return parts.map((part) => new Uint32Array(context.getImageData(...part).data.buffer));
  };
  const [p, q] = [await dataOf(one), await dataOf(other)];
  return p.map((part, k) => part.reduce((sum, pixel, i) => sum + (pixel !== q[k][i]), 0));
}, ...[a, b].map((file) => readFileSync(file).toString('base64')));

before(async () => {
  rmSync(WORK, { recursive: true, force: true });
  mkdirSync(`${WORK}/downloads`, { recursive: true });
  page = await launch({ width: 1280, height: 720, downloads: `${WORK}/downloads` });
  await page.open(`${PAGE}/explorer.html`);
  await page.until(() => Boolean(window.explorer) || document.body.classList.contains('failed'));
  await idle();
});
after(() => page.close());

test('opens without errors and without a network, with the objects of the table', async () => {
  await shot('1-open');
  assert.deepEqual(page.errors, []);
  assert.deepEqual(page.requests.filter((r) => !/^(file|blob|data):/.test(r)), []);
  const texts = await page.evaluate(() => [...document.querySelectorAll('#objects .head')].map((head) => head.textContent));
  assert.equal(texts.length, table.length);
  texts.forEach((text, i) => {
    assert.ok(text.startsWith(`${i + 1}: `) && text.endsWith(`${Math.round(100 * table[i].probability)} %`), text);
  });
  const counts = await page.evaluate(() => {
    const out = Array(explorer.objects.length + 1).fill(0);
    for (const label of explorer.labels) out[label]++;
    return out;
  });
  const isIn = (row, object) => row.object === object || (row.parent > 0 && isIn(table[row.parent - 1], object));
  for (const { object, voxels } of table) { // with those in it
    assert.equal(table.reduce((sum, row) => sum + (isIn(row, object) ? counts[row.object] : 0), 0), voxels, `object ${object}`);
  }
});

test('a click on a slice selects the most probable object, and the wheel and keys climb', async () => {
  const ball = table.find(({ x, z }) => Math.abs(x - BALL[0]) < 1 && Math.abs(z - BALL[2]) < 1);
  const [x, y] = await clickAt(BALL);
  assert.equal(await selected(), ball.object);
  assert.match(await status(), new RegExp(`, object ${ball.object} in ${ball.parent}`));
  const voxels = await voxelsOfClasses(), [shown] = Object.keys(voxels).filter((n) => n > 0);
  assert.equal(voxels[shown], ball.voxels); // nothing else is shown
  await shot('2-selected');
  await press('u');
  assert.equal(await selected(), ball.parent);
  assert.deepEqual(Object.values(await voxelsOfClasses()).slice(1), [table[ball.parent - 1].voxels]);
  await press('u'); // this object is the largest of its chain
  assert.equal(await selected(), ball.parent);
  await press('U', SHIFT);
  assert.equal(await selected(), ball.object);
  for (const [deltaY, object] of [[-100, ball.parent], [100, ball.object]]) {
    await page.wheel(x, y, deltaY, { modifiers: SHIFT });
    await page.until((n) => explorer.selected === n, 5000, object);
  }
  await page.evaluate(() => document.getElementById('larger').click());
  assert.equal(await selected(), ball.parent);
  await page.evaluate(() => document.querySelectorAll('#objects .head')[2].click());
  assert.equal(await selected(), 3);
  await page.evaluate(() => document.getElementById('all').click());
  assert.equal(await selected(), 0);
});

test('the pointer shows the object there, and clicks join objects or exclude them', async () => {
  const [ball, box] = [table.find(({ object }) => object === 2), table.find(({ parent, object }) => parent === 0 && object > 1)];
  const [x, y] = await clickAt(BALL);
  await page.evaluate(() => document.getElementById('all').click());
  await page.move(5, 5);
  await page.until(() => explorer.pointed === 0, 5000);
  await page.move(x + 1, y + 1);
  await page.until(() => explorer.pointed > 0, 5000);
  assert.equal(await page.evaluate(() => explorer.pointed), ball.object);
  assert.match(await status(), new RegExp(`^object ${ball.object}: .*, ${Math.round(100 * ball.probability)} %$`));
  await clickAt(BALL);
  await clickAt([box.x, box.y, box.z], CTRL);
  assert.deepEqual(await page.evaluate(() => explorer.selection), [ball.object, box.object]);
  assert.match(await status(), new RegExp(`HeatObjects --objects ${ball.object},${box.object}$`));
  const shown = await voxelsOfClasses();
  assert.deepEqual(Object.keys(shown).length, 3); // both and the rest
  await shot('2-joined');
  runWell(FIND, INPUT, HEAT, `${WORK}/joined.nrrd`, `${WORK}/joined.csv`, '--objects', `${ball.object},${box.object}`);
  assert.equal(readFileSync(`${WORK}/joined.csv`, 'utf8').trim().split('\n').length, 3);
  await clickAt([box.x, box.y, box.z], CTRL);
  assert.deepEqual(await page.evaluate(() => explorer.selection), [ball.object]);
  await press('x');
  await clickAt(BALL);
  assert.equal(await selected(), ball.parent);
  assert.ok(!(await page.evaluate(() => document.getElementById('objects').textContent)).includes(`${ball.object}: `));
  await press('z', CTRL);
  await clickAt(BALL);
  assert.equal(await selected(), ball.object);
  await page.evaluate(() => document.getElementById('all').click());
});

test('a click on the rendering selects the first visible object', async () => {
  const clickRendering = async (point) => {
    const [x, y] = await page.evaluate((p) => {
      const { rendering, volume: { origin, axes, spacing } } = explorer, { x: left, y: top } = rendering.canvas.getBoundingClientRect();
      const [a, b] = rendering.pixelOf(axes.map((axis, k) => axis.reduce((sum, c, i) => sum + c * (p[i] - origin[i]), 0) / spacing[k]));
      return [left + a, top + b];
    }, point);
    await page.click(x, y);
    await idle();
  };
  await clickRendering(BALL);
  assert.equal(await selected(), 2);
  await page.evaluate(() => document.getElementById('all').click());
  await page.evaluate(() => document.getElementById('picking').click());
  await clickRendering(BALL);
  assert.equal(await selected(), 0);
  await page.evaluate(() => document.getElementById('picking').click());
});

test('colors are saved, and the tool draws the same objects', async () => {
  for (const { object } of table) await show(object, false);
  await enter(2, '[type=color]', 'value', '#ff0000');
  await enter(2, '[type=range]', 'value', '1');
  assert.deepEqual(await page.evaluate(() => explorer.state.styles[1]), { isOn: true, isExcluded: false, color: '#ff0000', opacity: 1 });
  await shot('3-colored');
  const json = await saved('transfer-function.json', 's', CTRL), { version, lines, objects } = JSON.parse(readFileSync(json, 'utf8'));
  const ball = { number: 2, labels: [2], voxels: table[1].voxels, color: '#ff0000', opacity: 1 };
  assert.deepEqual([version, lines, objects], [2, [], [ball]]);
  const chosen = ['--from', json, '--objects', LABELS];
  runWell(DRAW, INPUT, HEAT, `${WORK}/object.vp`, ...chosen, '--picture', `${WORK}/object.png`, '--report', `${WORK}/report`);
  // The same voxels, found by a point and drawn as the only line of their mask.
  const point = ['--select', BALL.join(',')];
  runWell(FIND, INPUT, HEAT, `${WORK}/mask.nrrd`, `${WORK}/mask.csv`, ...point);
  runWell(DRAW, INPUT, `${WORK}/mask.nrrd`, `${WORK}/mask.vp`, '--lines', '0.5-1:#ff0000:1', '--picture', `${WORK}/mask.png`);
  assert.deepEqual(await differences(`${WORK}/object.png`, `${WORK}/mask.png`), [0, 0]);
  assert.match(readFileSync(`${WORK}/report/report.json`, 'utf8'), /"chosen\.objects": "2:#ff0000:1"/);
  assert.match(readFileSync(`${WORK}/report/index.html`, 'utf8'), /The heat volume with objects/);
});

test('an object in another one is drawn above it, as on the page', async () => {
  await enter(1, '[type=color]', 'value', '#0000ff');
  const json = await saved('transfer-function.json', 's', CTRL);
  const [, small, large] = Object.values(await voxelsOfClasses()); // none, object 1 without the large ball, the large ball
  assert.deepEqual([small, large], [table[0].voxels - table[1].voxels, table[1].voxels]);
  const { objects } = JSON.parse(readFileSync(json, 'utf8'));
  assert.deepEqual(objects.map(({ number, labels }) => [number, labels]), [[1, [1, 2, 4]], [2, [2]]]);
  runWell(DRAW, INPUT, HEAT, `${WORK}/two.vp`, '--from', json, '--objects', LABELS, '--picture', `${WORK}/two.png`);
  writeFileSync(json, readFileSync(json, 'utf8').replace(`"voxels": ${table[1].voxels}`, '"voxels": 3'));
  const { code, stderr } = run(DRAW, INPUT, HEAT, `${WORK}/x.vp`, '--from', json, '--objects', LABELS);
  assert.equal(code, 3);
  assert.match(stderr, /object 2 has \d+ voxels in .*, but 3 in the transfer function: use the labels/);
});

test('undo, and files that are opened again', async () => {
  const styles = () => page.evaluate(() => explorer.state.styles), colored = await styles();
  const json = await saved('transfer-function.json', 's', CTRL);
  for (const { object } of table) await show(object, false);
  await press('z', CTRL);
  await press('y', CTRL);
  assert.ok((await styles()).every(({ isOn }) => !isOn));
  await page.chooseFile('#file', json);
  await page.until(() => explorer.state.styles.some(({ isOn }) => isOn));
  await idle();
  assert.deepEqual(await styles(), colored);
  writeFileSync(`${WORK}/other.json`, readFileSync(json, 'utf8').replace('"number": 2', '"number": 3'));
  await page.chooseFile('#file', `${WORK}/other.json`);
  await page.until(() => /colors other objects/.test(document.getElementById('notices').textContent));
  assert.deepEqual(await styles(), colored);
});

test('a .vp has the heat range of an object, if picked as a line', async () => {
  await press('w');
  assert.match(await status(), /pick a line first; a \.vp has heat ranges, not objects/);
  await page.evaluate(() => [...document.querySelectorAll('#objects li')[1].querySelectorAll('button')].at(-1).click());
  await idle();
  const [line, isWhole] = await page.evaluate(() => {
    const { lines: [first], counts, labels, bins, numbers } = explorer;
    return [first, labels.every((label, v) => label !== 2 || numbers[bins[v]] === 1) && counts.length > 0];
  });
  assert.ok(isWhole && line.color === '#ff0000');
  const vp = await saved('transfer-function.vp', 'w');
  assert.match(await status(), /saved without the objects/);
  const json = await saved('transfer-function.json', 's', CTRL);
  runWell(DRAW, INPUT, HEAT, `${WORK}/line.vp`, '--from', json, '--objects', LABELS);
  assert.ok(readFileSync(vp).equals(readFileSync(`${WORK}/line.vp`)));
  const refused = run(DRAW, INPUT, HEAT, `${WORK}/x.vp`, '--from', json);
  assert.equal(refused.code, 2);
  assert.match(refused.stderr, /colors objects: state their labels, written by HeatObjects, with --objects/);
  const other = run(DRAW, INPUT, HEAT, `${WORK}/x.vp`, '--from', json, '--objects', OTHER);
  assert.equal(other.code, 3);
  assert.match(other.stderr, /other\.nrrd: the labels and the volume have different grids/);
  assert.deepEqual(page.errors, []);
});
