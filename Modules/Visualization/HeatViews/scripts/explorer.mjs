import { readBlock } from '../../../Core/Pages/scripts/bytes.mjs';
import { clamp } from '../../../Core/Pages/scripts/math.mjs';
import { toggle } from '../../../Core/Pages/scripts/keys.mjs';
import { byId, letGo, notice, openPage, saveFile } from '../../../Core/Pages/scripts/page.mjs';
import { scaleViews, View } from '../../../Core/Pages/scripts/view.mjs';
import { equalization, HeatAxis, rangeOfCounts } from './axis.mjs';
import { History } from './history.mjs';
import { HistogramView } from './histogram.mjs';
import { explorerKeys } from './keys.mjs';
import { fillLineList, shortNumber } from './line-list.mjs';
import { lineAround, lineNear } from './line-search.mjs';
import {
  binOf, linesOfBins, lowerEdge, MOST_LINES, NUMBER_OF_BINS, premultiplied, savedFromText, savedText, volumeProperty, withLine,
} from './lines.mjs';
import { PageWithObjects } from './object-page.mjs';
import { chainOf, objectKeys, objectsToSave, stylesOf, stylesOfSaved } from './objects.mjs';
import { RenderingView } from './rendering.mjs';
import { HeatSliceView, paintsOf } from './slices.mjs';

const CURSOR_STEP = 4; // pixels
const KEPT_STEPS = 2;  // volumes of time steps kept in memory

export const PAGE = `
<header>
  <b id="title"></b><label>time step <select id="steps"></select></label><span id="ranges"></span>
  <button id="undo">Undo</button><button id="redo">Redo</button>
  <button id="vp">Save .vp for 3D Slicer</button><button id="json">Save JSON</button>
  <button id="open">Open JSON</button><input type="file" id="file" accept=".json" hidden>
  <button id="help">Help ?</button><span id="unsaved"></span><span id="progress"></span>
</header>
<main id="views"></main>
<aside><div id="notices" role="alert"></div><ol id="lines"></ol></aside>
<footer><span id="status" role="status"></span><b>For research use; not a diagnosis. This page holds the volume.</b></footer>
<dialog id="keys"></dialog>`;

// The lines picked on a heat histogram, and all views. `history` stores the undoable state: time step, lines, opened
// ranges, colors of objects; it does not include crosshair, chosen line, selected object and camera.
export class HeatExplorer extends PageWithObjects {
  constructor(folder, info, gray, histogram, axisCounts) {
    super(info.objects ?? []);
    const { volume } = info, styles = stylesOf(this.objects, info.lineColors);
    const state = { step: info.stored.at(-1), lines: shownLines(info.lines), ranges: info.ranges, styles };
    Object.assign(this, { folder, info, volume, gray, isEqualized: info.isEqualized, live: null });
    Object.assign(this, { times: {}, steps: new Map(), chosen: -1, busy: 0, isSaved: true, history: new History(state) });
    Object.assign(this, { shown: { values: [], numbers: [], colors: [] }, isOutdated: false });
    this.place = info.place ?? volume.size.map((n) => n >> 1);
    this.setHistogram(histogram, axisCounts);
  }

  setHistogram(histogram, axisCounts) {
    Object.assign(this, { histogram, shares: equalization(axisCounts), whole: rangeOfCounts(axisCounts), axisKey: null });
    this.setAxis();
  }

  get state() { return this.history.state; }
  get lines() { return this.state.lines; }
  get step() { return this.live ? this.info.stored[0] : this.state.step; }

  makeViews() {
    const root = byId('views');
    this.histogramView = new HistogramView(root, this);
    this.rendering = this.makeRendering(root);
    this.slices = this.info.planes.map((plane) => this.makeSlice(root, plane));
    if (!this.rendering.isPossible) notice('This browser has no WebGL 2: histogram, slices and files work, the rendering does not.');
    if (this.volume.stride > 1) notice(`The volume is large: only one in ${this.volume.stride} voxels along each axis is shown.`);
    this.listen();
  }

  get keys() { return this.labels ? explorerKeys.with(objectKeys) : explorerKeys; }
  makeRendering(root) { return new RenderingView(root, this); }
  makeSlice(root, plane) { return new HeatSliceView(root, this, plane); }

