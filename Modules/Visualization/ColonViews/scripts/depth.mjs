import { distance, third } from '../../../Core/Report/scripts/math.mjs';

// Translucency: the tissue 2 to 6 mm behind the wall as color. The limits are those of PolypTissue in C++.
const DEPTHS = [2, 3, 4, 5, 6]; // mm
const RANGE = 50;               // mm around the crosshair
export const tissues = [ // name, HU below which, color
  ['gas', -150, [40, 42, 60]], ['fat', -30, [60, 170, 70]], ['soft tissue', 150, [205, 50, 45]], ['tagged', Infinity, [250, 250, 250]],
];

const colorOf = (hu) => tissues.find(([, most]) => hu < most)[2];

// Colors the wall around a place.
export function paintDepth(exam, place) {
  const { points: P, normals: N, colors: C, volume } = exam;
  if (!volume?.isCt) return;
  const outward = -exam.orientation() / 127;
  for (let i = 0; i < P.length / 3; i++) {
    const p = third(P, i);
    if (Math.abs(p[0] - place.xyz[0]) > RANGE || distance(p, place.xyz) > RANGE) continue;
    const sum = [0, 0, 0];
    for (const depth of DEPTHS) {
      const voxel = exam.voxelAt(p.map((x, k) => x + outward * depth * N[4 * i + k])), color = colorOf(voxel ? voxel.hu : -Infinity);
      for (let k = 0; k < 3; k++) sum[k] += color[k];
    }
    for (let k = 0; k < 3; k++) C[4 * i + k] = sum[k] / DEPTHS.length;
  }
}
