import { View } from '../../../Core/Pages/scripts/view.mjs';
import { paintDomain, paintMarks, paintTile, paintTracked, widthsOf } from './paint.mjs';
import { edgeUnder, nodeUnder, Tile } from './tile.mjs';

const MOST_NAMED = 40; // maximum number of labeled neighbors
const EDGE_REACH = 6;  // pixels

// The whole graph. GraphMarks paints the selection above it, so a click does not repaint the graph.
export class GraphPicture extends View {
  constructor(root, graph, group) {
    super(root, 'picture', graph.data.title);
    Object.assign(this, { graph, group, tiles: [] });
    this.label.remove(); // redundant with the caption
  }

  get frame() {
    const { extent, middle } = this.graph.data;
    return { c: this.w / 2, R: 0.48 * this.w, extent, middle };
  }

  // Tiles that are large enough, the original one first: [tile, index].
  findTiles() {
    const { graph: { data }, group: { model } } = this, { tiles: t } = data, { frame } = this, found = [];
    for (let i = 0; i < t.length; i += 4) {
      const tile = new Tile(model, data, frame, { a: [t[i], t[i + 1]], b: [t[i + 2], t[i + 3]] });
      if (model.hasTile(tile.node(0), frame)) found.push([tile, i / 4]);
    }
    this.tiles = found.map(([tile]) => tile);
    return found;
  }

  // Marks use the tiles of the last picture.
  paint() {
    super.paint();
    this.marks.paint();
  }

  draw(g, w, h) {
    const { model, show } = this.group, { c, R } = this.frame, found = this.findTiles(), { data } = this.graph;
    g.clearRect(0, 0, w, h);
    g.lineJoin = 'round';
    g.lineWidth = widthsOf(data).line;
    if (show.tiles && data.domain.length) for (const [tile, index] of [...found].reverse()) paintDomain(g, tile, index);
    if (model.rim()) {
      g.beginPath();
      g.arc(c, c, R * model.rim(), 0, 2 * Math.PI);
      g.strokeStyle = '#9e9e9e';
      g.stroke();
    }
    for (const [tile, index] of found) paintTile(g, tile, show, index === 0);
  }
}

// The selection above the picture, and the gestures of both.
export class GraphMarks extends View {
  constructor(root, picture, page) {
    super(root, 'marks', `${picture.graph.data.title}: selection`);
    Object.assign(this, { picture, page, graph: picture.graph, group: picture.group });
    this.figure = root.parentElement;
    this.caption = this.figure.querySelector('figcaption');
    picture.marks = this;
    this.label.remove();
    this.canvas.addEventListener('pointerdown', (e) => { this.last = this.unitsOf({ x: e.offsetX, y: e.offsetY }); page.focusOn(this); });
  }

  draw(g, w, h) {
    const marks = this.page.selection.marksIn(this.graph);
    g.clearRect(0, 0, w, h);
    g.lineJoin = 'round';
    this.picture.box.classList.toggle('faded', !this.page.selection.isEmpty);
    const { tiles } = this.picture, hasNames = marks?.near.length <= MOST_NAMED;
    tiles.forEach((tile, i) => paintTracked(g, tile, i === 0));
    if (marks) tiles.forEach((tile, i) => paintMarks(g, tile, this.group.show, this.graph, marks, hasNames && i === 0));
  }

  // In units of the ball or disk, upwards.
  unitsOf({ x, y }) {
    const { c, R } = this.picture.frame;
    return [(x - c) / R, (c - y) / R];
  }

  drag(dx, dy, button, to) {
    const at = this.unitsOf(to);
    this.group.model.drag(this.last, at, to.isShift);
    this.last = at;
    this.group.changed();
  }

  wheel(step, at, isCtrl, amount) { this.zoom(-0.0015 * amount, this.unitsOf(at)); }

  zoom(amount, at = [0, 0]) {
    this.group.model.zoom(at, amount);
    this.group.changed();
  }

  hover(x, y) {
    const node = this.nodeAt(x, y);
    this.caption.textContent = this.graph.data.title + (node < 0 ? '' : `: node ${this.graph.name(node)}`);
  }

  nodeAt(x, y) { return nodeUnder(this.picture.tiles, this.graph, [x, y], 0.03 * this.picture.frame.R); }

  // The node whose circle contains a pixel, if circles are shown.
  circleAt(x, y) {
    const { context: g, picture: { tiles } } = this, ratio = this.canvas.width / this.w;
    for (const tile of this.group.show.nodeCircles ? tiles : []) {
      for (let i = 0; i < this.graph.nodes; i++) {
        if (tile.nodeCircle(g, i) > 0 && g.isPointInPath(x * ratio, y * ratio)) return i;
      }
    }
    return -1;
  }

  // The node under a pixel, else the edge, else the node whose circle contains it.
  pick(x, y) {
    const { selection } = this.page, near = this.nodeAt(x, y);
    const edge = near < 0 ? edgeUnder(this.picture.tiles, this.graph, [x, y], EDGE_REACH) : -1;
    const node = near < 0 && edge < 0 ? this.circleAt(x, y) : near;
    if (node >= 0) selection.chooseNode(this.graph, node);
    else if (edge >= 0) selection.chooseEdge(this.graph, edge);
    else selection.clear();
    return true;
  }

  clicked(isCtrl) {
    if (isCtrl) this.page.track();
    else this.page.selected();
  }

  // Centers a node.
  center(node) {
    this.group.model.center(new Tile(this.group.model, this.graph.data, this.picture.frame, { a: [1, 0], b: [0, 0] }).node(node));
    this.group.changed();
  }
}
