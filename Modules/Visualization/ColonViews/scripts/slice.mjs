import { clamp, dot } from '../../../Core/Pages/scripts/math.mjs';
import { View } from '../../../Core/Pages/scripts/view.mjs';

const PLANES = ['sagittal', 'coronal', 'axial'];
const LETTERS = [['R', 'L'], ['A', 'P'], ['F', 'H']]; // for the ends of the patient's axes, LPS
const SCALES = [1, 2, 5, 10, 20, 50, 100];             // mm, lengths of the scale bar
const WIDEST_SCALE = 0.3;                               // of the width of the view
const RIGHT_OF_LABEL = 170;                             // pixels
const LEAST_IN_PLANE = 0.7;                             // of gravity
const AROUND_HEAD = 4;                                  // pixels between a head and its ring
export const LEAST_WIDTH = 20;                                 // HU, of the window

// Radius of the ring around a mark, and half the gap of the crosshair, in pixels: they do not cover the head of a candidate, which
// has the radius `depth` (mm).
export const radiusOf = ({ depth = 0 }, scale) => Math.max(9, depth * scale + AROUND_HEAD);
export const gapOf = (place, scale) => (place.depth ? radiusOf(place, scale) : 4);

// The image axis closest to each of the patient's axes.
export function nearestAxes(axes) {
  const orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
  const agreement = (order) => order.reduce((sum, image, patient) => sum + Math.abs(axes[image][patient]), 0);
  return orders.reduce((best, order) => (agreement(order) > agreement(best) + 1e-9 ? order : best));
}

// A slice of the volume as scanned, without resampling, with the rows and columns of the image.
export class SliceView extends View {
  constructor(root, panel, plane) {
    super(root, PLANES[plane], PLANES[plane]);
    Object.assign(this, { panel, plane, zoom: 1, middle: null, image: document.createElement('canvas'), key: '' });
  }

  // Image axes to the right and down, and whether they are flipped.
  layout() {
    const { axes } = this.panel.exam.volume, order = nearestAxes(axes), plane = this.plane;
    const [right, down] = [[1, 2], [0, 2], [0, 1]][plane];
    const across = order[right], below = order[down];
    const isUp = plane !== 2; // coronal and sagittal slices have the head on top
    this.axis = order[plane];
    this.across = across;
    this.down = below;
    this.flipX = axes[across][right] < 0;
    this.flipY = axes[below][down] < 0 !== isUp;
    const name = (flip, patient) => LETTERS[patient][flip ? 0 : 1];
    this.letters = { right: name(false, right), left: name(true, right), bottom: name(isUp, down), top: name(!isUp, down) };
    const tilt = (Math.acos(clamp(Math.abs(axes[this.axis][plane]), 0, 1)) * 180) / Math.PI;
    this.title = tilt > 0.5 ? `${PLANES[plane]}, oblique by ${tilt.toFixed(0)}°` : PLANES[plane];
  }

  // Width and height of a whole slice, mm.
  extent() {
    if (!this.letters) this.layout();
    const { size, spacing } = this.panel.exam.volume;
    return [this.across, this.down].map((k) => size[k] * spacing[k]);
  }

  // Pixels per mm at which a whole slice fits into the view; `room`, if set, is the larger slice of two positions.
  fit() {
    const [width, height] = this.room ?? this.extent();
    return Math.min(this.w / width, this.h / height);
  }

  frame() {
    const { exam, place } = this.panel, v = exam.volume, p = exam.toImage(place.xyz), pair = [this.across, this.down];
    const s = this.zoom * this.fit();
    if (this.zoom === 1 || !this.middle) this.middle = this.extent().map((mm, i) => mm / 2 - v.spacing[pair[i]] / 2);
    // Scrolls only if the crosshair would leave the view, so two clicks can measure a distance.
    const leaves = pair.some((k, i) => Math.abs(p[k] - this.middle[i]) * s > 0.46 * [this.w, this.h][i]);
    if (this.zoom > 1 && leaves) this.middle = pair.map((k) => p[k]);
    const [mx, my] = this.middle, sx = this.flipX ? -s : s, sy = this.flipY ? -s : s;
    return {
      s,
      at: (q) => [this.w / 2 + (q[this.across] - mx) * sx, this.h / 2 + (q[this.down] - my) * sy],
      back: (x, y) => {
        const q = [...p];
        q[this.across] = mx + (x - this.w / 2) / sx;
        q[this.down] = my + (y - this.h / 2) / sy;
        return q;
      },
    };
  }

