// Lines of a heat histogram as a transfer function: {lower, upper, color '#rrggbb', opacity, isOn}. A line contains the voxels with
// lower <= heat < upper. Bins as in HeatHistogram.
const BINS_PER_OCTAVE = 256, OCTAVES = 16;
export const NUMBER_OF_BINS = BINS_PER_OCTAVE * OCTAVES + 1;
export const MOST_LINES = 12; // limit of 3D Slicer

// Lower edge of a bin; exact, because it is an integer fraction of a power of two.
export function lowerEdge(bin) {
  if (bin === 0) return 0;
  return (1 + ((bin - 1) % BINS_PER_OCTAVE) / BINS_PER_OCTAVE) * 2 ** (Math.floor((bin - 1) / BINS_PER_OCTAVE) - OCTAVES);
}

export function binOf(heat) {
  if (!(heat >= 2 ** -OCTAVES)) return 0;
  let octave = Math.floor(Math.log2(heat));
  if (2 ** octave > heat) octave--; // corrects rounding of log2
  const within = Math.floor((heat / 2 ** octave - 1) * BINS_PER_OCTAVE);
  return Math.min(NUMBER_OF_BINS - 1, 1 + (octave + OCTAVES) * BINS_PER_OCTAVE + within);
}

export const channelsOf = (color) => [1, 3, 5].map((k) => parseInt(color.slice(k, k + 2), 16));

// Premultiplied color and opacity as the bytes of a word.
export function premultiplied({ color, opacity }) {
  const [r, g, b, a] = [...channelsOf(color).map((c) => Math.round(c * opacity)), Math.round(255 * opacity)];
  return ((a << 24) | (b << 16) | (g << 8) | r) >>> 0;
}

// Line number of each bin, counted from 1; 0 for none, and for lines that are off or transparent.
export function linesOfBins(lines) {
  const out = new Uint8Array(NUMBER_OF_BINS);
  lines.forEach((line, i) => {
    if (!line.isOn || line.opacity === 0) return;
    for (let bin = binOf(line.lower); bin < NUMBER_OF_BINS && lowerEdge(bin) < line.upper; bin++) {
      if (lowerEdge(bin) >= line.lower) out[bin] = i + 1;
    }
  });
  return out;
}

// Adds a line; overlapped parts are removed from the other lines.
export function withLine(lines, line) {
  const rest = lines.flatMap((l) => {
    const pieces = [{ ...l, upper: Math.min(l.upper, line.lower) }, { ...l, lower: Math.max(l.lower, line.upper) }];
    return pieces.filter((piece) => piece.lower < piece.upper);
  });
  return [...rest, line].sort((a, b) => a.lower - b.lower);
}

// Formats a number like C's %g with this number of digits: ties round to even, unlike toExponential().
export function rounded(x, digits) {
  if (x === 0) return '0';
  const exact = x.toExponential(60), [mantissa] = exact.split('e'), kept = mantissa.slice(0, digits + 1).replace(/\.$/, '');
  const isTie = /^50*$/.test(mantissa.slice(digits + 1)) && '02468'.includes(kept.slice(-1));
  const [m, e] = (isTie ? `${kept}e${exact.split('e')[1]}` : x.toExponential(digits - 1)).split('e');
  const exponent = Number(e), short = (text) => (text.includes('.') ? text.replace(/0*$/, '').replace(/\.$/, '') : text);
  if (exponent < -4 || exponent >= digits) return `${short(m)}e${exponent < 0 ? '-' : '+'}${String(Math.abs(exponent)).padStart(2, '0')}`;
  const figures = m.replace('.', '');
  if (exponent < 0) return short(`0.${'0'.repeat(-exponent - 1)}${figures}`);
  return short(`${figures.slice(0, exponent + 1)}.${figures.slice(exponent + 1)}`);
}

// Least distance of points, and width of the ramp that approximates a step, as in ShapeTransferFunction.
const CLOSEST = 1 / 16000;

function opacityPoints(lines) {
  const points = [];
  let end = 0;
  if (!lines.length || lines[0].lower > 0) points.push([0, 0]);
  lines.forEach((line, i) => {
    const gap = line.lower - end;
    if (gap > 0) points.push([line.lower - Math.min(CLOSEST, 0.5 * gap), 0]);
    points.push([line.lower, line.opacity], [line.upper - CLOSEST, line.opacity]);
    if (!(i + 1 < lines.length && lines[i + 1].lower <= line.upper)) points.push([line.upper, 0]);
    end = line.upper;
  });
  return points;
}

function colorPoints(lines) {
  return lines.flatMap((line) => {
    const color = channelsOf(line.color).map((c) => c / 255);
    return [[line.lower, ...color], [line.upper - CLOSEST, ...color]];
  });
}

function spread(points) {
  for (let k = 1; k < points.length; ++k) points[k][0] = Math.max(points[k][0], points[k - 1][0] + CLOSEST);
  return points;
}

function pointsText(points, unit) {
  const values = points.flatMap(([heat, ...rest]) => [rounded(heat * unit, 9), ...rest.map((x) => rounded(x, 4))]);
  return [values.length, ...values].join(' ');
}

// The lines as a volume property of 3D Slicer, with the same bytes as HeatTransferFunction. unit: volume value of heat 1.
export function volumeProperty(lines, unit) {
  const points = [spread(opacityPoints(lines)), [[0, 1], [1, 1]], spread(colorPoints(lines))];
  return `${['0', '1', '0.6', '0.3', '0.2', '10', ...points.map((p) => pointsText(p, unit))].join('\n')}\n`;
}

// Text for HeatTransferFunction --from. objects: {number, labels, voxels, color, opacity}; version 2 has some.
export function savedText(lines, quantity, timeStep, objects = []) {
  const saved = lines.map(({ lower, upper, color, opacity }) => ({ lower, upper, color, opacity }));
  const more = objects.length ? { objects } : {}, version = objects.length ? 2 : 1;
  return `${JSON.stringify({ shapeton: 'transfer function', version, quantity, timeStep, lines: saved, ...more }, null, 2)}\n`;
}

// Parses the lines and objects of such text. Throws an error with a user message if invalid; HeatTransferFunction checks
// more strictly.
export function savedFromText(text, quantity) {
  let saved = null;
  try {
    saved = JSON.parse(text);
  } catch {
    throw new Error('This file is not a transfer function: it is not JSON.');
  }
  const isRange = (a, b) => a >= 0 && a < b && b <= 1, isShare = (x) => x >= 0 && x <= 1;
  const isStyle = (l) => isShare(l.opacity) && /^#[0-9a-f]{6}$/.test(l.color), isLine = (l) => isRange(l.lower, l.upper) && isStyle(l);
  const { lines, version, objects = [] } = saved ?? {};
  const isKnown = saved?.shapeton === 'transfer function' && version === (objects.length ? 2 : 1) && Array.isArray(lines);
  if (!isKnown || lines.length > MOST_LINES || !lines.every(isLine) || !objects.every(isStyle)) {
    throw new Error('This file is not a transfer function saved by this page.');
  }
  if (saved.quantity !== quantity) throw new Error(`This transfer function is for ${saved.quantity}, not for ${quantity}.`);
  return { lines: lines.reduce((all, line) => withLine(all, { ...line, isOn: true }), []), objects };
}
