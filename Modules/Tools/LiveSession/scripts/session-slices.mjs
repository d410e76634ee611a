import { RenderingView } from '../../../Visualization/HeatViews/scripts/rendering.mjs';
import { HeatSliceView } from '../../../Visualization/HeatViews/scripts/slices.mjs';
import { axesOfSlice } from './frames.mjs';

// A slice that the server has sent, on which a start region can be painted.
export class SessionSliceView extends HeatSliceView {
  get data() { return this.page.sent[this.plane.through]; }
  get labels() { return this.data?.labels; }

  layout() {
    const { plane, page: { volume } } = this, [nx, ny] = this.size, [u, v] = axesOfSlice(plane.through);
    const strides = { [u]: 1, [v]: volume.size[u] };
    const across = strides[plane.across] * (plane.flipAcross ? -1 : 1), down = strides[plane.down] * (plane.flipDown ? -1 : 1);
    return { first: -Math.min(0, across) * (nx - 1) - Math.min(0, down) * (ny - 1), across, down };
  }

  fill() {
    const { data, page: { numbers, paints } } = this, [nx, ny] = this.size;
    if (!data) return;
    const out = new Uint32Array(this.pixels.data.buffer), { first, across, down } = this.layout();
    let row = first;
    for (let j = 0, o = 0; j < ny; j++, row += down) {
      for (let i = 0, at = row; i < nx; i++, at += across, o++) out[o] = paints[(numbers[data.bins[at]] << 8) | data.gray[at]];
    }
    this.image.getContext('2d').putImageData(this.pixels, 0, 0);
  }

  draw(g, w, h) {
    super.draw(g, w, h);
    this.drawRegion(g);
  }

  // Circles where the balls of the start region meet this slice.
  drawRegion(g) {
    const { plane, page } = this, f = this.frame(), { spacing } = page.volume, depth = page.place[plane.through];
    g.strokeStyle = '#ff9d4d';
    g.lineWidth = 1.5;
    for (const { index, radius } of page.balls) {
      const rest = radius ** 2 - ((index[plane.through] - depth) * spacing[plane.through]) ** 2;
      if (rest <= 0) continue;
      g.beginPath();
      g.arc(...f.at(index), Math.sqrt(rest) * f.s, 0, 7);
      g.stroke();
    }
  }

  drag(dx, dy, button, { x, y }) {
    if (this.page.isPainting) this.page.paint(this.frame().back(x, y)); else this.page.moveTo(this.frame().back(x, y));
  }

  drop() { if (this.page.isPainting) this.page.applyPaint(); }

  pick(x, y) {
    if (!this.page.isPainting) return super.pick(x, y);
    this.page.paint(this.frame().back(x, y));
    this.page.applyPaint();
    return false;
  }
}

// The rendering of the reduced volume, or the picture that the server has drawn.
export class SessionRendering extends RenderingView {
  constructor(root, page, session) {
    super(root, page);
    this.session = session;
  }

  quickly() {
    super.quickly();
    this.session?.askPicture();
  }

  draw(g, w, h, ratio) {
    const { picture } = this.session;
    if (!this.session.isDrawnByServer || !picture) { super.draw(g, w, h, ratio); return; }
    g.drawImage(picture, 0, 0, w, h);
    const [x, y] = this.pixelOf(this.page.place);
    this.cross(g, x, y, true);
  }
}