  listen() {
    const on = (id, act) => { byId(id).onclick = (e) => { act(); letGo(e); }; };
    on('undo', () => this.undo());
    on('redo', () => this.redo());
    on('vp', () => this.saveVp());
    on('json', () => this.saveJson());
    on('open', () => this.openFile());
    on('help', () => this.toggleHelp());
    byId('file').onchange = () => this.read(byId('file').files[0]);
    byId('steps').onchange = () => { this.showStep(Number(byId('steps').value)); byId('steps').blur(); };
    if (this.labels) this.listenToObjects();
    this.keys.listen(this);
    addEventListener('resize', scaleViews);
    addEventListener('beforeunload', (e) => { if (!this.isSaved) e.preventDefault(); });
    scaleViews();
    this.keys.fillHelp(byId('keys'));
  }

  // ---- states ----
  change(part, kind = null) {
    this.history.change({ ...this.state, ...part }, kind);
    this.isSaved = false;
    return this.follow(kind);
  }

  get canUndo() { return this.history.before.length > 0; }
  get canRedo() { return this.history.after.length > 0; }
  undo() { this.history.undo(); return this.follow(); }
  redo() { this.history.redo(); return this.follow(); }

  // Shows the current state of the history. kind: the slider that is being moved, if any; it is not rebuilt.
  async follow(kind = null) {
    const { step } = this;
    this.busy++;
    try {
      const shown = await this.load(step);
      if (step !== this.step) return; // superseded by another change
      Object.assign(this, shown);
      this.chosen = Math.min(this.chosen, this.lines.length - 1);
      this.setAxis();
      this.recolor();
      if (kind === null) this.fillLists();
      this.tell();
    } catch (error) { // unreadable data
      notice(error.message);
      this.history.drop();
      this.tell();
    } finally {
      this.busy--;
    }
  }

  // Loads a newer state of an active run.
  take({ state, histogram, axisCounts, live }) {
    Object.assign(this.info, state);
    this.live = live;
    this.setHistogram(histogram, axisCounts);
    if (!this.history.before.length) this.history = new History({ ...this.state, lines: shownLines(state.lines) });
    return this.follow();
  }

  // Bins of a time step, with the number of voxels in each.
  async load(step) {
    const { steps } = this;
    if (this.live) return this.live;
    if (!steps.has(step)) {
      const started = performance.now();
      steps.set(step, counted(await readBlock(this.folder, `bins-${step}`)));
      if (steps.size > KEPT_STEPS) steps.delete(steps.keys().next().value);
      this.times.step = performance.now() - started;
    }
    return steps.get(step);
  }

  // Shows the current colors: first in histogram and slices, then, because it takes longer, in the rendering.
  recolor() {
    this.numbers = linesOfBins(this.lines);
    this.paints = paintsOf([...this.lines, ...this.state.styles]);
    if (this.labels) this.setClasses();
    this.repaint();
    if (this.isOutdated) return;
    this.isOutdated = true;
    setTimeout(() => { this.isOutdated = false; this.recolorRendering(); });
  }

  // What the rendering shows. values: the bin of each voxel, or its class if there are objects; numbers: the class of each value, which
  // is a line or an object; colors: the premultiplied color of each value.
  recolorRendering() {
    const started = performance.now(), seen = [0, ...[...this.lines, ...this.state.styles].map(premultiplied)];
    const { values, numbers } = this.labels ? this.classes() : { values: this.bins, numbers: this.numbers };
    const colors = Uint32Array.from(numbers, (n) => seen[n]);
    this.shown = { values, numbers, colors };
    this.rendering.load(values, numbers, colors);
    this.times.recolor = performance.now() - started;
  }

  // The class of a voxel.
  classAt(voxel) { return this.labels ? this.ofLabel[this.labels[voxel]] || this.ofBin[this.bins[voxel]] : this.numbers[this.bins[voxel]]; }

  fillLists() {
    fillLineList(byId('lines'), this);
    if (this.labels) this.fillObjects();
  }

  setAxis() {
    const key = JSON.stringify([this.state.ranges, this.isEqualized]);
    if (key === this.axisKey) return;
    this.axisKey = key;
    const full = this.isEqualized ? this.whole : [0, this.whole[1]];
    this.axis = new HeatAxis(this.shares, this.isEqualized, this.state.ranges.at(-1) ?? full);
  }

  repaint() { [this.histogramView, ...this.slices].forEach((view) => view.changed()); }
  repaintSlices() { this.slices.forEach((slice) => slice.changed()); }

