import { clamp } from '../../../Core/Pages/scripts/math.mjs';
import { View } from '../../../Core/Pages/scripts/view.mjs';
import { channelsOf } from './lines.mjs';
import { labelsOf } from './objects.mjs';

const OPACITY = 0.6; // opacity of line colors over the gray values, as in report pictures

// A slice along the image's own axes, with voxels in the colors of their lines. plane: as written by HeatExplorer.
export class HeatSliceView extends View {
  constructor(root, page, plane) {
    super(root, plane.name, plane.name);
    Object.assign(this, { page, plane, zoom: 1, image: document.createElement('canvas') });
    const { volume } = page, { across, down } = plane;
    this.size = [volume.size[across], volume.size[down]];
    this.steps = [volume.spacing[across], volume.spacing[down]];
    this.pixels = new ImageData(...this.size);
    Object.assign(this.image, { width: this.size[0], height: this.size[1] });
  }

  // Maps an image index to the screen and back.
  frame() {
    const { plane, page: { place } } = this, [nx, ny] = this.size, [dx, dy] = this.steps;
    const s = this.zoom * Math.min(this.w / (nx * dx), this.h / (ny * dy));
    const own = (i, n, isFlipped) => (isFlipped ? n - 1 - i : i) + 0.5;
    // An enlarged slice follows the crosshair, but fills the view if possible.
    const start = (room, n, step, i) => {
      const length = n * step * s;
      return length <= room ? (room - length) / 2 : clamp(room / 2 - i * step * s, room - length, 0);
    };
    const x0 = start(this.w, nx, dx, own(place[plane.across], nx, plane.flipAcross));
    const y0 = start(this.h, ny, dy, own(place[plane.down], ny, plane.flipDown));
    return {
      s, x0, y0,
      at: (p) => [x0 + own(p[plane.across], nx, plane.flipAcross) * dx * s, y0 + own(p[plane.down], ny, plane.flipDown) * dy * s],
      back: (x, y) => {
        const p = [...place], of = (a, n) => clamp(Math.floor(a), 0, n - 1);
        const i = of((x - x0) / (dx * s), nx), j = of((y - y0) / (dy * s), ny);
        p[plane.across] = plane.flipAcross ? nx - 1 - i : i;
        p[plane.down] = plane.flipDown ? ny - 1 - j : j;
        return p;
      },
    };
  }

  draw(g, w, h) {
    const { plane, page } = this, f = this.frame(), [nx, ny] = this.size, [dx, dy] = this.steps;
    g.fillStyle = '#000';
    g.fillRect(0, 0, w, h);
    this.fill();
    g.imageSmoothingEnabled = true;
    g.drawImage(this.image, f.x0, f.y0, nx * dx * f.s, ny * dy * f.s);
    this.outline(g, f);
    g.fillStyle = '#ffd';
    g.font = '12px sans-serif';
    g.fillText(plane.left, 4, h / 2);
    g.fillText(plane.right, w - 16, h / 2);
    g.fillText(plane.top, w / 2 - 4, 14);
    g.fillText(plane.bottom, w / 2 - 4, h - 5);
    this.cross(g, ...f.at(page.place));
  }

  // Index of the voxel of the first pixel, and offsets of the next pixels across and down.
  layout() {
    const { plane, page: { volume, place } } = this, [nx, ny] = this.size, strides = [1, volume.size[0], volume.size[0] * volume.size[1]];
    const across = strides[plane.across] * (plane.flipAcross ? -1 : 1), down = strides[plane.down] * (plane.flipDown ? -1 : 1);
    const first = place[plane.through] * strides[plane.through] - Math.min(0, across) * (nx - 1) - Math.min(0, down) * (ny - 1);
    return { first, across, down };
  }

  get labels() { return this.page.labels; }

  // The border of the object under the pointer.
  outline(g, { x0, y0, s }) {
    const { labels, page: { pointed, objects } } = this, [nx, ny] = this.size, [dx, dy] = this.steps.map((step) => step * s);
    if (!pointed || !labels) return;
    const isIn = new Uint8Array(objects.length + 1), { first, across, down } = this.layout();
    for (const label of labelsOf(objects, pointed)) isIn[label] = 1;
    const has = (i, j) => i >= 0 && j >= 0 && i < nx && j < ny && isIn[labels[first + i * across + j * down]];
    g.beginPath();
    for (let j = 0; j <= ny; j++) {
      for (let i = 0; i <= nx; i++) {
        const here = has(i, j), x = x0 + i * dx, y = y0 + j * dy;
        if (here !== has(i - 1, j)) { g.moveTo(x, y); g.lineTo(x, y + dy); }
        if (here !== has(i, j - 1)) { g.moveTo(x, y); g.lineTo(x + dx, y); }
      }
    }
    g.strokeStyle = '#fff';
    g.lineWidth = 1.2;
    g.stroke();
  }

  // Voxels are classified first: colors are interpolated between voxels, heat is not.
  fill() {
    const { page, page: { gray, paints } } = this, [nx, ny] = this.size, out = new Uint32Array(this.pixels.data.buffer);
    const { first, across, down } = this.layout();
    let row = first;
    for (let j = 0, o = 0; j < ny; j++, row += down) {
      for (let i = 0, v = row; i < nx; i++, v += across, o++) out[o] = paints[(page.classAt(v) << 8) | gray[v]];
    }
    this.image.getContext('2d').putImageData(this.pixels, 0, 0);
  }

  pick(x, y) { this.page.moveTo(this.frame().back(x, y)); return true; }
  clicked(isAdded) { this.page.clicked(isAdded); }

  hover(x, y, isShift) {
    super.hover(x, y, isShift);
    this.page.pointAt(this.page.voxelAt(this.frame().back(x, y)));
  }

  leave() { this.page.pointAt(null); }

  wheel(d, at, isScaling, amount, isClimbing) {
    if (isClimbing) this.page.climb(-d);
    else if (isScaling) this.scaleBy(1.25 ** -d);
    else this.page.stepSlice([this.page.info.planes.indexOf(this.plane), d]);
  }

  scaleBy(by) { this.zoom = clamp(this.zoom * by, 1, 12); this.changed(); }
}

// Color of each gray value for each line, and for no line.
export function paintsOf(lines) {
  const paints = new Uint32Array((lines.length + 1) * 256);
  for (let g = 0; g < 256; g++) paints[g] = 0xff000000 | (g * 0x10101);
  lines.forEach((line, i) => {
    const rgb = channelsOf(line.color);
    for (let g = 0; g < 256; g++) {
      const [r, green, b] = rgb.map((c) => Math.round(g + OPACITY * (c - g)));
      paints[(i + 1) * 256 + g] = 0xff000000 | (b << 16) | (green << 8) | r;
    }
  });
  return paints;
}
