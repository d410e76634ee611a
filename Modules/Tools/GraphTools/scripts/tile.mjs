const SHORTEST = 0.4; // minimum length of a line, pixels

// The graph in one tile of its covering (the sphere has one tile): positions in pixels, computed on demand.
export class Tile {
  constructor(model, data, frame, motion) {
    Object.assign(this, { model, data, frame, move: model.mover(frame, motion), moved: [] });
  }

  // Position of a node after the motion of the view.
  node(i) {
    this.moved[i] ??= this.move(this.data.places, this.model.step * i);
    return this.moved[i];
  }

  isSeen(i) { return this.model.isSeen(this.node(i)); }
  pixelOf(i) { return this.model.pixel(this.frame, this.node(i)); }

  // Half an edge, from its node to the tangency point: pixels, or null if hidden or too short.
  half(h) { return this.curve(this.node(this.data.starts[h]), this.move(this.data.touches, this.model.step * h)); }

  dual(i) {
    const { step } = this.model;
    return this.curve(this.move(this.data.dual, 2 * i * step), this.move(this.data.dual, (2 * i + 1) * step));
  }

  curve(p, q) {
    const { model, frame } = this;
    if (!model.isSeen(p) || !model.isSeen(q)) return null;
    const s = model.pixel(frame, p), e = model.pixel(frame, q), length = Math.hypot(e[0] - s[0], e[1] - s[1]);
    if (length < SHORTEST) return null;
    const pieces = model.isStraight ? 1 : Math.min(16, Math.ceil(length / 25)), points = [s];
    for (let k = 1; k < pieces; k++) points.push(model.pixel(frame, model.between(p, q, k / pieces)));
    points.push(e);
    return points;
  }

  // Begins the path of the circle of a node or face; returns its radius in pixels, see Sphere.
  nodeCircle(g, i) { return this.circle(g, this.data.places, i, this.data.radii); }
  faceCircle(g, i) { return this.circle(g, this.data.faces, i, this.data.faceRadii); }

  circle(g, places, i, radii) {
    g.beginPath();
    return this.model.circle(g, this.frame, this.move, places, this.model.step * i, radii[i]);
  }
}

function gapToPiece([x, y], a, b) {
  const dx = b[0] - a[0], dy = b[1] - a[1], n = dx * dx + dy * dy;
  const t = n > 0 ? Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / n)) : 0;
  return Math.hypot(a[0] + t * dx - x, a[1] + t * dy - y);
}

// Distance between a pixel and half an edge. Halves certainly farther than `far` are skipped.
function gapToHalf(tile, h, at, far) {
  const { model, frame, data: { starts } } = tile, p = tile.node(starts[h]);
  if (model.isSeen(p)) {
    const s = model.pixel(frame, p), q = tile.move(tile.data.touches, model.step * h), e = model.pixel(frame, q);
    const length = Math.hypot(e[0] - s[0], e[1] - s[1]); // an arc stays within its length of the chord
    if (gapToPiece(at, s, e) > far + length) return Infinity;
  }
  const points = tile.half(h);
  let gap = Infinity;
  for (let k = 1; points && k < points.length; k++) gap = Math.min(gap, gapToPiece(at, points[k - 1], points[k]));
  return gap;
}

// Nearest node of the tiles within `reach` pixels, or -1; the first one among ties.
export function nodeUnder(tiles, graph, at, reach) {
  let best = reach, found = -1;
  for (const tile of tiles) {
    for (let i = 0; i < graph.nodes; i++) {
      if (!tile.isSeen(i)) continue;
      const [x, y] = tile.pixelOf(i), gap = Math.hypot(x - at[0], y - at[1]);
      if (gap < best) { best = gap; found = i; }
    }
  }
  return found;
}

export function edgeUnder(tiles, graph, at, reach) {
  let best = reach, found = -1;
  for (const tile of tiles) {
    graph.data.edgeOf.forEach((edge, h) => {
      const gap = gapToHalf(tile, h, at, best);
      if (gap < best) { best = gap; found = edge; }
    });
  }
  return found;
}