  // ---- picking ----
  pickAt(position, reach) {
    const heat = this.axis.heatAt(position), { lower, upper } = this.axis;
    const here = this.lines.findIndex((l) => l.lower <= heat && heat < l.upper && (l.lower > lower || l.upper < upper));
    if (here >= 0) { this.choose(here); return; }
    const found = lineNear(this.counts, this.axis, position, reach);
    if (found) this.pick(...found); else this.tell(`no voxel has ${this.info.quantity.name} ${shortNumber(heat)} in this time step`);
  }

  // Picks the range between two axis positions, in whole bins.
  rangeOf(a, b) { return [lowerEdge(binOf(this.axis.heatAt(a))), lowerEdge(binOf(this.axis.heatAt(b)) + 1)]; }
  pickPlaces(a, b) { this.pick(...this.rangeOf(a, b)); }
  openPlaces(a, b) { this.openRange(...this.rangeOf(a, b)); }

  pick(lower, upper, wanted = null) {
    const { lineColors } = this.info, isFree = (c) => this.lines.every((l) => l.color !== c);
    const color = wanted ?? lineColors.find(isFree) ?? lineColors[0];
    this.setLines(withLine(this.lines, { lower, upper, color, opacity: 0.6, isOn: true }), lower);
  }

  setLines(lines, lower, kind = null) {
    if (lines.length > MOST_LINES) { this.tell(`the maximum is ${MOST_LINES} lines: remove one first`); return; }
    this.chosen = lines.findIndex((l) => l.lower === lower);
    this.change({ lines }, kind);
  }

  pickHere() {
    const bin = this.bins[this.voxel];
    if (bin) this.pick(...lineAround(this.counts, bin)); else this.tell('the voxel under the crosshair is background');
  }

  openAt(position) {
    const heat = this.axis.heatAt(position), line = this.lines.find((l) => l.lower <= heat && heat < l.upper);
    if (line) this.openRange(line.lower, line.upper);
  }

  openRange(lower, upper) {
    const { ranges } = this.state, [from, to] = [Math.max(lower, this.axis.lower), Math.min(upper, this.axis.upper)];
    if (from >= to || (from === this.axis.lower && to === this.axis.upper)) return;
    this.change({ ranges: [...ranges, [from, to]] });
  }

  closeRange() { if (this.state.ranges.length) this.change({ ranges: this.state.ranges.slice(0, -1) }); }
  openChosen() { const line = this.lines[this.chosen]; if (line) this.openRange(line.lower, line.upper); }
  toggleScale() { this.isEqualized = !this.isEqualized; this.setAxis(); this.repaint(); this.tell(); }
  showStep(step) { if (step !== this.step) this.change({ step }); }

  nextStep(by) {
    const { stored } = this.info;
    this.showStep(stored[clamp(stored.indexOf(this.step) + by, 0, stored.length - 1)]);
  }

  // ---- the cursor of the keyboard ----
  moveCursor(by) {
    const { histogramView: view } = this, width = CURSOR_STEP / view.plot.width;
    view.cursor = clamp(view.cursor + by * width, 0, 1);
    this.isKeyboard = true;
    if (this.mark !== undefined) view.selection = [this.mark, view.cursor];
    view.changed();
    this.tell(`cursor at ${shortNumber(this.axis.heatAt(view.cursor))}`);
  }

  toggleMark() {
    const { histogramView: view } = this;
    this.mark = this.mark === undefined ? view.cursor : undefined;
    view.selection = this.mark === undefined ? null : [this.mark, this.mark];
    view.changed();
  }

  pickAtCursor() {
    const { histogramView: view, mark } = this;
    if (mark === undefined) { this.pickAt(view.cursor, 2 * CURSOR_STEP / view.plot.width); return; }
    this.toggleMark();
    this.pickPlaces(...[mark, view.cursor].sort((a, b) => a - b));
  }

  // ---- lines ----
  choose(i) { this.chosen = i; this.fillLists(); this.histogramView.changed(); this.tell(); }
  stepLine(by) { const n = this.lines.length; if (n) this.choose((Math.max(this.chosen, by < 0 ? 0 : -1) + by + n) % n); }
  removeLine(i) { this.change({ lines: this.lines.filter((_, k) => k !== i) }); }
  removeChosen() { if (this.lines[this.chosen]) this.removeLine(this.chosen); }

  alterLine(i, part, kind = null) {
    this.chosen = i;
    this.change({ lines: this.lines.map((line, k) => (k === i ? { ...line, ...part } : line)) }, kind && `${kind} ${i}`);
  }

  alterChosen(change) { const line = this.lines[this.chosen]; if (line) this.alterLine(this.chosen, change(line)); }
  addOpacity(by) { this.alterChosen((line) => ({ opacity: Math.round(100 * clamp(line.opacity + by, 0, 1)) / 100 })); }
  toggleLine() { this.alterChosen((line) => ({ isOn: !line.isOn })); }

