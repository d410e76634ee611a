import { readBlock } from '../../../Core/Pages/scripts/bytes.mjs';
import { clamp, cross, distance, dot, norm, sub, third, unit } from '../../../Core/Pages/scripts/math.mjs';
import { Details, vertexNormals } from './details.mjs';
import { pause } from '../../../Core/Pages/scripts/page.mjs';
import { hitOf, normalOf, Tree } from './tree.mjs';
import { Volume } from './volume.mjs';

const segmentNames = ['', 'rectum', 'sigmoid', 'descending', 'transverse', 'ascending', 'cecum'];
const hindranceNames = ['', 'no lumen', 'cut by the scan', 'untagged fluid', 'caliber below 10 mm'];
const BRIDGED = 64, CAP = 128; // CAP: over a pouch that was cut off
const NO_LUMEN = 1;       // of hindranceNames
const COATED = 5, AT_SEAM = 6; // in place of a hindrance: visible wall with tagged residue, or at a seam of cleansing
const COLLAPSED = 2.5;    // mm, radius below which a flight hurries
const TOUCH = 1.5;        // mm before a point where the wall does not hide it

const BLOCKS = ['points', 'uv', 'arc', 'source', 'faces', 'kinds', 'folds', 'relief', 'centerline'];

// v modulo c, in [0, c).
const turn = (v, c) => v - c * Math.floor(v / c);

// One position of a patient: the wall with its flat map, the centerline, the volume, and the mappings between them.
export class Exam {
  // Begins to read the blocks that load() uses.
  startReading(folder, prefix, info) {
    Object.assign(this, { folder, prefix, info, circumference: info.circumference, volume: null });
    this.blocks = [...BLOCKS, ...Details.blocks].map((name) => this.read(name));
    for (const block of this.blocks) block.catch(() => {}); // reported by load()
    return this;
  }

  read(name) { return readBlock(this.folder, this.prefix + name); }

  async load(painter) {
    const { info } = this, blocks = await Promise.all(this.blocks);
    BLOCKS.forEach((name, i) => { this[name] = blocks[i]; });
    Object.assign(this, { painter, blocks: null });
    this.center = [];
    for (let i = 0; i < this.centerline.length; i += 6) {
      const [x, y, z, arc, radius, hindrance] = this.centerline.subarray(i, i + 6);
      this.center.push({ xyz: [x, y, z], arc, radius, hindrance: Math.round(hindrance) });
    }
    this.orient();
    this.wall = new Tree(this.points, this.faces);
    await pause();
    this.details = new Details(...blocks.slice(BLOCKS.length), painter);
    this.wall.skip = this.replacedFaces();
    this.makeMap();
    await pause();
    this.normals = vertexNormals(this.points, this.faces, (i) => this.source[i]);
    for (const c of info.candidates) this.placeCandidate(c);
    this.valve = info.valve ? { xyz: info.valve, uv: this.fromXyz(info.valve, false).uv } : null;
    this.colors = new Uint8Array((4 * this.points.length) / 3);
    if (painter.gl) this.mesh = painter.mesh(this.points, this.normals, this.colors, this.faces);
    return this;
  }

  // The crosshair of a candidate is the center of its head, behind the wall; `depth` is the radius of the head.
  placeCandidate(c) {
    c.xyz = [c.x, c.y, c.z];
    const wall = (c.u !== null && this.fromUv(c.u, c.v)) || this.fromXyz(c.xyz, false);
    const depth = Math.max(c.diameter, c.height) / 2;
    const arc = c.arcLength ?? wall.arc; // as in the report
    c.place = { ...wall, arc, xyz: c.xyz, off: distance(c.xyz, wall.wall), depth, candidate: c };
    c.uv = wall.uv;
  }

  async readVolume() {
    const [data, coarse] = await Promise.all(['volume', 'volumeCoarse'].map((name) => this.read(name)));
    const volume = new Volume(data, coarse);
    if (volume.hasCleansed) volume.setChanges(...await Promise.all(['volumeCleansedAt', 'volumeCleansed'].map((name) => this.read(name))));
    return volume;
  }

  makeMap() {
    const n = this.uv.length / 2, flat = new Float64Array(3 * n);
    let lo = Infinity, hi = -Infinity;
    for (let i = 0; i < n; i++) {
      const u = this.uv[2 * i];
      flat[3 * i] = u;
      flat[3 * i + 1] = this.uv[2 * i + 1];
      if (u < lo) lo = u;
      if (u > hi) hi = u;
    }
    this.range = [lo, hi];
    this.map = new Tree(flat, this.faces);
    this.faceOfPixel = this.rasterize();
  }

