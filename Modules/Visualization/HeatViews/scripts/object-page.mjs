import { byId, element, notice } from '../../../Core/Pages/scripts/page.mjs';
import { lowerEdge, NUMBER_OF_BINS } from './lines.mjs';
import {
  binsOfObject, chainOf, classesOf, fillObjectList, listenToObjects, MOST_OBJECTS, OBJECT_CONTROLS, rowOfObject, shownObjects,
} from './objects.mjs';

// The objects of a heat explorer. labels: the number of the smallest object of each voxel, or null; selected: a number, or 0.
export class PageWithObjects {
  constructor(objects) { Object.assign(this, { objects, selected: 0, chain: [], labels: null }); }

  listenToObjects() {
    const section = element('section', { id: 'object-panel' }, [element('b', { textContent: 'Objects' })]);
    section.insertAdjacentHTML('beforeend', OBJECT_CONTROLS);
    byId('lines').before(section);
    byId('picking').checked = true;
    listenToObjects(this);
    if (this.objects.length > MOST_OBJECTS) notice(`Only the ${MOST_OBJECTS} largest of ${this.objects.length} objects are shown.`);
  }

  fillObjects() {
    const { objects, selected, state: { styles } } = this;
    fillObjectList(byId('objects'), this, objects, selected, (object) => rowOfObject(object, styles[object.number - 1], this));
  }

  // The class of each voxel, which is its own number. Objects take precedence over lines, the smallest first; with a selected
  // object, nothing else is shown.
  classes() {
    const { objects, labels, bins, lines, selected, state: { styles } } = this;
    const ofBin = selected ? new Uint8Array(NUMBER_OF_BINS) : this.numbers;
    const ofLabel = shownObjects(objects, styles, selected).map((n) => (n ? lines.length + n : 0));
    this.ofVoxels ??= new Uint16Array(labels.length);
    const numbers = Uint16Array.from({ length: lines.length + styles.length + 1 }, (_, n) => n);
    return { values: classesOf(labels, ofLabel, bins, ofBin, this.ofVoxels), numbers };
  }

  // ---- selection ----
  get isPicking() { return this.labels !== null && byId('picking').checked; }
  clicked() { if (this.isPicking) this.selectHere(); }

  selectHere() {
    this.chain = chainOf(this.objects, this.labels[this.voxel]);
    if (this.chain.length === 0) { this.tell('no object contains the voxel under the crosshair'); return; }
    const scoreOf = (n) => this.objects[n - 1].score;
    this.select({ object: this.chain.reduce((best, n) => (scoreOf(n) > scoreOf(best) ? n : best)) });
  }

  // Shows only this object; 0: all.
  select({ object }) {
    this.noteObject(object);
    this.recolor();
    this.fillLists();
    this.tell();
  }

  // Later, climb() follows the objects that contain this one, or those that contained the last picked one.
  noteObject(object) {
    this.selected = object;
    if (!this.chain.includes(object)) this.chain = chainOf(this.objects, object);
  }

  climb(by) {
    const next = this.chain[this.chain.indexOf(this.selected) + by];
    if (next && this.selected) this.select({ object: next });
  }

  alterObject(number, part, kind = null) {
    const styles = this.state.styles.map((style, i) => (i + 1 === number ? { ...style, ...part } : style));
    const isTooMany = styles.filter((style) => style.isOn).length > MOST_OBJECTS;
    if (isTooMany) this.tell(`the maximum is ${MOST_OBJECTS} objects: hide one first`);
    else this.change({ styles }, kind && `${kind} of object ${number}`);
  }

  // Picks the heat range of an object as a line.
  pickObject(number) {
    const [first, last] = binsOfObject(this.objects, number, this.labels, this.bins);
    this.pick(lowerEdge(first), lowerEdge(last + 1), this.state.styles[number - 1].color);
  }
}
