import { clamp } from '../../../Core/Pages/scripts/math.mjs';
import { View } from '../../../Core/Pages/scripts/view.mjs';
import { channelsOf, lowerEdge, NUMBER_OF_BINS } from './lines.mjs';

const WIDEST_LINE = 6, LEFT = 62, BOTTOM = 46, TOP = 22; // pixels

const brightnessOf = (count, greatest) => (count > 0 ? 0.15 + (0.85 * Math.log2(1 + count)) / Math.log2(1 + greatest) : 0);

// Counts of every column, for each row of the histogram. A bin without counts in adjacent bins is drawn as a line at its center.
function columnCounts(counts, axis, columns) {
  const rows = counts.length / NUMBER_OF_BINS, out = new Float32Array(rows * columns);
  for (let bin = 1; bin < NUMBER_OF_BINS; bin++) {
    if (lowerEdge(bin + 1) <= axis.lower || lowerEdge(bin) >= axis.upper) continue;
    const left = axis.positionOf(lowerEdge(bin)) * (columns - 1), right = axis.positionOf(lowerEdge(bin + 1)) * (columns - 1);
    const middle = (left + right) / 2, width = Math.max(right - left, 1e-6);
    for (let row = 0; row < rows; row++) {
      const at = row * NUMBER_OF_BINS + bin, count = counts[at];
      if (!count) continue;
      const isSpread = bin > 1 && counts[at - 1] > count / 8 && counts[at + 1] > count / 8;
      const w = width > WIDEST_LINE && !isSpread ? WIDEST_LINE : width;
      const first = Math.max(0, Math.round(middle - w / 2)), last = Math.min(columns - 1, Math.round(middle + w / 2));
      for (let c = first; c <= last; c++) {
        const overlap = Math.min(middle + w / 2, c + 0.5) - Math.max(middle - w / 2, c - 0.5);
        out[row * columns + c] += count * (first === last ? 1 : Math.max(0, overlap) / w);
      }
    }
  }
  return out;
}

// Raises pixels brighter than their neighborhood in the row, to make lines visible in the haze of drifting heat.
function sharpen(row) {
  const reach = 16, before = new Float64Array(row.length + 1);
  for (let x = 0; x < row.length; x++) before[x + 1] = before[x] + row[x];
  return row.map((b, x) => {
    const first = Math.max(0, x - reach), last = Math.min(row.length, x + reach + 1);
    const mean = (before[last] - before[first]) / (last - first);
    return b > 0 ? clamp(0.8 * b + 2.5 * (b - mean), 0.1, 1) : 0;
  });
}

// The histogram as HeatHistogramPicture draws it: heat to the right, time downwards, one pixel row per histogram row.
function pictureOf(counts, axis, columns, colors) {
  const rows = counts.length / NUMBER_OF_BINS, columnsOf = columnCounts(counts, axis, columns);
  const greatest = columnsOf.reduce((a, b) => Math.max(a, b), 0), image = new ImageData(columns, rows);
  const hues = Array.from({ length: columns }, (_, x) => {
    const place = (x / Math.max(1, columns - 1)) * (colors.length - 1), i = Math.min(colors.length - 2, Math.floor(place));
    return colors[i].map((c, k) => c + (place - i) * (colors[i + 1][k] - c));
  });
  for (let row = 0; row < rows; row++) {
    const line = sharpen(columnsOf.subarray(row * columns, (row + 1) * columns).map((count) => brightnessOf(count, greatest)));
    line.forEach((b, x) => image.data.set([...hues[x].map((c) => c * b + 12 * (1 - b)), 255], 4 * (row * columns + x)));
  }
  const canvas = Object.assign(document.createElement('canvas'), { width: columns, height: rows });
  canvas.getContext('2d').putImageData(image, 0, 0);
  return canvas;
}

// The heat histogram. page: axis, counts of all rows and of the shown step, lines, mouse actions.
export class HistogramView extends View {
  constructor(root, page) {
    super(root, 'histogram', 'histogram');
    Object.assign(this, { page, colors: page.info.heatColors.map(channelsOf), selection: null, cursor: 0.5 });
    this.canvas.addEventListener('dblclick', (e) => page.openAt(this.positionAt(e.offsetX / View.scale)));
  }

  get plot() { return { left: LEFT, top: TOP, width: Math.max(10, this.w - LEFT - 12), height: Math.max(10, this.h - TOP - BOTTOM) }; }
  positionAt(x) { const { left, width } = this.plot; return clamp((x - left) / (width - 1), 0, 1); }
  xOf(heat) { const { left, width } = this.plot; return left + this.page.axis.positionOf(heat) * (width - 1); }

  // Center of the row of a time step.
  yOf(step) {
    const { top, height } = this.plot, steps = this.page.info.timeSteps, after = steps.findIndex((s) => s > step);
    const below = after < 0 ? steps.length - 1 : Math.max(0, after - 1), next = steps[below + 1];
    const row = below + (after > 0 ? (step - steps[below]) / (next - steps[below]) : 0);
    return top + ((row + 0.5) * height) / steps.length;
  }

  draw(g, w, h) {
    const { left, top, width, height } = this.plot, { page } = this, columns = Math.round(width);
    g.fillStyle = '#0c0d12';
    g.fillRect(0, 0, w, h);
    if (this.drawnAxis !== page.axis || this.picture.width !== columns || this.drawnCounts !== page.histogram) {
      this.picture = pictureOf(page.histogram, page.axis, columns, this.colors);
      Object.assign(this, { drawnAxis: page.axis, drawnCounts: page.histogram });
    }
    g.imageSmoothingEnabled = false;
    g.drawImage(this.picture, left, top, width, height);
    this.drawLines(g);
    this.drawRow(g);
    this.drawTimes(g);
    this.drawHeats(g);
    this.drawMarks(g);
  }

