// Frames of the server: length of the header, header (JSON), arrays. See SessionFrame.

// The header and a function that takes the next array of a type and length.
export function readFrame(buffer) {
  const length = new DataView(buffer).getUint32(0, true), header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  let at = 4 + length;
  const take = (Type, count) => {
    const end = at + count * Type.BYTES_PER_ELEMENT, array = new Type(buffer.slice(at, end)); // a copy is aligned
    if (end > buffer.byteLength) throw new Error('The server has sent an incomplete frame.');
    at = end;
    return array;
  };
  return { header, take };
}

// The two axes of a slice, in the order of its array.
export const axesOfSlice = (through) => [0, 1, 2].filter((axis) => axis !== through);

// Grid of blocks of stride^3 voxels; its voxels are the centers of the blocks.
export function reducedVolume({ size, spacing, origin, axes }, stride) {
  const shift = (stride - 1) / 2;
  return {
    stride, axes,
    size: size.map((n) => Math.ceil(n / stride)),
    spacing: spacing.map((step) => step * stride),
    origin: origin.map((x, i) => x + axes.reduce((sum, axis, k) => sum + axis[i] * spacing[k] * shift, 0)),
  };
}

// Copies a brick, whose first voxel is given, into the bins of the volume.
export function placeBrick(bins, [nx, ny, nz], [x, y, z], length, take) {
  const [w, h, d] = [[nx, x], [ny, y], [nz, z]].map(([n, first]) => Math.min(length, n - first)), brick = take(Uint16Array, w * h * d);
  for (let k = 0, from = 0; k < d; k++) {
    for (let j = 0; j < h; j++, from += w) bins.set(brick.subarray(from, from + w), ((z + k) * ny + y + j) * nx + x);
  }
}

const MOST_ROWS = 64;

// Adds a row to the rows of a histogram; every second one is dropped if there are many. A repeated step replaces its row.
export function withRow(rows, row) {
  const kept = rows.filter(({ step }) => step < row.step), all = [...kept, row];
  return all.length > MOST_ROWS ? all.filter((_, i) => i % 2 === (all.length - 1) % 2) : all;
}
