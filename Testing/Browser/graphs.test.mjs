// Tests the graph pages of the tools like a user, in headless Chromium from file://.
// usage: SPHERE=folder of index.html TORUS=... DISK=... COMPARED=... STEPS=... [SHOTS=folder for pictures] node --test graphs.test.mjs
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { launch } from './browser.mjs';

const { SPHERE, TORUS, DISK, COMPARED, STEPS, SHOTS } = process.env;
const SHIFT = 8, CHOSEN = [0, 114, 178], NEAR = [213, 94, 0];
let page;

before(async () => { page = await launch({ width: 1280, height: 1000 }); });
after(() => page.close());

const idle = () => page.evaluate(() => graphPage.idle());
const open = async (folder) => {
  page.errors.length = page.requests.length = 0;
  await page.open(`${folder}/index.html`);
  await idle();
};
const shot = async (name) => { if (SHOTS) await page.screenshot(`${SHOTS}/${name}.png`); };
const press = async (key, modifiers = 0) => { await page.key(key, modifiers); await idle(); };
const click = async ([x, y]) => { await page.click(x, y); await idle(); };
const summary = () => page.evaluate(() => document.getElementById('summary').textContent);
const found = () => page.evaluate(() => document.getElementById('found').textContent);
const picture = () => page.evaluate(() => graphPage.views[0].picture.canvas.toDataURL());

// Window position of a node or of the middle of an edge in a view, and its name; in a tile of the cover.
const place = (view, kind, index, tile = 0) => page.evaluate((v, k, i, t) => {
  const { box, picture: { tiles }, graph } = graphPage.views[v];
  box.scrollIntoView({ block: 'center' });
  const { x, y } = box.getBoundingClientRect(), half = () => tiles[t].half(graph.halvesOf(i)[0]);
  const p = k === 'node' ? tiles[t].pixelOf(i) : half()[half().length >> 1];
  return { at: [x + p[0], y + p[1]], name: k === 'node' ? graph.name(i) : graph.nameOfEdge(i), tiles: tiles.length };
}, view, kind, index, tile);

// Number of mark pixels with a color within `reach` of a node.
const marked = (view, node, color, tile = 0, reach = 14) => page.evaluate((v, i, [r, g, b], t, d) => {
  const { canvas, context, w, picture: { tiles } } = graphPage.views[v], ratio = canvas.width / w, [x, y] = tiles[t].pixelOf(i);
  const { data } = context.getImageData((x - d) * ratio, (y - d) * ratio, 2 * d * ratio, 2 * d * ratio);
  let count = 0;
  for (let k = 0; k < data.length; k += 4) {
    if (Math.abs(data[k] - r) + Math.abs(data[k + 1] - g) + Math.abs(data[k + 2] - b) < 12 && data[k + 3] > 200) count++;
  }
  return count;
}, view, node, color, tile, reach);
const seenNodes = (view) => page.evaluate((v) => {
  const { graph, picture: { tiles: [tile] } } = graphPage.views[v];
  return graph.data.names.map((_, i) => i).filter((i) => tile.isSeen(i));
}, view);

test('pages open without errors, without a network, and with scripts of less than 150 kB', async () => {
  for (const folder of [SPHERE, TORUS, DISK, COMPARED, STEPS]) {
    await open(folder);
    assert.deepEqual(page.errors, []);
    assert.deepEqual(page.requests.filter((r) => !/^(file|blob|data):/.test(r)), []);
    const bytes = await page.evaluate(() => [...document.scripts].filter((s) => !s.type).reduce((sum, s) => sum + s.text.length, 0));
    assert.ok(bytes > 1000 && bytes < 150e3, `${bytes} bytes`);
  }
});

test('a click on a node selects it, marks it and its neighbors, and fades the rest', async () => {
  await open(SPHERE);
  const [node] = await seenNodes(0), { at, name } = await place(0, 'node', node);
  await click(at);
  assert.match(await summary(), new RegExp(`^node ${name} of .* · degree 3 · radius 0\\.615 rad · neighbors (\\w+, ){2}\\w+$`));
  assert.ok(await marked(0, node, CHOSEN) > 30);
  const near = await page.evaluate((i) => graphPage.views[0].graph.neighbors(i), node);
  for (const i of await seenNodes(0)) {
    if (near.includes(i)) assert.ok(await marked(0, i, NEAR) > 15, 'a neighbor is marked');
    else if (i !== node) assert.equal(await marked(0, i, NEAR) + await marked(0, i, CHOSEN), 0, 'other nodes are not marked');
  }
  await page.until(() => Number(getComputedStyle(document.querySelector('.picture')).opacity) < 0.3);
  await shot('1-node');
  await press('Escape');
  assert.match(await summary(), /^Click a node/);
  assert.equal(await marked(0, node, CHOSEN), 0);
  await page.until(() => getComputedStyle(document.querySelector('.picture')).opacity === '1');
});

