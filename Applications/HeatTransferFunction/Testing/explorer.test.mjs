// Selects lines on the pages of two reports, in a headless Chromium, and passes the saved file to the tool.
// usage: HEAT=report RANGE=report with opened ranges DENSITY=report INPUT=volume HEATS=volume SNAPSHOTS=folder VISITS=volume
//        TOOL=HeatTransferFunction WORK=folder to write to [SHOTS=folder for pictures] node --test explorer.test.mjs
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { lowerEdge, volumeProperty } from '../../../Modules/Visualization/HeatViews/scripts/lines.mjs';
import { launch } from '../../../Testing/Browser/browser.mjs';

const { HEAT, RANGE, DENSITY, INPUT, HEATS, SNAPSHOTS, VISITS, TOOL, WORK, SHOTS } = process.env;
const CTRL = 2, SHIFT = 8, figures = {};
let page;

before(async () => {
  rmSync(WORK, { recursive: true, force: true });
  mkdirSync(`${WORK}/downloads`, { recursive: true });
  page = await launch({ width: 1280, height: 720, downloads: `${WORK}/downloads` });
  const started = Date.now();
  await open(HEAT);
  figures.open = Date.now() - started;
});
after(async () => {
  await page.close();
  console.log(JSON.stringify(figures));
});

// Whether everything is painted, the rendering at least coarsely.
const idle = () => page.evaluate(() => explorer.idle(true));
const notices = () => page.evaluate(() => document.getElementById('notices').textContent);
const shot = async (name) => {
  if (!SHOTS) return;
  await page.evaluate(() => explorer.idle());
  await page.screenshot(`${SHOTS}/${name}.png`);
};
const press = async (key, modifiers = 0) => { await page.key(key, modifiers); await idle(); };
const ranges = () => page.evaluate(() => explorer.lines.map((l) => [l.lower, l.upper]));

async function open(folder) {
  page.errors.length = 0;
  await page.open(`${folder}/explorer.html`);
  await page.until(() => Boolean(window.explorer) || document.body.classList.contains('failed'));
  if (await page.evaluate(() => Boolean(window.explorer))) await idle();
}

// Page coordinates of a position (0 to 1) on the histogram axis.
const onPlot = (position) => page.evaluate((p) => {
  const { histogramView: view } = explorer, { left, top, width, height } = view.plot, box = view.canvas.getBoundingClientRect();
  return [box.x + left + p * (width - 1), box.y + top + height * 0.6];
}, position);
const drag = async (from, to, modifiers = 0) => {
  const [x, y] = await onPlot(from), [end] = await onPlot(to);
  await page.mouse('mouseMoved', x, y);
  await page.mouse('mousePressed', x, y, { modifiers });
  for (const share of [0.4, 1]) await page.mouse('mouseMoved', x + share * (end - x), y, { button: 'left', buttons: 1, modifiers });
  await page.mouse('mouseReleased', end, y, { modifiers });
  await idle();
};

// Visible colors in a view: number of pixels with a distinct hue.
const hues = (name) => page.evaluate((n) => {
  const { canvas, context } = [explorer.rendering, explorer.histogramView, ...explorer.slices].find((v) => v.box.dataset.view === n);
  const { data } = context.getImageData(0, 0, canvas.width, canvas.height), count = { red: 0, green: 0, blue: 0 };
  for (let i = 0; i < data.length; i += 4) {
    const [r, g, b] = data.subarray(i, i + 3), is = (x, y, z) => x > 1.3 * Math.max(y, z) + 12;
    if (is(r, g, b)) count.red++;
    if (is(g, r, b)) count.green++;
    if (is(b, r, g)) count.blue++;
  }
  return count;
}, name);
const pictures = () => page.evaluate(() => explorer.slices.map((slice) => slice.canvas.toDataURL()));
const setLines = async (lines) => {
  await page.evaluate((l) => explorer.change({ lines: l.map((line) => ({ isOn: true, ...line })) }), lines);
  await idle();
};

const saved = (name, key, modifiers = 0) => page.saved(name, () => press(key, modifiers));
const run = (...options) => {
  const { status, stderr } = spawnSync(TOOL, [...options, '--quiet'], { encoding: 'utf8' });
  return { status, stderr };
};
const runWell = (...options) => assert.deepEqual(run(...options), { status: 0, stderr: '' });
const flagOf = (lines) => lines.map((l) => `${l.lower}-${l.upper}:${l.color}:${l.opacity}`).join(',');

