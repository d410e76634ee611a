import { inverseOf, movedBy, normalized, polar, product, toPlace } from './motions.mjs';
import { Flat } from './plane.mjs';

const ALMOST = 1 - 1e-15;

// Maps a point of the Klein disk to the Poincare disk.
function fromKlein(p) {
  const k = 1 / (1 + Math.sqrt(Math.max(0, 1 - p[0] * p[0] - p[1] * p[1])));
  return [k * p[0], k * p[1]];
}

function within(p) { // clamps to the disk, with margin for the next motion
  const n = Math.hypot(p[0], p[1]) / 0.97;
  return n > 1 ? [p[0] / n, p[1] / n] : p;
}

// The hyperbolic plane as Poincare or Klein disk; motions apply to points of the Poincare disk.
export class Disk extends Flat {
  constructor() {
    super();
    this.choice = 'poincare';
  }

  reset() { Object.assign(this, { scale: 1, motion: { a: [1, 0], b: [0, 0] } }); }
  get isKlein() { return this.choice === 'klein'; }
  get isStraight() { return this.isKlein; }
  rim() { return this.scale; }
  sizeOfDot(q) { return 1 - q[0] * q[0] - q[1] * q[1]; }
  hasTile(q, frame) { return frame.R * this.scale * this.sizeOfDot(q) > 3; }

  mover(frame, tile) {
    const m = product(this.motion, tile);
    return (array, at) => movedBy(m, [array[at], array[at + 1]]);
  }

  pixel({ c, R }, q) {
    const s = R * this.scale * (this.isKlein ? 2 / (1 + q[0] * q[0] + q[1] * q[1]) : 1);
    return [c + s * q[0], c - s * q[1]];
  }

  between(p, q, t) {
    const m = toPlace(p), w = movedBy(inverseOf(m), q), n = Math.hypot(w[0], w[1]);
    if (n < 1e-9) return p;
    const k = Math.tanh(t * Math.atanh(Math.min(n, ALMOST))) / n;
    return movedBy(m, [k * w[0], k * w[1]]);
  }

  circle(g, frame, move, array, at, r) {
    const q = move(array, at), n = Math.hypot(q[0], q[1]), d = 2 * Math.atanh(Math.min(n, ALMOST));
    const far = Math.tanh((d + r) / 2), near = Math.tanh((d - r) / 2), size = (frame.R * this.scale * (far - near)) / 2;
    if (size < 0.3) return 0;
    if (this.isKlein) {
      this.ellipse(g, frame, toPlace(q), Math.tanh(r / 2));
      return size;
    }
    const s = (far + near) / 2 / (n || 1), [x, y] = this.pixel(frame, n ? [s * q[0], s * q[1]] : [0, 0]);
    g.arc(x, y, size, 0, 2 * Math.PI);
    return size;
  }

  ellipse(g, frame, m, t) {
    for (let k = 0; k < 28; k++) {
      const p = this.pixel(frame, movedBy(m, polar(t, (k * Math.PI) / 14)));
      if (k) g.lineTo(p[0], p[1]); else g.moveTo(p[0], p[1]);
    }
    g.closePath();
  }

  drag(from, to, isShift) {
    if (isShift) {
      const angle = Math.atan2(to[1], to[0]) - Math.atan2(from[1], from[0]);
      this.motion = product({ a: polar(1, angle / 2), b: [0, 0] }, this.motion);
      return;
    }
    const at = (p) => { const q = within([p[0] / this.scale, p[1] / this.scale]); return this.isKlein ? fromKlein(q) : q; };
    this.motion = normalized(product(product(toPlace(at(to)), inverseOf(toPlace(at(from)))), this.motion));
  }

  center(q) { this.motion = normalized(product(inverseOf(toPlace(q)), this.motion)); }
}
