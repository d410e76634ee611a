import { clamp } from '../../../Core/Pages/scripts/math.mjs';
import { paintFlat, segmentColors, taeniaColors } from './layers.mjs';
import { Shortened } from './shortened.mjs';
import { View } from '../../../Core/Pages/scripts/view.mjs';

const OVERVIEW = 34; // height of the overview strip of the whole colon, pixels

function canvasOf(columns, rows) {
  return Object.assign(document.createElement('canvas'), { width: columns, height: rows });
}

// The flat wall as seen from inside: u runs to the right from the rectum, shortened where the wall is interpolated; v wraps around
// the tube.
export class FlatView extends View {
  constructor(root, panel) {
    super(root, 'flat', [panel.exam.info.name, 'Virtual dissection (unfolded view)'].filter(Boolean).join(' · '));
    Object.assign(this, { panel, relief: panel.exam.info.relief, scale: null, along: null, v: null });
    this.short = new Shortened(panel.exam); // `along`: the center of the view on this shortened map
    const { columns, rows } = this.relief;
    this.picture = canvasOf(columns, rows);
    this.layer = canvasOf(columns, rows);
    this.paintRelief();
    this.ruler = this.ticks();
  }

  paintRelief() {
    const { relief, faceOfPixel } = this.panel.exam, { columns, rows } = this.relief, image = new ImageData(columns, rows);
    for (let i = 0; i < faceOfPixel.length; i++) {
      for (let k = 0; k < 3; k++) image.data[4 * i + k] = relief[3 * i + k];
      image.data[4 * i + 3] = 255;
    }
    this.picture.getContext('2d').putImageData(image, 0, 0);
  }

  // Every 5 cm of the centerline.
  ticks() {
    const { exam } = this.panel, marks = [];
    for (const c of exam.center) marks[Math.floor(c.arc / 50)] ??= c;
    return marks.filter(Boolean).map((c) => ({ cm: Math.round(c.arc / 10), u: exam.fromXyz(c.xyz).uv[0] }));
  }

  // The layers are a separate image, redrawn after changes.
  repaintLayers() {
    const { columns, rows } = this.relief, image = new ImageData(columns, rows);
    paintFlat(this.panel.exam, this.panel.layers, image);
    this.layer.getContext('2d').putImageData(image, 0, 0);
    this.changed();
  }

  get middle() { return (this.h + OVERVIEW) / 2; }

  frame() {
    const { exam } = this.panel, { short } = this, [lo, hi] = short.range, c = exam.circumference, fit = this.w / (hi - lo);
    const s = Math.max(this.scale ?? (this.h - OVERVIEW) / (1.15 * c), fit), half = this.w / 2 / s;
    this.along ??= short.of(this.panel.place.uv[0]);
    this.v ??= this.panel.place.uv[1];
    this.along = clamp(this.along, lo + half, Math.max(lo + half, hi - half));
    const sy = s * this.relief.vSign;
    return {
      s,
      sy,
      x: (u) => this.w / 2 + (short.of(u) - this.along) * s,
      y: (v) => this.middle + (v - this.v) * sy,
      back: (x, y) => [short.back(this.along + (x - this.w / 2) / s), this.v + (y - this.middle) / sy],
    };
  }

  // The same height, repeated for each visible turn around the tube.
  turns(y, s) {
    const period = this.panel.exam.circumference * s, out = [];
    for (let q = y - Math.ceil(y / period) * period; q < this.h + period; q += period) out.push(q);
    return out;
  }

  draw(g, w, h) {
    const { exam, place, layers } = this.panel, f = this.frame();
    g.fillStyle = '#111';
    g.fillRect(0, 0, w, h);
    this.drawPicture(g, f);
    if (layers.taeniae) exam.info.taeniae.forEach((t, i) => this.curve(g, f, t.uv, taeniaColors[i % 3], 2));
    if (layers.flexures) for (const x of exam.info.flexures) this.curve(g, f, this.uvOf(x), [20, 20, 60], 2);
    if (layers.segments) this.drawBands(g, f, h);
    this.drawRuler(g, f, h);
    if (layers.candidates) this.drawMarks(g, f);
    this.panel.drawMeasure(this, g, (p) => { const [u, v] = exam.fromXyz(p, false).uv; return [f.x(u), this.nearestTurn(f, v)]; });
    this.cross(g, f.x(place.uv[0]), this.nearestTurn(f, place.uv[1]), place.off > 5);
    this.overview(g, w, f);
  }

  // The copy around the tube that is nearest to the center of the view.
  nearestTurn(f, v) {
    return this.turns(f.y(v), f.s).reduce((best, y) => (Math.abs(y - this.middle) < Math.abs(best - this.middle) ? y : best));
  }

  drawPicture(g, f) {
    const { v, vSign, step, rows } = this.relief, height = rows * step * f.s;
    g.imageSmoothingEnabled = true;
    for (const y of this.turns(f.y(v - (vSign * step) / 2), f.s)) {
      this.short.draw(g, this.picture, this.relief, f.x, y, height + 0.7);
      this.short.draw(g, this.layer, this.relief, f.x, y, height);
    }
  }

  uvOf(curve) { return (curve.uv ??= [...curve.xyz, curve.xyz[0]].map((p) => this.panel.exam.fromXyz(p).uv)); }

  curve(g, f, uv, color, width) {
    const c = this.panel.exam.circumference;
    for (const turn of this.turns(f.y(0), f.s)) {
      let last = null;
      const points = uv.flatMap(([u, v]) => {
        const isJump = last !== null && Math.abs(v - last) > c / 2;
        last = v;
        return [...(isJump ? [null] : []), [f.x(u), turn + v * f.sy]];
      });
      this.line(g, points, `rgb(${color})`, width);
    }
  }