  draw(g, w, h) {
    const { exam, place, layers } = this.panel, v = exam.volume;
    this.shown = null;
    if (!v) { this.say(g, this.panel.volumeText); return; }
    if (!this.letters) this.layout();
    this.label.textContent = `${this.title} · ${v.name}`;
    this.label.classList.toggle('cleansed', v.isCleansed);
    const q = exam.toImage(place.xyz), index = clamp(Math.round(q[this.axis] / v.spacing[this.axis]), 0, v.size[this.axis] - 1);
    const f = this.frame(), at = (p) => f.at(exam.toImage(p));
    g.fillStyle = '#000';
    g.fillRect(0, 0, w, h);
    this.drawImage(g, f, index);
    if (layers.wall) this.drawContour(g, f, index);
    if (layers.candidates) this.drawMarks(g, at, index, f.s);
    this.panel.drawMeasure(this, g, at);
    this.drawLetters(g, w, h);
    this.drawFacts(g, index, place.xyz);
    this.drawGravity(g, w);
    this.drawScale(g, f.s, w, h);
    this.cross(g, ...f.at(q), false, gapOf(place, f.s));
  }

  // Number of the slice in the image, from 1, the position of the crosshair across it (LPS, mm), and the window.
  facts(index, xyz) {
    const { panel: { exam: { volume: v }, window: [width, level] }, axis, plane } = this;
    const slice = `slice ${v.first[axis] + index + 1} of ${v.whole[axis]}`, place = `${'xyz'[plane]} ${xyz[plane].toFixed(1)} mm`;
    return [`${slice} · ${place}`, v.isCt ? `W ${Math.round(width)}  L ${Math.round(level)}` : ''];
  }

  drawFacts(g, index, xyz) {
    this.facts(index, xyz).forEach((text, i) => this.write(g, text, 6, 33 + 15 * i));
  }

  // An arrow along gravity in the upper right corner, if it is known and lies in the plane of the slice.
  drawGravity(g, w) {
    const { exam: { info: { gravity }, volume: { axes } } } = this.panel;
    if (!gravity) return;
    const along = [[this.across, this.flipX], [this.down, this.flipY]].map(([k, flip]) => dot(gravity, axes[k]) * (flip ? -1 : 1));
    if (Math.hypot(...along) < LEAST_IN_PLANE) return;
    const [x, y] = along, tip = [w - 22 + 12 * x, 34 + 12 * y], at = (a, b) => [tip[0] - a * x - b * y, tip[1] - a * y + b * x];
    for (const [color, width] of [['#000c', 4], ['#ffd', 1.6]]) {
      this.line(g, [at(24, 0), tip, null, at(6, 4), tip, at(6, -4)], color, width);
    }
    this.write(g, 'gravity', w - 46, 70);
  }

  drawScale(g, scale, w, h) {
    const mm = SCALES.filter((x) => x * scale < WIDEST_SCALE * w).at(-1) || SCALES[0], end = 8 + mm * scale, y = h - 8;
    this.line(g, [[8, y - 4], [8, y], [end, y], [end, y - 4]], '#000', 4);
    this.line(g, [[8, y - 4], [8, y], [end, y], [end, y - 4]], '#ffd', 1.6);
    this.write(g, `${mm} mm`, 12, y - 5);
  }

  write(g, text, x, y) {
    g.font = '12px sans-serif';
    g.lineWidth = 3;
    g.strokeStyle = '#000c';
    g.strokeText(text, x, y);
    g.fillStyle = '#ffd';
    g.fillText(text, x, y);
  }

  drawImage(g, f, index) {
    const v = this.panel.exam.volume, nx = v.size[this.across], ny = v.size[this.down];
    this.fill(index);
    const corner = [0, 0, 0], [dx, dy] = [v.spacing[this.across], v.spacing[this.down]];
    corner[this.across] = this.flipX ? (nx - 1) * dx : 0;
    corner[this.down] = this.flipY ? (ny - 1) * dy : 0;
    const [x, y] = f.at(corner);
    g.imageSmoothingEnabled = true;
    g.drawImage(this.image, x - (f.s * dx) / 2, y - (f.s * dy) / 2, nx * dx * f.s, ny * dy * f.s);
  }

  // Windowed gray values of a slice. Means of 4^3 voxels are bluish to distinguish them from original voxels.
  fill(index) {
    const { exam: { volume: v }, window: [width, level] } = this.panel, key = [index, width, level, v.isCleansed].join();
    if (key === this.key) return;
    this.key = key;
    const nx = v.size[this.across], ny = v.size[this.down], { side, blocks, coarse, data } = v;
    if (!this.pixels) { Object.assign(this.image, { width: nx, height: ny }); this.pixels = new ImageData(nx, ny); }
    const words = new Uint32Array(this.pixels.data.buffer), strides = [1, v.size[0], v.size[0] * v.size[1]];
    const blockStrides = [1, blocks[0], blocks[0] * blocks[1]], block = (k, i) => blockStrides[k] * ((i / side) | 0);
    const grays = v.graysOf(width, level);
    for (let j = 0, o = 0; j < ny; j++) {
      const row = this.flipY ? ny - 1 - j : j;
      const start = index * strides[this.axis] + row * strides[this.down], startBlock = block(this.axis, index) + block(this.down, row);
      for (let i = 0; i < nx; i++, o++) {
        const column = this.flipX ? nx - 1 - i : i, b = grays[data[start + column * strides[this.across]]];
        const isMean = coarse[startBlock + block(this.across, column)];
        words[o] = isMean ? 0xff000000 | (b << 16) | (((b * 0.94) | 0) << 8) | ((b * 0.88) | 0) : 0xff000000 | (b * 0x10101);
      }
    }
    this.image.getContext('2d').putImageData(this.pixels, 0, 0);
  }