test('a click selects an edge or the node of a circle, and nothing elsewhere', async () => {
  await open(SPHERE);
  const edge = await page.evaluate(() => {
    const { graph, picture: { tiles: [tile] } } = graphPage.views[0];
    return [...Array(graph.edges).keys()].find((e) => [...graph.halvesOf(e)].every((h) => tile.half(h)?.length > 1));
  });
  const { at, name } = await place(0, 'edge', edge);
  await click(at);
  assert.match(await summary(), new RegExp(`^edge ${name} of .* · degrees of its ends 3 and 3$`));
  const [node] = await seenNodes(0), { at: [x, y], name: own } = await place(0, 'node', node);
  const offsets = [[1, 0], [-1, 0], [0, 1], [0, -1], [1, 1], [-1, -1], [1, -1], [-1, 1]].map(([a, b]) => [30 * a, 30 * b]);
  let hits = 0;
  for (const [a, b] of offsets) {
    await click([x + a, y + b]);
    if ((await summary()).startsWith(`node ${own} `)) hits++;
  }
  assert.ok(hits >= 3, `${hits} of ${offsets.length}`);
  await click([at[0] - at[0] + 30, at[1]]);
  assert.match(await summary(), /^Click a node/);
});

test('a node is marked in all tiles of the torus and of the disk', async () => {
  for (const folder of [TORUS, DISK]) {
    await open(folder);
    const { at, name, tiles } = await place(0, 'node', 1);
    await click(at);
    assert.match(await summary(), new RegExp(`^node ${name} of`));
    const inside = await page.evaluate(() => {
      const { picture: { tiles: all }, w } = graphPage.views[0];
      return [...all.keys()].filter((t) => all[t].pixelOf(1).every((x) => x > 10 && x < w - 10));
    });
    assert.ok(inside.length > 1 && tiles > 4, `${inside.length} of ${tiles}`);
    for (const t of inside) assert.ok(await marked(0, 1, CHOSEN, t) > 2, `tile ${t}`);
    await shot(`2-tiles-${folder === DISK ? 'disk' : 'torus'}`);
  }
});

test('in a comparison the partner listed in the node table is marked', async () => {
  await open(COMPARED);
  const rows = readFileSync(`${COMPARED}/nodes.csv`, 'utf8').trim().split('\n').slice(1).map((row) => row.split(','));
  const names = await page.evaluate(() => graphPage.views.map((v) => v.graph.data.names));
  let checked = 0;
  for (const [a, b] of rows) {
    await page.evaluate((name) => { document.getElementById('name').value = name; graphPage.find(); }, a);
    await idle();
    assert.match(await summary(), new RegExp(`^node ${a} of first graph .* · ${a === b ? 'in both graphs' : `in second graph: ${b}`}$`));
    const partner = names[1].indexOf(b);
    if (!(await seenNodes(1)).includes(partner)) continue;
    assert.ok(await marked(1, partner, CHOSEN) > 30);
    checked++;
  }
  assert.ok(checked > 2);
  await shot('3-compared');
});

test('a node is marked in all steps; steps without it are listed', async () => {
  await open(STEPS);
  const names = await page.evaluate(() => graphPage.views.map((v) => v.graph.data.names));
  assert.ok(names.length > 2 && names.some((list) => !list.includes('6')));
  await press('/');
  await page.key('6');
  await idle();
  assert.match(await summary(), /^node 6 of step [^·]*· degree .* · not in step/);
  for (const [view, list] of names.entries()) {
    const node = list.indexOf('6');
    if (node >= 0 && (await seenNodes(view)).includes(node)) assert.ok(await marked(view, node, CHOSEN) > 20, `view ${view}`);
  }
  await shot('4-steps');
});

