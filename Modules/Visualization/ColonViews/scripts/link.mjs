import { distance, third } from '../../../Core/Pages/scripts/math.mjs';
import { hitOf, Tree } from './tree.mjs';

// Faces of a position on the map of the other one. Triangles do not share vertices, because faces may cross the cut of that map.
// uv: vertex coordinates on the other map, of circumference c.
function imageOf({ faces }, uv, c) {
  const points = new Float64Array(3 * faces.length);
  for (let i = 0; i < faces.length; i++) {
    const v = uv[2 * faces[i] + 1], first = uv[2 * faces[i - (i % 3)] + 1];
    points[3 * i] = uv[2 * faces[i]];
    points[3 * i + 1] = v - c * Math.round((v - first) / c);
  }
  return new Tree(points, Uint32Array.from({ length: faces.length }, (_, i) => i));
}

// Longest edge of the faces of a tree.
function sizeOf({ points, faces }, face) {
  const [a, b, c] = [0, 1, 2].map((k) => third(points, faces[3 * face + k]));
  return Math.max(distance(a, b), distance(b, c), distance(c, a));
}

// Mappings between two positions. mapped: (u, v) of each vertex on the flat map of the other position. Between vertices (u, v)
// is interpolated, because a straight line in space would leave the wall. Where the forward map stretches the faces more than
// the backward map, the inverse of the latter is used, because it has more vertices.
export class Link {
  constructor(exams, mapped) {
    Object.assign(this, { exams, images: exams.map((exam, k) => imageOf(exam, mapped[k], exams[1 - k].circumference)) });
  }

  stretch(k, face) { return sizeOf(this.images[k], face) / sizeOf(this.exams[k].map, face); }

  // Maps a point of position k to the other position.
  from(k, { face, weights, uv }) {
    const other = this.exams[1 - k], back = hitOf(this.images[1 - k], this.exams[k].circumference, uv);
    if (back && this.stretch(1 - k, back.face) < this.stretch(k, face)) return other.place(back.face, back.weights);
    const { points } = this.images[k], at = 9 * face;
    const [u, v] = [at, at + 1].map((i) => weights.reduce((sum, w, j) => sum + w * points[i + 3 * j], 0));
    return other.fromUv(u, v) || other.nearestUv(u, v);
  }
}
