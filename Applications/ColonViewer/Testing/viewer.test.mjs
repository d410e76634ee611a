// Simulates a reader of an examination, in a headless Chromium with software WebGL, from file://.
// usage: VIEWER=folder of viewer.html [SHOTS=folder for pictures] [TIMINGS=1] node --test viewer.test.mjs
import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { launch } from '../../../Testing/Browser/browser.mjs';

const folder = process.env.VIEWER, shots = process.env.SHOTS, downloads = mkdtempSync(join(tmpdir(), 'verdicts-'));
const isTimed = Boolean(process.env.TIMINGS); // limits for an idle machine
const SHIFT = 8, CTRL = 2, VIEWS = ['flat', 'outside', 'inside', 'axial', 'coronal', 'sagittal'];
const figures = {};
let page;

before(async () => {
  page = await launch({ downloads });
  const started = Date.now();
  await page.open(`${folder}/viewer.html`);
  await page.until(() => Boolean(window.viewer) || document.body.classList.contains('failed'), 120000);
  await idle();
  figures.load = Date.now() - started;
});
after(async () => {
  await page.close();
  rmSync(downloads, { recursive: true });
  console.log(JSON.stringify(figures));
});

const idle = () => page.evaluate(() => viewer.idle());
const far = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));
const median = (a) => a.sort((x, y) => x - y)[a.length >> 1];
const shot = async (name) => { if (shots) await page.screenshot(`${shots}/${name}.png`); };
const box = (name, position = 0) => page.evaluate((n, p) => {
  const r = document.querySelectorAll('section')[p].querySelector(`[data-view=${n}]`).getBoundingClientRect();
  return [r.x, r.y, r.width, r.height];
}, name, position);
const state = (position = 0) => page.evaluate((p) => {
  const { place, inside, views } = viewer.panels[p], { xyz, uv, arc } = place;
  return { xyz, uv, arc, index: inside.index, shown: Object.fromEntries(views.map((v) => [v.box.dataset.view, v.shown])) };
}, position);
const press = async (key, modifiers = 0) => { await page.key(key, modifiers); await idle(); };
const clickOn = async (selector) => {
  const [x, y] = await page.evaluate((s) => {
    const e = document.querySelector(s);
    e.scrollIntoView({ block: 'nearest' });
    const r = e.getBoundingClientRect();
    return [r.x + r.width / 2, r.y + r.height / 2];
  }, selector);
  await page.click(x, y);
  await idle();
};

// Visible center of the yellow crosshair near its expected position.
const crossSeen = (name, position = 0) => page.evaluate((n, p) => {
  const v = viewer.panels[p].views.find((x) => x.box.dataset.view === n), [x, y] = v.shown, r = v.canvas.width / v.w, reach = 17;
  const left = Math.round((x - reach) * r), top = Math.round((y - reach) * r), side = Math.round(2 * reach * r);
  const { data } = v.context.getImageData(left, top, side, side);
  const mean = (a) => a.reduce((sum, b) => sum + b, 0) / a.length, xs = [], ys = [];
  for (let i = 0; i < side * side; i++) {
    const [red, green, blue] = data.subarray(4 * i, 4 * i + 3); // not gray, wall or the orange of a selected ring
    if (red < 120 || green < 0.74 * red || blue > 0.5 * red || red < green) continue;
    const dx = (left + (i % side) + 0.5) / r - x, dy = (top + Math.floor(i / side) + 0.5) / r - y;
    if (Math.abs(dx) < 4 && Math.abs(dy) > 5) xs.push(dx);
    if (Math.abs(dy) < 4 && Math.abs(dx) > 5) ys.push(dy);
  }
  return { count: Math.min(xs.length, ys.length), off: Math.hypot(mean(xs), mean(ys)) };
}, name, position);

test('opens without errors and without a network', async () => {
  await shot('1-open');
  assert.deepEqual(page.errors, []);
  assert.deepEqual(page.requests.filter((r) => !/^(file|blob|data):/.test(r)), []);
  const text = await page.evaluate(() => document.querySelector('footer').innerText);
  assert.match(text, /For research use; not a diagnosis\. This page holds patient data\./);
  const patient = await page.evaluate(() => [viewer.info.patient, document.title]);
  assert.ok(patient[1].includes(patient[0]), 'the title names the patient');
  const bytes = statSync(`${folder}/viewer.html`).size;
  if (existsSync(`${folder}/data`)) assert.ok(bytes < 150e3, `${bytes} bytes of scripts`);
});

test('a click on the flat wall moves the crosshair everywhere', async () => {
  const [x, y, w, h] = await box('flat'), times = [];
  for (let i = 0; i < 6; i++) {
    const at = [x + w * (0.15 + 0.11 * i), y + h * (0.4 + 0.08 * i)], started = Date.now();
    await page.click(...at);
    await idle();
    times.push(Date.now() - started);
    const s = await state();
    assert.ok(far([s.shown.flat[0] + x, s.shown.flat[1] + y], at) < 1.5, 'the crosshair is at the click');
    for (const view of VIEWS) {
      assert.ok(s.shown[view], `no crosshair in ${view}`);
      const [, , width, height] = await box(view), [a, b] = s.shown[view], seen = await crossSeen(view);
      const isInside = a > 20 && b > 20 && a < width - 20 && b < height - 20;
      if (isInside && (view !== 'flat' || b > 55)) assert.ok(seen.count >= 6 && seen.off < 1.5, `${view}: ${JSON.stringify(seen)}`);
    }
  }
  figures.flatClick = median(times);
  if (isTimed) assert.ok(figures.flatClick < 500);
  await shot('2-flat-click');
});