  nextColor() {
    const { lineColors } = this.info;
    this.alterChosen((line) => ({ color: lineColors[(lineColors.indexOf(line.color) + 1) % lineColors.length] }));
  }

  // Moves an end by bins, keeping at least one bin; overlapped bins are removed from the neighbors.
  moveEnd([end, by]) {
    const line = this.lines[this.chosen];
    if (!line) return;
    const bin = line[end] === 1 ? NUMBER_OF_BINS : binOf(line[end]); // as the end of a line, 1 means the end of the last bin
    const moved = { ...line, [end]: lowerEdge(clamp(bin + by, 1, NUMBER_OF_BINS)) };
    if (moved.lower >= moved.upper) return;
    this.setLines(withLine(this.lines.filter((l) => l !== line), moved), moved.lower);
  }

  get countedVolume() { return this.volume; } // grid of the bins

  sizeOf(line) {
    let voxels = 0;
    for (let bin = binOf(line.lower); bin < NUMBER_OF_BINS && lowerEdge(bin) < line.upper; bin++) voxels += this.counts[bin];
    const { spacing, stride } = this.countedVolume, ml = (voxels * spacing[0] * spacing[1] * spacing[2]) / 1000;
    return `${stride > 1 ? 'about ' : ''}${(voxels * stride ** 3).toLocaleString('en')} voxels, ${shortNumber(ml)} ml`;
  }

  // ---- crosshair ----
  get voxel() { return this.voxelAt(this.place); }
  voxelAt([x, y, z]) { const [nx, ny] = this.volume.size; return (z * ny + y) * nx + x; }
  heatHere() { return this.bins ? lowerEdge(this.bins[this.voxel]) : -1; }

  moveTo(index) {
    this.place = index.map((i, k) => clamp(i, 0, this.volume.size[k] - 1));
    this.repaint();
    this.rendering.changed();
    this.tell();
  }

  stepSlice([plane, by]) {
    const place = [...this.place];
    place[this.info.planes[plane].through] += by;
    this.moveTo(place);
  }

  turn(by) { this.rendering.turn(by); }
  cutRendering(plane) { this.rendering.cuts.next(plane); }

  enlarge(by) {
    this.slices.forEach((slice) => slice.scaleBy(by));
    this.rendering.enlarge(by);
  }

  // ---- files ----
  get shownLines() { return this.lines.filter((line) => line.isOn); }

  save(name, text, type) {
    saveFile(name, text, type);
    this.isSaved = true;
    this.tell();
  }

  // 3D Slicer knows heat only.
  saveVp() {
    const lines = this.shownLines, unit = Math.max(1, this.info.quantity.greatestVisits);
    const hasObjects = this.state.styles.some((style) => style.isOn), hint = hasObjects ? '; a .vp has heat ranges, not objects' : '';
    if (!lines.length) { this.tell(`nothing to save: pick a line first${hint}`); return; }
    this.save('transfer-function.vp', volumeProperty(lines, unit), 'text/plain');
    if (hasObjects) this.tell('saved without the objects: a .vp has heat ranges only');
  }

  saveJson() {
    const lines = this.shownLines, objects = objectsToSave(this.objects, this.state.styles);
    if (!lines.length && !objects.length) { this.tell('nothing to save: pick a line first'); return; }
    this.save('transfer-function.json', savedText(lines, this.info.quantity.name, this.step, objects), 'application/json');
  }

  openFile() { byId('file').click(); }

  async read(file) {
    try {
      const { lines, objects } = savedFromText(await file.text(), this.info.quantity.name);
      this.change({ lines, styles: stylesOfSaved(objects, this.objects, this.state.styles) });
    } catch (error) {
      notice(error.message);
    }
    byId('file').value = '';
  }

  // ---- the page ----
  toggleHelp() { toggle(byId('keys')); }
  toggleFull() { document.body.classList.toggle('full'); }

  leave() {
    if (byId('keys').open) byId('keys').close();
    document.activeElement?.blur();
    document.body.classList.remove('full');
    if (this.mark !== undefined) this.toggleMark();
  }

