import { paintDepth } from './depth.mjs';

// Layers that can be shown or hidden. Colors by Okabe and Ito, which are safe for color-blind readers.
export const layerList = [
  ['candidates', 'candidates', true],
  ['folds', 'folds', false],
  ['taeniae', 'taeniae', true],
  ['flexures', 'flexures', true],
  ['segments', 'segments', false],
  ['centerline', 'centerline, if transparent', true],
  ['hindered', 'not evaluable', true],
  ['coated', 'tagged residue', true],
  ['seams', 'seams of cleansing', true],
  ['trust', 'confidence of the map', false],
  ['unseen', 'areas not seen', false],
  ['wall', 'wall on slices', true],
  ['through', 'transparent wall', false],
];

export const taeniaColors = [[230, 159, 0], [86, 180, 233], [204, 121, 167]];
export const segmentColors = [ // unknown, rectum, sigmoid, ...
  [170, 170, 170], [204, 121, 167], [213, 94, 0], [240, 228, 66], [0, 158, 115], [86, 180, 233], [0, 114, 178],
];
export const flexureColor = [20, 20, 60];
export const centerlineColor = [213, 94, 0];
const FOLD = [0, 158, 115], HINDERED = [130, 130, 140], MADE_UP = [190, 190, 190], UNSEEN = [90, 60, 170], DOUBT = [40, 40, 110];
const RESIDUE = [240, 228, 66], SEAM = [0, 114, 178];

// Color and opacity of a face from the layers, or null; later layers are on top.
function faceColor(exam, layers, face) {
  const { trust, seen } = exam;
  if (exam.isSynthetic(face)) return [MADE_UP, 0.9];
  if (layers.unseen && seen && !seen.marks[face]) return [UNSEEN, 0.75];
  if (layers.hindered && exam.hindranceOf(face)) return [HINDERED, 0.75];
  if (layers.coated && exam.isCoated(face)) return [RESIDUE, 0.7];
  if (layers.seams && exam.isSeam(face)) return [SEAM, 0.35];
  if (layers.trust && trust) {
    const t = trust[exam.faces[3 * face]];
    return t > 200 ? [HINDERED, 0.85] : [DOUBT, 0.8 * (1 - t / 200)];
  }
  if (layers.folds && exam.folds[face]) return [FOLD, 0.6];
  if (layers.segments) return [segmentColors[exam.segmentOf(face)], 0.55];
  return null;
}

const WALL = [226, 160, 142];

// Vertex colors for the views in space. translucent: where the tissue behind the wall is shown, or null.
export function paintWall(exam, layers, translucent) {
  const { faces: F, kinds, colors: C, details } = exam;
  for (let i = 0; i < C.length; i += 4) { C[i] = WALL[0]; C[i + 1] = WALL[1]; C[i + 2] = WALL[2]; C[i + 3] = 255; }
  for (let i = 0; i < details.replaced.length; i++) if (details.replaced[i]) C[4 * i + 3] = 0;
  for (let i = 0; i < details.colors.length; i++) details.colors[i] = i % 4 === 3 ? 255 : WALL[i % 4];
  for (let f = 0; f < kinds.length; f++) {
    const layer = faceColor(exam, layers, f);
    if (!layer) continue;
    const [color, opacity] = layer;
    for (let j = 0; j < 3; j++) for (let k = 0; k < 3; k++) C[4 * F[3 * f + j] + k] = WALL[k] + opacity * (color[k] - WALL[k]);
  }
  if (translucent) for (const surface of [exam, details]) paintDepth(exam, surface, translucent);
  for (const { mesh, colors } of [exam, details]) if (mesh) exam.painter.recolor(mesh, colors);
}

// The layers as an overlay image of the flat wall.
export function paintFlat(exam, layers, image) {
  const { faceOfPixel, folds, info: { relief: { columns } } } = exam, words = new Uint32Array(image.data.buffer);
  const foldAt = (i) => (faceOfPixel[i] < 0 ? 0 : folds[faceOfPixel[i]]);
  const areas = { ...layers, folds: false }; // folds are drawn as outlines here
  for (let i = 0; i < faceOfPixel.length; i++) {
    const face = faceOfPixel[i], layer = face < 0 ? null : faceColor(exam, areas, face);
    words[i] = layer ? packed(...layer) : 0;
    if (layers.folds && foldAt(i) && (foldAt(i - 1) !== foldAt(i) || foldAt(i - columns) !== foldAt(i))) words[i] = packed(FOLD, 1);
  }
}

const packed = ([r, g, b], opacity) => ((Math.round(255 * opacity) << 24) | (b << 16) | (g << 8) | r) >>> 0;
