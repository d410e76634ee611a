// Starts, steers and saves a session on its page, in a headless Chromium.
// usage: TOOL=ShapetonSession PHANTOM=ShapePhantom WORK=folder to write to [SHOTS=folder for pictures] node --test session.test.mjs
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { connect, createServer } from 'node:net';
import { dirname } from 'node:path';
import { createInterface } from 'node:readline';
import { after, before, test } from 'node:test';
import { launch } from '../../../Testing/Browser/browser.mjs';

const { TOOL, PHANTOM, WORK, SHOTS } = process.env;
const INPUT = `${WORK}/figure.nrrd`, RESULTS = `${WORK}/results`;
let page, run, url;

// Starts a session; returns the process and the URL that it prints.
async function start(...options) {
  const walk = ['--preset', 'published', '--shapetons', '20000', '--timeSteps', '400'];
  const child = spawn(TOOL, [INPUT, '--folder', RESULTS, ...walk, ...options]);
  let errors = '';
  child.stderr.on('data', (text) => { errors += text; });
  const gone = new Promise((done) => { child.on('exit', (status) => done({ status, errors })); });
  const line = await new Promise((done) => { createInterface({ input: child.stdout }).once('line', done); });
  return { child, gone, url: line };
}

const open = async (one, address) => {
  await one.visit(address);
  await one.until(() => Boolean(globalThis.session) || document.body.classList.contains('failed'));
  assert.equal(await one.evaluate(() => document.getElementById('notices').textContent), '');
};
const state = (one = page) => one.evaluate(() => session.state0);
const shoot = async (name) => { if (SHOTS) await page.screenshot(`${SHOTS}/${name}.png`); };
const press = (id) => page.evaluate((name) => document.getElementById(name).click(), id);
const enter = (id, value) => page.evaluate((name, text) => {
  const field = document.getElementById(name);
  field.value = text;
  field.dispatchEvent(new Event('change'));
}, id, value);
const middleOf = (view) => page.evaluate((name) => {
  const { left, top, width, height } = document.querySelector(`.view.${name}`).getBoundingClientRect();
  return [left + width / 2, top + height / 2];
}, view);

// A network between page and session, which can be cut. url: of the page through it.
async function network(address) {
  const { hostname, port } = new URL(address), sockets = new Set();
  const server = createServer((near) => {
    const far = connect(port, hostname);
    [[near, far], [far, near]].forEach(([from, to]) => {
      sockets.add(from);
      from.pipe(to);
      from.on('error', () => {});
      from.on('close', () => { to.destroy(); sockets.delete(from); });
    });
  });
  const listen = (at) => new Promise((done) => { server.listen(at, hostname, done); });
  await listen(0);
  const own = server.address().port;
  const cut = () => {
    const closed = new Promise((done) => { server.close(done); });
    sockets.forEach((socket) => socket.destroy());
    return closed;
  };
  return { url: Object.assign(new URL(address), { port: own }).href, cut, mend: () => listen(own) };
}

before(async () => {
  rmSync(WORK, { recursive: true, force: true });
  mkdirSync(RESULTS, { recursive: true });
  const made = spawnSync(PHANTOM, [INPUT, '--shape', 'figure2.4', '--noise', '10', '--quiet'], { encoding: 'utf8' });
  assert.equal(made.stderr, '');
  page = await launch();
  run = await start();
  url = run.url;
});
after(async () => {
  run.child.kill();
  await page.close();
});

test('the page shows the shapetons while they move', async () => {
  assert.match(url, /^http:\/\/127\.0\.0\.1:\d+\/[0-9a-f]{32}\/$/);
  await open(page, url);
  await page.until(() => session.state0.step === 400 && !session.state0.isMoving);
  await page.evaluate(() => session.idle(true));
  const counts = await page.evaluate(() => [session.counts.slice(1).reduce((a, b) => a + b), session.lines.length, session.rows.length]);
  assert.ok(counts.every((count) => count > 0), String(counts));
  await shoot('density');
  assert.deepEqual(page.errors, []);
});

