import { clamp } from '../../../Core/Pages/scripts/math.mjs';
import { byId, element, openPage } from '../../../Core/Pages/scripts/page.mjs';
import { counted, HeatExplorer, PAGE, shownLines } from '../../../Visualization/HeatViews/scripts/explorer.mjs';
import { History } from '../../../Visualization/HeatViews/scripts/history.mjs';
import { explorerKeys } from '../../../Visualization/HeatViews/scripts/keys.mjs';
import { shortNumber } from '../../../Visualization/HeatViews/scripts/line-list.mjs';
import { lowerEdge, NUMBER_OF_BINS } from '../../../Visualization/HeatViews/scripts/lines.mjs';
import { objectKeys, objectOfClick } from '../../../Visualization/HeatViews/scripts/objects.mjs';
import { Connection } from './connection.mjs';
import { CONTROLS, Controls, sessionKeys } from './controls.mjs';
import { axesOfSlice, placeBrick, reducedVolume, withRow } from './frames.mjs';
import { SessionRendering, SessionSliceView } from './session-slices.mjs';

const QUALITY = 85; // of JPEG pictures

const linesFor = (lines) => lines.map(({ lower, upper, color, opacity }) => ({ lower, upper, color, opacity }));

// The page of a live session: the heat explorer on values that the server sends, with controls.
class Session extends HeatExplorer {
  constructor(info, connection, first) {
    super(null, Object.assign(info, first.info), null, first.row.counts, first.row.axis);
    const display = reducedVolume(info.volume, info.stride), bins = new Uint16Array(display.size.reduce((a, b) => a * b));
    Object.assign(this, { connection, display, sent: first.sent, balls: [], rows: [first.row], state0: first.state, picture: null });
    Object.assign(this, { live: counted(bins), isPainting: false, isAsking: false, frames: 0, linesAt: [] });
    Object.assign(this, this.live);
  }

  makeSlice(root, plane) { return new SessionSliceView(root, this, plane); }

  // The rendering shows the reduced volume; its voxels are blocks.
  makeRendering(root) {
    const session = this, { display, info, times } = this, { stride } = display;
    return new SessionRendering(root, {
      volume: display, info, times,
      get place() { return session.place.map((i) => (i - (stride - 1) / 2) / stride); },
      get shown() { return session.shown; },
      moveTo: (index) => session.moveTo(index.map((i) => i * stride + (stride >> 1))),
      clicked: () => session.clicked(),
      climb: (by) => session.climb(by),
    }, this);
  }

  listen() {
    super.listen();
    this.controls = new Controls(this);
  }

  get keys() { return explorerKeys.with(objectKeys, sessionKeys); }

  // ---- frames ----
  take({ header, take }) {
    const { state } = header, isOther = state.shown !== this.state0.shown || state.changes !== this.state0.changes;
    if (isOther) this.rows = [];
    if (state.undo > this.state0.undo) this.linesAt[state.undo] = this.history.before.length;
    Object.assign(this, { state0: state, selection: state.selection });
    this.info.quantity = state.quantity;
    for (const slice of header.slices ?? []) this.takeSlice(slice, take);
    for (const first of header.bricks ?? []) placeBrick(this.bins, this.display.size, first, this.info.brickLength, take);
    if (header.histogram) this.takeHistogram(header.histogram, take);
    if (header.bricks?.length) this.takeBins();
    else if (header.slices) this.repaint();
    this.controls.show(state);
    this.tell(this.message);
    this.frames++;
  }

  takeSlice({ axis, index, hasGray, hasLabels }, take) {
    const [u, v] = axesOfSlice(axis), count = this.volume.size[u] * this.volume.size[v], bins = take(Uint16Array, count);
    const gray = hasGray ? take(Uint8Array, count) : this.sent[axis].gray, labels = hasLabels ? take(Uint16Array, count) : null;
    this.sent[axis] = { index, bins, gray, labels };
  }

