import { add, axesOf, clamp, cross, distance, dot, norm, scaled, sub, unit } from '../../../Core/Pages/scripts/math.mjs';
import { tissues } from './depth.mjs';
import { viewOfHead } from './eye.mjs';
import { FISHEYE, pixelOf, rayOf, scaleAt } from './lens.mjs';
import { gapOf, radiusOf } from './slice.mjs';
import { View } from '../../../Core/Pages/scripts/view.mjs';

// Depth of the center of a candidate behind the surface of its head, mm.
const hiddenDepth = ({ depth }) => (depth ? 1.2 * depth + 1 : 0);

// Base of the two views in space: picking, candidates, crosshair.
class SpaceView extends View {
  constructor(root, name, title, panel) {
    super(root, name, title);
    this.panel = panel;
    this.kept = document.createElement('canvas');
  }

  draw(g, w, h, ratio) {
    const { exam, place, layers } = this.panel, camera = this.camera();
    this.shown = null;
    if (!exam.painter.gl) { this.say(g, 'This view needs WebGL 2, which this browser lacks or has switched off.'); return; }
    this.render(camera, Math.round(w * ratio), Math.round(h * ratio));
    g.drawImage(this.kept, 0, 0, w, h);
    if (layers.candidates) this.drawMarks(g, camera, w, h);
    this.panel.drawMeasure(this, g, (p) => pixelOf(camera, w, h, p));
    const q = pixelOf(camera, w, h, place.xyz);
    if (q) this.cross(g, ...q, exam.hidden(camera.eye, place.xyz, hiddenDepth(place)), gapOf(place, scaleAt(camera, h, place.xyz)));
  }

  // If only the crosshair moves, the picture is reused.
  render(camera, width, height) {
    const { exam, paintings, layers } = this.panel, key = JSON.stringify([camera, width, height, layers, paintings, this.paintings()]);
    if (key === this.key) return;
    this.key = key;
    const picture = exam.painter.draw(width, height, camera, this.items());
    Object.assign(this.kept, { width, height });
    this.kept.getContext('2d').drawImage(picture, 0, 0, width, height, 0, 0, width, height);
  }

  drawMarks(g, camera, w, h) {
    const { exam, layers } = this.panel;
    for (const mark of this.panel.marks()) {
      const q = this.isNear(mark.xyz) && pixelOf(camera, w, h, mark.xyz), isHidden = exam.hidden(camera.eye, mark.xyz, hiddenDepth(mark));
      if (q && (layers.through || !isHidden)) this.ring(g, ...q, mark.text, mark.chosen, radiusOf(mark, scaleAt(camera, h, mark.xyz)));
    }
  }

  isNear() { return true; }
  paintings() { return 0; } // of what only this view shows

  lines(reach = 0) {
    const { layers, taeniae, flexures } = this.panel;
    return [...(layers.taeniae ? taeniae : []), ...(layers.flexures ? flexures : [])].map((mesh) => ({ mesh, reach }));
  }

  pick(x, y) {
    const camera = this.camera(), ray = rayOf(camera, this.w, this.h, x, y), place = ray && this.panel.exam.fromRay(camera.eye, ray);
    if (place) this.panel.set(place, this);
    return Boolean(place);
  }
}

export class OutsideView extends SpaceView {
  constructor(root, panel) {
    super(root, 'outside', 'Colon wall in 3D', panel);
    const { points: P } = panel.exam, lo = [Infinity, Infinity, Infinity], hi = lo.map((x) => -x);
    for (let i = 0; i < P.length; i++) {
      const k = i % 3;
      lo[k] = Math.min(lo[k], P[i]);
      hi[k] = Math.max(hi[k], P[i]);
    }
    Object.assign(this, { center: scaled(add(lo, hi), 0.5), radius: distance(lo, hi) / 2, yaw: 0, pitch: 0, zoom: 1 });
  }

  // Initially from the front: the patient's anterior is -y.
  camera() {
    const fov = 0.75, narrow = Math.max(1, this.h / (this.w || 1)), d = (this.radius * 2.6 * narrow) / this.zoom, c = Math.cos(this.pitch);
    const back = [Math.sin(this.yaw) * c, -Math.cos(this.yaw) * c, Math.sin(this.pitch)];
    const near = Math.max(1, d - 2 * this.radius);
    return { eye: add(this.center, scaled(back, d)), at: this.center, up: [0, 0, 1], fov, near, far: d + 2 * this.radius };
  }

  items() {
    const { layers, centerline, exam: { mesh, details } } = this.panel; // the endoluminal eye is on the centerline and does not show it
    const lines = [...this.lines(), ...(layers.centerline ? centerline.map((line) => ({ mesh: line })) : [])];
    return layers.through ? [...lines, { mesh, clear: 0.75 }] : [{ mesh }, { mesh: details.mesh }, ...lines];
  }

  drag(dx, dy, button) {
    if (button === 0) this.turn(dx / 120, dy / 120); else this.shift(dx, dy);
  }

  turn(yaw, pitch) {
    this.yaw -= yaw;
    this.pitch = clamp(this.pitch + pitch, -1.5, 1.5);
    this.changed();
  }

  shift(dx, dy) {
    const c = this.camera(), { right, up } = axesOf(c), s = (2 * distance(c.eye, c.at) * Math.tan(c.fov / 2)) / this.h;
    this.center = add(this.center, add(scaled(right, -dx * s), scaled(up, dy * s)));
    this.changed();
  }

  wheel(d) { this.scale(1.15 ** -d); }
  scale(by) { this.zoom = clamp(this.zoom * by, 0.4, 20); this.changed(); }
}

