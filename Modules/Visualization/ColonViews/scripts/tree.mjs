import { cross, dot, sub, third } from '../../../Core/Pages/scripts/math.mjs';

const LEAF = 4; // triangles

// A bounding volume hierarchy of triangles, for first ray hits and nearest surface points.
export class Tree {
  constructor(points, faces) {
    const n = faces.length / 3;
    this.points = points;
    this.faces = faces;
    this.order = Uint32Array.from({ length: n }, (_, i) => i);
    this.middles = this.middlesOf(n); // in the order of `order`
    const most = Math.max(1, 2 * n);
    this.box = new points.constructor(6 * most); // minimum and maximum corner; same precision as the points
    this.first = new Int32Array(most);     // leaf: its first triangle; else ~(left child), followed by the right child
    this.count = new Int32Array(most);     // 0: inner node
    this.build(n);
    this.middles = null;
  }

  middlesOf(n) {
    const { points: P, faces: F } = this;
    const middles = new Float32Array(3 * n);
    for (let i = 0; i < n; i++) {
      for (let k = 0; k < 3; k++) middles[3 * i + k] = (P[3 * F[3 * i] + k] + P[3 * F[3 * i + 1] + k] + P[3 * F[3 * i + 2] + k]) / 3;
    }
    return middles;
  }

  build(n) {
    let nodes = 1;
    const stack = [[0, 0, n]];
    while (stack.length) {
      const [node, from, to] = stack.pop();
      const middle = to - from > LEAF ? this.part(from, to) : from;
      if (middle === from || middle === to) {
        this.first[node] = from;
        this.count[node] = to - from;
      } else {
        this.first[node] = ~nodes;
        stack.push([nodes, from, middle], [nodes + 1, middle, to]);
        nodes += 2;
      }
    }
    for (let node = nodes - 1; node >= 0; node--) this.fit(node); // children come after their parent
  }

  // Sets the box of a node from its triangles or its children.
  fit(node) {
    const { points: P, faces: F, order, box, first, count } = this, begin = first[node], end = begin + count[node];
    for (let k = 0; k < 3; k++) {
      let lo = Infinity, hi = -Infinity;
      for (let i = begin; i < end; i++) {
        for (let f = 3 * order[i], j = f; j < f + 3; j++) {
          const x = P[3 * F[j] + k];
          if (x < lo) lo = x;
          if (x > hi) hi = x;
        }
      }
      if (begin < 0) {
        const a = 6 * ~begin + k, b = a + 6;
        lo = Math.min(box[a], box[b]);
        hi = Math.max(box[a + 3], box[b + 3]);
      }
      box[6 * node + k] = lo;
      box[6 * node + 3 + k] = hi;
    }
  }

  // Splits triangles at the middle of the largest spread of their centers; returns where the second part begins.
  part(from, to) {
    const { order, middles: M } = this;
    let axis = 0, at = 0, width = 0;
    for (let k = 0; k < 3; k++) {
      let least = Infinity, most = -Infinity;
      for (let i = 3 * from + k; i < 3 * to; i += 3) {
        const m = M[i];
        if (m < least) least = m;
        if (m > most) most = m;
      }
      if (most - least > width) { axis = k; at = (least + most) / 2; width = most - least; }
    }
    let i = from, j = width > 0 ? to : from;
    while (i < j) {
      if (M[3 * i + axis] < at) { i++; continue; }
      j--;
      const t = order[i]; order[i] = order[j]; order[j] = t;
      for (let k = 0; k < 3; k++) { const m = M[3 * i + k]; M[3 * i + k] = M[3 * j + k]; M[3 * j + k] = m; }
    }
    return i;
  }

  // First triangle hit by the ray from o in direction d before `far`, or null. any: any hit, which is faster.
  ray(o, d, far = Infinity, any = false, skip = null) {
    const inverse = d.map((x) => 1 / (Math.abs(x) < 1e-12 ? 1e-12 : x));
    const { first, count, order } = this;
    const stack = this.faces.length ? [0] : [];
    let best = null;
    while (stack.length) {
      const node = stack.pop();
      if (!this.meets(node, o, inverse, far)) continue;
      if (!count[node]) { const l = ~first[node]; stack.push(l, l + 1); continue; }
      for (let i = first[node]; i < first[node] + count[node]; i++) {
        if (skip !== null && skip[order[i]]) continue;
        const hit = this.hit(order[i], o, d, far);
        if (hit) { best = hit; far = hit.t; if (any) return best; }
      }
    }
    return best;
  }

  meets(node, o, inverse, far) {
    const { box } = this;
    let lo = 0, hi = far;
    for (let k = 0; k < 3; k++) {
      const x = (box[6 * node + k] - o[k]) * inverse[k], y = (box[6 * node + 3 + k] - o[k]) * inverse[k];
      if (x < y) { if (x > lo) lo = x; if (y < hi) hi = y; } else { if (y > lo) lo = y; if (x < hi) hi = x; }
    }
    return lo <= hi;
  }

