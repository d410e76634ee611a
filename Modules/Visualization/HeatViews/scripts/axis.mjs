import { binOf, lowerEdge, NUMBER_OF_BINS } from './lines.mjs';

// Fraction of the counts (without bin 0) below the lower edge of each bin, averaged over the rows.
export function equalization(counts) {
  const below = new Float64Array(NUMBER_OF_BINS + 1);
  for (let at = 0; at < counts.length; at += NUMBER_OF_BINS) {
    let total = 0;
    for (let bin = 1; bin < NUMBER_OF_BINS; bin++) total += counts[at + bin];
    if (total > 0) for (let bin = 1; bin < NUMBER_OF_BINS; bin++) below[bin + 1] += counts[at + bin] / total;
  }
  for (let bin = 1; bin <= NUMBER_OF_BINS; bin++) below[bin] += below[bin - 1];
  const total = below[NUMBER_OF_BINS];
  return below.map((x, bin) => (total > 0 ? x / total : bin / NUMBER_OF_BINS));
}

// From the first to the last bin with a count in any row, without the background.
export function rangeOfCounts(counts) {
  let first = NUMBER_OF_BINS, last = 0;
  for (let at = 0; at < counts.length; at += NUMBER_OF_BINS) {
    for (let bin = 1; bin < NUMBER_OF_BINS; bin++) {
      if (!counts[at + bin]) continue;
      first = Math.min(first, bin);
      last = Math.max(last, bin);
    }
  }
  return last === 0 ? [lowerEdge(1), 1] : [lowerEdge(first), lowerEdge(last + 1)];
}

// Position of a heat value on the axis of the histogram, from 0 to 1, as in HeatAxis: equalized inside the range, or
// linear.
export class HeatAxis {
  constructor(shares, isEqualized, [lower, upper]) {
    Object.assign(this, { shares, isEqualized, lower, upper });
    this.setEnds();
    if (this.high > this.low) return;
    this.shares = Float64Array.from({ length: NUMBER_OF_BINS + 1 }, (_, edge) => edge); // no counts in the range
    this.setEnds();
  }

  setEnds() {
    this.low = this.shareBelow(this.lower);
    this.high = this.shareBelow(this.upper);
  }

  shareBelow(heat) {
    const bin = binOf(heat), edge = lowerEdge(bin), within = Math.min(1, Math.max(0, (heat - edge) / (lowerEdge(bin + 1) - edge)));
    return this.shares[bin] + within * (this.shares[bin + 1] - this.shares[bin]);
  }

  positionOf(heat) {
    const equalized = (this.shareBelow(heat) - this.low) / (this.high - this.low), linear = (heat - this.lower) / (this.upper - this.lower);
    return Math.min(1, Math.max(0, this.isEqualized ? equalized : linear));
  }

  // Smallest heat at this position.
  heatAt(position) {
    const within = Math.min(1, Math.max(0, position));
    if (!this.isEqualized) return this.lower + within * (this.upper - this.lower);
    const share = this.low + within * (this.high - this.low);
    let first = 0, last = NUMBER_OF_BINS; // first edge with at least this fraction
    while (first < last) {
      const middle = (first + last) >> 1;
      if (this.shares[middle] < share) first = middle + 1; else last = middle;
    }
    if (first === 0) return this.lower;
    const below = this.shares[first - 1], inside = (share - below) / (this.shares[first] - below || 1), edge = lowerEdge(first - 1);
    return Math.min(this.upper, Math.max(this.lower, edge + inside * (lowerEdge(first) - edge)));
  }
}