test('mapping a point to space and back is the identity', async () => {
  const errors = await page.evaluate(() => viewer.exams.flatMap((exam) => {
    const out = [];
    for (let i = 0; i < 400; i++) {
      const face = Math.floor((i * exam.faces.length) / 3 / 400), place = exam.place(face, [0.2, 0.3, 0.5]);
      const back = exam.fromUv(...exam.fromXyz(place.xyz, false).uv);
      out.push(Math.hypot(...back.xyz.map((x, k) => x - place.xyz[k])));
    }
    return out;
  }));
  errors.sort((a, b) => a - b);
  figures.thereAndBack = errors[Math.floor(0.99 * errors.length)];
  assert.ok(figures.thereAndBack <= 0.1);
});

test('a click on the 3D wall moves the crosshair to this point', async () => {
  const [x, y, w, h] = await box('outside');
  let hits = 0;
  for (const [a, b] of [[0.3, 0.4], [0.25, 0.5], [0.7, 0.35], [0.7, 0.5], [0.5, 0.6], [0.3, 0.65], [0.4, 0.3], [0.6, 0.45]]) {
    const old = await state();
    await page.click(x + a * w, y + b * h);
    await idle();
    const s = await state();
    if (far(s.xyz, old.xyz) < 1e-9) continue; // outside the colon
    hits++;
    assert.ok(far(s.shown.outside.slice(0, 2), [a * w, b * h]) < 1.5);
    assert.equal(s.shown.outside[2], false, 'the clicked point is visible');
  }
  assert.ok(hits >= 2);
  await shot('3-wall-click');
});

test('a click on a slice selects that voxel, the wheel and keys the next slice', async () => {
  for (const [view, k] of [['axial', 0], ['coronal', 1], ['sagittal', 2]]) {
    const [x, y, w, h] = await box(view), slice = () => page.evaluate((n) => {
      const { panels: [p] } = viewer, { axis } = p.slices[n];
      return p.exam.toImage(p.place.xyz)[axis] / p.exam.volume.spacing[axis];
    }, k);
    const old = await slice();
    await page.click(x + w * 0.45, y + h * 0.45);
    await idle();
    assert.ok(Math.abs(await slice() - old) < 1e-6);
    assert.ok(far((await state()).shown[view].slice(0, 2), [w * 0.45, h * 0.45]) < 1);
    await page.wheel(x + w / 2, y + h / 2, 100);
    await idle();
    assert.ok(Math.abs(await slice() - old - 1) < 1e-6);
    await press('acs'[k], 0);
    await press('acs'[k], SHIFT);
    assert.ok(Math.abs(await slice() - old - 1) < 1e-6);
  }
});

test('slices use the radiological convention: left is at the right', async () => {
  const directions = await page.evaluate(() => {
    const { panels: [panel] } = viewer;
    return panel.slices.map((s) => {
      const f = s.frame(), [a, b, c] = [[100, 100], [101, 100], [100, 101]].map((p) => panel.exam.fromImage(f.back(...p)));
      return [b.map((x, k) => x - a[k]), c.map((x, k) => x - a[k])];
    });
  });
  const [axial, coronal, sagittal] = directions;
  assert.ok(axial[0][0] > 0 && axial[1][1] > 0 && coronal[0][0] > 0 && coronal[1][2] < 0 && sagittal[0][1] > 0 && sagittal[1][2] < 0);
});

test('the displayed HU are those of the voxel under the crosshair', async (t) => {
  if (await page.evaluate(() => !viewer.exams[0].volume.isCt)) { t.skip('a mask'); return; }
  const [hu, text] = await page.evaluate(() => {
    const { panels: [panel] } = viewer, c = panel.exam.center[Math.floor(panel.exam.center.length / 2)].xyz;
    panel.set(panel.exam.fromXyz(c));
    return [panel.exam.voxelAt(c).hu, document.getElementById('status').textContent];
  });
  assert.ok(text.startsWith(`${Math.round(hu)} HU`));
  assert.ok(hu < -600, 'gas');
});

test('Shift and moving the mouse moves the crosshair', async () => {
  const [x, y, w, h] = await box('flat'), old = await state();
  await page.mouse('mouseMoved', x + w * 0.31, y + h * 0.6, { modifiers: SHIFT });
  await idle();
  assert.ok(far((await state()).xyz, old.xyz) > 1);
});

test('Home and End look into the colon from inside its ends', async () => {
  const inside = () => page.evaluate(() => {
    const { inside: eye, exam: { center } } = viewer.panels[0];
    const { point: { arc }, way, yaw, pitch } = eye;
    return { fromEnds: [arc - center[0].arc, center.at(-1).arc - arc], way, turned: Math.hypot(yaw, pitch) };
  });
  for (const [key, end, way] of [['Home', 0, 1], ['End', 1, -1]]) {
    for (let i = 0; i < 3; i++) await press('ArrowRight');
    await press(key);
    const eye = await inside();
    assert.ok(eye.fromEnds[end] >= 15 && eye.fromEnds[end] < 25, `${key}: ${eye.fromEnds[end]} mm from the end`);
    assert.deepEqual([eye.way, eye.turned], [way, 0]);
  }
  await press('Home');
});