test('nodes are tracked with Ctrl and click or with a key, in all steps, until their button is pressed', async () => {
  await open(STEPS);
  const colors = () => page.evaluate(() => graphPage.views.map((v) => [...v.graph.data.tracked].map(([n, c]) => [v.graph.name(n), c])));
  const before = await colors(), [node] = await seenNodes(0), { at: [x, y], name } = await place(0, 'node', node);
  await page.click(x, y, { modifiers: 2 });
  await idle();
  const after = await colors();
  for (const [view, list] of after.entries()) {
    const added = list.filter(([n]) => !before[view].some(([m]) => m === n));
    assert.ok(added.every(([n]) => n === name), `view ${view}`);
  }
  assert.equal(after[0].length, before[0].length + 1);
  await shot('5-tracked');
  await press('a');
  assert.deepEqual(await colors(), before);
});

test('two steps are shown with their differences, or all steps', async () => {
  await open(STEPS);
  const choose = async (from, to) => {
    await page.evaluate((values) => values.forEach((value, i) => {
      const select = document.querySelectorAll('#steps select')[i];
      select.value = value;
      select.dispatchEvent(new Event('change'));
    }), [from, to]);
    await idle();
  };
  const shown = () => page.evaluate(() => graphPage.views.map((v) => v.canvas.clientWidth > 0));
  await choose('0', '2');
  assert.deepEqual(await shown(), [true, false, true]);
  const green = await page.evaluate(() => {
    const [a, , b] = graphPage.views.map((v) => v.graph);
    const around = (graph, n) => graph.neighbors(graph.nodeOf(n)).map((m) => graph.name(m)).sort().join();
    const isNew = (n) => a.nodeOf(n) < 0 || around(a, n) !== around(b, n);
    return b.data.names.filter((_, i) => b.data.colors[i] === '#43a047').every(isNew);
  });
  assert.ok(green, 'only changed nodes are green');
  await shot('6-two-steps');
  await choose('0', '');
  assert.deepEqual(await shown(), [true, true, true]);
});

test('search finds nodes by name, Enter selects the next match and centers it', async () => {
  await open(SPHERE);
  await press('/');
  await page.key('x');
  await idle();
  assert.equal(await found(), 'no matching node');
  await press('Escape');
  const names = await page.evaluate(() => graphPage.views[0].graph.data.names), [first] = names[0];
  const like = names.filter((n) => n.includes(first));
  await press('/');
  await page.key(first);
  await idle();
  for (let i = 0; i <= like.length; i++) {
    assert.equal(await found(), `${(i % like.length) + 1} of ${like.length}`);
    const { node, off } = await page.evaluate(() => {
      const { picture: { tiles: [tile], frame }, page: { selection } } = graphPage.views[0], [x, y] = tile.pixelOf(selection.node);
      return { node: selection.node, off: Math.hypot(x - frame.c, y - frame.c) };
    });
    assert.ok(like.includes(names[node]) && off < 1);
    await press('Enter');
  }
});

test('keys select, step, move, zoom and toggle; help lists them', async () => {
  await open(DISK);
  const old = await picture();
  const moves = [['ArrowLeft', 'r'], ['ArrowUp', 'r', SHIFT], ['+', 'r'], ['c', 'c'], ['d', 'd'], ['k', 'k'], ['t', 't']];
  for (const [key, back, modifiers] of moves) {
    await press(key, modifiers);
    assert.notEqual(await picture(), old, key);
    await press(back);
    assert.equal(await picture(), old, `${key} and back`);
  }
  await press('n');
  assert.match(await summary(), /^node 1 of/);
  await press('e');
  assert.match(await summary(), /^edge .*1/);
  await press('Enter');
  assert.match(await summary(), /^node (?!1 )/);
  await press('?');
  const help = await page.evaluate(() => (document.getElementById('keys').open ? document.getElementById('keys').innerText : ''));
  assert.match(help, /search by name[^]*Moebius/);
  await press('Escape');
  assert.equal(await page.evaluate(() => document.getElementById('keys').open), false);
  assert.match(await summary(), /^node/, 'Escape only closed the help');
});

test('dragging moves all graphs of a group and selects nothing', async () => {
  await open(COMPARED);
  const prints = () => page.evaluate(() => graphPage.views.map((v) => v.picture.canvas.toDataURL()));
  const old = await prints(), { at: [x, y] } = await place(0, 'node', (await seenNodes(0))[0]);
  await page.mouse('mousePressed', x, y);
  await page.mouse('mouseMoved', x + 40, y + 10, { button: 'left' });
  await page.mouse('mouseReleased', x + 40, y + 10);
  await idle();
  (await prints()).forEach((print, i) => assert.notEqual(print, old[i]));
  assert.match(await summary(), /^Click a node/);
  await page.wheel(x, y, -100);
  await idle();
  assert.deepEqual(page.errors, []);
});