  takeBins() {
    this.live = counted(this.bins);
    this.counts = this.live.counts;
    this.recolor();
    this.askPicture();
  }

  // Lines that the user has not changed follow the server's.
  takeHistogram({ step, lines }, take) {
    const row = { step, counts: take(Uint32Array, NUMBER_OF_BINS), axis: take(Uint32Array, NUMBER_OF_BINS) };
    const isNew = !this.rows.length;
    this.rows = withRow(this.rows, row);
    const histogram = new Uint32Array(this.rows.length * NUMBER_OF_BINS);
    this.rows.forEach(({ counts }, i) => histogram.set(counts, i * NUMBER_OF_BINS));
    Object.assign(this.info, { stored: [step], timeSteps: this.rows.map((r) => r.step), lines });
    this.setHistogram(histogram, row.axis);
    if (isNew && this.quantityOfLines !== this.info.quantity.name) this.forgetLines();
    this.quantityOfLines = this.info.quantity.name;
    if (this.history.before.length) return;
    this.history = new History({ ...this.state, lines: shownLines(lines) });
    this.follow();
  }

  // ---- undo ----
  get canUndo() { return super.canUndo || this.state0.undo > 0; }
  get canRedo() { return super.canRedo || this.state0.redo > 0; }

  forgetLines() {
    this.history.before.length = 0;
    this.linesAt = [];
  }

  // The last change of lines on this page or of values on the server. linesAt: number of changes of lines before each change of values.
  undo() {
    const { history: { before }, state0: { undo }, linesAt } = this;
    return undo && before.length <= (linesAt[undo] ?? 0) ? this.ask({ do: 'undo' }) : super.undo();
  }

  redo() { return this.state0.redo && !super.canRedo ? this.ask({ do: 'redo' }) : super.redo(); }

  // ---- commands ----
  async ask(command) {
    try {
      this.message = null;
      return await this.connection.ask(command);
    } catch (error) {
      this.message = error.message;
      this.tell(error.message);
      return null;
    }
  }

  toggleMoving() { this.ask({ do: this.state0.isMoving ? 'pause' : 'resume' }); }
  stepOnce() { this.ask({ do: 'step', steps: 1 }); }
  toggleShown() { this.ask(this.state0.shown === 'heat' ? { do: 'density' } : { do: 'heat', timeSteps: this.controls.heatSteps }); }
  nextStep(by) { this.ask({ do: 'heat', timeSteps: Math.max(1, Math.round(this.state0.heatSteps * 2 ** by)) }); }
  showStep() {} // the server has one time step

  moveTo(index) {
    super.moveTo(index);
    this.ask({ do: 'view', place: this.place });
  }

  async saveToFolder() {
    const lines = linesFor(this.lines.filter((line) => line.isOn));
    const selected = byId('alone').checked, objects = !selected && this.state0.shown === 'heat' && this.state0.objects !== null;
    byId('saved').textContent = 'saving';
    const answer = await this.ask({ do: 'save', name: byId('name').value, labels: byId('labels').checked, lines, objects, selected });
    byId('saved').textContent = answer ? `saved ${answer.files.join(', ')}` : this.message;
    if (answer) this.isSaved = true;
  }

  // ---- objects ----
  get isPicking() { return byId('picking').checked && this.state0.objects !== null; }

  async findObjects(choose) {
    const answer = await this.ask({ do: 'objects', choose });
    if (answer) this.takeObjects(answer);
  }

  // what: object or point, and whether it is added to the selected objects or replaces the last one.
  async select({ isAdded = false, ...what }) {
    const answer = await this.ask({ do: 'select', ...what, add: isAdded });
    if (answer) this.takeObjects(answer);
    return answer;
  }

  climb(by) {
    const next = this.chain[this.chain.indexOf(this.selected) + by];
    if (next && this.selected) this.select({ object: next, replace: true });
  }

  notThis() { return this.ask({ do: 'exclude', region: 'selected' }); }

  // The object under the pointer, whose index is in one of the slices.
  voxelAt(index) { return index; }