  // Description of the voxel under the crosshair.
  describe() {
    const { info: { quantity, window: [low, high] }, gray, voxel, place, bins, numbers, labels, objects } = this;
    const line = numbers[bins[voxel]], chain = chainOf(objects, labels?.[voxel] ?? 0).join(' in ');
    const classes = `${line ? `, line ${line}` : ''}${chain ? `, object ${chain}` : ''}`;
    const value = low + (gray[voxel] / 255) * (high - low), mm = this.rendering.toSpace(place).map((x) => x.toFixed(1)).join(', ');
    const edges = [bins[voxel], bins[voxel] + 1].map((bin) => shortNumber(lowerEdge(bin))).join(' to ');
    return `${mm} mm (LPS), intensity about ${shortNumber(value)}, ${quantity.name} ${edges}${classes}`;
  }

  // text: message on the last action, if any.
  tell(text = null) {
    const ranges = this.state.ranges.map((r) => r.map(shortNumber).join('–'));
    byId('status').textContent = text ?? this.describe();
    byId('unsaved').textContent = this.isSaved ? '' : 'not saved yet';
    byId('steps').replaceChildren(...this.info.stored.map((step) => new Option(step, step, false, step === this.step)));
    byId('undo').disabled = !this.canUndo;
    byId('redo').disabled = !this.canRedo;
    byId('ranges').textContent = `axis: ${['all', ...ranges].join(' › ')}${this.isEqualized ? '' : ' (not equalized)'}`;
  }

  // For tests: resolves when everything requested is painted, at full quality unless a coarse picture suffices.
  async idle(isCoarseEnough = false) {
    do await new Promise((done) => { requestAnimationFrame(() => setTimeout(done)); });
    while (View.pending || this.busy || this.isOutdated || (this.rendering.isCoarse && !isCoarseEnough));
  }
}

export const shownLines = (lines) => lines.map((line) => ({ ...line, isOn: true }));

// Bins of a volume, with the number of voxels in each.
export function counted(bins) {
  const counts = new Uint32Array(NUMBER_OF_BINS);
  for (let i = 0; i < bins.length; i++) counts[bins[i]]++;
  return { bins, counts };
}

// The state of an active run: one file that is replaced repeatedly. Null if it is unchanged.
async function readState(folder, version = '', known = {}) {
  const state = await readBlock(folder, 'live', version);
  if (state.stored[0] === known.stored?.[0] && state.isFinished === known.isFinished) return null;
  const histogram = await readBlock(folder, 'histogram'), axisCounts = await readBlock(folder, 'axis');
  return { state, histogram, axisCounts, live: counted(await readBlock(folder, 'bins-live')) };
}

// Follows a run until it finishes. Lines picked by the user are kept; automatic lines are recomputed.
function followRun(explorer) {
  const { info, folder } = explorer, wait = 1000 * Math.max(0.2, info.secondsBetweenStates);
  let news = performance.now(), number = 0;
  const tell = () => {
    const silence = (performance.now() - news) / 1000;
    const isStopped = !info.isFinished && silence > 30 + 10 * info.secondsBetweenStates;
    byId('progress').textContent = info.progress + (info.isFinished ? ', finished' : isStopped ? ', no news: stopped?' : '');
  };
  const look = async () => {
    try {
      const found = await readState(folder, `?${++number}`, info);
      if (found) news = performance.now();
      if (found) await explorer.take(found);
    } catch (error) {
      notice(error.message);
      return;
    }
    tell();
    if (!info.isFinished) setTimeout(look, wait);
  };
  tell();
  if (!info.isFinished) setTimeout(look, wait);
}

async function openExplorer(folder) {
  const started = performance.now(), info = await readBlock(folder, 'info'), gray = await readBlock(folder, 'gray');
  byId('title').textContent = document.title = `${info.title} – heat explorer`;
  const first = info.secondsBetweenStates ? await readState(folder) : { histogram: await readBlock(folder, 'histogram') };
  first.axisCounts ??= info.hasAxis ? await readBlock(folder, 'axis') : first.histogram;
  const explorer = new HeatExplorer(folder, Object.assign(info, first.state), gray, first.histogram, first.axisCounts);
  explorer.live = first.live ?? null;
  if (info.objects) explorer.labels = await readBlock(folder, 'labels');
  Object.assign(explorer, await explorer.load(explorer.step)); // if the first step is unreadable, only the error is shown
  explorer.makeViews();
  await explorer.follow();
  explorer.times.open = performance.now() - started;
  if (explorer.live) followRun(explorer);
  globalThis.explorer = explorer; // for tests and for use in the console
}

// folder: the folder of the data scripts, relative to the page.
export async function startHeatExplorer(folder) {
  document.body.innerHTML = PAGE;
  await openPage(() => openExplorer(folder));
}
