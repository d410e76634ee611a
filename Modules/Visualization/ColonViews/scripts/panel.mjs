import { distance, sub } from '../../../Core/Pages/scripts/math.mjs';
import { centerlineColor, flexureColor, paintWall, taeniaColors } from './layers.mjs';
import { EndoView, OutsideView } from './space.mjs';
import { FlatView } from './flat.mjs';
import { SliceView } from './slice.mjs';
import { tube } from './painter.mjs';

const ON_WALL = 2;     // mm; points farther from the wall have no distance along it
const EYE_REACH = 120; // mm; wall farther away is not a target

const REPAINT = 10;    // mm; the translucent area follows the crosshair in steps
const HURRY = 6;       // times the speed of a flight where the colon is collapsed
const HEAD_SPAN = 80, HEAD_SCALE = 1.5; // size of slices in mm, and least pixels per mm of the map, at a candidate

// All views of one position, around one crosshair.
export class Panel {
  // notify: callback with this panel after its crosshair has moved; zoomed: with a slice after its scale has changed; scrolled: with
  // this panel and the shift (mm) of its crosshair by a slice; shifted: with this panel after its unfolded view was dragged or zoomed;
  // marksOf: candidates and findings to show; calipersOf: their measurements.
  constructor(root, exam, layers, { notify, zoomed, scrolled, shifted, marksOf, calipersOf }) {
    Object.assign(this, { root, exam, layers, notify, zoomed, scrolled, shifted, marksOf, calipersOf });
    Object.assign(this, { window: [1500, -200], paintings: 0, measure: null });
    Object.assign(this, { translucent: null, tissuePaintings: 0 }); // translucent: the place around which it is shown
    this.volumeText = 'Loading the volume …';
    this.place = exam.fromXyz(exam.center[Math.min(60, exam.center.length - 1)].xyz, false);
    this.makeLines();
    this.flat = new FlatView(root, this);
    const row = document.createElement('div');
    row.className = 'row';
    root.append(row);
    this.outside = new OutsideView(row, this);
    this.inside = new EndoView(row, this);
    this.slices = [2, 1, 0].map((plane) => new SliceView(row, this, plane));
    this.views = [this.flat, this.outside, this.inside, ...this.slices];
    this.active = this.flat;
    for (const view of this.views) {
      view.clicked = () => this.clicked();
      view.canvas.addEventListener('pointerdown', () => { this.active = view; });
    }
    this.inside.lookAt(this.place);
  }

  makeLines() {
    const { painter, info, center } = this.exam, lines = (all, radius, color) =>
      (painter.gl ? all.map((line, i) => tube(painter, line, radius, color(i))) : []);
    this.taeniae = lines(info.taeniae.map((t) => t.xyz), 0.7, (i) => taeniaColors[i % 3]);
    this.flexures = lines(info.flexures.map((f) => [...f.xyz, f.xyz[0]]), 1.2, () => flexureColor);
    this.centerline = lines([center.map((c) => c.xyz)], 0.7, () => centerlineColor);
  }

  marks() { return this.marksOf(this); }

  // Repaints the layers.
  repaint() {
    this.paintings++;
    paintWall(this.exam, this.layers, this.translucent);
    this.flat.repaintLayers();
    this.changed();
  }

  // Shows the tissue behind the wall around the crosshair, or no longer.
  toggleTranslucency() {
    this.translucent = this.translucent ? null : this.place;
    this.repaint();
  }

  followTranslucency() {
    if (!this.translucent || distance(this.translucent.xyz, this.place.xyz) < REPAINT) return;
    this.translucent = this.place;
    this.tissuePaintings++;
    paintWall(this.exam, this.layers, this.place);
  }

  // Shows the original or the cleansed CT.
  showCleansed(isCleansed) {
    this.exam.volume?.show(isCleansed);
    if (this.translucent) this.repaint();
    this.changed();
  }

  changed() { this.views.forEach((v) => v.changed()); }

  setWindow(window) {
    this.window = window;
    this.slices.forEach((v) => v.changed());
  }

  // Sets the crosshair. from: the originating view, which keeps its view direction.
  set(place, from = null) {
    this.follow(place, from);
    this.notify(this);
  }

  // Measures from or to the crosshair.
  clicked() {
    if (!this.measure) return;
    this.measurePlace(this.place);
    this.changed();
    this.notify(this);
  }

