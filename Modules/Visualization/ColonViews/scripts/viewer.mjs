import { readBlock } from '../../../Core/Pages/scripts/bytes.mjs';
import { Assessment } from './assessment.mjs';
import { Bookmarks, snapshotOf } from './bookmarks.mjs';
import { Exam } from './exam.mjs';
import { Seen } from './flight.mjs';
import { SurfacePaths } from './geodesic.mjs';
import { viewerKeys } from './help.mjs';
import { layerList } from './layers.mjs';
import { layoutAfter, layouts } from './layouts.mjs';
import { Link } from './link.mjs';
import { fillNotes, tellMissing } from './notes.mjs';
import { Painter } from './painter.mjs';
import { Panel } from './panel.mjs';
import { LEAST_WIDTH } from './slice.mjs';
import { Verdicts } from './verdicts.mjs';
import { add } from '../../../Core/Pages/scripts/math.mjs';
import { toggle } from '../../../Core/Pages/scripts/keys.mjs';
import { byId, letGo, notice, openPage, pause } from '../../../Core/Pages/scripts/page.mjs';
import { scaleViews, View } from '../../../Core/Pages/scripts/view.mjs';

const DOUBTFUL = 0.3; // below this confidence of the map the other position is dimmed
const EXCLUDED = 255;   // in `trust`: not visible in one of the positions
const CINE = 100;       // ms per slice
const HIDDEN_LAYERS = Object.fromEntries(layerList.map(([name]) => [name, false]).filter(([name]) => name !== 'through'));