  // The face under each pixel of the relief, or -1.
  rasterize() {
    const { uv, faces: F, info: { relief: r } } = this, out = new Int32Array(r.columns * r.rows).fill(-1);
    const x = [0, 0, 0], y = [0, 0, 0];
    for (let f = 0; f < F.length / 3; f++) {
      for (let k = 0; k < 3; k++) {
        x[k] = (uv[2 * F[3 * f + k]] - r.u) / r.step;
        y[k] = ((uv[2 * F[3 * f + k] + 1] - r.v) * r.vSign) / r.step;
      }
      const area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
      const left = Math.max(0, Math.ceil(Math.min(...x))), right = Math.min(r.columns - 1, Math.floor(Math.max(...x)));
      for (let j = Math.ceil(Math.min(...y)); j <= Math.max(...y); j++) {
        for (let i = left; i <= right; i++) {
          const a = ((x[1] - i) * (y[2] - j) - (x[2] - i) * (y[1] - j)) / area;
          const b = ((x[2] - i) * (y[0] - j) - (x[0] - i) * (y[2] - j)) / area;
          if (a >= 0 && b >= 0 && a + b <= 1) out[turn(j, r.rows) * r.columns + i] = f;
        }
      }
    }
    return out;
  }

  // Faces of the flat wall that the details replace.
  replacedFaces() {
    const { faces: F, details: { replaced } } = this;
    const out = new Uint8Array(F.length / 3);
    for (let f = 0; f < out.length; f++) out[f] = replaced[F[3 * f]] & replaced[F[3 * f + 1]] & replaced[F[3 * f + 2]];
    return out;
  }

  // Direction and up vector at each point of the centerline; the up vector is parallel transported, so the view does not spin.
  orient() {
    const c = this.center, reach = 4;
    let up = [0, 0, 1];
    c.forEach((p, i) => {
      p.ahead = unit(sub(c[Math.min(c.length - 1, i + reach)].xyz, c[Math.max(0, i - reach)].xyz));
      up = sub(up, p.ahead.map((x) => x * dot(up, p.ahead)));
      up = norm(up) < 1e-3 ? unit(cross(p.ahead, [1, 0, 0])) : unit(up);
      p.up = up;
    });
  }

  // Index of the centerline point at a given distance along the line.
  centerAt(arc) {
    const c = this.center;
    let lo = 0, hi = c.length - 1;
    while (hi - lo > 1) {
      const middle = (lo + hi) >> 1;
      if (c[middle].arc < arc) lo = middle; else hi = middle;
    }
    return arc - c[lo].arc < c[hi].arc - arc ? lo : hi;
  }

  // Number of faces before a given distance; faces are sorted by distance along the colon.
  facesBefore(arc) {
    let lo = 0, hi = this.faces.length / 3;
    while (lo < hi) {
      const middle = (lo + hi) >> 1;
      if (this.arc[this.faces[3 * middle]] < arc) lo = middle + 1; else hi = middle;
    }
    return lo;
  }

  mix(array, n, face, w) {
    const F = this.faces, out = [];
    for (let k = 0; k < n; k++) {
      out.push(w[0] * array[n * F[3 * face] + k] + w[1] * array[n * F[3 * face + 1] + k] + w[2] * array[n * F[3 * face + 2] + k]);
    }
    return out;
  }

  segmentOf(face) { return this.kinds[face] & 7; }
  stateOf(face) { return (this.kinds[face] >> 3) & 7; }
  hindranceOf(face) { return this.stateOf(face) < COATED ? this.stateOf(face) : 0; }
  isCoated(face) { return this.stateOf(face) === COATED; }
  isSeam(face) { return this.stateOf(face) === AT_SEAM; }
  isSynthetic(face) { return this.kinds[face] >= BRIDGED; } // bridged, or the cap of a pouch
  nameOfSegment(face) { return segmentNames[this.segmentOf(face)] || ''; }

  // Whether there is little to see around a point of the centerline.
  isCollapsed(c) { return c.hindrance === NO_LUMEN || c.radius < COLLAPSED; }

  // All properties of a point of the wall; xyz if the point is off the wall.
  place(face, weights, xyz = null) {
    const wall = this.mix(this.points, 3, face, weights);
    const [u, v] = this.mix(this.uv, 2, face, weights), [arc] = this.mix(this.arc, 1, face, weights);
    return { xyz: xyz || wall, wall, uv: [u, v], arc, face, weights, off: xyz ? distance(xyz, wall) : 0 };
  }

  fromXyz(p, keep = true) {
    const { face, weights } = this.wall.nearest(p);
    return this.place(face, weights, keep ? p : null);
  }

  fromUv(u, v) {
    const hit = hitOf(this.map, this.circumference, [u, v]);
    return hit && this.place(hit.face, hit.weights);
  }

  // Clamps beyond the ends of the map.
  nearestUv(u, v) {
    const c = this.circumference, found = [0, -1, 1].map((k) => this.map.nearest([u, turn(v, c) + k * c, 0]));
    const { face, weights } = found.reduce((a, b) => (b.squared < a.squared ? b : a));
    return this.place(face, weights);
  }