test('each layer changes a view, and hiding it restores the view', async () => {
  const print = () => page.evaluate(() => viewer.panels[0].views.map((v) => v.canvas.toDataURL()).join());
  const names = await page.evaluate(() => [...document.querySelectorAll('#layers input')].map((e) => e.name));
  const isCleansed = await page.evaluate(() => Boolean(viewer.exams[0].volume.changes));
  await press('n');
  const flip = (name) => clickOn(`#layers input[name=${name}]`);
  for (const name of names) {
    if (name === 'centerline') await flip('through');
    const old = await print();
    await flip(name);
    const changed = await print();
    await flip(name);
    assert.equal(await print(), old, name);
    if (name === 'centerline') await flip('through');
    const isPlain = ['hindered', 'trust', 'coated'].includes(name) || (name === 'seams' && !isCleansed); // not in a good examination
    assert.ok(changed !== old || isPlain, `${name} changes nothing`);
  }
});

test('slices show the original CT first and say so; D shows the cleansed CT', async (t) => {
  if (await page.evaluate(() => !viewer.exams[0].volume.changes)) { t.skip('no CT before cleansing'); return; }
  // A voxel that cleansing changed most.
  await page.evaluate(() => {
    const [panel] = viewer.panels, { exam } = panel, { volume: v } = exam, { at, codes } = v.changes, [nx, ny] = v.size;
    const change = (i) => Math.abs(v.huOf(v.data[at[i]]) - v.huOf(codes[i]));
    const voxel = at[[...at.keys()].reduce((a, b) => (change(b) > change(a) ? b : a))];
    const index = [voxel % nx, Math.floor(voxel / nx) % ny, Math.floor(voxel / nx / ny)];
    viewer.current = 0;
    panel.set(exam.fromXyz(exam.fromImage(index.map((x, k) => x * v.spacing[k]))));
  });
  await idle();
  const look = () => page.evaluate(() => {
    const [{ exam, place, slices }] = viewer.panels;
    const pictures = slices.map((s) => s.canvas.toDataURL()).join();
    const labels = slices.map((s) => s.label.textContent), button = document.getElementById('ct').textContent;
    return { hu: exam.voxelAt(place.xyz).hu, labels, button, pictures };
  });
  const original = await look();
  assert.deepEqual(original.labels.map((l) => l.split(' · ')[1]), Array(3).fill('Original CT'));
  await press('d');
  const cleansed = await look();
  assert.deepEqual(cleansed.labels.map((l) => l.split(' · ')[1]), Array(3).fill('Cleansed CT'));
  assert.equal(cleansed.button, 'Cleansed CT');
  assert.ok(original.hu > 200 && cleansed.hu < -500, `tagged fluid of ${original.hu} HU becomes ${cleansed.hu} HU`);
  assert.notEqual(cleansed.pictures, original.pictures);
  await shot('cleansed');
  await clickOn('#ct');
  assert.deepEqual(await look(), original);
});

test('slices have number, position, window, scale and the sides of the patient', async () => {
  const slices = await page.evaluate(() => {
    const [panel] = viewer.panels, { volume: v } = panel.exam;
    return panel.slices.map((s) => {
      const index = Math.round(panel.exam.toImage(panel.place.xyz)[s.axis] / v.spacing[s.axis]);
      const { axis, letters, plane } = s, { xyz } = panel.place;
      return { facts: s.facts(index, xyz), letters, number: v.first[axis] + index + 1, of: v.whole[axis], xyz, plane };
    });
  });
  for (const { facts: [where], number, of, xyz, plane } of slices) {
    assert.equal(where, `slice ${number} of ${of} · ${'xyz'[plane]} ${xyz[plane].toFixed(1)} mm`);
    assert.ok(number >= 1 && number <= of);
  }
  const [axial, coronal, sagittal] = slices.map((s) => s.letters);
  assert.deepEqual(axial, { right: 'L', left: 'R', bottom: 'P', top: 'A' });
  assert.deepEqual(coronal, { right: 'L', left: 'R', bottom: 'F', top: 'H' });
  assert.deepEqual(sagittal, { right: 'P', left: 'A', bottom: 'F', top: 'H' });
  if (await page.evaluate(() => !viewer.exams[0].volume.isCt)) return; // a mask has no window
  const gravity = await page.evaluate(() => viewer.exams.map((e) => [e.info.name, e.info.gravity]));
  for (const [name, g] of gravity) assert.equal(Math.sign(g[1]), name === 'prone' ? -1 : 1, name);
  const windowText = () => page.evaluate(() => viewer.panels[0].slices[0].facts(0, [0, 0, 0])[1]);
  await press('2');
  assert.equal(await windowText(), 'W 400  L 40');
  await press('ArrowRight', CTRL);
  await press('ArrowDown', CTRL);
  assert.equal(await windowText(), 'W 450  L 15');
  await press('1');
  assert.equal(await windowText(), 'W 1500  L -200');
});

test('a candidate is at the center of all views, and the endoluminal view shows its head', async () => {
  const number = await page.evaluate(() => { viewer.verdicts.choose(null); return viewer.verdicts.entries.length; });
  let seen = 0;
  for (let i = 0; i < number; i++) {
    await press('n');
    const { place, head, slices, gap, shown, share } = await page.evaluate(() => {
      const { chosen: { candidate: c } } = viewer.verdicts, { panel } = viewer, { inside } = panel, camera = inside.camera();
      const ahead = camera.at.map((x, k) => x - camera.eye[k]), to = [c.x, c.y, c.z].map((x, k) => x - camera.eye[k]);
      const cosine = ahead.reduce((sum, x, k) => sum + x * to[k], 0) / Math.hypot(...ahead) / Math.hypot(...to);
      const off = panel.slices.map((s) => Math.hypot(s.shown[0] - s.w / 2, s.shown[1] - s.h / 2));
      const gap = Math.acos(Math.min(1, cosine));
      return { place: panel.place.xyz, head: [c.x, c.y, c.z], slices: off, gap, shown: inside.shown, share: c.view.share };
    });
    assert.deepEqual(place, head, 'the crosshair is at the center of the head');
    assert.ok(Math.max(...slices) < 1, `slices are centered: ${slices}`);
    assert.ok(gap < 1e-3, 'the eye looks at the center of the head');
    if (share >= 0.4 && !shown[2]) seen++;
    if (i === 0) await shot('4-candidate');
  }
  figures.candidates = `${seen} of ${number}`;
  assert.ok(number > 0 && seen >= 0.75 * number, figures.candidates);
});