const PAGE = `
<header>
  <b id="title"></b><span id="layers"></span>
  <button id="ct">Original CT</button>
  <select id="window" aria-label="window of the slices">
    <option value="1500,-200">colon 1500/-200</option><option value="400,40">soft tissue 400/40</option>
    <option value="2000,300">tagged residue 2000/300</option><option value="1536,-256">wide 1536/-256</option>
    <option value="">by hand</option>
  </select>
  <select id="layout" aria-label="layout of the views"></select>
  <button id="fly">Fly-through</button><button id="way">→ cecum</button><button id="wide">Fisheye</button>
  <button id="cine">Cine</button><button id="translucency">Translucency</button><button id="measure">Measure</button>
  <button id="finding">Add finding</button><button id="bookmark">Bookmark</button>
  <button id="reveal">Show candidates</button><label id="linkBox"><input type="checkbox" id="link" checked> link</label>
  <button id="help">Help ?</button>
</header>
<main id="panels"></main>
<aside>
  <div id="notices" role="alert"></div>
  <p><button id="save">Save verdicts</button> <button id="open">Open</button><input type="file" id="file" accept=".json" hidden>
  <span id="unsaved"></span><br><small>ColonViewer --verdicts verdicts.json writes the reader's report.</small></p>
  <div id="notes"></div>
  <div id="assessment"></div>
  <ol id="entries"></ol>
  <ol id="bookmarks"></ol>
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
    this.verdicts = this.makeVerdicts();
    this.makeLayers();
    $('layout').append(...layouts.map(([name, text]) => new Option(text, name)));
    this.setLayout('all');
    this.listen();
  }

  makePanel(exam, k) {
    const root = document.createElement('section');
    root.dataset.position = k;
    $('panels').append(root);
    exam.seen = new Seen(exam);
    let paths = null;
    exam.paths = () => (paths ??= new SurfacePaths(exam)); // created for the first distance
    return new Panel(root, exam, this.layers, {
      notify: (panel) => this.moved(panel),
      zoomed: (slice) => this.zoomOthers(slice),
      scrolled: (panel, shift) => this.scrollOther(panel, shift),
      shifted: (panel) => this.shiftOther(panel),
      marksOf: (panel) => this.verdicts.marks(this.panels.indexOf(panel)),
      calipersOf: (panel) => this.verdicts.calipers(this.panels.indexOf(panel)),
    });
  }

  makeVerdicts() {
    const changed = () => { if (this.verdicts) this.verdicts.changed(); };
    const parts = {
      assessment: new Assessment($('assessment'), changed),
      bookmarks: new Bookmarks($('bookmarks'), { go: (bookmark) => this.jump(bookmark), changed }),
    };
    return new Verdicts($('entries'), this.info, this.exams, parts, {
      jump: (entry) => this.jump(entry),
      resize: (entry) => this.resize(entry),
      changed: () => this.notify(),
    });
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
    on('cine', () => this.toggleCine(1));
    on('way', () => this.reverse());
    on('measure', () => this.toggleMeasure());
    on('finding', () => this.addFinding());
    on('bookmark', () => this.addBookmark());
    on('reveal', () => this.reveal());
    on('ct', () => this.toggleCleansed());
    on('wide', () => this.toggleWide());
    on('translucency', () => this.toggleTranslucency());
    $('layout').onchange = () => { this.setLayout($('layout').value); $('layout').blur(); };
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
  goTo(arc) { this.panel.inside.goToEnd(arc > 0); }
  moveFlat([right, down]) { this.panel.flat.move(right, down); }
  stepSlice([k, n]) { this.panel.slices[k].step(n); }
  nextPanel() { this.current = (this.current + 1) % this.panels.length; this.notify(); }
  turnOutside(yaw) { this.panel.outside.turn(yaw, 0); }
  stepEntry(by) { this.verdicts.step(by); }
  giveVerdict(verdict) { this.verdicts.give(verdict); }
  writeNote() { this.verdicts.write('note'); }
  writeSize() { this.verdicts.write('size'); }
  addFinding() { this.verdicts.addFinding(this.current, this.panel.place); }
  addBookmark() {
    const { inside, slices } = this.panel, label = this.panel.exam.nameOfSegment(this.panel.place.face);
    this.verdicts.bookmarks.add(this.current, this.panel.place.xyz, label, snapshotOf([...slices, inside]));
  }

  reveal() { this.verdicts.reveal(); this.repaint(); }
  save() {
    document.activeElement?.blur(); // takes what is being typed
    this.verdicts.save();
  }
  openFile() { $('file').click(); }
  toggleHelp() { toggle($('keys')); }
  setWindow(window) { this.panels.forEach((p) => p.setWindow(window)); }
  changeWindow([width, level]) { const [w, l] = this.panel.window; this.setWindow([Math.max(LEAST_WIDTH, w + width), l + level]); }

  // Hides the layers over the wall, or shows those again that were shown.
  toggleLayers() {
    const shown = this.kept ?? HIDDEN_LAYERS;
    this.kept = this.kept ? null : { ...this.layers };
    Object.assign(this.layers, shown);
    for (const box of $('layers').querySelectorAll('input')) box.checked = this.layers[box.name];
    this.repaint();
  }

  // Shows the other CT in all positions.
  toggleCleansed() {
    const isCleansed = !this.panel.exam.volume?.isCleansed;
    this.panels.forEach((p) => p.showCleansed(isCleansed));
    this.notify();
  }

  toggleWide() {
    for (const { inside } of this.panels) { inside.isWide = !inside.isWide; inside.changed(); }
    this.notify();
  }

  toggleTranslucency() {
    this.panels.forEach((p) => p.toggleTranslucency());
    this.notify();
  }

  setLayout(name) {
    $('panels').dataset.layout = name;
    $('layout').value = name;
  }

  nextLayout() { this.setLayout(layoutAfter($('panels').dataset.layout)); }
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
    this.stopCine();
  }

  toggleMeasure() {
    const isOn = Boolean(this.panel.measure);
    const keep = (position) => (mm, places) => {
      const { chosen } = this.verdicts;
      if (chosen?.position === position && this.verdicts.isSized(chosen)) this.verdicts.setCaliper(chosen, mm, places);
    };
    this.panels.forEach((p, position) => (isOn ? p.endMeasure() : p.startMeasure(keep(position))));
    this.notify();
  }

  // Measures a candidate or finding by two clicks.
  resize(entry) {
    this.panels[entry.position].startMeasure((mm, places) => {
      this.panels[entry.position].endMeasure();
      if (!this.verdicts.setCaliper(entry, mm, places)) notice(`This measurement is not at ${entry.id}: its size is unchanged.`);
    });
    this.notify();
  }

  toggleFlight() {
    this.isFlying = !this.isFlying;
    const { panel } = this, step = () => {
      if (!this.isFlying || panel.isAtEnd) { this.isFlying = false; this.notify(); return; }
      panel.cruise(2);
      requestAnimationFrame(step);
    };
    if (this.isFlying) step();
    this.notify();
  }

  // Plays slices to the last one, or stops.
  toggleCine(direction) {
    if (this.cine) { this.stopCine(); return; }
    const { slices, active } = this.panel, slice = slices.includes(active) ? active : slices[0];
    this.cine = setInterval(() => { if (!slice.step(direction)) this.stopCine(); }, CINE);
    this.notify();
  }

  stopCine() {
    clearInterval(this.cine);
    this.cine = null;
    this.notify();
  }

  // Moves to a candidate, finding or bookmark.
  jump({ candidate, position, lps }) {
    const panel = this.panels[position];
    this.current = position;
    panel.centerOn(candidate ? candidate.place : panel.exam.fromXyz(lps));
    if (this.isLinked) this.panels[1 - position].showAround();
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

  // Follows a link in the report: "#candidate=id", or "#lps=x,y,z" in mm, in the first position.
  follow(hash) {
    const [, id] = /^#candidate=(.+)$/.exec(hash) || [];
    if (id) this.verdicts.goTo(id);
    const numbers = /^#lps=(-?[\d.]+),(-?[\d.]+),(-?[\d.]+)$/.exec(hash);
    if (numbers) this.jump({ position: 0, lps: numbers.slice(1).map(Number) });
  }

  get isLinked() { return Boolean(this.maps) && $('link').checked; }

  // Slices of both positions have the same scale.
  zoomOthers(slice) {
    if (!this.isLinked) return;
    for (const { slices } of this.panels) slices[slice.panel.slices.indexOf(slice)].zoomTo(slice.zoom);
  }

  // Slices of both positions scroll by the same distance.
  scrollOther(panel, shift) {
    this.current = this.panels.indexOf(panel);
    const other = this.isLinked && this.panels[1 - this.current];
    if (other) other.follow(other.exam.fromXyz(add(other.place.xyz, shift)));
    this.notify();
  }

  // Unfolded views of both positions show the same part of the colon at one scale.
  shiftOther(panel) {
    if (!this.isLinked) return;
    const k = this.panels.indexOf(panel), { place, scale } = panel.flat.center();
    this.panels[1 - k].flat.show({ place: this.link.from(k, place), scale });
  }

  shareScale() {
    if (this.exams.some(({ volume }) => !volume)) return;
    this.panel.slices.forEach((_, k) => {
      const slices = this.panels.map((p) => p.slices[k]), extents = slices.map((s) => s.extent());
      for (const slice of slices) slice.room = [0, 1].map((i) => Math.max(...extents.map((e) => e[i])));
    });
  }

  // ---- updates after a move of the crosshair ----
  moved(panel) {
    this.current = this.panels.indexOf(panel);
    if (this.isLinked) this.linkFrom(this.current);
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
    $('trust').textContent = !this.maps ? '' : this.trust === null ? 'narrow or hidden in one position: the mapped point is unreliable'
      : this.trust === undefined ? '' : `confidence of the map ${this.trust.toFixed(2)}`;
    $('unsaved').textContent = verdicts?.isSaved === false ? 'not saved yet' : '';
    $('way').textContent = panel.inside.way > 0 ? '→ cecum' : '← anal verge';
    $('fly').textContent = this.isFlying ? 'Stop' : 'Fly-through';
    const actions = { measure: panel.measure, cine: this.cine, wide: panel.inside.isWide, translucency: panel.translucent };
    for (const [id, isOn] of Object.entries(actions)) $(id).classList.toggle('on', Boolean(isOn));
    $('reveal').hidden = verdicts?.isRevealed !== false;
    $('ct').textContent = panel.exam.volume?.name || 'CT';
    $('ct').classList.toggle('on', Boolean(panel.exam.volume?.changes && panel.exam.volume.isCleansed));
    $('ct').disabled = !panel.exam.volume?.changes;
    $('window').value = [...$('window').options].some((o) => o.value === String(panel.window)) ? String(panel.window) : '';
    this.panels.forEach((p) => p.views.forEach((v) => v.box.classList.toggle('active', p === panel && v === p.active)));
  }

  async loadVolumes(volumes) {
    for (const [k, exam] of this.exams.entries()) {
      const started = performance.now();
      try {
        exam.volume = await volumes[k];
        if (!exam.volume.isCt) this.panels[k].setWindow([1, 0.5]);
      } catch (error) {
        this.panels[k].volumeText = 'The volume cannot be shown.';
        notice(`${error.message} Unfolded view and wall in 3D still work.`);
      }
      this.times[`volume${k}`] = performance.now() - started;
      this.panels[k].changed();
    }
    this.shareScale();
    this.notify();
  }

  // For tests: everything requested has been painted.
  async idle() {
    do await new Promise((done) => { requestAnimationFrame(() => setTimeout(done)); });
    while (View.pending || this.exams.some((e) => e.seen.isBusy));
  }
}

async function open(folder) {
  const started = performance.now(), info = await readBlock(folder, 'info');
  $('title').textContent = document.title = `${[info.title, info.patient].filter(Boolean).join(' · ')} – Shapeton viewer`;
  const exams = info.positions.map((position, k) => new Exam().startReading(folder, `${k}/`, position));
  const volumes = exams.map((exam) => exam.readVolume());
  for (const volume of volumes) volume.catch(() => {}); // reported by loadVolumes()
  await exams[0].blocks[0];
  const painter = new Painter(); // while blocks are decoded
  for (const exam of exams) await exam.load(painter);
  await pause();
  const mapOf = async (k) => ({ mapped: await readBlock(folder, `${k}/mapped`), trust: await readBlock(folder, `${k}/trust`) });
  const maps = info.hasMap ? [await mapOf(0), await mapOf(1)] : null;
  maps?.forEach((map, k) => { exams[k].trust = map.trust; });
  document.body.classList.toggle('pair', exams.length > 1);
  $('linkBox').hidden = !maps;
  tellMissing(info, painter);
  fillNotes($('notes'), info, exams, info.bits);
  const viewer = new Viewer(info, exams, maps, painter);
  viewer.times.surface = performance.now() - started;
  viewer.repaint();
  await pause();
  await viewer.loadVolumes(volumes);
  viewer.follow(location.hash);
  addEventListener('hashchange', () => viewer.follow(location.hash));
  viewer.times.all = performance.now() - started;
  globalThis.viewer = viewer; // for tests and for use in the console
}

// folder: the folder of the data scripts, relative to the page; null if they are in the page.
export async function startColonViewer(folder) {
  document.body.innerHTML = PAGE;
  await openPage(() => open(folder));
}