  // Sets the crosshair without the callback, for moves of the other position.
  follow(place, from = null) {
    this.place = place;
    if (from !== this.flat) this.flat.reveal(place);
    if (from !== this.inside) this.inside.lookAt(place);
    this.followTranslucency();
    this.changed();
  }

  // Sets the crosshair to a place on another slice.
  scroll(place, slice) {
    const shift = sub(place.xyz, this.place.xyz);
    this.follow(place, slice);
    this.scrolled(this, shift);
  }

  // Sets the crosshair to a place with all views centered on it.
  centerOn(place) {
    this.set(place);
    this.showAround();
  }

  // Centers all views on the crosshair.
  showAround() {
    this.slices.forEach((s) => s.centerOn(this.place, HEAD_SPAN));
    this.flat.centerOn(this.place, HEAD_SCALE);
  }

  // Flies by this distance (mm) along the centerline in the direction of flight.
  fly(mm) {
    const { center } = this.exam, i = this.inside;
    i.go(this.exam.centerAt(center[i.index].arc + mm * i.way));
  }

  // One step of the autopilot, longer where there is little to see.
  cruise(mm) { this.fly(this.exam.isCollapsed(this.inside.point) ? HURRY * mm : mm); }

  get isAtEnd() {
    const { index, way } = this.inside;
    return way > 0 ? index === this.exam.center.length - 1 : index === 0;
  }

  // Sets the crosshair to the wall ahead of the eye.
  flown() {
    const camera = this.inside.camera(), place = this.exam.fromRay(camera.eye, sub(camera.at, camera.eye));
    const isNear = place && distance(place.xyz, camera.eye) < EYE_REACH;
    this.place = isNear ? place : this.exam.fromXyz(camera.eye, false);
    this.followTranslucency();
    this.flat.reveal(this.place);
    this.turned();
  }

  // Takes into account what the eye sees.
  turned() {
    if (this.exam.seen) this.exam.seen.look(this.inside.camera(), this.inside.w / (this.inside.h || 1));
    this.changed();
    this.notify(this);
  }

  // Adds a point to the measurement and computes the paths between both points; a third point starts over.
  startMeasure(done = null) { this.measure = { places: [], done }; this.changed(); }
  endMeasure() { this.measure = null; this.changed(); }

  measurePlace(place) {
    const m = this.measure;
    if (m.places.length === 2) Object.assign(m, { places: [], path: null, text: '' });
    m.places.push(place);
    if (m.places.length < 2) return;
    const [a, b] = m.places, straight = distance(a.xyz, b.xyz), isOnWall = Math.max(a.off, b.off) < ON_WALL;
    m.path = isOnWall ? this.exam.paths().between(a, b) : null;
    m.lengths = { straight, wall: m.path ? m.path.length : null, line: Math.abs(a.arc - b.arc) };
    const wall = m.path ? `${m.path.length.toFixed(1)} mm` : isOnWall ? 'more than 1 m' : 'unknown (a point is off the wall)';
    m.text = `straight ${straight.toFixed(1)} mm · along the wall ${wall} · along the centerline ${m.lengths.line.toFixed(1)} mm`;
    if (m.done) m.done(straight, m.places);
  }

  // at: maps a point in space to its pixel, or null.
  drawMeasure(view, g, at) {
    for (const { ends, text } of this.calipersOf(this)) this.drawCaliper(view, g, ends.map(at), text);
    if (!this.measure) return;
    const { places, path, lengths } = this.measure;
    if (path && view !== this.flat) view.line(g, path.line.map(at), '#ffffff', 1.5);
    this.drawCaliper(view, g, places.map((p) => at(p.xyz)), lengths ? `${lengths.straight.toFixed(1)} mm` : '');
  }

  drawCaliper(view, g, ends, text) {
    view.line(g, ends, '#7cfc00', 2);
    g.fillStyle = '#7cfc00';
    for (const p of ends) if (p) g.fillRect(p[0] - 3, p[1] - 3, 6, 6);
    if (ends.length < 2 || !ends[0] || !ends[1]) return;
    const [x, y] = ends[0][0] > ends[1][0] ? ends[0] : ends[1]; // numbers of candidates are above their middles
    g.font = '13px sans-serif';
    g.lineWidth = 3;
    g.strokeStyle = '#000c';
    g.strokeText(text, x + 6, y + 16);
    g.fillText(text, x + 6, y + 16);
  }

  describe() {
    const text = this.exam.describe(this.place);
    return this.measure ? `${this.measure.text || 'click two places to measure'} · ${text}` : text;
  }
}