  // Ranges of u by segment.
  bands() {
    if (this.memory) return this.memory;
    const { exam } = this.panel, out = [];
    for (let u = exam.range[0]; u < exam.range[1]; u += 4) {
      const place = exam.fromUv(u, exam.circumference / 2), segment = place ? exam.segmentOf(place.face) : 0, last = out.at(-1);
      if (last?.segment === segment) last.to = u + 4; else out.push({ segment, from: u, to: u + 4 });
    }
    return (this.memory = out);
  }

  drawBands(g, f, h) {
    for (const { segment, from, to } of this.bands()) {
      g.fillStyle = `rgb(${segmentColors[segment]})`;
      g.fillRect(f.x(from), h - 6, f.x(to) - f.x(from), 6);
    }
  }

  drawRuler(g, f, h) {
    g.font = '12px sans-serif';
    let free = -Infinity;
    for (const { cm, u } of this.ruler) {
      const x = f.x(u);
      g.fillStyle = '#000';
      g.fillRect(x - 1, h - 14, 3, 8);
      g.fillStyle = '#fff';
      g.fillRect(x, h - 14, 1, 8);
      if (x <= free) continue;
      g.strokeStyle = '#000b';
      g.lineWidth = 3;
      g.strokeText(`${cm} cm`, x + 3, h - 7);
      g.fillText(`${cm} cm`, x + 3, h - 7);
      free = x + 56;
    }
  }

  drawMarks(g, f) {
    for (const mark of this.panel.marks()) {
      for (const y of this.turns(f.y(mark.uv[1]), f.s)) this.ring(g, f.x(mark.uv[0]), y, mark.text, mark.chosen);
    }
  }

  overview(g, w, f) {
    const { place, layers } = this.panel, { short } = this, [lo, hi] = short.range, height = OVERVIEW - 4;
    const x = (u) => ((short.of(u) - lo) / (hi - lo)) * w;
    for (const image of [this.picture, this.layer]) short.draw(g, image, this.relief, x, 0, height);
    g.fillStyle = '#1b1c1f';
    g.fillRect(0, height, w, 4);
    g.fillStyle = '#0009';
    const [from, to] = [f.back(0, 0)[0], f.back(w, 0)[0]].map(x);
    g.fillRect(0, 0, from, height);
    g.fillRect(to, 0, w, height);
    if (layers.candidates) {
      for (const mark of this.panel.marks()) {
        g.fillStyle = mark.chosen ? '#ff9d4d' : '#56b4e9';
        g.fillRect(x(mark.uv[0]) - 1.5, 0, 3, height);
      }
    }
    g.fillStyle = '#ffd400';
    g.fillRect(x(place.uv[0]) - 1, 0, 2, height);
  }

  // Keeps the crosshair visible.
  reveal(place) {
    if (!this.w) return;
    const f = this.frame(), x = f.x(place.uv[0]), c = this.panel.exam.circumference;
    if (x < 40 || x > this.w - 40) this.along = this.short.of(place.uv[0]);
    const dv = place.uv[1] - this.v, around = dv - c * Math.round(dv / c);
    if (Math.abs(around * f.s) > (this.h - OVERVIEW) / 2 - 15) this.v += around;
  }

  // Enlarges the map at least to this many pixels per mm, with a place at the center.
  centerOn(place, scale) {
    this.scale = Math.max(this.frame().s, scale);
    this.along = this.short.of(place.uv[0]);
    this.reveal(place);
    this.changed();
  }

  pick(x, y) {
    const { exam } = this.panel, [lo, hi] = this.short.range, inOverview = y < OVERVIEW, { vSign, v } = this.relief;
    const uv = inOverview
      ? [this.short.back(lo + (x / this.w) * (hi - lo)), v + (vSign * exam.circumference * y) / (OVERVIEW - 4)]
      : this.frame().back(x, y);
    const place = exam.fromUv(...uv);
    if (!place) return false;
    if (inOverview) this.along = this.short.of(place.uv[0]);
    this.panel.set(place, this);
    return true;
  }

  drag(dx, dy) {
    const { s, sy } = this.frame();
    this.along -= dx / s;
    this.v -= dy / sy;
    this.changed();
    this.panel.shifted(this.panel);
  }

  // The place at the center of the view, and its scale.
  center() {
    const f = this.frame();
    return { place: this.panel.exam.nearestUv(...f.back(this.w / 2, this.middle)), scale: f.s };
  }

  // Shows a place at the center.
  show({ place, scale }) {
    Object.assign(this, { scale, along: this.short.of(place.uv[0]), v: place.uv[1] });
    this.changed();
  }

  wheel(d, at) { this.scaleAt(1.25 ** -d, at.x, at.y); }
  scaleBy(by) { this.scaleAt(by, this.w / 2, this.middle); }

  // Zooms with (x, y) fixed.
  scaleAt(by, x, y) {
    const f = this.frame(), [u, v] = f.back(x, y), s = clamp(f.s * by, 0.05, 16);
    this.scale = s;
    this.along = this.short.of(u) - (x - this.w / 2) / s;
    this.v = v - (y - this.middle) / (s * this.relief.vSign);
    this.changed();
    this.panel.shifted(this.panel);
  }

  // Moves the crosshair on the map by millimeters to the right and down.
  move(right, down) {
    const [u, v] = this.panel.place.uv, place = this.panel.exam.fromUv(u + right, v + down * this.relief.vSign);
    if (place) this.panel.set(place, null);
  }
}