test('opens without errors and without a network, with the lines of the report', async () => {
  await shot('1-open');
  assert.deepEqual(page.errors, []);
  assert.deepEqual(page.requests.filter((r) => !/^(file|blob|data):/.test(r)), []);
  assert.match(await page.evaluate(() => document.querySelector('footer').innerText), /For research use; not a diagnosis\./);
  assert.ok(statSync(`${HEAT}/explorer.html`).size < 150e3);
  const report = JSON.parse(readFileSync(`${HEAT}/report.json`, 'utf8')), lines = await page.evaluate(() => explorer.lines);
  assert.equal(flagOf(lines), report.transferFunction);
  const rows = readFileSync(`${HEAT}/classes.csv`, 'utf8').trim().split('\n').slice(1).map((row) => row.split(',').map(Number));
  const sizes = await page.evaluate(() => explorer.lines.map((line) => Number(explorer.sizeOf(line).replace(/ .*|,/g, ''))));
  lines.forEach((line, i) => assert.equal(sizes[i], rows.find(([, lower]) => lower === line.lower)[4], `voxels of line ${i + 1}`));
});

test('a click picks a line, which colors all views at once; undo and redo', async () => {
  await setLines([]);
  const empty = await pictures(), count = () => page.evaluate(() => explorer.lines.length);
  assert.equal((await hues('rendering')).blue, 0);
  const places = await page.evaluate(() => { // the three separate bins with most voxels
    const order = [...explorer.counts.keys()].slice(1).sort((a, b) => explorer.counts[b] - explorer.counts[a]), out = [];
    for (const bin of order) if (out.every((b) => Math.abs(b - bin) > 60)) out.push(bin);
    const lower = (bin) => (1 + ((bin - 1) % 256) / 256) * 2 ** (Math.floor((bin - 1) / 256) - 16);
    return out.slice(0, 3).map((bin) => ({ bin, position: explorer.axis.positionOf((lower(bin) + lower(bin + 1)) / 2) }));
  });
  for (const [i, { bin, position }] of places.entries()) {
    const started = Date.now();
    await page.click(...await onPlot(position));
    await idle();
    (figures.pick ??= []).push(Date.now() - started);
    assert.equal(await count(), i + 1);
    const [lower, upper] = await page.evaluate(() => { const l = explorer.lines[explorer.chosen]; return [l.lower, l.upper]; });
    assert.ok(lower <= lowerEdge(bin) && lowerEdge(bin + 1) <= upper, `bin ${bin} is not from ${lower} to ${upper}`);
  }
  await shot('2-picked');
  const picked = await pictures();
  assert.notDeepEqual(picked, empty);
  for (let i = 0; i < 3; i++) await press('z', CTRL);
  assert.deepEqual(await pictures(), empty);
  for (let i = 0; i < 3; i++) await press('y', CTRL);
  assert.deepEqual(await pictures(), picked);
});

test('voxels are classified before colors are interpolated: a line without voxels is invisible', async () => {
  const gap = await page.evaluate(() => { // the widest gap in the heat below the highest frequent heat
    const { counts } = explorer, lower = (bin) => (1 + ((bin - 1) % 256) / 256) * 2 ** (Math.floor((bin - 1) / 256) - 16);
    let best = [0, 0], start = null;
    for (let bin = 1; bin < counts.length; bin++) {
      if (counts[bin]) { if (start !== null && bin - start > best[1] - best[0]) best = [start, bin]; start = bin + 1; }
    }
    return best.map(lower);
  });
  const opaque = { opacity: 1 }, [from, to] = gap;
  await setLines([{ lower: from, upper: to, color: '#00ff00', ...opaque }, { lower: to, upper: 1, color: '#ff0000', ...opaque }]);
  for (const view of ['rendering', 'axial', 'coronal', 'sagittal']) assert.equal((await hues(view)).green, 0, view);
  assert.ok((await hues('rendering')).red > 500);
  await shot('3-classified');
});

test('the page and the tool save identical files', async () => {
  await setLines([]);
  await drag(0.2, 0.45);
  await drag(0.6, 0.8);
  await press('k');
  await press('-');
  await shot('4-ranges');
  const lines = await page.evaluate(() => explorer.lines);
  assert.equal(lines.length, 2);
  const vp = await saved('transfer-function.vp', 'w'), json = await saved('transfer-function.json', 's', CTRL);
  runWell(INPUT, HEATS, `${WORK}/from.vp`, '--from', json, '--picture', `${WORK}/from.png`);
  runWell(INPUT, HEATS, `${WORK}/lines.vp`, '--lines', flagOf(lines), '--timeStep', '5000', '--picture', `${WORK}/lines.png`);
  const same = (a, b) => assert.ok(readFileSync(a).equals(readFileSync(b)), `${a} and ${b} differ`);
  same(vp, `${WORK}/from.vp`);
  same(vp, `${WORK}/lines.vp`);
  same(`${WORK}/from.png`, `${WORK}/lines.png`);
  const { status, stderr } = run(INPUT, VISITS, `${WORK}/x.vp`, '--from', json);
  assert.equal(status, 2, stderr); // another time step
  writeFileSync(json, readFileSync(json, 'utf8').replace('5000', '500'));
  assert.deepEqual(run(INPUT, VISITS, `${WORK}/x.vp`, '--from', json).status, 3);
  assert.match(run(INPUT, VISITS, `${WORK}/x.vp`, '--from', json).stderr, /were picked on heat, but .* contains density/);
});