  // Where a ray meets the wall as drawn; on details, the place is the nearest one of the flat wall.
  fromRay(eye, d) {
    const flat = this.wall.ray(eye, d, Infinity, false, this.wall.skip), hit = this.details.tree.ray(eye, d, flat ? flat.t : Infinity);
    if (hit) return this.fromXyz(eye.map((x, k) => x + hit.t * d[k]));
    return flat && this.place(flat.face, flat.weights);
  }

  // Whether the wall occludes a point from an eye. depth: mm of the point behind its own surface.
  hidden(eye, p, depth = 0) {
    const d = sub(p, eye);
    const l = norm(d) - Math.max(TOUCH, depth), ahead = unit(d);
    return (this.wall.ray(eye, ahead, l, true, this.wall.skip) || this.details.tree.ray(eye, ahead, l, true)) !== null;
  }

  // Best view of a point of the wall: {index of the centerline, eye}. If eye is null, the view is from the centerline, unoccluded,
  // close to perpendicular, about 25 mm away. If no such point exists, for example behind a fold, the eye is in front of the wall.
  viewpoint(place) {
    const mid = this.centerAt(place.arc), n = this.inward(place.face), reach = 60;
    let best = { score: -Infinity, index: mid };
    for (let i = Math.max(0, mid - reach); i <= Math.min(this.center.length - 1, mid + reach); i += 3) {
      const c = this.center[i], d = sub(place.xyz, c.xyz), l = norm(d);
      const score = Math.abs(dot(d, n)) / (l || 1) - Math.abs(l - 25) / 25;
      if (score > best.score && !this.hidden(c.xyz, place.wall)) best = { score, index: i };
    }
    return { index: best.index, eye: best.score > -Infinity ? null : this.before(place, n) };
  }

  // Halfway from a point to the opposite wall, at most 15 mm.
  before(place, n) {
    const hit = this.wall.ray(place.wall.map((x, k) => x + 0.01 * n[k]), n, 30);
    return place.wall.map((x, k) => x + (hit ? hit.t / 2 : 15) * n[k]);
  }

  // Normal of a face, into the lumen.
  inward(face) {
    const side = this.orientation();
    return normalOf(this.points, this.faces, face).map((x) => side * x);
  }

  // 1 if normals point into the lumen, else -1. All faces have the same orientation, with the centerline in front of most of them.
  orientation() {
    if (!this.side) {
      const { points: P, faces: F, center } = this;
      let sum = 0;
      for (let f = 0; f < F.length / 3; f += 50) {
        const p = third(P, F[3 * f]), c = center[this.centerAt(this.arc[F[3 * f]])].xyz;
        sum += Math.sign(dot(normalOf(P, F, f), sub(c, p)));
      }
      this.side = Math.sign(sum) || 1;
    }
    return this.side;
  }

  // LPS to millimeters along the image axes from the center of the first voxel, and back.
  toImage(p) { const d = sub(p, this.volume.origin); return this.volume.axes.map((a) => dot(d, a)); }
  fromImage(q) { return this.volume.origin.map((o, k) => o + this.volume.axes.reduce((s, a, j) => s + q[j] * a[k], 0)); }

  // {hu, isMean} of the voxel that contains a point, or null outside.
  voxelAt(p) {
    const v = this.volume;
    if (!v) return null;
    const [i, j, k] = this.toImage(p).map((x, axis) => Math.round(x / v.spacing[axis])), [nx, ny, nz] = v.size;
    if (i < 0 || j < 0 || k < 0 || i >= nx || j >= ny || k >= nz) return null;
    const block = [i, j, k].map((x) => Math.floor(x / v.side));
    const isMean = v.coarse[block[0] + v.blocks[0] * (block[1] + v.blocks[1] * block[2])] === 1;
    return { hu: v.huOf(v.data[i + nx * (j + ny * k)]), isMean };
  }

  // Description of a position for the status line.
  describe(place) {
    const voxel = this.voxelAt(place.xyz), fold = this.folds[place.face], out = [];
    if (voxel && this.volume.isCt) out.push(`${Math.round(voxel.hu)} HU${voxel.isMean ? ' (mean of 4×4×4)' : ''}`);
    out.push(`${place.xyz.map((x) => x.toFixed(1)).join(', ')} mm (LPS)`, `${(place.arc / 10).toFixed(1)} cm from the anal verge`);
    out.push(this.nameOfSegment(place.face) || 'segment unknown');
    if (fold) out.push(`fold ${fold}`);
    if (place.off > 5) out.push(`${place.off.toFixed(0)} mm off the wall`);
    const hindrance = hindranceNames[clamp(this.hindranceOf(place.face), 0, 4)];
    if (hindrance) out.push(`stretch not fully evaluable: ${hindrance}`);
    if (this.isCoated(place.face)) out.push('tagged residue on the wall');
    if (this.isSeam(place.face)) out.push('seam of cleansing at a fluid level: not evaluable');
    if (this.kinds[place.face] >= CAP) out.push('wall that the unfolded view does not show');
    else if (this.isSynthetic(place.face)) out.push('interpolated wall (no CT data)');
    return out.join(' · ');
  }
}
