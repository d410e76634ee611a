import { minus, plus, polar, times } from './motions.mjs';

// Base of plane and disk: a scale, without a hidden side.
export class Flat {
  constructor() {
    this.step = 2;
    this.reset();
  }

  isSeen() { return true; }
  zoom(at, amount) { this.scale = Math.min(1e6, Math.max(0.05, this.scale * Math.exp(amount))); }
}

// The universal cover of a flat torus. frame: the center of the domain, and the length that the radius of a view
// represents.
export class Plane extends Flat {
  reset() { Object.assign(this, { scale: 1, turned: 0, shift: [0, 0] }); }
  get isStraight() { return true; }
  rim() { return 0; }
  sizeOfDot() { return 1; }
  hasTile(q) { return Math.hypot(q[0], q[1]) < 8 * Math.max(1, this.scale); }

  mover({ middle, extent }, tile) {
    const t = polar(this.scale / extent, this.turned), from = minus(tile.b, middle);
    return (array, at) => plus(times(t, [array[at] + from[0], array[at + 1] + from[1]]), this.shift);
  }

  pixel({ c, R }, q) { return [c + R * q[0], c - R * q[1]]; }
  between(p, q, t) { return [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]; }

  circle(g, frame, move, array, at, r) {
    const s = (r * this.scale * frame.R) / frame.extent, [x, y] = this.pixel(frame, move(array, at)), most = 2 * frame.c + s;
    if (s < 0.3 || x < -s || y < -s || x > most || y > most) return 0;
    g.arc(x, y, s, 0, 2 * Math.PI);
    return s;
  }

  drag(from, to, isShift) {
    if (!isShift) { this.shift = plus(this.shift, minus(to, from)); return; }
    const angle = Math.atan2(to[1], to[0]) - Math.atan2(from[1], from[0]);
    this.turned += angle;
    this.shift = times(polar(1, angle), this.shift);
  }

  zoom(at, amount) {
    const old = this.scale;
    super.zoom(at, amount);
    this.shift = plus(at, times([this.scale / old, 0], minus(this.shift, at)));
  }

  center(q) { this.shift = minus(this.shift, q); }
}
