import { clamp, cross, norm, scaled, unit } from '../../../Core/Pages/scripts/math.mjs';

// A Moebius transformation of the sphere is a Lorentz matrix: points are light-like vectors (x, y, z, 1), caps de Sitter
// vectors (c / sin r, cos r / sin r), so circles stay circles. Matrices row by row.
function matrixProduct(m, n) {
  const r = new Array(16).fill(0);
  for (let i = 0; i < 4; i++) for (let j = 0; j < 4; j++) for (let k = 0; k < 4; k++) r[4 * i + j] += m[4 * i + k] * n[4 * k + j];
  return r;
}

function boostAlong(u, rapidity) {
  const c = Math.cosh(rapidity), s = Math.sinh(rapidity), m = [];
  for (let i = 0; i < 3; i++) {
    for (let j = 0; j < 3; j++) m.push((i === j ? 1 : 0) + (c - 1) * u[i] * u[j]);
    m.push(s * u[i]);
  }
  return [...m, s * u[0], s * u[1], s * u[2], c];
}

// Rows: right, up, towards the eye; as in FrameOf() of shapetonPictureMaps.cxx.
function frameTowards(eye) {
  const right = unit(Math.abs(eye[2]) < 0.9 ? [-eye[1], eye[0], 0] : cross([0, 1, 0], eye)), up = cross(eye, right);
  return [...right, 0, ...up, 0, ...eye, 0, 0, 0, 0, 1];
}

const FLAT = 0.45; // radius of the equator in the stereographic picture; the ball has radius 1

// The sphere as a ball, or stereographic from the point farthest from the eye. Pictures are in units of the ball; frame has the
// center c and the radius R of a view in pixels.
export class Sphere {
  constructor(front) {
    this.start = frameTowards(front);
    this.step = 3;
    this.choice = 'ball';
    this.reset();
  }

  reset() { this.lorentz = this.start; }
  get isFlat() { return this.choice === 'flat'; }
  get isStraight() { return false; }
  rim() { return this.isFlat ? 0 : 1; }
  isSeen(q) { return this.isFlat ? q[2] > -0.995 : q[2] >= 0; }
  sizeOfDot() { return 1; }
  hasTile() { return true; }

  apply(x, y, z, t) {
    const m = this.lorentz;
    return [0, 4, 8, 12].map((i) => m[i] * x + m[i + 1] * y + m[i + 2] * z + m[i + 3] * t);
  }

  // Returns a function that moves the point at an index of an array.
  mover() {
    return (array, at) => {
      const [x, y, z, t] = this.apply(array[at], array[at + 1], array[at + 2], 1);
      return [x / t, y / t, z / t];
    };
  }

  pixel({ c, R }, q) {
    const s = this.isFlat ? (FLAT * R) / Math.max(1e-9, 1 + q[2]) : R;
    return [c + s * q[0], c - s * q[1]];
  }

  between(p, q, t) {
    const angle = Math.acos(clamp(p[0] * q[0] + p[1] * q[1] + p[2] * q[2], -1, 1));
    if (angle < 1e-6) return p;
    const f = Math.sin((1 - t) * angle) / Math.sin(angle), g = Math.sin(t * angle) / Math.sin(angle);
    return [0, 1, 2].map((i) => f * p[i] + g * q[i]);
  }

  // Adds the circle as a path; returns its radius in pixels: 0 if it is hidden, negative if inside and outside are swapped.
  circle(g, frame, move, array, at, r) {
    const sin = Math.sin(r), cos = Math.cos(r);
    const [x, y, z, t] = this.apply(array[at] / sin, array[at + 1] / sin, array[at + 2] / sin, cos / sin);
    const u = unit([x, y, z]), s = Math.atan2(1, t), size = frame.R * Math.sin(s);
    if (this.isFlat) return this.flatCap(g, frame, u, s);
    if (size < 0.3 || u[2] < -Math.sin(s)) return 0;
    return s < 1.57 && u[2] > Math.sin(s) ? this.wholeCap(g, frame, u, s) : this.partOfCap(g, frame, u, s);
  }

