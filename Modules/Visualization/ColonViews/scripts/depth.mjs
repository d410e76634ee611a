import { distance, dot, third } from '../../../Core/Pages/scripts/math.mjs';

// Translucency: the tissue 2 to 6 mm behind the wall as color. The limits are those of PolypTissue in C++.
const DEPTHS = [2, 3, 4, 5, 6]; // mm
const RANGE = 60;               // mm around the crosshair
const OUTSIDE = [40, 42, 60];
export const tissues = [ // name, HU below which, color
  ['gas', -150, OUTSIDE], ['fat', -30, [60, 170, 70]], ['soft tissue', 150, [205, 50, 45]], ['tagged', Infinity, [250, 250, 250]],
];

// Colors a surface {points, normals, colors, orientation()} around a place.
export function paintDepth(exam, surface, place) {
  const { points: P, normals: N, colors: C } = surface, { volume: v } = exam;
  if (!v?.isCt) return;
  const colorOfCode = Array.from({ length: v.levels }, (_, code) => tissues.find(([, most]) => v.huOf(code) < most)[2]);
  const outward = -surface.orientation() / 127, [nx, ny, nz] = v.size;
  const colorAt = ([a, b, c], [da, db, dc], depth) => {
    const i = Math.round(a + depth * da), j = Math.round(b + depth * db), k = Math.round(c + depth * dc);
    const isInside = i >= 0 && j >= 0 && k >= 0 && i < nx && j < ny && k < nz;
    return isInside ? colorOfCode[v.data[i + nx * (j + ny * k)]] : OUTSIDE;
  };
  for (let i = 0; i < P.length / 3; i++) {
    if (Math.abs(P[3 * i] - place.xyz[0]) > RANGE || Math.abs(P[3 * i + 1] - place.xyz[1]) > RANGE) continue;
    const p = third(P, i);
    if (distance(p, place.xyz) > RANGE) continue;
    const n = [N[4 * i], N[4 * i + 1], N[4 * i + 2]], at = exam.toImage(p).map((x, k) => x / v.spacing[k]);
    const step = v.axes.map((a, k) => (outward * dot(a, n)) / v.spacing[k]), sum = [0, 0, 0];
    for (const depth of DEPTHS) {
      const color = colorAt(at, step, depth);
      for (let k = 0; k < 3; k++) sum[k] += color[k];
    }
    for (let k = 0; k < 3; k++) C[4 * i + k] = sum[k] / DEPTHS.length;
  }
}