test('the controls pause, step and change the walk', async () => {
  await press('move');
  await page.until(() => session.state0.isMoving || session.state0.step > 400);
  await press('move');
  await page.until(() => !session.state0.isMoving);
  const { step } = await state();
  await press('once');
  await page.until((s) => session.state0.step === s + 1, 10000, step);
  await enter('option-p', '12');
  await page.until((s) => session.state0.options.p === 12 && session.state0.step === s + 1, 60000, step);
  await enter('option-distance', '7'); // more than 1
  await page.until(() => /distance.*more than the maximum/.test(document.getElementById('status').textContent));
  await page.evaluate(() => session.ask({ do: 'pause' }));
  assert.equal((await state()).options.distance, 0.01);
});

test('the window is set by two fields, and an emptied or refused field returns to its value', async () => {
  const before = (await state()).options;
  const shown = await page.evaluate(() => ['lower', 'upper'].map((end) => Number(document.getElementById(`window-${end}`).value)));
  assert.deepEqual(shown, before.intensityWindow);
  await enter('window-upper', '150.5');
  await page.until(() => session.state0.options.intensityWindow[1] === 150.5);
  assert.match(await page.evaluate(() => document.getElementById('change').textContent), /^set: intensityWindow \[.*, 150\.5\]$/);
  await enter('window-lower', '200'); // above the upper one
  await page.until((lower) => Number(document.getElementById('window-lower').value) === lower, 5000, before.intensityWindow[0]);
  for (const id of ['option-p', 'window-lower', 'speed', 'radius']) {
    const { changes } = await state(), value = await page.evaluate((name) => document.getElementById(name).value, id);
    await enter(id, '');
    assert.equal(await page.evaluate((name) => document.getElementById(name).value, id), value, id);
    await page.evaluate(() => session.ask({ do: 'pause' }));
    assert.equal((await state()).changes, changes, id);
  }
  await press('undo');
  await page.until((window) => String(session.state0.options.intensityWindow) === window, 5000, String(before.intensityWindow));
});

test('a brush on a slice sets the start region', async () => {
  await enter('region', 'brush');
  const [x, y] = await middleOf('axial');
  await page.mouse('mouseMoved', x - 20, y);
  await page.mouse('mousePressed', x - 20, y);
  for (let i = 0; i <= 40; i += 8) await page.mouse('mouseMoved', x - 20 + i, y, { button: 'left', buttons: 1 });
  await page.mouse('mouseReleased', x + 20, y);
  await page.until(() => session.state0.region === 'balls' && !session.state0.isMoving);
  await page.evaluate(() => session.idle(true));
  await shoot('brush');
  assert.ok(await page.evaluate(() => session.balls.length > 2));
  await enter('region', 'everywhere');
  await press('start');
  await page.until(() => session.state0.region === 'everywhere');
});

test('the slider shows heat at another time, coarse and then exact', async () => {
  await page.evaluate(() => {
    const slider = document.getElementById('slider');
    slider.value = 400;
    slider.dispatchEvent(new Event('input'));
  });
  await page.until(() => session.state0.shown === 'heat' && session.state0.quality === 'exact' && session.state0.heatSteps === 10000);
  await page.evaluate(() => session.idle(true));
  assert.equal(await page.evaluate(() => session.info.quantity.name), 'heat');
  assert.ok(await page.evaluate(() => session.lines.length > 0));
  await shoot('heat');
});

test('the server draws the rendering on request', async () => {
  await page.evaluate(() => { document.getElementById('served').click(); session.askPicture(); });
  await page.until(() => Boolean(session.picture));
  const [width, height] = await page.evaluate(() => [session.picture.width, session.picture.height]);
  assert.deepEqual([width, height], await page.evaluate(() => [session.rendering.w, session.rendering.h].map(Math.round)));
  await shoot('served');
  await press('served');
});

test('a click on a slice moves the crosshair', async () => {
  const [x, y] = await middleOf('coronal');
  await page.click(x + 15, y + 10);
  await page.until(() => session.place.every((i, axis) => session.sent[axis].index === i));
  assert.match(await page.evaluate(() => document.getElementById('status').textContent), /mm \(LPS\), intensity about .*, heat/);
});