test('warnings and limitations are folded lists with their numbers', async () => {
  const lists = await page.evaluate(() => ['warnings', 'limitations'].map((id) => {
    const list = document.getElementById(id), number = Number(list.querySelector('summary').textContent.match(/\((\d+)\)/)[1]);
    return { open: list.open, number, items: [...list.querySelectorAll('li')].filter((li) => !li.querySelector('li')).length };
  }));
  for (const { open, number, items } of lists) {
    assert.equal(open, false);
    assert.equal(number, items);
  }
  assert.ok(lists[1].number > 5);
});

test('fisheye: a click at the pixel of a point selects it, also 75 degrees from the axis', async () => {
  await press('w');
  const errors = await page.evaluate(async () => {
    const { panel } = viewer, { inside, exam } = panel, out = [];
    inside.go(exam.centerAt(200));
    const { eye, at, up } = inside.camera(), ahead = at.map((x, k) => x - eye[k]);
    for (const degrees of [0, 30, 75]) {
      const [c, s] = [Math.cos, Math.sin].map((f) => f((degrees * Math.PI) / 180));
      const wall = exam.fromRay(eye, ahead.map((x, k) => c * x + s * up[k]));
      panel.set(wall, inside);
      await viewer.idle();
      const [x, y] = inside.shown, isInside = y > 0 && y < inside.h;
      inside.pick(x, y);
      out.push(isInside ? Math.hypot(...panel.place.xyz.map((v, k) => v - wall.xyz[k])) : Infinity);
    }
    return out;
  });
  assert.ok(Math.max(...errors) < 0.1, `${errors} mm`);
  await shot('fisheye');
  await press('w');
});

test('translucency colors the wall by the tissue behind it, and ends', async (t) => {
  if (await page.evaluate(() => !viewer.exams[0].volume.isCt)) { t.skip('a mask'); return; }
  await page.evaluate(() => viewer.verdicts.choose(null));
  await press('n');
  const colors = () => page.evaluate(() => {
    const { exam, place } = viewer.panel, { details: d } = exam, i = d.tree.nearest(place.xyz).face;
    return [...d.colors.subarray(4 * d.faces[3 * i], 4 * d.faces[3 * i] + 3)];
  });
  const before = await colors();
  await press('u');
  assert.notDeepEqual(await colors(), before);
  await press('u');
  assert.deepEqual(await colors(), before);
});

test('layouts enlarge the views that they name', async () => {
  const area = async (name) => { const [, , w, h] = await box(name); return w * h; };
  const all = { axial: await area('axial'), flat: await area('flat'), inside: await area('inside') };
  for (const name of ['axial', 'flat', 'inside']) {
    await press('l');
    assert.ok(await area(name) > 1.2 * all[name], name);
    await shot(`layout-${name}`);
  }
  await press('l');
  assert.equal(await area('flat'), all.flat);
});

test('keys fly along the centerline, both ways', async () => {
  const arc = () => page.evaluate(() => viewer.panels[0].exam.center[viewer.panels[0].inside.index].arc);
  await page.evaluate(() => { const [p] = viewer.panels; viewer.current = 0; p.inside.go(p.exam.centerAt(300)); });
  const a = await arc(), steps = 10;
  for (let i = 0; i < steps; i++) await press('ArrowUp');
  const b = await arc();
  assert.ok(Math.abs(b - a - 2 * steps) < 8, `${b - a} mm in ${steps} steps of 2 mm`);
  await press('r');
  await press('PageUp');
  assert.ok(Math.abs(await arc() - b + 20) < 3);
  await press('r');
  const before = await page.evaluate(() => viewer.panel.inside.camera().at);
  await press('ArrowLeft');
  assert.ok(far(await page.evaluate(() => viewer.panel.inside.camera().at), before) > 0.1);
  await shot('5-flight');
});

test('turning the eye and its way keeps the lesion', async () => {
  await page.evaluate(() => viewer.verdicts.choose(null));
  await press('n');
  const { xyz } = await state(await page.evaluate(() => viewer.current));
  const at = () => page.evaluate(() => {
    const { place, inside } = viewer.panel;
    return { xyz: place.xyz, camera: inside.camera(), way: inside.way };
  });
  const before = await at();
  for (const key of ['r', 'r']) await press(key);
  assert.deepEqual(await at(), before);
  await press('ArrowLeft');
  const turned = await at();
  assert.deepEqual(turned.xyz, xyz);
  assert.ok(far(turned.camera.at, before.camera.at) > 0.1);
  await press('r');
  assert.ok(far((await at()).camera.at, turned.camera.at) < 1e-9, 'the view stays');
  await press('r');
  await press('ArrowUp');
  assert.ok(far((await at()).xyz, xyz) > 0.1, 'flying moves on');
});