  objectAt(index) {
    const slice = this.sent.findIndex((one, axis) => one?.labels && one.index === index[axis]);
    if (slice < 0) return 0;
    const [u, v] = axesOfSlice(slice), label = this.sent[slice].labels[index[v] * this.volume.size[u] + index[u]];
    return label <= this.objects.length ? objectOfClick(this.objects, label) : 0;
  }

  takeObjects(answer) {
    this.objects = answer.objects;
    this.noteSelection(answer.selection);
    this.controls.list(answer);
  }

  selectHere(isAdded = false) {
    this.chain = [];
    return this.select({ point: this.toPoint(this.place), isAdded });
  }

  // ---- start region ----
  toPoint(index) {
    const { origin, axes, spacing } = this.volume;
    return origin.map((x, i) => x + axes.reduce((sum, axis, k) => sum + axis[i] * spacing[k] * index[k], 0));
  }

  get radius() { return Math.max(0.1, Number(byId('radius').value)); }

  regionChosen() {
    this.isPainting = byId('region').value === 'brush';
    this.balls = [];
    this.repaint();
  }

  paint(index) {
    this.balls.push({ index, radius: this.radius });
    this.repaint();
  }

  get ballsInSpace() { return this.balls.map((b) => [...this.toPoint(b.index), b.radius]); }
  applyPaint() { if (byId('at-once').checked) this.startThere(); }

  startThere() { return this.askRegion('start'); }
  excludeThere() { return this.askRegion('exclude'); }

  askRegion(name) {
    const kind = byId('region').value;
    if (kind !== 'brush') this.balls = kind === 'sphere' ? [{ index: this.place, radius: this.radius }] : [];
    this.repaint();
    const region = this.region(kind);
    return region && this.ask({ do: name, ...region });
  }

  region(kind) {
    const label = Number(byId('label').value), point = this.toPoint(this.place), plane = this.info.planes.find((one) => one.name === kind);
    if (kind === 'everywhere' || kind === 'selected') return { region: kind };
    if (kind === 'file') return { region: 'file', name: byId('mask').value, ...(label ? { label } : {}) };
    if (plane) return { region: 'plane', point, axis: plane.through };
    if (kind === 'object') return this.regionOfLine(point);
    if (this.balls.length) return { region: 'balls', balls: this.ballsInSpace };
    this.tell('paint on a slice first');
    return null;
  }

  // The voxels of the line under the crosshair that are connected to it.
  regionOfLine(point) {
    const line = this.lines[this.numbers[this.binHere] - 1];
    if (!line) { this.tell('no line contains the voxel under the crosshair: pick one first'); return null; }
    return { region: 'object', point, lower: line.lower, upper: line.upper };
  }

  // ---- pictures of the server ----
  get isDrawnByServer() { return Boolean(byId('served')?.checked); }

  async askPicture() {
    const lines = linesFor(this.lines.filter((line) => line.isOn)), { rendering } = this;
    if (!this.isDrawnByServer || !lines.length) { rendering?.changed(); return; }
    this.isPictureOld = true;
    if (this.isAsking) return;
    this.isAsking = true;
    while (this.isPictureOld) {
      this.isPictureOld = false;
      const [width, height] = [rendering.w, rendering.h].map((n) => clamp(Math.round(n), 16, 2048));
      const view = { azimuth: rendering.azimuth, elevation: rendering.elevation, zoom: rendering.enlarged };
      const { low, high } = rendering.cuts.box, { stride } = this.display;
      const box = { first: low.map((i) => i * stride), last: high.map((i) => (i + 1) * stride - 1) };
      if (!await this.ask({ do: 'picture', ...view, ...box, width, height, quality: QUALITY, lines })) break;
    }
    this.isAsking = false;
  }

  async takePicture({ header, take }) {
    const jpeg = new Blob([take(Uint8Array, header.bytes)], { type: 'image/jpeg' });
    this.picture = await createImageBitmap(jpeg);
    this.rendering.changed();
  }

