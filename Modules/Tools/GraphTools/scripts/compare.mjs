const CHANGED = '#43a047', OTHER = '#ef9a9a'; // as in shapetonGraphSequencePictures.cxx
const FORM = `<label>changes from <select id="from"></select></label> <label>to <select id="to"></select></label>`;

// Changes between two graphs, by the keys of their nodes. Of each graph: its nodes and edges that the other one lacks, and the
// ends of those edges; of the second graph also the ends of edges that only the first one has.
export function changesBetween(a, b) {
  const gone = missingIn(b, a), fresh = missingIn(a, b);
  for (const edge of gone.edges) {
    for (const end of a.ends(edge)) {
      const node = b.nodeOf(a.keys[end]);
      if (node >= 0) fresh.nodes.add(node);
    }
  }
  return [gone, fresh];
}

// The nodes and edges of `graph` that `other` lacks, and the ends of those edges.
function missingIn(other, graph) {
  const edges = [...Array(graph.edges).keys()].filter((edge) => other.edgeOf(graph.keyOfEdge(edge)) < 0);
  const nodes = graph.keys.flatMap((key, node) => (other.nodeOf(key) < 0 ? [node] : []));
  return { nodes: new Set([...nodes, ...edges.flatMap((edge) => graph.ends(edge))]), edges: new Set(edges) };
}

// Shows two steps that the user chooses, with their differences in green, instead of all steps.
export class StepChooser {
  constructor(box, page) {
    this.page = page;
    box.innerHTML = FORM;
    this.selects = [...box.querySelectorAll('select')];
    this.selects.forEach((select) => {
      select.append(new Option('–', ''), ...page.views.map(({ graph }, i) => new Option(graph.data.title, i)));
      select.addEventListener('change', () => this.show());
    });
  }

  // All steps if fewer than two are chosen.
  show() {
    const { views, groups } = this.page, chosen = this.selects.map((select) => views[select.value]);
    const isChosen = chosen[0] && chosen[1] && chosen[0] !== chosen[1];
    for (const view of views) {
      view.graph.mark(null);
      view.figure.hidden = Boolean(isChosen) && !chosen.includes(view);
    }
    if (isChosen) {
      const graphs = chosen.map((view) => view.graph);
      changesBetween(...graphs).forEach((changes, i) => graphs[i].mark(changes, CHANGED, OTHER));
    }
    for (const group of groups) {
      group.root.hidden = group.views.every((view) => view.figure.hidden);
      group.changed();
    }
    this.page.selected();
  }
}
