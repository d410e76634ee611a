import { cross, sub, third, unit } from '../../../Core/Pages/scripts/math.mjs';
import { Tree } from './tree.mjs';

// Area-weighted normals of the vertices, as bytes. source: vertices with the same source share one.
export function vertexNormals(points, faces, source) {
  const n = points.length / 3, sum = new Float32Array(points.length), normals = new Int8Array(4 * n);
  for (let f = 0; f < faces.length; f += 3) {
    const a = third(points, faces[f]), c = cross(sub(third(points, faces[f + 1]), a), sub(third(points, faces[f + 2]), a));
    for (let j = 0; j < 3; j++) for (let k = 0; k < 3; k++) sum[3 * source(faces[f + j]) + k] += c[k];
  }
  for (let i = 0; i < n; i++) {
    const u = unit(third(sum, source(i)));
    for (let k = 0; k < 3; k++) normals[4 * i + k] = Math.round(127 * u[k]);
  }
  return normals;
}

// The wall at full resolution around candidates and in pouches that were cut off, where it replaces the flat wall in 3D and on
// slices. replaced: 1 for vertices of the flat wall.
export class Details {
  static blocks = ['detailPoints', 'detailFaces', 'replaced'];

  constructor(points, faces, replaced, painter) {
    Object.assign(this, { points, faces, replaced, tree: new Tree(points, faces), orientation: () => -1 }); // normals point outward
    this.normals = vertexNormals(points, faces, (i) => i);
    this.colors = new Uint8Array((4 * points.length) / 3).fill(255);
    if (painter.gl) this.mesh = painter.mesh(points, this.normals, this.colors, faces);
  }
}