test('volume properties of the page and the tool are byte-identical', () => {
  let seed = 12345;
  const random = () => { seed = (1103515245 * seed + 12345) % 2 ** 31; return seed / 2 ** 31; };
  for (let n = 0; n < 3; n++) {
    const bins = Array.from({ length: 14 }, () => 1 + Math.floor(4096 * random() ** 0.4)).sort((a, b) => a - b);
    const opacity = () => Math.round(100 * random()) / 100;
    const lines = bins.slice(1).map((bin, i) => ({ lower: lowerEdge(bins[i]), upper: lowerEdge(bin), opacity: opacity() }))
      .filter((l, i) => l.lower < l.upper && i % 4 !== n)
      .map((l) => ({ ...l, color: `#${Math.floor(random() * 2 ** 24).toString(16).padStart(6, '0')}` }));
    runWell(INPUT, HEATS, `${WORK}/random.vp`, '--lines', flagOf(lines));
    assert.equal(volumeProperty(lines, 1), readFileSync(`${WORK}/random.vp`, 'utf8'));
  }
});

test('another stored time step', async () => {
  const [x, y] = await page.evaluate(() => {
    const { histogramView: view } = explorer, box = view.canvas.getBoundingClientRect();
    return [box.x + 20, box.y + view.yOf(1000)];
  });
  await page.click(x, y);
  await idle();
  assert.equal(await page.evaluate(() => explorer.step), 1000);
  const json = await saved('transfer-function.json', 's', CTRL);
  assert.equal(JSON.parse(readFileSync(json, 'utf8')).timeStep, 1000);
  runWell(INPUT, SNAPSHOTS, `${WORK}/step.vp`, '--from', json); // snapshot of this step
  assert.equal(run(INPUT, HEATS, `${WORK}/x.vp`, '--from', json).status, 2);
  await press('PageUp');
  assert.equal(await page.evaluate(() => explorer.step), 100);
  for (const key of ['PageDown', 'PageDown']) await press(key);
  assert.equal(await page.evaluate(() => explorer.step), 5000);
});

test('nested ranges are opened, and lines picked in them', async () => {
  await setLines([]);
  await drag(0.3, 0.7, SHIFT);
  const [first] = await page.evaluate(() => explorer.state.ranges);
  assert.deepEqual(await page.evaluate(() => [explorer.axis.lower, explorer.axis.upper]), first);
  await drag(0.25, 0.75, SHIFT);
  const [, second] = await page.evaluate(() => explorer.state.ranges);
  assert.ok(first[0] < second[0] && second[1] < first[1]);
  await drag(0.1, 0.6);
  const [[lower, upper]] = await ranges();
  assert.ok(second[0] <= lower && lower < upper && upper < second[1]);
  await shot('5-opened');
  assert.match(await page.evaluate(() => document.getElementById('ranges').textContent), /^axis: all › .+ › .+$/);
  await press('b');
  await press('b');
  assert.equal(await page.evaluate(() => explorer.state.ranges.length), 0);
  const [x, y] = await onPlot(await page.evaluate(() => explorer.axis.positionOf((explorer.lines[0].lower + explorer.lines[0].upper) / 2)));
  for (const clickCount of [1, 2]) for (const type of ['mousePressed', 'mouseReleased']) await page.mouse(type, x, y, { clickCount });
  await idle();
  assert.deepEqual(await page.evaluate(() => explorer.state.ranges), [[lower, upper]]);
  await press('z', CTRL);
  assert.equal(await page.evaluate(() => explorer.state.ranges.length), 0);
});

test('ranges opened by the tool are open initially', async () => {
  await open(RANGE);
  assert.deepEqual(await page.evaluate(() => explorer.state.ranges), [[0.14, 0.3], [0.145, 0.17]]);
  assert.deepEqual(await page.evaluate(() => [explorer.axis.lower, explorer.axis.upper]), [0.145, 0.17]);
  await press('b');
  assert.deepEqual(await page.evaluate(() => [explorer.axis.lower, explorer.axis.upper]), [0.14, 0.3]);
  assert.deepEqual(page.errors, []);
  await open(HEAT);
});

