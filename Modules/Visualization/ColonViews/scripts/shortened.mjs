const RATE = 0.1;     // length of a shortened stretch relative to its true length
const SHARE = 0.8;    // of a column, interpolated, from which it is shortened
const SHORTEST = 10;  // mm

// Stretches of the map without CT data, [from, to] in mm of u.
function stretchesOf(exam) {
  const { relief: { columns, rows, step, u: first } } = exam.info, out = [];
  for (let column = 0; column < columns; column++) {
    let made = 0, all = 0;
    for (let row = 0; row < rows; row++) {
      const face = exam.faceOfPixel[row * columns + column];
      if (face < 0) continue;
      all++;
      if (exam.isSynthetic(face)) made++;
    }
    if (!all || made < SHARE * all) continue;
    const u = first + column * step, last = out.at(-1);
    if (last && u - last[1] < 1.5 * step) last[1] = u + step / 2; else out.push([u - step / 2, u + step / 2]);
  }
  return out.filter(([from, to]) => to - from >= SHORTEST);
}

// The length of the flat map with interpolated stretches shortened. pieces: {from, to} in mm of u, {at} where they begin on the
// shortened map, {rate}.
export class Shortened {
  constructor(exam) {
    const [lo, hi] = exam.range;
    this.pieces = [];
    let at = lo, u = lo;
    const add = (to, rate) => {
      if (to <= u) return;
      this.pieces.push({ from: u, to, at, rate });
      at += rate * (to - u);
      u = to;
    };
    for (const [from, to] of stretchesOf(exam)) {
      add(Math.min(from, hi), 1);
      add(Math.min(to, hi), RATE);
    }
    add(hi, 1);
    this.range = [lo, at];
  }

  of(u) {
    const p = this.pieces.find(({ to }) => u < to) || this.pieces.at(-1);
    return p.at + p.rate * (u - p.from);
  }

  back(x) {
    const p = this.pieces.filter(({ at }) => x >= at).at(-1) || this.pieces[0];
    return p.from + (x - p.at) / p.rate;
  }

  // Draws an image of the map, whose columns have this step (mm) and begin at u. x: the pixel of a u.
  draw(g, image, { u, step }, x, y, height) {
    for (const { from, to } of this.pieces) {
      const column = (from - u) / step + 0.5, left = x(from);
      g.drawImage(image, column, 0, (to - from) / step, image.height, left, y, x(to) - left, height);
    }
  }
}