  drawLines(g) {
    const { top, height, left, width } = this.plot, bar = top + height + 10;
    this.page.lines.forEach((line, i) => {
      const a = Math.max(left, this.xOf(line.lower)), b = Math.min(left + width, this.xOf(line.upper)), wide = Math.max(2, b - a);
      if (line.upper <= this.page.axis.lower || line.lower >= this.page.axis.upper) return;
      g.fillStyle = line.color;
      g.globalAlpha = line.isOn ? 0.28 : 0.08;
      g.fillRect(a, top, wide, height);
      g.globalAlpha = line.isOn ? 1 : 0.4;
      g.fillRect(a, bar, wide, 9);
      g.globalAlpha = 1;
      if (i !== this.page.chosen) return;
      g.strokeStyle = '#fff';
      g.lineWidth = 1.5;
      g.strokeRect(a - 1, top - 1, wide + 2, height + 22);
    });
  }

  // The counts of the shown step above the axis.
  drawRow(g) {
    const { left, top, height, width } = this.plot, columns = Math.round(width), { counts, axis } = this.page;
    const row = columnCounts(counts, axis, columns), greatest = row.reduce((a, b) => Math.max(a, b), 0), high = Math.min(90, height / 3);
    g.strokeStyle = '#fffc';
    g.lineWidth = 1;
    g.beginPath();
    row.forEach((count, x) => g.lineTo(left + x, top + height - high * brightnessOf(count, greatest)));
    g.stroke();
  }

  drawTimes(g) {
    const { left, width, top, height } = this.plot, { info: { stored }, step } = this.page;
    g.font = '12px sans-serif';
    g.textAlign = 'right';
    let free = -Infinity;
    for (const s of stored) {
      const y = this.yOf(s), isShown = s === step;
      g.fillStyle = isShown ? '#fff' : '#aaa';
      const line = clamp(Math.max(y + 4, free), top + 10, top + height);
      g.fillText(`${isShown ? '▸ ' : ''}${s}`, left - 6, line, LEFT - 8);
      free = line + 14;
      g.strokeStyle = isShown ? '#fff' : '#fff5';
      g.setLineDash(isShown ? [6, 4] : [2, 6]);
      g.beginPath();
      g.moveTo(left, y);
      g.lineTo(left + width, y);
      g.stroke();
    }
    g.setLineDash([]);
    g.textAlign = 'left';
  }

  drawHeats(g) {
    const { left, width, top, height } = this.plot, { axis } = this.page, y = top + height + 34;
    g.fillStyle = '#ddd';
    g.textAlign = 'center';
    let free = -Infinity;
    for (let i = 0; i <= width; i += 4) {
      const heat = Number(axis.heatAt(i / width).toPrecision(3)), text = heat < 1e-3 ? heat.toExponential() : String(heat);
      const x = this.xOf(heat), half = g.measureText(text).width / 2 + 6;
      if (heat < axis.lower || heat > axis.upper || x - half < free || x + half > left + width + 20) continue;
      g.fillText(text, x, y);
      g.fillRect(x, top + height, 1, 6);
      free = x + half;
    }
    g.textAlign = 'left';
  }

  // Selection, cursor of the keyboard, heat of the voxel under the crosshair.
  drawMarks(g) {
    const { left, top, height, width } = this.plot, { page } = this;
    if (this.selection) {
      const [a, b] = this.selection.map((p) => left + p * (width - 1));
      g.fillStyle = '#fff5';
      g.fillRect(Math.min(a, b), top, Math.abs(b - a), height);
    }
    const mark = (x, text, color) => {
      g.fillStyle = color;
      g.fillRect(x - 0.5, top - 4, 1.5, height + 4);
      g.fillText(text, clamp(x - 8, left, left + width - 60), top - 8);
    };
    if (document.activeElement === document.body && page.isKeyboard) mark(left + this.cursor * (width - 1), '▾ cursor', '#fff');
    const heat = page.heatHere();
    this.shown = heat >= page.axis.lower && heat <= page.axis.upper ? [this.xOf(heat), top, false] : null;
    if (this.shown) mark(this.shown[0], '▾ crosshair', '#ffd400');
  }

  // A click on the left border selects a stored time step, a click on the plot a line.
  pick(x, y) {
    const { stored } = this.page.info;
    if (x < LEFT) this.page.showStep(stored.reduce((a, b) => (Math.abs(this.yOf(b) - y) < Math.abs(this.yOf(a) - y) ? b : a)));
    else this.page.pickAt(this.positionAt(x), WIDEST_LINE / this.plot.width);
    return false;
  }

  grab({ x }, isOpening) { this.start = { x, isOpening }; }

  drag(dx) {
    const { x } = this.start, to = (this.selection ? this.end : x) + dx;
    this.end = to;
    this.selection = [this.positionAt(x), this.positionAt(to)];
    this.changed();
  }

  drop() {
    const [a, b] = this.selection.sort((p, q) => p - q);
    this.selection = null;
    if (this.start.isOpening) this.page.openPlaces(a, b); else this.page.pickPlaces(a, b);
    this.changed();
  }
}
