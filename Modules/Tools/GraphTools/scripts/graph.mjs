// A graph of the page: its data, and how its nodes and edges correspond to the nodes and edges of other graphs. A node
// is identified across graphs by its key: its name, or a number that the page assigns to corresponding nodes.
export class PageGraph {
  constructor(data) {
    this.data = data;
    this.keys = data.keys || data.names;
    this.colors = data.colors;
    this.findEdgesAround();
  }

  // Colors the given nodes and edges instead of the colors of the data; null: the colors of the data.
  mark(changes, color, other) {
    this.data.colors = changes ? this.keys.map((_, node) => (changes.nodes.has(node) ? color : other)) : this.colors;
    this.data.marked = changes ? { color, halves: [...changes.edges].flatMap((edge) => [...this.halvesOf(edge)]) } : null;
  }

  get nodes() { return this.data.names.length; }
  get edges() { return this.data.ends.length / 2; }

  // The edges of a node are around[first[node]] to around[first[node + 1] - 1]; a loop occurs twice. Likewise for the halves of
  // each edge.
  findEdgesAround() {
    const { ends, edgeOf } = this.data;
    [this.first, this.around] = lists(ends, this.nodes, (i) => i >> 1);
    [this.firstHalf, this.halves] = lists(edgeOf, this.edges, (i) => i);
  }

  edgesAt(node) { return this.around.subarray(this.first[node], this.first[node + 1]); }
  halvesOf(edge) { return this.halves.subarray(this.firstHalf[edge], this.firstHalf[edge + 1]); }
  degree(node) { return this.first[node + 1] - this.first[node]; }
  ends(edge) { return [this.data.ends[2 * edge], this.data.ends[2 * edge + 1]]; }
  otherEnd(edge, node) { const [a, b] = this.ends(edge); return a === node ? b : a; }
  neighbors(node) { return [...new Set(Array.from(this.edgesAt(node), (e) => this.otherEnd(e, node)))]; }
  name(node) { return this.data.names[node]; }
  nameOfEdge(edge) { return this.ends(edge).map((node) => this.name(node)).join(' – '); }

  nodeOf(key) {
    if (!this.numbers) this.numbers = new Map(this.keys.map((k, i) => [k, i]));
    return this.numbers.get(key) ?? -1;
  }

  // Edges between two nodes in order, so that the k-th parallel edge corresponds to the k-th one of the other graph.
  edgesBetween(a, b) { return [...new Set(this.edgesAt(a))].filter((e) => this.otherEnd(e, a) === b); }

  keyOfEdge(edge) {
    const [a, b] = this.ends(edge);
    return { a: this.keys[a], b: this.keys[b], which: this.edgesBetween(a, b).indexOf(edge) };
  }

  edgeOf({ a, b, which }) {
    const [p, q] = [this.nodeOf(a), this.nodeOf(b)];
    return p < 0 || q < 0 ? -1 : this.edgesBetween(p, q)[which] ?? -1;
  }
}

// Inverts an array: for each number below `count`, the positions where it occurs, as list bounds and concatenated
// lists.
function lists(numbers, count, valueOf) {
  const first = new Uint32Array(count + 1), all = new Uint32Array(numbers.length);
  for (const n of numbers) first[n + 1]++;
  for (let i = 0; i < count; i++) first[i + 1] += first[i];
  const next = first.slice();
  numbers.forEach((n, i) => { all[next[n]++] = valueOf(i); });
  return [first, all];
}
