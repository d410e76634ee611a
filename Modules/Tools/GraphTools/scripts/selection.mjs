// The selected node or edge, and the tracked nodes with their colors, by key, in all graphs of a page.
export class Selection {
  constructor(graphs, colors = []) {
    Object.assign(this, { graphs, colors, tracked: new Map() });
    this.clear();
  }

  // Tracks the node with a key in the first free color, or no longer.
  track(key) {
    if (!this.tracked.delete(key)) {
      const taken = [...this.tracked.values()], free = this.colors.find((color) => !taken.includes(color));
      this.tracked.set(key, free ?? this.colors[this.tracked.size % this.colors.length]);
    }
    for (const graph of this.graphs) {
      const found = [...this.tracked].map(([k, color]) => [graph.nodeOf(k), color]);
      graph.data.tracked = new Map(found.filter(([node]) => node >= 0));
    }
  }

  // The name of a tracked node in the first graph that has it.
  nameOf(key) {
    const graph = this.graphs.find((g) => g.nodeOf(key) >= 0);
    return graph ? graph.name(graph.nodeOf(key)) : String(key);
  }

  clear() { Object.assign(this, { graph: null, node: -1, edge: -1, key: null, hub: -1 }); }
  get isEmpty() { return this.graph === null; }
  chooseNode(graph, node) { Object.assign(this, { graph, node, edge: -1, key: graph.keys[node] }); }

  // hub: the end around which edges are stepped.
  chooseEdge(graph, edge, hub = graph.ends(edge)[0]) { Object.assign(this, { graph, node: -1, edge, key: graph.keyOfEdge(edge), hub }); }

  // Marks in a graph: {node, edge, near: nodes, edges}; -1 for the other kind; null if the graph lacks the selection.
  marksIn(graph) {
    if (this.isEmpty) return null;
    if (this.edge >= 0) {
      const edge = graph === this.graph ? this.edge : graph.edgeOf(this.key);
      return edge < 0 ? null : { node: -1, edge, near: graph.ends(edge), edges: [edge] };
    }
    const node = graph === this.graph ? this.node : graph.nodeOf(this.key);
    if (node < 0) return null;
    return { node, edge: -1, near: graph.neighbors(node).filter((n) => n !== node), edges: [...new Set(graph.edgesAt(node))] };
  }

  // Selects the next or previous edge around a node.
  stepAround(by) {
    const { graph, node, edge } = this;
    if (this.isEmpty) return;
    const hub = edge >= 0 ? this.hub : node, list = graph.edgesAt(hub), n = list.length;
    const at = edge >= 0 ? list.indexOf(edge) + by : Math.min(0, by);
    if (n) this.chooseEdge(graph, list[(at + n) % n], hub);
  }

  // Follows a selected edge to its far end.
  follow() { if (this.edge >= 0) this.chooseNode(this.graph, this.graph.otherEnd(this.edge, this.hub)); }

  describe() {
    if (this.isEmpty) return '';
    const { graph, node, edge } = this;
    return [...(edge >= 0 ? wordsOfEdge(graph, edge) : wordsOfNode(graph, node)), ...this.mates()].join(' · ');
  }

  // Lists the other graphs that contain the selection, with its name there, and the graphs that do not.
  mates() {
    const others = this.graphs.filter((g) => g !== this.graph), own = this.nameIn(this.graph), absent = [], words = [];
    for (const graph of others) {
      const name = this.nameIn(graph);
      if (name === null) absent.push(graph.data.title);
      else if (name !== own) words.push(`in ${graph.data.title}: ${name}`);
    }
    if (absent.length) words.push(`not in ${absent.join(', ')}`);
    else if (others.length && !words.length) words.push(others.length > 1 ? 'in all graphs' : 'in both graphs');
    return words;
  }

  nameIn(graph) {
    const marks = this.marksIn(graph);
    if (!marks) return null;
    return marks.edge >= 0 ? graph.nameOfEdge(marks.edge) : graph.name(marks.node);
  }
}

const MOST_NAMES = 12;
const UNITS = { spherical: ' rad', euclidean: '', hyperbolic: '' };

function wordsOfNode(graph, node) {
  const near = graph.neighbors(node).map((n) => graph.name(n)), { radii, geometry, title } = graph.data;
  const more = near.length > MOST_NAMES ? ` and ${near.length - MOST_NAMES} more` : '';
  const radius = `radius ${Number(radii[node].toPrecision(3))}${UNITS[geometry]}`;
  return [`node ${graph.name(node)} of ${title}`, `degree ${graph.degree(node)}`, radius,
    near.length ? `neighbors ${near.slice(0, MOST_NAMES).join(', ')}${more}` : 'no neighbors'];
}

function wordsOfEdge(graph, edge) {
  const degrees = graph.ends(edge).map((node) => graph.degree(node));
  return [`edge ${graph.nameOfEdge(edge)} of ${graph.data.title}`, `degrees of its ends ${degrees.join(' and ')}`];
}

// Nodes whose name equals, begins with or contains the given text, best matches first; case-insensitive.
export function nodesNamed(graph, text) {
  const wanted = text.trim().toLowerCase(), ranks = [[], [], []];
  if (!wanted) return [];
  graph.data.names.forEach((name, node) => {
    const at = name.toLowerCase().indexOf(wanted);
    if (at >= 0) ranks[at > 0 ? 2 : name.length === wanted.length ? 0 : 1].push(node);
  });
  return ranks.flat();
}
