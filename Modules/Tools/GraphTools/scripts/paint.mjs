const NODE = '#c62828', DUAL = '#2e7d32', EDGE = '#212121', CIRCLE = '#f3b3ac';
// Outlines and marks next to colors that show a quantity.
const OUTLINE = '#9e9e9e', MARK = '#424242';
const PASTEL = ['#fff3c4', '#cfe8ff', '#ffd9d4', '#d6f5d6', '#eadcff', '#ffe3c2', '#d2f4f0', '#ffd6ec', '#e8f0c8', '#dfe3ee'];
// Selection styles: hues that are safe for color-blind readers (Okabe and Ito), each with a different width.
const CHOSEN = '#0072b2', NEAR = '#d55e00';
const MOST_LINES = 500; // lines per path; browsers are slower per line in longer paths
const FULL = 2 * Math.PI;

const colorOf = (data, node) => data.tracked?.get(node) ?? (data.colors ? data.colors[node] : CIRCLE);

const outlineOf = (data) => (data.edgeColors ? OUTLINE : NODE);

// Halves of edges of each color, found on first use.
const found = new WeakMap();
function halvesByColor(data) {
  if (!found.has(data)) {
    const groups = new Map();
    data.edgeOf.forEach((edge, half) => {
      const color = data.edgeColors ? data.edgeColors[edge] : EDGE;
      if (!groups.has(color)) groups.set(color, []);
      groups.get(color).push(half);
    });
    found.set(data, groups);
  }
  return found.get(data);
}

function addLine(g, line) { line?.forEach(([x, y], k) => (k ? g.lineTo(x, y) : g.moveTo(x, y))); }

function strokeLines(g, count, lineOf) {
  for (let i = 0; i < count;) {
    g.beginPath();
    for (const end = Math.min(count, i + MOST_LINES); i < end; i++) addLine(g, lineOf(i));
    g.stroke();
  }
}

// Thinner lines and smaller dots for more edges.
export function widthsOf(data) {
  const root = Math.sqrt(2 * data.touches.length + 1), clamped = (lo, hi, x) => Math.max(lo, Math.min(hi, x));
  return { line: clamped(0.3, 1.3, 60 / root), dot: clamped(1, 4, 90 / root) };
}

function paintNodeCircles(g, tile) {
  const { data } = tile;
  g.strokeStyle = outlineOf(data);
  for (let i = 0; i < data.names.length; i++) {
    const size = tile.nodeCircle(g, i);
    if (size > 0) { g.fillStyle = colorOf(data, i); g.fill(); }
    if (size) g.stroke();
  }
}

function paintDot(g, tile, i, size, color) {
  const s = size * tile.model.sizeOfDot(tile.node(i));
  if (s <= 0.4) return;
  g.fillStyle = color;
  g.beginPath();
  g.arc(...tile.pixelOf(i), s, 0, FULL);
  g.fill();
}

function label(g, tile, i) {
  const [x, y] = tile.pixelOf(i);
  g.font = '12px sans-serif';
  g.fillStyle = '#000';
  g.fillText(tile.data.names[i], x + 5, y - 5);
}

export function paintTile(g, tile, show, isFirst) {
  const { data } = tile, { line, dot: size } = widthsOf(data);
  g.lineWidth = line;
  if (show.nodeCircles) paintNodeCircles(g, tile);
  g.strokeStyle = DUAL;
  for (let i = 0; show.faceCircles && i < data.faceRadii.length; i++) if (tile.faceCircle(g, i)) g.stroke();
  for (const [color, halves] of show.graph ? halvesByColor(data) : []) {
    Object.assign(g, { strokeStyle: color, lineWidth: data.edgeColors ? 2 * line : line });
    strokeLines(g, halves.length, (i) => tile.half(halves[i]));
  }
  if (show.graph && data.marked) {
    Object.assign(g, { strokeStyle: data.marked.color, lineWidth: 3 * line });
    strokeLines(g, data.marked.halves.length, (i) => tile.half(data.marked.halves[i]));
  }
  g.lineWidth = line;
  g.strokeStyle = DUAL;
  if (show.dual) strokeLines(g, data.dual.length / 2 / tile.model.step, (i) => tile.dual(i));
  for (let i = 0; (show.nodes || show.labels) && i < data.names.length; i++) {
    if (!tile.isSeen(i)) continue;
    if (show.nodes) paintDot(g, tile, i, size, data.edgeColors ? MARK : NODE);
    if (show.labels && isFirst) label(g, tile, i);
  }
}

export function paintDomain(g, tile, index) {
  const { model, frame, data: { domain } } = tile;
  g.beginPath();
  for (let i = 0; i < domain.length; i += 2) {
    const [x, y] = model.pixel(frame, tile.move(domain, i));
    if (i) g.lineTo(x, y); else g.moveTo(x, y);
  }
  g.closePath();
  g.fillStyle = tile.data.edgeColors ? '#fff' : PASTEL[index % PASTEL.length];
  g.strokeStyle = index ? '#b0a890' : '#8d6e00';
  g.fill();
  g.stroke();
}

// Text with a halo, readable on circles and lines.
function name(g, tile, i, isChosen) {
  const [x, y] = tile.pixelOf(i), text = tile.data.names[i];
  g.font = isChosen ? 'bold 14px sans-serif' : '12px sans-serif';
  g.lineWidth = 4;
  g.strokeStyle = '#fffc';
  g.strokeText(text, x + 8, y - 7);
  g.fillStyle = '#000';
  g.fillText(text, x + 8, y - 7);
}

// Smaller in small copies, but still visible.
function ring(g, tile, i, color, width) {
  const size = Math.max(0.3, Math.min(1, tile.model.sizeOfDot(tile.node(i))));
  g.strokeStyle = color;
  g.lineWidth = Math.max(1.5, size * width);
  g.beginPath();
  g.arc(...tile.pixelOf(i), size * (3 + 2 * width), 0, FULL);
  g.stroke();
}

// Tracked nodes, drawn on top.
export function paintTracked(g, tile, hasNames) {
  for (const [i, color] of tile.data.tracked ?? []) {
    if (!tile.isSeen(i)) continue;
    ring(g, tile, i, '#212121', 3.5);
    ring(g, tile, i, color, 3);
    if (hasNames) name(g, tile, i, true);
  }
}

// The selection and its neighbors, drawn on top.
export function paintMarks(g, tile, show, graph, { node, edge, near, edges }, hasNames) {
  const nodes = node >= 0 ? [...near, node] : near, seen = nodes.filter((i) => tile.isSeen(i));
  for (const i of show.nodeCircles ? nodes : []) {
    const size = tile.nodeCircle(g, i);
    g.fillStyle = colorOf(tile.data, i);
    if (size > 0) g.fill();
    Object.assign(g, i === node ? { strokeStyle: CHOSEN, lineWidth: 3 } : { strokeStyle: NODE, lineWidth: 1 });
    if (size) g.stroke();
  }
  const halves = edges.flatMap((e) => [...graph.halvesOf(e)]);
  for (const [color, width] of [['#fff', 5], [edge >= 0 ? CHOSEN : NEAR, edge >= 0 ? 3.5 : 2]]) {
    Object.assign(g, { strokeStyle: color, lineWidth: width });
    strokeLines(g, halves.length, (k) => tile.half(halves[k]));
  }
  for (const i of seen) {
    ring(g, tile, i, i === node ? CHOSEN : NEAR, i === node ? 3 : 1.5);
    paintDot(g, tile, i, 3, i === node ? CHOSEN : NODE);
  }
  if (hasNames) for (const i of seen) name(g, tile, i, i === node);
}
