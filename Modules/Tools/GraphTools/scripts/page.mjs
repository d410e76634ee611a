import { toggle } from '../../../Core/Pages/scripts/keys.mjs';
import { View } from '../../../Core/Pages/scripts/view.mjs';
import { StepChooser } from './compare.mjs';
import { Disk } from './disk.mjs';
import { PageGraph } from './graph.mjs';
import { graphKeys } from './keys-of-graphs.mjs';
import { Plane } from './plane.mjs';
import { nodesNamed, Selection } from './selection.mjs';
import { Sphere } from './sphere.mjs';
import { GraphMarks, GraphPicture } from './views.mjs';

const TOOLS = `<label>search <input type="search" id="name" placeholder="name of a node" autocomplete="off"></label>
<output id="found"></output> <button type="button" id="help">keys (?)</button>
<span id="steps"></span> <span id="tracked"></span>
<p id="summary" aria-live="polite"></p><dialog id="keys"></dialog>`;
const HINT = 'Click a node or an edge, or search for a name.';
const MODELS = { spherical: Sphere, euclidean: Plane, hyperbolic: Disk };

// Graphs of one geometry with their switches; they move together.
class Group {
  constructor(root, page) {
    this.root = root;
    this.graphs = [...root.querySelectorAll('[data-graph]')].map((figure) => {
      const graph = new PageGraph(JSON.parse(document.getElementById(figure.dataset.graph).textContent));
      graph.box = figure.querySelector('.stack');
      return graph;
    });
    const { geometry, front } = this.graphs[0].data;
    this.model = new MODELS[geometry](front);
    this.listen();
    this.views = this.graphs.map((graph) => new GraphMarks(graph.box, new GraphPicture(graph.box, graph, this), page));
  }

  listen() {
    this.show = {};
    this.boxes = [...this.root.querySelectorAll('.switches input')];
    this.chooser = this.root.querySelector('.switches select');
    for (const box of this.boxes) {
      this.show[box.name] = box.checked;
      box.addEventListener('change', () => { this.show[box.name] = box.checked; this.changed(); });
    }
    const choose = () => { if (this.chooser) this.model.choice = this.chooser.value; };
    this.chooser?.addEventListener('change', () => { choose(); this.changed(); });
    this.root.querySelector('.switches button').addEventListener('click', () => this.reset());
    choose();
  }

  changed() { this.views.forEach((view) => view.picture.changed()); }

  reset() {
    this.model.reset();
    this.changed();
  }

  // Same as clicking the checkbox.
  flip(name) { this.boxes.find((box) => box.name === name)?.click(); }

  project() {
    if (!this.chooser) return;
    this.chooser.selectedIndex = 1 - this.chooser.selectedIndex;
    this.chooser.dispatchEvent(new Event('change'));
  }
}

class GraphPage {
  constructor() {
    const tools = document.getElementById('tools');
    tools.innerHTML = TOOLS;
    this.groups = [...document.querySelectorAll('.graph-group')].map((root) => new Group(root, this));
    this.views = this.groups.flatMap((group) => group.views);
    const { colors, nodes, isSequence } = JSON.parse(document.getElementById('tracking').textContent);
    this.selection = new Selection(this.views.map((view) => view.graph), colors);
    if (isSequence) this.steps = new StepChooser(document.getElementById('steps'), this);
    this.matches = [];
    this.focusOn(this.views[0]);
    graphKeys.listen(this);
    graphKeys.fillHelp(document.getElementById('keys'));
    document.getElementById('help').addEventListener('click', () => this.help());
    this.listenToField();
    nodes.forEach((key) => this.selection.track(key));
    this.showTracked();
    this.selected();
  }

  listenToField() {
    this.field = document.getElementById('name');
    this.field.addEventListener('input', () => this.find());
    this.field.addEventListener('keydown', (e) => {
      if (e.key === 'Enter') this.stepNode(e.shiftKey ? -1 : 1);
    });
  }

