import { distance, dot, sub, third } from '../../../Core/Pages/scripts/math.mjs';

const PLACES = [1 / 6, 1 / 2, 5 / 6]; // points on each edge that an initial path may pass
const SWEEPS = 300;

// Shortest paths on a cut surface: points with the same source are identified. First the shortest path through three points on each
// edge (Lanthier et al. 2001), then the crossings slide along their edges until the path is straight across each triangle pair.
export class SurfacePaths {
  constructor({ points, faces, source }) {
    const n = faces.length;
    Object.assign(this, { points, faces, edgeOf: new Int32Array(n) }); // edge from the corner to the next one
    this.ends = new Uint32Array(2 * n);             // two points per edge
    this.sides = new Int32Array(2 * n).fill(-1);    // one or two faces per edge
    const head = new Int32Array(points.length / 3).fill(-1), next = new Int32Array(n); // linked lists of the edges of a point
    let count = 0;
    for (let i = 0; i < n; i++) {
      const a = faces[i], b = faces[i % 3 === 2 ? i - 2 : i + 1], isUp = source[a] < source[b], [lo, hi] = isUp ? [a, b] : [b, a];
      let edge = head[source[lo]];
      while (edge >= 0 && source[this.ends[2 * edge + 1]] !== source[hi]) edge = next[edge];
      if (edge < 0) {
        edge = count++;
        next[edge] = head[source[lo]];
        head[source[lo]] = edge;
        this.ends.set([lo, hi], 2 * edge);
      }
      this.edgeOf[i] = edge;
      this.sides[2 * edge + (this.sides[2 * edge] < 0 ? 0 : 1)] = (i / 3) | 0;
    }
  }

  at(edge, t) {
    const a = third(this.points, this.ends[2 * edge]), b = third(this.points, this.ends[2 * edge + 1]);
    return a.map((x, k) => x + t * (b[k] - x));
  }

  // {length, line} of the path between two positions {face, wall}, or null if longer than `limit` mm.
  between(from, to, limit = 1000) {
    if (from.face === to.face) return { length: distance(from.wall, to.wall), line: [from.wall, to.wall] };
    const edges = this.search(from, to, limit);
    return edges && this.straighten(from.wall, edges, to.wall);
  }

  // Crossings {edge, t} of the shortest path through PLACES: A* with the straight distance as lower bound.
  search(from, to, limit) {
    const queue = new Queue(), best = new Map(), before = new Map(), done = new Set(), END = -1;
    const offer = (node, g, place, previous) => {
      if (g >= (best.get(node) ?? Infinity)) return;
      best.set(node, g);
      before.set(node, previous);
      queue.push(g + distance(place, to.wall), node);
    };
    const reach = (face, place, g, previous, own) => {
      if (face === to.face) offer(END, g + distance(place, to.wall), to.wall, previous);
      for (let k = 0; k < 3; k++) {
        const edge = this.edgeOf[3 * face + k];
        if (edge === own) continue;
        PLACES.forEach((t, i) => {
          const p = this.at(edge, t);
          offer(3 * edge + i, g + distance(place, p), p, previous);
        });
      }
    };
    reach(from.face, from.wall, 0, null, -1);
    while (queue.size) {
      const node = queue.pop();
      if (done.has(node)) continue;
      done.add(node);
      if (node === END) return this.trace(before, END);
      const g = best.get(node), edge = Math.floor(node / 3);
      if (g > limit) return null;
      const place = this.at(edge, PLACES[node % 3]);
      for (const face of this.sides.subarray(2 * edge, 2 * edge + 2)) if (face >= 0) reach(face, place, g, node, edge);
    }
    return null;
  }

  trace(before, end) {
    const crossings = [];
    for (let node = before.get(end); node !== null; node = before.get(node)) {
      crossings.push({ edge: Math.floor(node / 3), t: PLACES[node % 3] });
    }
    return crossings.reverse();
  }

  // The length is convex in the positions of the crossings, so sliding them one at a time converges to the minimum.
  straighten(start, crossings, end) {
    const line = [start, ...crossings.map((c) => this.at(c.edge, c.t)), end];
    for (let sweep = 0; sweep < SWEEPS; sweep++) {
      let moved = 0;
      for (let i = 1; i < line.length - 1; i++) {
        const p = this.slide(crossings[i - 1].edge, line[i - 1], line[i + 1]);
        moved = Math.max(moved, distance(p, line[i]));
        line[i] = p;
      }
      if (moved < 1e-4) break;
    }
    let length = 0;
    for (let i = 1; i < line.length; i++) length += distance(line[i - 1], line[i]);
    return { length, line };
  }

  // Where the straight line from p to q crosses an edge after unfolding its two triangles into a plane.
  slide(edge, p, q) {
    const a = third(this.points, this.ends[2 * edge]), e = sub(third(this.points, this.ends[2 * edge + 1]), a), ee = dot(e, e) || 1;
    const s = dot(sub(p, a), e) / ee, t = dot(sub(q, a), e) / ee;
    const ds = distance(p, a.map((x, k) => x + s * e[k])), dt = distance(q, a.map((x, k) => x + t * e[k]));
    const share = ds + dt > 1e-9 ? ds / (ds + dt) : 0.5;
    const place = Math.min(1, Math.max(0, s + share * (t - s)));
    return a.map((x, k) => x + place * e[k]);
  }
}

// A binary heap: pop() returns the value with the smallest key.
class Queue {
  constructor() { this.keys = []; this.values = []; }
  get size() { return this.keys.length; }

  push(key, value) {
    const { keys, values } = this;
    let i = keys.length;
    for (; i > 0; i = (i - 1) >> 1) {
      const parent = (i - 1) >> 1;
      if (keys[parent] <= key) break;
      keys[i] = keys[parent];
      values[i] = values[parent];
    }
    keys[i] = key;
    values[i] = value;
  }

  pop() {
    const { keys, values } = this, top = values[0], key = keys.pop(), value = values.pop(), n = keys.length;
    if (!n) return top;
    let i = 0;
    for (;;) {
      let child = 2 * i + 1;
      if (child >= n) break;
      if (child + 1 < n && keys[child + 1] < keys[child]) child++;
      if (keys[child] >= key) break;
      keys[i] = keys[child];
      values[i] = values[child];
      i = child;
    }
    keys[i] = key;
    values[i] = value;
    return top;
  }
}
