import { readBlock } from '../../../Core/Report/scripts/bytes.mjs';
import { Exam } from './exam.mjs';
import { Seen } from './flight.mjs';
import { SurfacePaths } from './geodesic.mjs';
import { viewerKeys } from './help.mjs';
import { layerList } from './layers.mjs';
import { Link } from './link.mjs';
import { Painter } from './painter.mjs';
import { Panel } from './panel.mjs';
import { Verdicts } from './verdicts.mjs';
import { toggle } from '../../../Core/Report/scripts/keys.mjs';
import { byId, letGo, notice, openPage } from '../../../Core/Report/scripts/page.mjs';
import { scaleViews, View } from '../../../Core/Report/scripts/view.mjs';

const DOUBTFUL = 0.3; // below this confidence of the map the other position is dimmed
const EXCLUDED = 255;   // in `trust`: not visible in one of the positions

const PAGE = `
<header>
  <b id="title"></b><span id="layers"></span>
  <select id="window" aria-label="window of the slices">
    <option value="1500,-200">colon</option><option value="400,40">soft tissue</option>
    <option value="2000,300">tagged residue</option><option value="1536,-256">wide</option><option value="">by hand</option>
  </select>
  <button id="fly">Fly</button><button id="way">→ cecum</button><button id="measure">Measure</button>
  <button id="finding">Add finding</button><label id="linkBox"><input type="checkbox" id="link" checked> link</label>
  <button id="help">Help ?</button>
</header>
<main id="panels"></main>
<aside>
  <div id="notices" role="alert"></div>
  <p><button id="save">Save verdicts</button> <button id="open">Open</button><input type="file" id="file" accept=".json" hidden>
  <span id="unsaved"></span></p>
  <ol id="entries"></ol>
</aside>
<footer>
  <span id="status" role="status"></span><span id="trust"></span><span id="share"></span>
  <b>For research use; not a diagnosis. This page holds patient data.</b>
</footer>
<dialog id="keys"></dialog>`;

const $ = byId;

// Panels of one or two positions, linked by the registration, and their actions.
class Viewer {
  constructor(info, exams, maps, painter) {
    Object.assign(this, { info, exams, maps, painter, current: 0, isFlying: false, times: {} });
    this.link = maps && new Link(exams, maps.map(({ mapped }) => mapped));
    this.layers = Object.fromEntries(layerList.map(([name, , isOn]) => [name, isOn]));
    this.panels = exams.map((exam, k) => this.makePanel(exam, k));
    this.verdicts = new Verdicts($('entries'), info, exams, {
      jump: (entry) => this.jump(entry),
      resize: (finding) => this.resize(finding),
      changed: () => this.notify(),
    });
    this.makeLayers();
    this.listen();
  }

  makePanel(exam, k) {
    const root = document.createElement('section');
    root.dataset.position = k;
    $('panels').append(root);
    exam.seen = new Seen(exam);
    let paths = null;
    exam.paths = () => (paths ??= new SurfacePaths(exam)); // created for the first distance
    return new Panel(root, exam, this.layers, (panel) => this.moved(panel), (panel) => this.verdicts.marks(this.panels.indexOf(panel)));
  }

  get panel() { return this.panels[this.current]; }

  makeLayers() {
    for (const [name, text] of layerList) {
      if (name === 'trust' && !this.maps) continue;
      const label = document.createElement('label'), box = document.createElement('input');
      Object.assign(box, { type: 'checkbox', name, checked: this.layers[name] });
      box.onchange = () => { this.layers[name] = box.checked; this.repaint(); };
      box.onclick = letGo;
      label.append(box, ` ${text}`);
      $('layers').append(label);
    }
  }

  listen() {
    const on = (id, act) => { $(id).onclick = (e) => { act(); letGo(e); }; };
    on('fly', () => this.toggleFlight());
    on('way', () => this.reverse());
    on('measure', () => this.toggleMeasure());
    on('finding', () => this.addFinding());
    on('save', () => this.save());
    on('open', () => this.openFile());
    on('help', () => this.toggleHelp());
    $('window').onchange = () => { if ($('window').value) this.setWindow($('window').value.split(',').map(Number)); $('window').blur(); };
    $('file').onchange = () => this.read($('file').files[0]);
    viewerKeys.listen(this);
    addEventListener('resize', scaleViews);
    scaleViews();
    addEventListener('beforeunload', (e) => { if (!this.verdicts.isSaved) e.preventDefault(); });
    this.panels.forEach((panel, k) => panel.root.addEventListener('pointerdown', () => { this.current = k; }, true));
    viewerKeys.fillHelp($('keys'));
  }