  focusOn(view) {
    this.view = view;
    this.views.forEach((v) => v.box.classList.toggle('active', v === view && this.views.length > 1));
  }

  // Called after a change of the selection.
  selected() {
    document.getElementById('summary').textContent = this.selection.describe() || HINT;
    this.tellFound();
    this.views.forEach((view) => view.changed());
  }

  // Tracks the selected node, or no longer.
  track(key = this.selection.node >= 0 ? this.selection.key : null) {
    if (key !== null) {
      this.selection.track(key);
      this.showTracked();
      this.groups.forEach((group) => group.changed());
    }
    this.selected();
  }

  showTracked() {
    const buttons = [...this.selection.tracked].map(([key, color]) => {
      const button = Object.assign(document.createElement('button'), { type: 'button', title: 'no longer track this node' });
      button.textContent = `${this.selection.nameOf(key)} ×`;
      button.style.borderColor = color;
      button.onclick = () => this.track(key);
      return button;
    });
    document.getElementById('tracked').replaceChildren(...(buttons.length ? ['tracked: ', ...buttons] : []));
  }

  // Nodes that match the text of the field: in the view with the keyboard focus, else in the first one with matches.
  find() {
    const order = [this.view, ...this.views.filter((view) => view !== this.view)];
    const view = order.find((v) => nodesNamed(v.graph, this.field.value).length);
    this.matches = view ? nodesNamed(view.graph, this.field.value) : [];
    if (view) {
      this.focusOn(view);
      this.choose(this.matches[0]);
    } else {
      this.tellFound();
    }
  }

  tellFound() {
    const at = this.matches.indexOf(this.selection.node) + 1;
    const text = !this.field.value ? '' : !this.matches.length ? 'no matching node' : `${at || '–'} of ${this.matches.length}`;
    document.getElementById('found').textContent = text;
  }

  choose(node) {
    this.selection.chooseNode(this.view.graph, node);
    this.selected();
    this.bring();
  }

  // ---- key actions ----
  search() { this.field.select(); this.field.focus(); }
  help() { toggle(document.getElementById('keys')); }
  flip(name) { this.view.group.flip(name); }
  project() { this.view.group.project(); }
  reset() { this.view.group.reset(); }
  zoom(amount) { this.view.zoom(amount); }

  nextView() {
    this.focusOn(this.views[(this.views.indexOf(this.view) + 1) % this.views.length]);
    this.view.box.scrollIntoView({ block: 'nearest' });
  }

  stepNode(by) {
    const { graph } = this.view, list = this.matches.length ? this.matches : graph.data.names.map((_, i) => i);
    const marks = this.selection.marksIn(graph), at = marks ? list.indexOf(marks.node) : -1;
    this.choose(list[at < 0 ? (by > 0 ? 0 : list.length - 1) : (at + by + list.length) % list.length]);
  }

  stepEdge(by) { this.selection.stepAround(by); this.selected(); }
  follow() { this.selection.follow(); this.selected(); this.bring(); }

  // Starts off-center, because turning with Shift requires a lever arm.
  move([dx, dy, isShift]) {
    const { model } = this.view.group, from = isShift && model.step === 2 ? [dy && 0.5, dx && 0.5] : [0, 0];
    model.drag(from, [from[0] + dx, from[1] + dy], Boolean(isShift));
    this.view.group.changed();
  }

  bring() {
    const marks = this.selection.marksIn(this.view.graph);
    if (marks) this.view.center(marks.node >= 0 ? marks.node : marks.near[0]);
  }

  leave() {
    const help = document.getElementById('keys');
    if (help.open) { help.close(); return; }
    this.field.value = '';
    this.field.blur();
    this.matches = [];
    this.selection.clear();
    this.selected();
  }

  // For tests: whether everything requested has been painted.
  async idle() {
    do await new Promise((done) => { requestAnimationFrame(() => setTimeout(done)); });
    while (View.pending);
  }
}

export function startGraphPage() { globalThis.graphPage = new GraphPage(); }