const REACH = 90;    // range of the light inside the colon, mm
const STRETCH = 250; // visible range along the colon ahead of and behind the eye, mm
const FROM_END = 20; // mm from an end of the centerline to an eye that looks from there into the colon

// An eye on the centerline. Its vertical field of view is 120 degrees; at 92 degrees, a flight in both directions misses a tenth of
// the wall. way: 1 to the cecum, -1 to the rectum; look: the target point, if any; otherwise yaw and pitch apply.
export class EndoView extends SpaceView {
  constructor(root, panel) {
    super(root, 'inside', 'Endoluminal view', panel);
    Object.assign(this, { index: 0, eye: null, yaw: 0, pitch: 0, way: 1, look: null, fov: (2 * Math.PI) / 3, isWide: false });
    this.headFov = null; // field of view of the head of a candidate
    this.isFlown = false; // otherwise the eye was placed at a target, which keeps the crosshair when the eye turns
  }

  get point() { return this.panel.exam.center[this.index]; }

  // Moves to the best view of a point of the wall, or of the head of a candidate.
  lookAt(place) {
    const { exam } = this.panel, { candidate } = place, view = candidate && (candidate.view ??= viewOfHead(exam, candidate));
    const { index, eye, fov = null } = view || exam.viewpoint(place);
    Object.assign(this, { index, eye, headFov: fov, look: place.xyz, yaw: 0, pitch: 0, isFlown: false });
  }

  draw(g, w, h, ratio) {
    super.draw(g, w, h, ratio);
    const parts = [this.eye && 'off the centerline', this.isWide && 'fisheye 160°', this.panel.translucent && 'translucency'];
    this.label.textContent = ['Endoluminal view', ...parts.filter(Boolean)].join(' · ');
    if (this.panel.translucent) this.drawTissues(g, h);
  }

  drawTissues(g, h) {
    g.font = '12px sans-serif';
    tissues.forEach(([name, , color], i) => {
      const y = h - 8 - 15 * (tissues.length - 1 - i);
      g.fillStyle = `rgb(${color})`;
      g.fillRect(8, y - 9, 10, 10);
      g.fillStyle = '#ffd';
      g.fillText(name, 23, y);
    });
    g.fillText('2 to 6 mm behind the wall:', 8, h - 8 - 15 * tissues.length);
  }

  camera() {
    const c = this.point, eye = this.eye || c.xyz, right = cross(scaled(c.ahead, this.way), c.up), { cos, sin } = Math;
    const level = add(scaled(c.ahead, this.way * cos(this.yaw)), scaled(right, sin(this.yaw)));
    let ahead = unit(add(scaled(level, cos(this.pitch)), scaled(c.up, sin(this.pitch)))), { up } = c;
    if (this.look) ahead = unit(sub(this.look, eye));
    if (norm(cross(ahead, up)) < 0.2) up = unit(cross(ahead, right)); // the view direction is parallel to up
    const fisheye = this.isWide ? FISHEYE : 0;
    return { eye, at: add(eye, ahead), up, fov: this.headFov ?? this.fov, fisheye, near: 0.3, far: 600 };
  }

  paintings() { return this.panel.tissuePaintings; }
  isNear(p) { return distance(p, this.point.xyz) < REACH; }

  items() {
    const { exam } = this.panel, { arc } = this.point;
    const wall = { mesh: exam.mesh, reach: REACH, from: exam.facesBefore(arc - STRETCH), to: exam.facesBefore(arc + STRETCH) };
    return [wall, { mesh: exam.details.mesh, reach: REACH }, ...this.lines(REACH)];
  }

  // Flies to a point of the centerline.
  go(index) {
    this.index = clamp(index, 0, this.panel.exam.center.length - 1);
    Object.assign(this, { look: null, eye: null, headFov: null, isFlown: true });
    this.panel.flown();
  }

  // Flies to an end of the centerline, where the eye is inside and looks into the colon.
  goToEnd(isLast) {
    const { exam } = this.panel, { arc } = exam.center.at(isLast ? -1 : 0), way = isLast ? -1 : 1;
    Object.assign(this, { way, yaw: 0, pitch: 0 });
    this.go(exam.centerAt(arc + way * FROM_END));
  }

  reverse() {
    this.way = -this.way;
    if (!this.isFlown) { this.yaw += Math.PI; return; } // keeps the view
    Object.assign(this, { yaw: 0, pitch: 0 });
    this.go(this.index);
  }

  // Turns relative to the current view direction.
  turn(yaw, pitch) {
    if (this.look) this.straighten();
    this.yaw += yaw;
    this.pitch = clamp(this.pitch + pitch, -1.4, 1.4);
    if (this.isFlown) this.panel.flown(); else this.panel.turned();
  }

  // Yaw and pitch of the direction to the target.
  straighten() {
    const c = this.point, d = unit(sub(this.look, this.eye || c.xyz)), ahead = scaled(c.ahead, this.way), right = cross(ahead, c.up);
    const part = (a) => dot(d, a);
    this.yaw = Math.atan2(part(right), part(ahead));
    this.pitch = clamp(Math.asin(clamp(part(c.up), -1, 1)), -1.4, 1.4);
    this.look = null;
  }

  drag(dx, dy) { this.turn(-dx / 200, dy / 200); }
  wheel(d) { this.panel.fly(-2 * d); }
  scale(by) {
    const name = this.headFov === null ? 'fov' : 'headFov';
    this[name] = clamp(this[name] / by, 0.5, 2.2);
    this.changed();
  }
}