  // ---- key and button actions ----
  fly(mm) { this.panel.fly(mm); }
  turn([yaw, pitch]) { this.panel.inside.turn(yaw, pitch); }
  reverse() { this.panel.inside.reverse(); this.notify(); }
  goTo(arc) { const { center } = this.panel.exam; this.panel.inside.go(arc ? center.length - 1 : 0); }
  moveFlat([right, down]) { this.panel.flat.move(right, down); }
  stepSlice([k, n]) { this.panel.slices[k].step(n); }
  nextPanel() { this.current = (this.current + 1) % this.panels.length; this.notify(); }
  turnOutside(yaw) { this.panel.outside.turn(yaw, 0); }
  stepEntry(by) { this.verdicts.step(by); }
  nextVerdict() { this.verdicts.nextVerdict(); }
  writeNote() { this.verdicts.writeNote(); }
  addFinding() { this.verdicts.addFinding(this.current, this.panel.place); }
  save() { this.verdicts.save(); }
  openFile() { $('file').click(); }
  toggleHelp() { toggle($('keys')); }
  setWindow(window) { this.panels.forEach((p) => p.setWindow(window)); }
  measureHere() { if (!this.panel.measure) this.toggleMeasure(); this.panel.clicked(); }

  nextView() {
    const { panel } = this, { views } = panel;
    panel.active = views[(views.indexOf(panel.active) + 1) % views.length];
    this.notify();
  }

  zoom(by) {
    const { active } = this.panel;
    if (active === this.panel.flat) active.scaleBy(by); else active.scale(by);
  }

  leave() {
    if ($('keys').open) $('keys').close();
    document.activeElement?.blur();
    this.panels.forEach((p) => p.endMeasure());
    this.notify();
  }

  toggleMeasure() {
    const isOn = Boolean(this.panel.measure);
    this.panels.forEach((p) => (isOn ? p.endMeasure() : p.startMeasure()));
    this.notify();
  }

  // Measures a finding by two clicks.
  resize(finding) {
    this.panels[finding.position].startMeasure((mm) => {
      this.verdicts.setDiameter(finding, mm);
      this.panels[finding.position].endMeasure();
    });
    this.notify();
  }

  toggleFlight() {
    this.isFlying = !this.isFlying;
    const { panel } = this, step = () => {
      if (!this.isFlying || panel.isAtEnd) { this.isFlying = false; this.notify(); return; }
      panel.fly(2);
      requestAnimationFrame(step);
    };
    if (this.isFlying) step();
    this.notify();
  }

  jump({ candidate, position, lps }) {
    const panel = this.panels[position];
    this.current = position;
    panel.set(candidate ? candidate.place : panel.exam.fromXyz(lps));
    panel.slices.forEach((s) => { s.zoom = Math.max(s.zoom, 3); });
    panel.flat.scale = Math.max(panel.flat.frame().s, 1.5);
    panel.flat.u = panel.place.uv[0];
    panel.flat.reveal(panel.place);
    this.panels.forEach((p) => p.changed());
  }

  async read(file) {
    try {
      this.verdicts.open(await file.text());
    } catch (error) {
      notice(error.message);
    }
    $('file').value = '';
  }

  // ---- updates after a move of the crosshair ----
  moved(panel) {
    this.current = this.panels.indexOf(panel);
    if (this.maps && $('link').checked) this.linkFrom(this.current);
    if (panel.exam.seen.queue.length) this.lookAround(panel.exam.seen);
    this.notify();
  }

  // Moves the other position to the mapped point, dimmed if the map is unreliable there.
  linkFrom(k) {
    const { place } = this.panels[k], other = this.panels[1 - k], t = this.maps[k].trust[this.exams[k].faces[3 * place.face]];
    this.trust = t === EXCLUDED ? null : t / 200;
    other.follow(this.link.from(k, place));
    this.panels[k].root.classList.remove('dim');
    other.root.classList.toggle('dim', this.trust === null || this.trust < DOUBTFUL);
  }

