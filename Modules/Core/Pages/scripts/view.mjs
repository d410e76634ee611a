// A canvas that follows the size of its box, repaints on demand, and reports gestures.
export class View {
  constructor(root, name, title) {
    this.box = document.createElement('div');
    this.box.className = `view ${name}`;
    this.box.dataset.view = name;
    this.canvas = document.createElement('canvas');
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', title);
    this.label = document.createElement('span');
    this.label.textContent = title;
    this.box.append(this.canvas, this.label);
    root.append(this.box);
    this.context = this.canvas.getContext('2d');
    this.shown = null; // [x, y, hidden] of the crosshair in the last image
    new ResizeObserver(() => this.changed()).observe(this.box);
    this.listen();
  }

  listen() {
    const c = this.canvas;
    const at = (e) => ({ x: e.offsetX / View.scale, y: e.offsetY / View.scale });
    let down = null;
    c.addEventListener('pointerdown', (e) => {
      c.setPointerCapture(e.pointerId);
      down = { ...at(e), button: e.button, moved: false };
      this.grab(down, e.shiftKey);
    });
    c.addEventListener('pointermove', (e) => {
      const { x, y } = at(e);
      if (!down) {
        this.hover(x, y, e.shiftKey);
        return;
      }
      const dx = x - down.x, dy = y - down.y;
      if (!down.moved && Math.hypot(dx, dy) < 4) return;
      Object.assign(down, { moved: true, x, y });
      this.drag(dx, dy, down.button, { x, y, isShift: e.shiftKey });
    });
    c.addEventListener('pointerup', (e) => {
      const { x, y } = at(e);
      if (down?.moved) this.drop({ x, y }, down.button);
      else if (down?.button === 0 && this.pick(x, y)) this.clicked(e.ctrlKey || e.metaKey);
      down = null;
    });
    c.addEventListener('pointerleave', () => this.leave());
    c.addEventListener('pointercancel', () => { down = null; });
    c.addEventListener('wheel', (e) => {
      e.preventDefault();
      const amount = e.deltaY || (e.shiftKey ? e.deltaX : 0); // with Shift, some browsers scroll sideways
      this.wheel(Math.sign(amount), at(e), e.ctrlKey, amount, e.shiftKey);
    }, { passive: false });
    c.addEventListener('contextmenu', (e) => e.preventDefault());
  }

  get w() { return this.box.clientWidth / View.scale; }
  get h() { return this.box.clientHeight / View.scale; }
  hover(x, y, isShift) { if (isShift) this.pick(x, y); } // as in 3D Slicer
  leave() {} // the pointer is no longer over the view
  grab() {}  // position where a button was pressed, and whether Shift was pressed
  drag() {}  // by dx, dy with a button, to {x, y, isShift}
  drop() {}  // after a drag
  wheel() {} // wheel: direction, position, whether Ctrl is pressed, amount, and whether Shift is pressed
  pick() { return false; } // moves the crosshair to a pixel; false where nothing is displayed
  clicked() {}             // after a click that has moved the crosshair; true: with Ctrl

  // Paints once before the next frame.
  changed() {
    if (this.waiting) return;
    this.waiting = true;
    View.pending++;
    requestAnimationFrame(() => {
      this.waiting = false;
      View.pending--;
      this.paint();
    });
  }

  paint() {
    const ratio = View.scale * Math.min(2, globalThis.devicePixelRatio || 1), { w, h, canvas, context } = this;
    if (!w || !h) return;
    const started = performance.now(), width = Math.round(w * ratio), height = Math.round(h * ratio);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.draw(context, w, h, ratio);
    this.milliseconds = performance.now() - started;
  }

  say(g, text) {
    g.fillStyle = '#000';
    g.fillRect(0, 0, this.w, this.h);
    g.fillStyle = '#ddd';
    g.font = '13px sans-serif';
    g.fillText(text, 10, this.h / 2, this.w - 20);
  }

  // The crosshair, open at its center by `gap` pixels; dashed if the position is hidden.
  cross(g, x, y, hidden = false, gap = 4) {
    this.shown = [x, y, hidden];
    for (const [color, width] of [['#000a', 3.5], ['#ffd400', 1.6]]) {
      g.strokeStyle = color;
      g.lineWidth = width;
      g.setLineDash(hidden ? [3, 3] : []);
      g.beginPath();
      for (const [a, b] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
        g.moveTo(x + gap * a, y + gap * b);
        g.lineTo(x + (gap + 10) * a, y + (gap + 10) * b);
      }
      g.stroke();
    }
    g.setLineDash([]);
  }

  // A numbered ring around a candidate or finding; the selected one differs in color and thickness.
  ring(g, x, y, text, chosen, radius = chosen ? 11 : 9) {
    g.strokeStyle = chosen ? '#ff9d4d' : '#56b4e9';
    g.lineWidth = chosen ? 3 : 1.6;
    g.beginPath();
    g.arc(x, y, radius, 0, 7);
    g.stroke();
    g.font = '12px sans-serif';
    g.lineWidth = 3;
    g.strokeStyle = '#000b';
    g.strokeText(text, x + radius + 2, y - 6);
    g.fillStyle = '#fff';
    g.fillText(text, x + radius + 2, y - 6);
  }

  line(g, points, color, width) {
    g.strokeStyle = color;
    g.lineWidth = width;
    g.beginPath();
    let pen = false;
    for (const p of points) {
      if (!p) { pen = false; continue; }
      if (pen) g.lineTo(p[0], p[1]); else g.moveTo(p[0], p[1]);
      pen = true;
    }
    g.stroke();
  }
}
View.pending = 0; // number of views waiting for an image
View.scale = 1;   // page pixels per view pixel: on a large screen, drawings scale with the text

export function scaleViews() { View.scale = parseFloat(getComputedStyle(document.body).fontSize) / 13; }