  // ---- values under the crosshair ----
  get countedVolume() { return this.display; }

  get voxel() {
    const { size, stride } = this.display, [x, y, z] = this.place.map((i) => Math.floor(i / stride));
    return (z * size[1] + y) * size[0] + x;
  }

  // The bin of the crosshair's voxel, from the slice through it.
  get binHere() {
    const [x, y] = this.place;
    return this.sent[2] ? this.sent[2].bins[y * this.volume.size[0] + x] : 0;
  }

  heatHere() { return lowerEdge(this.binHere); }

  describe() {
    const { info: { quantity, window: [low, high] }, place: [x, y], binHere, numbers } = this, number = numbers[binHere];
    const gray = this.sent[2] ? this.sent[2].gray[y * this.volume.size[0] + x] : 0, intensity = low + (gray / 255) * (high - low);
    const mm = this.toPoint(this.place).map((c) => c.toFixed(1)).join(', '), line = number ? `, line ${number}` : '';
    return `${mm} mm (LPS), intensity about ${shortNumber(intensity)}, ${quantity.name} ${shortNumber(lowerEdge(binHere))}${line}`;
  }
}

// The data of the first frame with a picture, from which the page is made.
function firstOf({ header, take }, { volume }) {
  const sent = [];
  for (const { axis, index } of header.slices) {
    const [u, v] = axesOfSlice(axis), count = volume.size[u] * volume.size[v];
    sent[axis] = { index, bins: take(Uint16Array, count), gray: take(Uint8Array, count) };
  }
  return { sent, state: header.state };
}

async function openSession(info) {
  let session = null, connection = null;
  const middle = info.volume.size.map((n) => n >> 1), { classList } = document.body;
  const onOpen = () => {
    classList.remove('lost');
    const lostAgain = () => {}; // onLost() follows
    connection.ask({ do: 'view', place: session?.place ?? middle }).then(() => connection.ready(), lostAgain);
  };
  const onLost = (wait) => {
    byId('progress').textContent = `no connection to the session, which may have ended; next attempt in ${wait} s`;
    classList.add('lost');
  };
  const onEnd = () => {
    byId('progress').textContent = 'the session has ended';
    classList.add('ended');
  };
  const onFrame = (frame) => {
    if (frame.header.kind === 'picture') { session?.takePicture(frame); return; }
    if (!session && frame.header.histogram) session = globalThis.session = begin(info, connection, frame);
    else if (session) session.take(frame);
    else byId('progress').textContent = frame.header.state.error || 'computing';
    requestAnimationFrame(() => connection.ready());
  };
  connection = new Connection({ onOpen, onFrame, onLost, onEnd });
}

// Makes the page from the first frame.
function begin(info, connection, frame) {
  const { header } = frame, first = firstOf(frame, info), { size } = reducedVolume(info.volume, info.stride);
  const bins = new Uint16Array(size.reduce((a, b) => a * b));
  for (const brick of header.bricks) placeBrick(bins, size, brick, info.brickLength, frame.take);
  const { step, lines } = header.histogram;
  first.row = { step, counts: frame.take(Uint32Array, NUMBER_OF_BINS), axis: frame.take(Uint32Array, NUMBER_OF_BINS) };
  first.info = { quantity: header.state.quantity, stored: [step], timeSteps: [step], lines, ranges: [] };
  const session = new Session(info, connection, first);
  session.bins.set(bins);
  session.quantityOfLines = info.quantity.name;
  byId('title').textContent = info.title;
  session.makeViews();
  session.takeBins();
  session.follow();
  session.controls.show(header.state);
  return session;
}

// info: as LiveSession::GetInfo() returns it.
export async function startSession(info) {
  document.body.innerHTML = PAGE;
  const controls = element('section', { id: 'controls' });
  controls.insertAdjacentHTML('beforeend', CONTROLS);
  document.querySelector('aside').prepend(controls);
  byId('steps').parentElement.hidden = true;
  await openPage(() => openSession(info));
}