  drawContour(g, f, index) {
    const { exam } = this.panel;
    if (this.contourIndex !== index) {
      this.contourIndex = index;
      const at = index * exam.volume.spacing[this.axis];
      this.contour = [...contour(exam, exam, exam.wall.skip, this.axis, at), ...contour(exam, exam.details, null, this.axis, at)];
    }
    g.strokeStyle = '#00d8a0';
    g.lineWidth = 1;
    g.beginPath();
    for (const [a, b] of this.contour) {
      g.moveTo(...f.at(a));
      g.lineTo(...f.at(b));
    }
    g.stroke();
  }

  drawMarks(g, at, index, scale) {
    const { exam } = this.panel, step = exam.volume.spacing[this.axis];
    for (const mark of this.panel.marks()) {
      const away = Math.abs(exam.toImage(mark.xyz)[this.axis] - index * step);
      if (away < Math.max(3, mark.depth)) this.ring(g, ...at(mark.xyz), mark.text, mark.chosen, radiusOf(mark, scale));
    }
  }

  drawLetters(g, w, h) {
    const { left, right, top, bottom } = this.letters;
    this.write(g, left, 4, h / 2);
    this.write(g, right, w - 13, h / 2);
    this.write(g, top, Math.max(w / 2 - 4, RIGHT_OF_LABEL), 15);
    this.write(g, bottom, w / 2 - 4, h - 5);
  }

  pick(x, y) {
    const { panel } = this, { exam } = panel;
    if (exam.volume) panel.set(exam.fromXyz(exam.fromImage(this.frame().back(x, y))), this);
    return Boolean(exam.volume);
  }

  wheel(d, at, isScaling) { if (isScaling) this.scale(1.25 ** -d); else this.step(d); }
  scale(by) { this.zoomTo(this.zoom * by); this.panel.zoomed(this); }
  zoomTo(zoom) { this.zoom = clamp(zoom, 1, 12); this.changed(); }

  // Shows a place at the center, enlarged until `span` mm fit into the view: slices in views of one size have the same scale.
  centerOn(place, span) {
    const { exam } = this.panel, { w, h } = this;
    if (!exam.volume || !w) return;
    this.zoomTo(Math.min(w, h) / span / this.fit());
    const p = exam.toImage(place.xyz);
    this.middle = [this.across, this.down].map((k) => p[k]);
    this.changed();
  }

  // Moves the crosshair by this number of slices; false at the last one.
  step(n) {
    const { panel, axis } = this, { exam } = panel, v = exam.volume;
    if (!v) return false;
    if (!this.letters) this.layout();
    const q = exam.toImage(panel.place.xyz), old = q[axis];
    q[axis] = clamp(old + n * v.spacing[axis], 0, (v.size[axis] - 1) * v.spacing[axis]);
    panel.scroll(exam.fromXyz(exam.fromImage(q)), this);
    return q[axis] !== old;
  }

  drag(dx, dy) {
    const [width, level] = this.panel.window;
    this.panel.setWindow([Math.max(LEAST_WIDTH, width + 4 * dx), level + 4 * dy]);
  }
}

// Intersection of a surface {points, faces} with a plane perpendicular to an image axis: pairs of points in image millimeters.
// skip: 1 for faces that are not shown, or null.
function contour(exam, { points: P, faces: F }, skip, axis, value) {
  const { origin, axes } = exam.volume, n = axes[axis], shift = dot(n, origin) + value;
  const height = new Float32Array(P.length / 3), out = [];
  for (let i = 0, o = 0; i < height.length; i++, o += 3) height[i] = n[0] * P[o] + n[1] * P[o + 1] + n[2] * P[o + 2] - shift;
  for (let f = 0; f < F.length; f += 3) {
    if (skip && skip[f / 3]) continue;
    const above = height[F[f]] > 0;
    if (above === height[F[f + 1]] > 0 && above === height[F[f + 2]] > 0) continue;
    const ends = [];
    for (let j = 0; j < 3; j++) {
      const a = F[f + j], b = F[f + ((j + 1) % 3)];
      if (height[a] > 0 === height[b] > 0) continue;
      const t = height[a] / (height[a] - height[b]);
      ends.push(exam.toImage([0, 1, 2].map((k) => P[3 * a + k] + t * (P[3 * b + k] - P[3 * a + k]))));
    }
    out.push(ends);
  }
  return out;
}