  // Updates the seen areas in small steps, smaller ones while flying, to prioritize rendering.
  lookAround(seen) {
    if (seen.isBusy) return;
    seen.isBusy = true;
    const work = () => {
      const isMore = seen.work(12);
      if (isMore) { setTimeout(work, this.isFlying ? 60 : 0); return; }
      this.notify();
      seen.isBusy = false;
      if (this.layers.unseen) this.repaint();
    };
    setTimeout(work);
  }

  repaint() { this.panels.forEach((p) => p.repaint()); }

  notify() {
    const { panel, verdicts } = this, { seen } = panel.exam;
    $('status').textContent = panel.describe();
    $('share').textContent = seen.sum ? `wall seen in flight: ${(100 * seen.share).toFixed(1)} %` : '';
    $('trust').textContent = !this.maps ? '' : this.trust === null ? 'not visible in one position: the mapped point is unreliable'
      : this.trust === undefined ? '' : `confidence of the map ${this.trust.toFixed(2)}`;
    $('unsaved').textContent = verdicts?.isSaved === false ? 'not saved yet' : '';
    $('way').textContent = panel.inside.way > 0 ? '→ cecum' : '← anal verge';
    $('fly').textContent = this.isFlying ? 'Stop' : 'Fly';
    $('measure').classList.toggle('on', Boolean(panel.measure));
    $('window').value = [...$('window').options].some((o) => o.value === String(panel.window)) ? String(panel.window) : '';
    this.panels.forEach((p) => p.views.forEach((v) => v.box.classList.toggle('active', p === panel && v === p.active)));
  }

  async loadVolumes(folder) {
    for (const [k, exam] of this.exams.entries()) {
      const started = performance.now();
      try {
        await exam.loadVolume(folder, `${k}/`);
        if (!exam.volume.isCt) this.panels[k].setWindow([1, 0.5]);
      } catch (error) {
        this.panels[k].volumeText = 'The volume cannot be shown.';
        notice(`${error.message} Flat wall and wall in space still work.`);
      }
      this.times[`volume${k}`] = performance.now() - started;
      this.panels[k].changed();
    }
    this.notify();
  }

  // For tests: everything requested has been painted.
  async idle() {
    do await new Promise((done) => { requestAnimationFrame(() => setTimeout(done)); });
    while (View.pending || this.exams.some((e) => e.seen.isBusy));
  }
}

// Notices to show before reading.
function tellMissing(info, painter) {
  if (!painter.gl) notice('This browser has no WebGL 2: flat wall, slices and verdicts work, both 3D views do not.');
  for (const position of info.positions) {
    const { missing, name } = position, what = missing.filter((m) => m !== 'CT');
    if (missing.includes('CT')) notice('This run is based on a lumen mask: slices show the mask, not a CT.');
    if (what.length) notice(`The run has no ${what.join(', ')}${name ? ` (${name})` : ''}.`);
  }
  if (info.positions.length > 1 && !info.hasMap) notice('The run has no registration: the positions are not linked.');
}

async function open(folder) {
  const started = performance.now(), info = await readBlock(folder, 'info'), painter = new Painter();
  $('title').textContent = document.title = `${info.title} – Shapeton viewer`;
  const exams = [];
  for (const [k, position] of info.positions.entries()) exams.push(await new Exam().load(folder, `${k}/`, position, painter));
  const mapOf = async (k) => ({ mapped: await readBlock(folder, `${k}/mapped`), trust: await readBlock(folder, `${k}/trust`) });
  const maps = info.hasMap ? [await mapOf(0), await mapOf(1)] : null;
  maps?.forEach((map, k) => { exams[k].trust = map.trust; });
  document.body.classList.toggle('pair', exams.length > 1);
  $('linkBox').hidden = !maps;
  tellMissing(info, painter);
  const viewer = new Viewer(info, exams, maps, painter);
  viewer.times.surface = performance.now() - started;
  viewer.repaint();
  await viewer.loadVolumes(folder);
  viewer.times.all = performance.now() - started;
  globalThis.viewer = viewer; // for tests and for use in the console
}

// folder: the folder of the data scripts, relative to the page; null if they are in the page.
export async function startColonViewer(folder) {
  document.body.innerHTML = PAGE;
  await openPage(() => open(folder));
}