test('cine plays the slices to the last one, or until it is stopped', async (t) => {
  if (await page.evaluate(() => !viewer.exams[0].volume)) { t.skip('no volume'); return; }
  const slice = () => page.evaluate(() => {
    const { panel } = viewer, [{ axis }] = panel.slices, v = panel.exam.volume;
    return [panel.exam.toImage(panel.place.xyz)[axis] / v.spacing[axis], v.size[axis] - 1];
  });
  await page.evaluate(() => { viewer.current = 0; viewer.panel.active = viewer.panel.slices[0]; });
  const [from] = await slice();
  await press('g');
  await page.until(() => Boolean(viewer.cine));
  await new Promise((done) => { setTimeout(done, 600); });
  await press('Escape');
  const [now] = await slice();
  assert.ok(now > from, `${from} to ${now}`);
  await page.evaluate(() => { while (viewer.panel.slices[0].step(40)); viewer.panel.slices[0].step(-2); });
  await press('g');
  await page.until(() => !viewer.cine);
  const [last, end] = await slice();
  assert.ok(Math.abs(last - end) < 1e-6, 'it stops at the last slice');
});

test('Q hides all layers over the wall and shows them again', async () => {
  const shown = () => page.evaluate(() => [...document.querySelectorAll('#layers input')].filter((e) => e.checked).map((e) => e.name));
  const before = await shown();
  await press('q');
  assert.deepEqual(await shown(), before.filter((name) => name === 'through'));
  await press('q');
  assert.deepEqual(await shown(), before);
});

test('a finding at a candidate says so', async () => {
  await page.evaluate(() => viewer.verdicts.choose(null));
  await press('n');
  const id = await page.evaluate(() => viewer.verdicts.chosen.id);
  await press('f');
  const [head, finding] = await page.evaluate(() => {
    const item = document.querySelector('#entries li.chosen');
    return [item.querySelector('.head').innerText, item.dataset.id];
  });
  assert.ok(head.includes(`at candidate ${id}`), head);
  await press('z');
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute('aria-label')), `size of ${finding} in mm`);
  await press('Escape');
  await page.evaluate(() => { const v = viewer.verdicts; v.removeFinding(v.findings.at(-1)); v.isSaved = true; v.actions.changed(); });
});

test('Space flies to the end, and unseen areas are counted', async () => {
  figures.framesPerSecond = await page.evaluate(async () => {
    const [p] = viewer.panels, arc = () => p.exam.center[p.inside.index].arc, from = arc(), started = performance.now();
    viewer.toggleFlight();
    await new Promise((done) => { setTimeout(done, 2000); });
    viewer.toggleFlight();
    return (1000 * (arc() - from)) / 2 / (performance.now() - started);
  });
  if (isTimed) assert.ok(figures.framesPerSecond > 3);
  await page.evaluate(() => { const [p] = viewer.panels; p.inside.go(p.exam.center.length - 8); });
  await press(' ');
  await page.until(() => !viewer.isFlying);
  assert.ok(await page.evaluate(() => viewer.panel.isAtEnd));
  assert.match(await page.evaluate(() => document.getElementById('share').textContent), /wall seen in flight: [\d.]+ %/);
});

// Brute-force visibility: the center of the face is in the view, at most 200 mm
// away, and no other face crosses the ray. For a subset of the faces; `poses` are the cameras of the flight.
const bruteForceOf = (number, poses) => page.evaluate((n, all) => {
  const [{ exam, inside }] = viewer.panels, { points: P, faces: F } = exam, { middles, marks, area } = exam.seen;
  const aspect = inside.w / inside.h;
  const sub = (a, b) => a.map((x, k) => x - b[k]), dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const unit = (a) => a.map((x) => x / Math.hypot(...a)), corner = (f, k) => [0, 1, 2].map((i) => P[3 * F[3 * f + k] + i]);
  const triangles = Array.from({ length: F.length / 3 }, (_, f) => {
    const [a, b, c] = [0, 1, 2].map((k) => corner(f, k));
    return [a, sub(b, a), sub(c, a)];
  });
  const isHit = (eye, d, end) => triangles.some(([a, ab, ac]) => { // Moeller and Trumbore
    const p = cross(d, ac), det = dot(ab, p), s = sub(eye, a), q = cross(s, ab);
    const u = dot(s, p) / det, v = dot(d, q) / det, t = dot(ac, q) / det;
    return det !== 0 && u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < end;
  });
  const isSeen = (m) => all.some(({ eye, at, up, fov }) => {
    const d = sub(m, eye), l = Math.hypot(...d), ahead = unit(sub(at, eye)), right = unit(cross(ahead, up)), above = cross(right, ahead);
    const z = dot(d, ahead), high = Math.tan(fov / 2) * z;
    return l < 200 && z > 0 && Math.abs(dot(d, above)) < high && Math.abs(dot(d, right)) < high * aspect && !isHit(eye, unit(d), l - 0.2);
  });
  const step = Math.ceil(marks.length / n), faces = [...marks.keys()].filter((f) => f % step === 0 && area[f]);
  const sum = (list) => list.reduce((s, f) => s + area[f], 0);
  const shareOf = (isTrue) => sum(faces.filter(isTrue)) / sum(faces);
  return { page: shareOf((f) => marks[f]), brute: shareOf((f) => isSeen([...middles.slice(3 * f, 3 * f + 3)])) };
}, number, poses);