test('all actions by keys', async () => {
  await setLines([]);
  for (let i = 0; i < 10; i++) await page.key('ArrowRight');
  await page.key('m');
  for (let i = 0; i < 20; i++) await page.key('ArrowRight');
  await press('Enter');
  assert.equal((await ranges()).length, 1);
  const line = () => page.evaluate(() => explorer.lines[explorer.chosen]);
  const old = await line();
  for (const key of ['k', '+', '[', '}', 'h']) await press(key);
  const now = await line();
  assert.ok(now.color !== old.color && now.opacity === 0.65 && now.lower < old.lower && now.upper > old.upper && !now.isOn);
  await press('h');
  await press('o');
  assert.equal(await page.evaluate(() => explorer.state.ranges.length), 1);
  await press('b');
  const place = () => page.evaluate(() => explorer.place), start = await place();
  for (const key of ['a', 'c', 's', 's']) await press(key);
  await press('S', SHIFT);
  assert.deepEqual((await place()).map((x, k) => x - start[k]), [1, 1, 1]);
  await press('ArrowLeft', SHIFT);
  assert.equal(await page.evaluate(() => explorer.rendering.azimuth), -15);
  await page.key('?');
  assert.ok(await page.evaluate(() => document.getElementById('keys').open));
  await press('Escape');
  await press('f');
  await shot('6-full');
  await press('Escape');
  await press('Delete');
  assert.equal((await ranges()).length, 0);
  await press('w');
  assert.match(await page.evaluate(() => document.getElementById('status').textContent), /nothing to save/);
});

test('a click on a slice moves the crosshair to the voxel', async () => {
  const { x, y, index } = await page.evaluate(() => {
    const [slice] = explorer.slices, place = [...explorer.place], { across, down } = slice.plane;
    const box = slice.canvas.getBoundingClientRect();
    place[across] -= 4;
    place[down] += 3;
    const [a, b] = slice.frame().at(place);
    return { x: box.x + a, y: box.y + b, index: place };
  });
  await page.click(x, y);
  await idle();
  assert.deepEqual(await page.evaluate(() => explorer.place), index);
  await press('l');
  const [heat, [[lower, upper]]] = [await page.evaluate(() => explorer.heatHere()), await ranges()];
  assert.ok(lower <= heat && heat < upper, 'the line of the voxel was picked');
});

test('densities of shapetons: lines are in visits', async () => {
  await open(DENSITY);
  await shot('7-density');
  assert.deepEqual(page.errors, []);
  const vp = await saved('transfer-function.vp', 'w'), json = await saved('transfer-function.json', 's', CTRL);
  runWell(INPUT, VISITS, `${WORK}/visits.vp`, '--from', json);
  assert.ok(readFileSync(vp).equals(readFileSync(`${WORK}/visits.vp`)));
});

const broken = (file, isRemoved) => {
  const folder = `${WORK}/broken`, path = `${folder}/explorer/${file}`;
  rmSync(folder, { recursive: true, force: true });
  cpSync(HEAT, folder, { recursive: true });
  const text = readFileSync(path, 'utf8');
  if (isRemoved) rmSync(path); else writeFileSync(path, text.slice(0, text.length / 2));
  return folder;
};

test('damaged and missing data are reported, and the rest of the page works', async () => {
  for (const file of ['gray.js', 'bins-5000.js']) {
    await open(broken(file));
    assert.match(await notices(), new RegExp(`The data .* in explorer/${file} is damaged`));
  }
  await open(broken('histogram.js', true));
  assert.match(await notices(), /explorer\/histogram\.js of this page is missing/);
  await open(broken('bins-100.js'));
  const before = await ranges();
  await press('PageUp');
  await press('PageUp');
  assert.match(await notices(), /bins-100\.js is damaged/);
  assert.equal(await page.evaluate(() => explorer.step), 1000);
  assert.deepEqual(await ranges(), before);
});

test('a file that is not a transfer function is rejected, a saved one is opened', async () => {
  await open(HEAT);
  const old = await ranges(), json = await saved('transfer-function.json', 's', CTRL);
  writeFileSync(`${WORK}/other.json`, '{"lines": []}');
  await page.chooseFile('#file', `${WORK}/other.json`);
  await page.until(() => document.getElementById('notices').textContent.includes('not a transfer function'));
  await setLines([]);
  await page.chooseFile('#file', json);
  await page.until(() => explorer.lines.length > 0);
  await idle();
  assert.deepEqual(await ranges(), old);
});

test('without DecompressionStream and without WebGL 2', async () => {
  const { identifier } = await page.send('Page.addScriptToEvaluateOnNewDocument', { source: 'delete globalThis.DecompressionStream' });
  await open(HEAT);
  assert.match(await notices(), /lacks DecompressionStream.*Firefox 113/);
  await page.send('Page.removeScriptToEvaluateOnNewDocument', { identifier });
  await page.close();
  page = await launch({ width: 1280, height: 720, hasGl: false });
  await open(HEAT);
  assert.match(await notices(), /no WebGL 2/);
  const old = await pictures();
  await setLines([]);
  assert.notDeepEqual(await pictures(), old);
  await shot('8-no-webgl');
  assert.deepEqual(page.errors, []);
});
