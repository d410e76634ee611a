import { lowerEdge, NUMBER_OF_BINS } from './lines.mjs';

// The line around a peak bin: both slopes, until the counts fall below a twentieth of the peak or rise again.
export function lineAround(counts, top) {
  const at = (i) => (counts[i - 1] + 2 * counts[i] + (counts[i + 1] ?? 0)) / 4; // single bins are noisy
  const least = at(top) / 20;
  const end = (direction) => {
    let bin = top, lowest = Infinity;
    for (let i = top + direction; i > 0 && i < NUMBER_OF_BINS; i += direction) {
      const count = at(i);
      if (count < least || count > 1.5 * lowest + 2) break;
      if (count <= lowest) bin = i;
      lowest = Math.min(lowest, count);
    }
    while (counts[bin] === 0) bin -= direction;
    return bin;
  };
  return [lowerEdge(end(-1)), lowerEdge(end(1) + 1)];
}

// The line drawn at a position of the axis, within `reach` (fraction of the axis); null if no voxel has such a value.
export function lineNear(counts, axis, position, reach) {
  let top = 0;
  for (let bin = 1; bin < NUMBER_OF_BINS; bin++) {
    if (counts[bin] <= (top ? counts[top] : 0)) continue;
    const left = axis.positionOf(lowerEdge(bin)), right = axis.positionOf(lowerEdge(bin + 1)), isIn = right > 0 && left < 1;
    if (isIn && left - reach <= position && position <= right + reach) top = bin;
  }
  return top ? lineAround(counts, top) : null;
}