  // Unrolled by coordinate for speed: a flight casts a million rays to find the seen areas.
  hit(f, o, d, far) {
    const { points: P, faces: F } = this;
    const a = 3 * F[3 * f], b = 3 * F[3 * f + 1], c = 3 * F[3 * f + 2];
    const ax = P[a], ay = P[a + 1], az = P[a + 2];
    const ex = P[b] - ax, ey = P[b + 1] - ay, ez = P[b + 2] - az, gx = P[c] - ax, gy = P[c + 1] - ay, gz = P[c + 2] - az;
    const hx = d[1] * gz - d[2] * gy, hy = d[2] * gx - d[0] * gz, hz = d[0] * gy - d[1] * gx;
    const det = ex * hx + ey * hy + ez * hz;
    if (Math.abs(det) < 1e-20) return null;
    const sx = o[0] - ax, sy = o[1] - ay, sz = o[2] - az, u = (sx * hx + sy * hy + sz * hz) / det;
    if (u < -1e-7 || u > 1 + 1e-7) return null;
    const qx = sy * ez - sz * ey, qy = sz * ex - sx * ez, qz = sx * ey - sy * ex;
    const v = (d[0] * qx + d[1] * qy + d[2] * qz) / det;
    if (v < -1e-7 || u + v > 1 + 1e-7) return null;
    const t = (gx * qx + gy * qy + gz * qz) / det;
    return t > 1e-6 && t < far ? { face: f, t, weights: [1 - u - v, u, v] } : null;
  }

  // {face, squared, weights} of the nearest surface point.
  nearest(p) {
    const { first, count, order } = this;
    const stack = [[0, 0]];
    let best = { face: -1, squared: Infinity, weights: null };
    while (stack.length) {
      const [node, gap] = stack.pop();
      if (gap >= best.squared) continue;
      if (!count[node]) {
        const l = ~first[node], a = this.gap(l, p), b = this.gap(l + 1, p);
        if (a < b) stack.push([l + 1, b], [l, a]); else stack.push([l, a], [l + 1, b]);
        continue;
      }
      for (let i = first[node]; i < first[node] + count[node]; i++) {
        const found = this.nearestOf(order[i], p);
        if (found.squared < best.squared) best = found;
      }
    }
    return best;
  }

  // Squared distance from a point to the box of a node.
  gap(node, p) {
    let sum = 0;
    for (let k = 0; k < 3; k++) {
      const b = 6 * node + k, x = Math.max(this.box[b] - p[k], 0, p[k] - this.box[b + 3]);
      sum += x * x;
    }
    return sum;
  }

  nearestOf(face, p) {
    const { points: P, faces: F } = this;
    const a = third(P, F[3 * face]), b = third(P, F[3 * face + 1]), c = third(P, F[3 * face + 2]);
    const weights = nearestWeights(p, a, b, c);
    let squared = 0;
    for (let k = 0; k < 3; k++) squared += (weights[0] * a[k] + weights[1] * b[k] + weights[2] * c[k] - p[k]) ** 2;
    return { face, squared, weights };
  }
}

// Barycentric weights of the point of a triangle nearest to p, found by the regions of corners, edges and inside
// (Ericson, Real-time collision detection, 5.1.5).
function nearestWeights(p, a, b, c) {
  const ab = sub(b, a), ac = sub(c, a), ap = sub(p, a), d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return [1, 0, 0];
  const bp = sub(p, b), d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return [0, 1, 0];
  const vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) { const t = d1 / (d1 - d3 || 1); return [1 - t, t, 0]; }
  const cp = sub(p, c), d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return [0, 0, 1];
  const vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) { const t = d2 / (d2 - d6 || 1); return [1 - t, 0, t]; }
  const va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) { const t = (d4 - d3) / (d4 - d3 + (d5 - d6) || 1); return [0, 1 - t, t]; }
  const sum = va + vb + vc || 1;
  return [va / sum, vb / sum, vc / sum];
}

// Unit normal of a face.
export function normalOf(points, faces, face) {
  const a = third(points, faces[3 * face]);
  const n = cross(sub(third(points, faces[3 * face + 1]), a), sub(third(points, faces[3 * face + 2]), a));
  const length = Math.hypot(...n) || 1;
  return n.map((x) => x / length);
}

// The face of a map of circumference c that contains (u, v), or null.
export function hitOf(tree, c, [u, v]) {
  const rest = v - c * Math.floor(v / c);
  for (const k of [0, -1, 1]) { // the cut is within one turn of v = 0
    const hit = tree.ray([u, rest + k * c, -1], [0, 0, 1]);
    if (hit) return hit;
  }
  return null;
}