test('a flight in both directions sees nearly all that is visible from the centerline, and the page counts correctly', async () => {
  const { seen, visible, poses } = await page.evaluate(() => {
    const [{ exam, inside }] = viewer.panels, { seen: s } = exam, { index, way } = inside, cameras = [];
    Object.assign(s, { sum: 0, queue: [] });
    s.marks.fill(0);
    for (inside.way of [1, -1]) {
      Object.assign(inside, { look: null, yaw: 0, pitch: 0 });
      for (inside.index = 0; inside.index < exam.center.length - 2; inside.index += 2) {
        cameras.push(inside.camera());
        s.look(cameras.at(-1), inside.w / inside.h);
      }
    }
    while (s.work(1000));
    const isVisible = (face) => {
      const m = [0, 1, 2].map((k) => s.middles[3 * face + k]), at = exam.centerAt(exam.arc[exam.faces[3 * face]]);
      return exam.center.slice(Math.max(0, at - 200), at + 200).filter((_, i) => i % 5 === 0).some(({ xyz }) => {
        const d = m.map((x, k) => x - xyz[k]), l = Math.hypot(...d);
        return l < 200 && !exam.wall.ray(xyz, d.map((x) => x / l), l - 0.2, true);
      });
    };
    const missed = [...s.marks.keys()].filter((f) => !s.marks[f] && s.area[f] && isVisible(f));
    Object.assign(inside, { index, way });
    return { seen: s.sum, visible: s.sum + missed.reduce((sum, f) => sum + s.area[f], 0), poses: cameras };
  });
  figures.seenOfVisible = seen / visible;
  assert.ok(figures.seenOfVisible > 0.95, `${figures.seenOfVisible}`);
  if (await page.evaluate(() => viewer.panels[0].exam.faces.length > 150000)) return; // brute force on these takes hours
  const { page: counted, brute } = await bruteForceOf(150, poses);
  Object.assign(figures, { counted, brute });
  assert.ok(brute > 0.5 && Math.abs(counted - brute) < 0.01, `${counted} for ${brute}`);
});

test('distances: straight, along the wall, along the centerline', async () => {
  const [x, y, w, h] = await box('axial');
  await page.evaluate(() => { const [p] = viewer.panels; p.slices[0].zoom = 1; p.changed(); });
  await idle();
  await press('m');
  await page.click(x + w * 0.3, y + h * 0.5);
  await page.click(x + w * 0.6, y + h * 0.5);
  await idle();
  const { lengths, scale, arcs } = await page.evaluate(() => {
    const { measure, slices } = viewer.panels[0];
    return { lengths: measure.lengths, scale: slices[0].frame().s, arcs: measure.places.map((p) => p.arc) };
  });
  assert.ok(Math.abs(lengths.straight - (w * 0.3) / scale) < 0.5);
  assert.ok(Math.abs(lengths.line - Math.abs(arcs[0] - arcs[1])) < 0.5);
  await press('Escape');
  await press('ArrowRight', SHIFT); // onto the wall
  await press('Enter');
  for (let i = 0; i < 4; i++) await press('ArrowRight', SHIFT);
  await press('Enter');
  const near = await page.evaluate(() => viewer.panels[viewer.current].measure.lengths);
  assert.ok(near.straight > 1 && near.wall >= near.straight - 1e-3 && near.wall < 60, JSON.stringify(near));
  assert.match(await page.evaluate(() => document.getElementById('status').textContent), /straight [\d.]+ mm · along the wall [\d.]+ mm/);
  await shot('6-measure');
  await press('Escape');
});

const saved = async () => {
  for (let i = 0; i < 100; i++) {
    const name = readdirSync(downloads).find((n) => n.endsWith('.json'));
    if (name) {
      const text = readFileSync(join(downloads, name), 'utf8');
      rmSync(join(downloads, name));
      return text;
    }
    await new Promise((done) => { setTimeout(done, 50); });
  }
  throw new Error('no file was saved');
};
const openVerdicts = async (text) => {
  const file = join(downloads, 'open.txt');
  writeFileSync(file, text);
  await page.chooseFile('#file', file);
  await page.until(() => !document.getElementById('file').value); // wait until read
  await idle();
  rmSync(file);
};