test('finding objects reports what it changes, and Undo goes back through lines and values', async () => {
  await page.evaluate(() => session.ask({ do: 'density' }));
  await page.until(() => session.state0.shown === 'density' && !session.state0.isMoving);
  const before = await state();
  await press('find');
  await page.until(() => session.state0.objects > 0 && document.querySelectorAll('#objects li').length > 0, 60000);
  const found = await state(), report = await page.evaluate(() => document.getElementById('change').textContent);
  assert.ok(report.includes(`p ${before.options.p} -> ${found.options.p}, `), report);
  assert.match(report, /^Find objects: .*intensityWindow .* -> .*time of heat 10000 -> \d+ steps/);
  const lines = await page.evaluate(() => session.lines.length);
  await page.evaluate(() => session.removeLine(0));
  await shoot('change');
  await press('undo');
  assert.deepEqual([await page.evaluate(() => session.lines.length), (await state()).undo], [lines, found.undo]);
  await press('undo');
  await page.until((n) => session.state0.undo === n && session.state0.shown === 'density', 60000, found.undo - 1);
  await page.until(() => !session.state0.isMoving);
  const undone = await state();
  assert.deepEqual([undone.options, undone.heatSteps], [before.options, before.heatSteps]);
  await page.until(() => document.getElementById('option-p').value === String(session.state0.options.p), 5000);
});

test('objects are found, and a click selects one', async () => {
  await press('find');
  await page.until(() => session.state0.objects > 0 && document.querySelectorAll('#objects li').length > 0, 60000);
  await press('picking');
  const [x, y] = await middleOf('axial');
  await page.click(x, y); // the cube of Figure 2.4 is in the middle
  await page.until(() => session.state0.selected > 0);
  await page.evaluate(() => session.idle(true));
  assert.equal(await page.evaluate(() => document.querySelectorAll('#objects .selected').length), 1);
  await shoot('object');
  await page.evaluate(() => session.alterLine(0, { opacity: 0.9 })); // only the object is visible
  const inRendering = await page.evaluate(() => {
    session.chain = [];
    const { rendering } = session, { left, top } = rendering.canvas.getBoundingClientRect();
    return rendering.pixelOf(rendering.page.place).map((x, i) => x + [left, top][i]);
  });
  await page.click(...inRendering);
  await page.until(() => session.chain[0] > 0 && session.chain[0] === session.state0.selected);
  await page.evaluate(() => session.undo());
  await press('all');
  await page.until(() => session.state0.selected === 0);
  await press('picking');
  await page.evaluate(() => session.ask({ do: 'heat', timeSteps: 10000 }));
  await page.until(() => session.state0.quality === 'exact' && session.state0.heatSteps === 10000);
});

test('the pointer shows an object, Ctrl adds one, and heat flows around what is not meant', async () => {
  await press('find');
  await page.until(() => session.state0.objects > 0 && session.sent.every(({ labels }) => labels), 60000);
  const [x, y] = await middleOf('axial');
  await page.mouse('mouseMoved', x, y);
  await page.until(() => /^object 1: .* %/.test(document.getElementById('status').textContent), 5000);
  await page.evaluate(() => session.select({ object: 1, isAdded: true }));
  await page.until(() => String(session.state0.selection) === '1', 5000);
  const { undo } = await state();
  await press('not-this');
  await page.until(() => /^exclude selected: barrier 0 -> \d+ voxels/.test(document.getElementById('change').textContent), 5000);
  await page.until(() => session.state0.quality === 'exact' && session.state0.objects !== null && !session.state0.stage, 60000);
  await page.evaluate(() => session.idle(true));
  assert.equal(await page.evaluate(() => session.binHere), 0); // no heat where the object was
  await shoot('barrier');
  await press('undo');
  await page.until((n) => session.state0.undo === n && session.state0.quality === 'exact', 60000, undo);
  await page.evaluate(() => session.ask({ do: 'heat', timeSteps: 10000 }));
  await page.until(() => session.state0.quality === 'exact' && session.state0.heatSteps === 10000);
});

test('the page reconnects after its connection was lost, and continues with the state of the server', async () => {
  const line = await network(url);
  const other = await launch();
  try {
    await open(other, line.url);
    await line.cut();
    await other.until(() => document.body.classList.contains('lost'));
    assert.match(await other.evaluate(() => document.getElementById('progress').textContent), /no connection.*next attempt in \d/);
    await other.evaluate(() => session.ask({ do: 'set', p: 1 }));
    assert.match(await other.evaluate(() => document.getElementById('status').textContent), /no connection/);
    const frames = await other.evaluate(() => session.frames);
    await page.evaluate(() => session.ask({ do: 'set', seed: 9 })); // another page goes on
    await line.mend();
    await other.until((n) => session.frames > n && !document.body.classList.contains('lost'), 30000, frames);
    await other.until(() => session.state0.options.seed === 9 && session.state0.quality === 'exact');
    await other.evaluate(() => session.ask({ do: 'set', seed: 10 }));
    await page.until(() => session.state0.options.seed === 10);
    const sumOfBins = () => session.idle(true).then(() => session.bins.reduce((sum, bin, i) => (sum * 31 + bin * i) % 1e9));
    await Promise.all([page, other].map((one) => one.until(() => session.state0.quality === 'exact')));
    assert.equal(await other.evaluate(sumOfBins), await page.evaluate(sumOfBins));
    assert.deepEqual(other.errors, []);
  } finally {
    await other.close();
    await line.cut();
  }
});

