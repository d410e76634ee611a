// Pages written by the tool, and their error messages.
// usage: TOOL=ColonViewer EXAM=folder of a finished run with candidates WORK=folder to write to, node --test pages.test.mjs
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { gunzipSync, gzipSync } from 'node:zlib';
import { launch } from '../../../Testing/Browser/browser.mjs';

const { TOOL: tool, EXAM: exam, WORK: work } = process.env;
const NOTE = 'on a fold</script><b>é';
let page;

const make = (folder, ...options) => {
  const { status, stderr } = spawnSync(tool, [exam, `${work}/${folder}`, '--quiet', ...options], { encoding: 'utf8' });
  return { status, stderr };
};
const made = (folder, ...options) => {
  const { status, stderr } = make(folder, ...options);
  assert.equal(status, 0, stderr);
  return `${work}/${folder}`;
};
const infoOf = (folder) => {
  const text = readFileSync(`${folder}/data/info.js`, 'utf8');
  return JSON.parse(text.replace(/^block\("info",null,/, '').replace(/\);\n$/, ''));
};
const verdictsOf = (sha256) => JSON.stringify({
  version: 1, exam: { seriesUIDs: [], sha256 }, candidates: [{ id: '1', verdict: 'polyp', note: NOTE }],
  findings: [{ id: 'F1', position: 0, lps: [1, 2, 3], uv: [20, 10], diameter: 6.5, note: 'flat' }],
});
const open = async (folder) => {
  page.errors.length = 0;
  await page.open(`${folder}/viewer.html`);
  await page.until(() => Boolean(window.viewer) || document.body.classList.contains('failed'));
};
// A compressed NRRD file: its header and values.
const NRRD_TYPES = { float: Float32Array, short: Int16Array };
const nrrdOf = (name) => {
  const bytes = readFileSync(`${exam}/segmentation/${name}`), end = bytes.indexOf('\n\n'), header = bytes.subarray(0, end).toString();
  const field = (key) => header.match(new RegExp(`^${key}: (.*)$`, 'm'))[1];
  assert.equal(field('encoding'), 'gzip');
  const values = new NRRD_TYPES[field('type')](Uint8Array.from(gunzipSync(bytes.subarray(end + 2))).buffer);
  const numbersIn = (text) => text.match(/-?[\d.]+(e-?\d+)?/g).map(Number);
  return { values, size: numbersIn(field('sizes')), origin: numbersIn(field('space origin')), axes: numbersIn(field('space directions')) };
};
const notices = () => page.evaluate(() => document.getElementById('notices').textContent);
const broken = (name, file) => {
  const folder = `${work}/${name}`;
  cpSync(`${work}/first`, folder, { recursive: true });
  const text = readFileSync(`${folder}/data/${file}`, 'utf8');
  writeFileSync(`${folder}/data/${file}`, text.slice(0, text.length / 2));
  return folder;
};

before(async () => {
  rmSync(work, { recursive: true, force: true });
  mkdirSync(work, { recursive: true });
  made('first');
  page = await launch({ width: 1280, height: 720 });
});
after(() => page.close());

test('equal runs give equal bytes', () => {
  const again = made('again'), files = readdirSync(`${work}/first/data`);
  assert.ok(files.length > 10);
  for (const name of ['viewer.html', ...files.map((f) => `data/${f}`)]) {
    assert.ok(readFileSync(`${work}/first/${name}`).equals(readFileSync(`${again}/${name}`)), name);
  }
});

test('a single page contains all data, with the given verdicts', async () => {
  writeFileSync(`${work}/verdicts.json`, verdictsOf(infoOf(`${work}/first`).exam.sha256));
  const folder = made('single', '--single', '--bits', '16', '--verdicts', `${work}/verdicts.json`);
  const report = ['reader-report.csv', 'reader-report.html', 'reader-report.pdf'];
  assert.deepEqual(readdirSync(folder).sort(), [...report, 'verdicts.mrk.json', 'viewer.html']);
  await open(folder);
  await page.until(() => Boolean(window.viewer));
  assert.deepEqual(page.errors, []);
  assert.equal(await page.evaluate(() => document.querySelector('#entries .note').value), NOTE);
  assert.equal(await page.evaluate(() => viewer.verdicts.findings[0].diameter), 6.5);
  const [list] = JSON.parse(readFileSync(`${folder}/verdicts.mrk.json`, 'utf8')).markups;
  assert.deepEqual(list.controlPoints.map((p) => p.label), ['candidate 1: polyp', 'finding F1']);
  assert.deepEqual(list.controlPoints[1].position, [1, 2, 3]);
});