test('verdicts, assessment, findings and bookmarks are saved, reopened, and rejected for another examination', async () => {
  await page.evaluate(() => viewer.verdicts.choose(null));
  await press('n');
  await press('e');
  await press('t');
  for (const c of 'on a <fold>') await page.key(c);
  await press('Escape');
  const enter = (selector, value) => page.evaluate((s, v) => {
    const field = document.querySelector(s);
    field.value = v;
    for (const type of ['input', 'change']) field.dispatchEvent(new Event(type));
  }, selector, value);
  assert.deepEqual(await page.evaluate(() => viewer.verdicts.document().assessment), { colonic: '', extracolonic: '', note: '' });
  await enter('#entries li.chosen .size', '7.25');
  await enter('#entries li.chosen [name=morphology]', 'sessile');
  await enter('#assessment [name=colonic]', 'C2b');
  assert.ok(await page.evaluate(() => document.querySelector('aside').scrollWidth <= document.querySelector('aside').clientWidth),
    'long categories widen the panel');
  await enter('#assessment [name=colonic]', 'C2a');
  await enter('#assessment [name=assessmentNote]', 'one polyp');
  await press('b');
  await press('f');
  await clickOn('#entries li.chosen button:not(.head)');
  const [x, y, w, h] = await box('axial');
  await page.click(x + w * 0.4, y + h * 0.5);
  await page.click(x + w * 0.5, y + h * 0.5);
  await idle();
  assert.equal(await page.evaluate(() => document.getElementById('unsaved').textContent), 'not saved yet');
  await press('s', CTRL);
  const text = await saved(), verdicts = JSON.parse(text);
  assert.equal(verdicts.version, 2);
  assert.deepEqual([verdicts.secondReader, verdicts.candidatesRevealed], [false, true]);
  assert.match(verdicts.exam.sha256, /^[0-9a-f]{64}$/);
  const id = await page.evaluate(() => viewer.verdicts.entries[0].id);
  assert.deepEqual(verdicts.candidates[0], { id, verdict: 'polyp', note: 'on a <fold>', size: 7.3, morphology: 'sessile' });
  assert.deepEqual(verdicts.assessment, { colonic: 'C2a', extracolonic: '', note: 'one polyp' });
  const [finding] = verdicts.findings, [bookmark] = verdicts.bookmarks;
  assert.ok(finding.diameter > 0 && finding.lps.length === 3 && finding.uv.length === 2);
  assert.ok(finding.arcLength > 0 && typeof finding.segment === 'string' && finding.morphology === '');
  assert.deepEqual(finding.caliper.map((end) => end.length), [3, 3], 'the caliper stays');
  assert.ok(Math.abs(far(...finding.caliper) - finding.diameter) < 0.2);
  const outside = await page.evaluate(() => {
    const v = viewer.verdicts, item = () => v.itemOf(v.findings[0]), texts = [];
    for (let i = 0; i < 2; i++) {
      item().querySelector('.outside').click();
      texts.push([v.document().findings[0].extracolonic, item().textContent]);
    }
    return texts;
  });
  assert.deepEqual(outside.map(([flag]) => flag), [true, false], 'a finding can be outside the colon');
  await page.evaluate(() => viewer.verdicts.choose(viewer.verdicts.entries[0]));
  await press('z');
  await page.key('9');
  await press('s', CTRL);
  assert.equal(JSON.parse(await saved()).candidates[0].size, 7.4, 'what is being typed, 7.39, is saved');
  assert.match(outside[0][1], /^F1.* extracolonic · /);
  assert.match(outside[1][1], / cm from the anal verge/);
  const isRefused = await page.evaluate(() => {
    const { verdicts } = viewer, [entry] = verdicts.findings, elsewhere = entry.lps.map((x) => x + 100);
    return !verdicts.setCaliper(entry, 5, [{ xyz: entry.lps }, { xyz: elsewhere }]) && entry.diameter !== 5;
  });
  assert.ok(isRefused, 'a measurement elsewhere does not change the size');
  const picture = Buffer.from(bookmark.picture.replace(/^data:image\/png;base64,/, ''), 'base64');
  assert.ok(picture.readUInt32BE(16) <= 900 && picture.readUInt32BE(20) > 100, 'width and height of the PNG');
  await page.evaluate(() => {
    const v = viewer.verdicts;
    Object.assign(v.entries[0], { verdict: 'unsure', size: null, morphology: '' });
    v.assessment.take({});
    v.bookmarks.take([]);
    v.removeFinding(v.findings[0]);
  });
  await openVerdicts(text.replace(verdicts.exam.sha256, '0'.repeat(64)));
  const refusal = await page.evaluate(() => document.getElementById('notices').textContent);
  assert.match(refusal, /belong to another examination; nothing was changed/);
  assert.equal(await page.evaluate(() => viewer.verdicts.entries[0].verdict), 'unsure');
  await openVerdicts('{"version": 1');
  assert.match(await page.evaluate(() => document.getElementById('notices').textContent), /not JSON/);
  await openVerdicts(text);
  await press('s', CTRL);
  assert.equal(await saved(), text);
  await shot('7-verdicts');
  await page.evaluate(() => viewer.panels[0].inside.go(0));
  await clickOn('#bookmarks li button.head');
  assert.ok(far((await state()).xyz, bookmark.lps) < 1e-9, 'a click on a bookmark returns to its place');
});

test('verdicts of version 1 are opened and completed', async () => {
  const exam = await page.evaluate(() => viewer.info.exam), { xyz, uv } = await state();
  const id = await page.evaluate(() => viewer.verdicts.entries[0].id);
  await openVerdicts(JSON.stringify({
    version: 1, exam, candidates: [{ id, verdict: 'unsure', note: 'old' }],
    findings: [{ id: 'F1', position: 0, lps: xyz, uv, diameter: 6.5, note: 'flat' }],
  }));
  const { candidates: [first], findings: [finding], bookmarks, version } = await page.evaluate(() => viewer.verdicts.document());
  assert.deepEqual([version, bookmarks], [2, []]);
  assert.deepEqual(first, { id, verdict: 'unsure', note: 'old', size: null, morphology: '' });
  assert.equal(finding.diameter, 6.5);
  assert.ok(finding.arcLength > 0);
});

test('the other position follows the map, and back', async (t) => {
  if (await page.evaluate(() => !viewer.maps)) { t.skip('one position'); return; }
  const [x, y, w, h] = await box('flat'), times = [];
  for (let i = 0; i < 5; i++) {
    const old = [await state(0), await state(1)], started = Date.now();
    await page.click(x + w * (0.25 + 0.1 * i), y + h * 0.6);
    await idle();
    times.push(Date.now() - started);
    for (const k of [0, 1]) assert.ok(far((await state(k)).xyz, old[k].xyz) > 1, `crosshair ${k} stayed at click ${i}`);
  }
  figures.linkedClick = median(times);
  if (isTimed) assert.ok(figures.linkedClick < 500);
  const errors = await page.evaluate(() => {
    const [a] = viewer.exams, out = [];
    for (let i = 0; i < 200; i++) {
      const face = Math.floor((i * a.faces.length) / 600), trust = viewer.maps[0].trust[a.faces[3 * face]];
      if (trust < 60 || trust > 200) continue;
      const place = a.place(face, [0.3, 0.3, 0.4]);
      viewer.panels[0].set(place);
      viewer.panels[1].set(viewer.panels[1].place);
      out.push(Math.hypot(...viewer.panels[0].place.xyz.map((v, k) => v - place.xyz[k])));
    }
    return out;
  });
  figures.linkedBack = [0.5, 0.9, 1].map((q) => errors.sort((a, b) => a - b)[Math.min(errors.length - 1, Math.floor(q * errors.length))]);
  assert.ok(errors.length > 20 && figures.linkedBack[2] <= 5, JSON.stringify(figures.linkedBack));
  await idle();
  await shot('8-linked');
});