test('a second page sees the same session', async () => {
  const other = await launch();
  try {
    await open(other, url);
    await page.evaluate(() => session.ask({ do: 'set', seed: 5 }));
    await other.until(() => session.state0.options.seed === 5 && session.state0.quality === 'exact');
    assert.deepEqual(other.errors, []);
  } finally {
    await other.close();
  }
});

test('the saved script repeats the saved files', async () => {
  await page.until(() => session.state0.quality === 'exact');
  await press('list');
  await page.until(() => session.state0.objects > 0);
  await page.evaluate(() => session.select({ object: 1 }));
  await enter('name', 'alone');
  await page.evaluate(() => { document.getElementById('alone').checked = true; });
  await press('save');
  await page.until(() => /^saved alone-heat.nrrd, alone-object.nrrd, alone-object.csv/.test(document.getElementById('saved').textContent));
  await page.evaluate(() => { document.getElementById('alone').checked = false; });
  await enter('name', 'warm');
  await page.evaluate(() => { document.getElementById('labels').checked = true; });
  await press('save');
  await page.until(() => /^saved warm/.test(document.getElementById('saved').textContent));
  await page.evaluate(() => session.ask({ do: 'density' }));
  await page.until(() => session.state0.shown === 'density' && !session.state0.isMoving && session.state0.step > 0);
  await page.evaluate(() => session.saveToFolder());
  await page.until(() => /warm-density/.test(document.getElementById('saved').textContent));
  const env = { ...process.env, PATH: `${dirname(TOOL)}:${process.env.PATH}` };
  mkdirSync(`${WORK}/again`);
  const { status, stderr } = spawnSync('sh', [`${RESULTS}/warm.sh`, `${WORK}/again`], { env, encoding: 'utf8' });
  assert.deepEqual({ status, stderr }, { status: 0, stderr: '' });
  const volumes = ['heat', 'density', 'labels', 'objects'].map((what) => `warm-${what}.nrrd`);
  const alone = ['alone-object.nrrd', 'alone-object.csv'];
  for (const name of [...volumes, ...alone, 'warm-objects.csv', 'warm.json', 'warm.vp']) {
    assert.ok(readFileSync(`${RESULTS}/${name}`).equals(readFileSync(`${WORK}/again/${name}`)), name);
  }
  assert.deepEqual(page.errors, []);
});

test('a page of another origin gets nothing', async () => {
  const { hostname, port } = new URL(url);
  await page.visit('about:blank');
  const failed = await page.evaluate((address) => new Promise((done) => {
    const socket = new globalThis['WebSocket'](address);
    socket.onopen = () => done(false);
    socket.onerror = () => done(true);
  }), `ws://${hostname}:${port}${new URL(url).pathname}live`);
  assert.ok(failed);
});

test('a killed server is reported by the page', async () => {
  await open(page, url);
  run.child.kill('SIGKILL');
  await page.until(() => document.body.classList.contains('lost'));
  assert.match(await page.evaluate(() => document.getElementById('progress').textContent), /may have ended/);
  assert.ok(readdirSync(RESULTS).every((name) => !name.startsWith('.')));
});

test('Ctrl-C and closing the page end the session cleanly', async () => {
  run = await start('--patience', '0.5');
  await open(page, run.url);
  run.child.kill('SIGINT');
  assert.deepEqual(await run.gone, { status: 0, errors: '' });
  await page.until(() => document.body.classList.contains('ended'));
  assert.match(await page.evaluate(() => document.getElementById('progress').textContent), /has ended/);
  run = await start();
  await open(page, run.url);
  await page.visit('about:blank');
  assert.deepEqual(await run.gone, { status: 0, errors: '' });
  assert.ok(existsSync(`${RESULTS}/warm.sh`));
});