  wholeCap(g, { c, R }, u, s) {
    const d = R * Math.cos(s), size = R * Math.sin(s), turn = -Math.atan2(u[1], u[0]) - Math.PI / 2;
    g.ellipse(c + d * u[0], c - d * u[1], size, size * Math.abs(u[2]), turn, 0, 2 * Math.PI);
    return s < 1.57 ? size : -size;
  }

  flatCap(g, { c, R }, u, s) {
    const theta = Math.acos(clamp(u[2], -1, 1)), k = FLAT * R, h = Math.hypot(u[0], u[1]) || 1;
    const far = Math.tan((theta + s) / 2), near = Math.tan((theta - s) / 2), size = (k * Math.abs(far - near)) / 2;
    if (size < 0.3 || size > 1e5) return 0;
    g.arc(c + (k * (far + near) * u[0]) / 2 / h, c - (k * (far + near) * u[1]) / 2 / h, size, 0, 2 * Math.PI);
    return theta + s > Math.PI ? -size : size;
  }

  // The visible part of a cap, closed along the limb. A cap that just touches the limb may be entirely on one side.
  partOfCap(g, frame, u, s) {
    const { c, R } = frame;
    const x = unit(Math.abs(u[0]) < 0.7 ? cross([1, 0, 0], u) : cross([0, 1, 0], u)), y = cross(u, x), number = 64;
    const points = Array.from({ length: number }, (_, k) => {
      const a = (2 * Math.PI * k) / number;
      return [0, 1, 2].map((i) => Math.cos(s) * u[i] + Math.sin(s) * (Math.cos(a) * x[i] + Math.sin(a) * y[i]));
    });
    const start = points.findIndex((p, k) => p[2] >= 0 && points[(k + number - 1) % number][2] < 0);
    if (start < 0) return points[0][2] >= 0 ? this.wholeCap(g, frame, u, s) : 0;
    let last = null;
    for (let k = 0; k < number; k++) {
      const p = points[(start + k) % number];
      if (p[2] < 0) break;
      if (last) g.lineTo(c + R * p[0], c - R * p[1]); else g.moveTo(c + R * p[0], c - R * p[1]);
      last = p;
    }
    const a = Math.atan2(last[1], last[0]), b = Math.atan2(points[start][1], points[start][0]);
    const middle = a + ((b - a + 4 * Math.PI) % (2 * Math.PI)) / 2;
    g.arc(c, c, R, -a, -b, Math.cos(middle) * u[0] + Math.sin(middle) * u[1] > Math.cos(s));
    return R * Math.sin(s);
  }

  turn(dx, dy) {
    const c = Math.cos(dx), s = Math.sin(dx), d = Math.cos(dy), e = Math.sin(dy);
    const aroundY = [c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1], aroundX = [1, 0, 0, 0, 0, d, -e, 0, 0, e, d, 0, 0, 0, 0, 1];
    this.lorentz = matrixProduct(aroundX, matrixProduct(aroundY, this.lorentz));
  }

  boost(u, rapidity) { this.lorentz = matrixProduct(boostAlong(u, rapidity), this.lorentz); }

  drag(from, to, isShift) {
    const d = [to[0] - from[0], to[1] - from[1], 0], length = norm(d);
    if (!length) return;
    if (isShift) this.boost(scaled(d, 1 / length), 1.2 * length); else this.turn(d[0], -d[1]);
  }

  // Zooms by a Moebius transformation that fixes the point under the pointer.
  zoom([x, y], amount) { this.boost(this.isFlat ? this.flatPoint(x / FLAT, y / FLAT) : this.ballPoint(x, y), -amount); }

  flatPoint(x, y) {
    const n = x * x + y * y;
    return [(2 * x) / (1 + n), (2 * y) / (1 + n), (1 - n) / (1 + n)];
  }

  ballPoint(x, y) {
    const n = Math.hypot(x, y);
    return n < 1 ? [x, y, Math.sqrt(1 - n * n)] : [x / n, y / n, 0];
  }

  // Rotates a moved point to the center.
  center([x, y, z]) { this.turn(-Math.atan2(x, z), Math.atan2(y, Math.hypot(x, z))); }
}