test('scrolling slices and dragging the unfolded view move both positions', async (t) => {
  if (await page.evaluate(() => !viewer.maps)) { t.skip('one position'); return; }
  const places = () => page.evaluate(() => viewer.panels.map((p) => p.place.xyz));
  const [x, y, w, h] = await box('axial'), before = await places();
  await page.wheel(x + w / 2, y + h / 2, 100);
  await idle();
  const after = await places(), shifts = after.map((p, k) => p.map((v, i) => v - before[k][i]));
  assert.ok(Math.hypot(...shifts[0]) > 0.1 && far(...shifts) < 1e-6, JSON.stringify(shifts));
  const middles = () => page.evaluate(() => {
    const [a, b] = viewer.panels.map((p) => p.flat.center());
    return { scales: [a.scale, b.scale], off: viewer.link.from(0, a.place).uv.map((v, i) => v - b.place.uv[i]), u: a.place.uv[0] };
  });
  const [u, v, width, height] = await box('flat'), old = await middles();
  await page.evaluate(() => {
    const [{ flat, exam }] = viewer.panels, { xyz } = exam.center[exam.center.length >> 1];
    flat.show({ place: exam.fromXyz(xyz, false), scale: 4 });
  });
  for (const [type, dx] of [['mousePressed', 0], ['mouseMoved', -30], ['mouseMoved', -60], ['mouseReleased', -60]]) {
    await page.mouse(type, u + width / 2 + dx, v + height * 0.6, { button: 'left', buttons: 1, clickCount: 1 });
  }
  await idle();
  const moved = await middles();
  assert.ok(moved.u !== old.u && Math.abs(moved.scales[0] - moved.scales[1]) < 1e-9, JSON.stringify(moved));
  assert.ok(Math.abs(moved.off[0]) < 1, `the same part: ${moved.off}`);
});

test('a candidate is shown at one scale in both positions, also after zooming', async (t) => {
  if (await page.evaluate(() => !viewer.maps)) { t.skip('no second position'); return; }
  const scales = () => page.evaluate(() => viewer.panels.map((p) => p.slices.map((s) => s.frame().s)));
  const same = ([a, b]) => a.every((x, k) => Math.abs(x - b[k]) < 1e-9 * x);
  await page.evaluate(() => viewer.verdicts.step(1));
  await idle();
  const before = await scales();
  assert.ok(same(before), JSON.stringify(before));
  const [x, y, w, h] = await box('coronal', 1);
  await page.wheel(x + w / 2, y + h / 2, -100, { modifiers: CTRL });
  await idle();
  const after = await scales();
  assert.ok(same(after) && after[0][1] > before[0][1], JSON.stringify(after));
});

test('the other position is dimmed where the map is unreliable', async (t) => {
  if (await page.evaluate(() => !viewer.maps)) { t.skip('one position'); return; }
  const dims = await page.evaluate(() => [255, 20, 190].map((trust) => {
    const [panel] = viewer.panels, corners = panel.exam.faces.subarray(3 * panel.place.face, 3 * panel.place.face + 3);
    const kept = viewer.maps[0].trust[corners[0]];
    viewer.maps[0].trust[corners[0]] = trust;
    panel.set(panel.place);
    viewer.maps[0].trust[corners[0]] = kept;
    return [viewer.panels[1].root.classList.contains('dim'), document.getElementById('trust').textContent];
  }));
  assert.deepEqual(dims.map(([isDim]) => isDim), [true, true, false]);
  assert.match(dims[0][1], /unreliable/);
  assert.match(dims[2][1], /0\.95/);
});

test('help lists the keys; the layout fits small and large screens', async () => {
  await press('?');
  const help = await page.evaluate(() => (document.getElementById('keys').open ? document.getElementById('keys').innerText : ''));
  assert.match(help, /fly ahead 2 mm[^]*original or cleansed CT[^]*save verdicts\.json[^]*moves the crosshair/);
  await shot('9-help');
  await press('Escape');
  for (const [width, height] of [[1280, 720], [3840, 2160]]) {
    await page.size(width, height);
    await idle();
    await shot(`10-${width}`);
    const [bottom, least] = await page.evaluate(() => [
      document.querySelector('footer').getBoundingClientRect().bottom,
      Math.min(...[...document.querySelectorAll('.view')].map((v) => v.clientHeight)),
    ]);
    assert.ok(bottom <= height && least > 60, `${width} x ${height}: ${bottom}, ${least}`);
  }
  await page.size(1600, 1000);
});

test('unsaved work warns before the page closes', async () => {
  await press('f');
  const [x, y] = await box('flat');
  await page.click(x + 100, y + 100); // browsers prompt only after user interaction
  await page.open(`${folder}/viewer.html`);
  assert.deepEqual(page.dialogs, ['beforeunload']);
  assert.deepEqual(page.errors, []);
});