test('the report of the reader states sizes, category and what is unread', () => {
  const verdicts = JSON.parse(verdictsOf(infoOf(`${work}/first`).exam.sha256));
  const total = infoOf(`${work}/first`).positions[0].candidates.length;
  Object.assign(verdicts, { version: 2, assessment: { colonic: 'C2', extracolonic: '', note: '' } });
  Object.assign(verdicts.candidates[0], { size: 12.5, morphology: 'pedunculated' });
  writeFileSync(`${work}/report.json`, JSON.stringify(verdicts));
  const folder = made('report', '--verdicts', `${work}/report.json`);
  const text = readFileSync(`${folder}/reader-report.html`, 'utf8');
  assert.match(text, new RegExp(`Preliminary: ${total - 1} candidates? (is|are) unread`));
  assert.match(text, /C2, as entered by the reader/);
  assert.match(text, /1 of 10 mm and more, 1 of 6 to 9 mm, 0 below 6 mm/);
  assert.match(text, /src="data:image\/png;base64,/);
  const rows = readFileSync(`${folder}/reader-report.csv`, 'utf8').trim().split('\n');
  assert.equal(rows.length, 1 + total + 1);
  assert.match(rows[1], /^1,candidate,polyp,.*,12.5,reader,pedunculated,reader,/);
  const files = readdirSync(folder).filter((name) => name.startsWith('reader-report'));
  const again = made('reportAgain', '--verdicts', `${work}/report.json`);
  for (const name of files) assert.ok(readFileSync(`${folder}/${name}`).equals(readFileSync(`${again}/${name}`)), name);
});

test('a page opens with verdicts of version 2', async () => {
  const saved = JSON.parse(verdictsOf(infoOf(`${work}/first`).exam.sha256));
  Object.assign(saved, { version: 2, secondReader: true, candidatesRevealed: true, bookmarks: [] });
  saved.assessment = { colonic: 'C3', extracolonic: 'E2', note: NOTE };
  Object.assign(saved.candidates[0], { size: 8.5, morphology: 'flat' });
  writeFileSync(`${work}/verdicts2.json`, JSON.stringify(saved));
  await open(made('second', '--verdicts', `${work}/verdicts2.json`));
  await page.until(() => Boolean(window.viewer));
  const { assessment, candidates, secondReader } = await page.evaluate(() => viewer.verdicts.document());
  assert.deepEqual(assessment, saved.assessment);
  assert.deepEqual(candidates.find((c) => c.id === '1'), saved.candidates[0]);
  assert.equal(secondReader, true);
  writeFileSync(`${work}/verdicts3.json`, JSON.stringify({ ...saved, version: 3 }));
  assert.match(make('third', '--verdicts', `${work}/verdicts3.json`).stderr, /unsupported version/);
});

test('the page holds the HU of the original and of the cleansed CT, and the slice numbers of the image', async () => {
  const cleansed = nrrdOf('cleansed.nrrd'), cleansing = nrrdOf('cleansing.nrrd'), [nx, ny] = cleansed.size;
  await open(`${work}/first`);
  await page.until(() => Boolean(window.viewer?.exams[0].volume));
  const samples = await page.evaluate(() => {
    const [{ volume: v }] = viewer.exams, { changes: { at, codes } } = v, out = [], [a, b] = v.size;
    for (let i = 0; i < at.length; i += Math.ceil(at.length / 500)) {
      const voxel = at[i], index = [voxel % a, Math.floor(voxel / a) % b, Math.floor(voxel / a / b)];
      const block = index.map((x) => Math.floor(x / v.side));
      if (v.coarse[block[0] + v.blocks[0] * (block[1] + v.blocks[1] * block[2])]) continue;
      out.push({ index: index.map((x, k) => x + v.first[k]), original: v.huOf(v.data[voxel]), cleansed: v.huOf(codes[i]) });
    }
    return out;
  });
  const clamped = (hu) => Math.min(1560, Math.max(-1024, hu)), tolerance = (hu) => (hu < 300 ? 3.01 : 20.01);
  let greatest = 0;
  for (const { index: [i, j, k], original, cleansed: after } of samples) {
    const at = i + nx * (j + ny * k), clean = cleansed.values[at], ct = clean + cleansing.values[at];
    assert.ok(Math.abs(original - clamped(ct)) < tolerance(ct), `${original} instead of ${ct} HU`);
    assert.ok(Math.abs(after - clamped(clean)) < tolerance(clean), `${after} instead of ${clean} HU`);
    greatest = Math.max(greatest, ct - clean);
  }
  assert.ok(samples.length > 100 && greatest > 300, `${samples.length} voxels`);
  const { facts, z } = await page.evaluate(() => {
    viewer.stepEntry(1);
    const [panel] = viewer.panels, [axial] = panel.slices, { volume: v } = panel.exam;
    const { xyz } = panel.place, index = Math.round(panel.exam.toImage(xyz)[axial.axis] / v.spacing[axial.axis]);
    return { facts: axial.facts(index, xyz), z: xyz[2] };
  });
  const slice = Math.round((z - cleansed.origin[2]) / cleansed.axes[8]) + 1;
  assert.match(facts[0], new RegExp(`^slice ${slice} of ${cleansed.size[2]} `));
});

test('a second reader sees no candidates until asking for them, and verdicts say so', async () => {
  await open(made('secondReader', '--secondReader'));
  const look = () => page.evaluate(async () => {
    viewer.stepEntry(1);
    await viewer.idle();
    const { secondReader, candidatesRevealed } = viewer.verdicts.document();
    const items = document.querySelectorAll('#entries li[data-id]').length;
    const marks = viewer.panels[0].marks().filter(({ text }) => text !== 'valve').length;
    const isOffered = !document.getElementById('reveal').hidden;
    return { secondReader, candidatesRevealed, items, marks, isOffered, chosen: viewer.verdicts.chosen?.id ?? null };
  });
  await page.until(() => Boolean(window.viewer));
  const number = await page.evaluate(() => viewer.verdicts.entries.length);
  assert.deepEqual(await look(), { secondReader: true, candidatesRevealed: false, items: 0, marks: 0, isOffered: true, chosen: null });
  await page.key('h');
  const { chosen, ...revealed } = await look();
  assert.deepEqual(revealed, { secondReader: true, candidatesRevealed: true, items: number, marks: number, isOffered: false });
  assert.ok(number > 0 && chosen);
});

test('the page states the limitations of the report and why C0 should be considered', async () => {
  const stated = JSON.parse(readFileSync(`${exam}/limitations.json`));
  assert.ok(stated.limitations.length > 0);
  assert.match(stated.note, /^Consider category C0/);
  const report = readFileSync(`${exam}/report.html`, 'utf8').replaceAll('&lt;', '<').replaceAll('&gt;', '>').replaceAll('&amp;', '&');
  for (const text of [stated.note, ...stated.limitations]) assert.ok(report.includes(text), text);
  await open(`${work}/first`);
  const shown = await page.evaluate(() => [...document.querySelectorAll('#stated li')].map((item) => item.textContent));
  assert.deepEqual(shown, stated.limitations);
  assert.ok((await notices()).includes(stated.note));
});

test('the page lists the warnings of the stages', () => {
  const files = readdirSync(`${exam}/stages`).filter((f) => f.endsWith('.json'));
  const stages = files.map((f) => JSON.parse(readFileSync(`${exam}/stages/${f}`, 'utf8')));
  const expected = stages.flatMap(({ stage, warnings = [] }) => warnings.map((w) => `${stage}: ${w}`));
  assert.deepEqual(infoOf(`${work}/first`).warnings.flatMap((kind) => kind.warnings).sort(), expected.sort());
});

test('a link of the report opens the page at its place', async () => {
  await open(`${work}/first`);
  await page.until(() => Boolean(window.viewer?.exams[0].volume));
  const lps = await page.evaluate(() => Array.from(viewer.verdicts.entries.find((e) => e.candidate).candidate.xyz));
  await page.evaluate((hash) => { location.hash = hash; }, `#lps=${lps.map(Math.round)}`);
  await page.until(() => location.hash.startsWith('#lps'));
  const xyz = await page.evaluate(async () => { await viewer.idle(); return Array.from(viewer.panels[0].place.xyz); });
  assert.ok(Math.hypot(...xyz.map((x, k) => x - lps[k])) < 2, `${xyz} instead of ${lps}`);
});

test('a link of the report to a candidate selects its card', async () => {
  await page.evaluate(() => { viewer.verdicts.choose(null); location.hash = '#candidate=1'; });
  await page.until(() => viewer.verdicts.chosen !== null);
  const [id, isMarked, off] = await page.evaluate(() => {
    const { chosen } = viewer.verdicts, { xyz } = viewer.panels[0].place;
    return [chosen.id, Boolean(document.querySelector('#entries li.chosen')), xyz.map((x, k) => x - chosen.candidate.xyz[k])];
  });
  assert.deepEqual([id, isMarked, off], ['1', true, [0, 0, 0]]);
});

test('a full page holds no means', async () => {
  await open(made('full', '--full'));
  await page.until(() => Boolean(window.viewer?.exams[0].volume));
  assert.equal(await page.evaluate(() => viewer.exams[0].volume.coarse.includes(1)), false);
});

test('verdicts of another examination are rejected, and the old page is unchanged', () => {
  const old = readFileSync(`${work}/single/viewer.html`);
  writeFileSync(`${work}/other.json`, verdictsOf('0'.repeat(64)));
  const { status, stderr } = make('single', '--single', '--verdicts', `${work}/other.json`);
  assert.equal(status, 3);
  assert.match(stderr, /belong to another examination/);
  assert.deepEqual(readdirSync(`${work}/single`).filter((name) => name.includes('part')), []);
  writeFileSync(`${work}/other.json`, verdictsOf(infoOf(`${work}/first`).exam.sha256).replace('"polyp"', '"cancer"'));
  const unknown = make('single', '--single', '--verdicts', `${work}/other.json`);
  assert.equal(unknown.status, 3);
  assert.match(unknown.stderr, /the candidate "1" has an unknown verdict "cancer"/);
  writeFileSync(`${work}/other.json`, '{"version": 1, "exam": 3}');
  assert.equal(make('single', '--single', '--verdicts', `${work}/other.json`).status, 3);
  assert.ok(readFileSync(`${work}/single/viewer.html`).equals(old));
});

test('an anonymous page contains neither series UID nor folder name', () => {
  const info = infoOf(made('anonymous', '--anonymous'));
  assert.deepEqual(info.exam.seriesUIDs, []);
  assert.equal(info.title, 'Examination');
  assert.equal(info.patient, '');
  assert.equal(infoOf(`${work}/first`).exam.seriesUIDs.length, info.positions.length);
  assert.equal(info.exam.sha256, infoOf(`${work}/first`).exam.sha256);
});

test('a truncated volume is reported, and everything else works', async () => {
  const folder = broken('noVolume', '0-volume.js');
  await open(folder);
  await page.until(() => Boolean(window.viewer));
  assert.match(await notices(), /The data "0\/volume" in data\/0-volume\.js is damaged.*still work/);
  await page.evaluate(async () => { viewer.stepEntry(1); viewer.giveVerdict('polyp'); await viewer.idle(); });
  assert.ok(await page.evaluate(() => viewer.panels[0].flat.shown && viewer.verdicts.document().candidates[0].verdict === 'polyp'));
});

test('a block in parts is read, and a missing part is reported', async () => {
  const folder = `${work}/parts`, codes = () => page.evaluate(() => viewer.exams[0].volume.data.join());
  cpSync(`${work}/first`, folder, { recursive: true });
  await open(folder);
  const whole = await codes(), file = `${folder}/data/0-volume.js`, text = readFileSync(file, 'utf8');
  const [, header, body] = text.match(/^block\("0\/volume",(.*),"([^"]*)"\);\n$/);
  const bytes = gunzipSync(Buffer.from(body, 'base64')), cut = Math.floor(bytes.length / 3);
  writeFileSync(file, text.replace('"parts":0', '"parts":2').replace(body, ''));
  [bytes.subarray(0, cut), bytes.subarray(cut)].forEach((part, i) => {
    writeFileSync(`${folder}/data/0-volume.${i + 1}.js`, `block("0/volume.${i + 1}",null,"${gzipSync(part).toString('base64')}");\n`);
  });
  assert.equal(JSON.parse(header).parts, 0, 'a small block is not split');
  await open(folder);
  assert.ok(whole === await codes());
  rmSync(`${folder}/data/0-volume.2.js`);
  await open(folder);
  assert.match(await notices(), /data\/0-volume\.2\.js of this page is missing.*still work/);
});

test('a truncated surface and a missing file are reported', async () => {
  await open(broken('noPoints', '0-points.js'));
  assert.match(await notices(), /The data "0\/points" in data\/0-points\.js is damaged/);
  const folder = broken('noFaces', '0-faces.js');
  rmSync(`${folder}/data/0-faces.js`);
  await open(folder);
  assert.match(await notices(), /data\/0-faces\.js of this page is missing/);
});

test('a browser without DecompressionStream gets a list of supported browsers', async () => {
  const { identifier } = await page.send('Page.addScriptToEvaluateOnNewDocument', { source: 'delete globalThis.DecompressionStream' });
  await open(`${work}/first`);
  assert.match(await notices(), /lacks DecompressionStream.*Firefox 113/);
  await page.send('Page.removeScriptToEvaluateOnNewDocument', { identifier });
});

test('without WebGL 2 the 2D views still work', async () => {
  await page.close();
  page = await launch({ width: 1280, height: 720, hasGl: false });
  await open(`${work}/first`);
  await page.until(() => Boolean(window.viewer));
  assert.match(await notices(), /no WebGL 2/);
  await page.evaluate(async () => { viewer.stepEntry(1); await viewer.idle(); });
  const shown = await page.evaluate(() => viewer.panels[0].views.map((v) => Boolean(v.shown)));
  assert.deepEqual(shown, [true, false, false, true, true, true]);
  assert.deepEqual(page.errors, []);
  assert.ok(!existsSync(`${work}/first/verdicts.mrk.json`));
});
