import { byId, element, notice } from '../../../Core/Pages/scripts/page.mjs';
import { lowerEdge, NUMBER_OF_BINS } from './lines.mjs';
import {
  binsOfObject, chainOf, classesOf, fillObjectList, listenToObjects, MOST_OBJECTS, OBJECT_CONTROLS, objectOfClick, rowOfObject,
  shownObjects, textOf,
} from './objects.mjs';

// The objects of a heat explorer. labels: the number of the smallest object of each voxel, or null; selection: numbers of objects, the last
// selected one at the end; pointed: the number of the object under the pointer, or 0.
export class PageWithObjects {
  constructor(objects) { Object.assign(this, { objects, selection: [], pointed: 0, chain: [], labels: null }); }

  get selected() { return this.selection.at(-1) ?? 0; }

  listenToObjects() {
    const section = element('section', { id: 'object-panel' }, [element('b', { textContent: 'Objects' })]);
    section.insertAdjacentHTML('beforeend', OBJECT_CONTROLS);
    byId('lines').before(section);
    byId('picking').checked = true;
    listenToObjects(this);
    const { length } = this.objects.filter((object) => !object.isOffer);
    if (length > MOST_OBJECTS) notice(`Only the ${MOST_OBJECTS} largest of ${length} objects are shown.`);
  }

  // The objects that are not excluded, and the offers that are selected or shown.
  fillObjects() {
    const { objects, selection, state: { styles } } = this;
    const isListed = ({ number, isOffer }) => !this.isExcluded(number)
      && (!isOffer || styles[number - 1].isOn || selection.includes(number));
    const rowOf = (object) => rowOfObject(object, styles[object.number - 1], this);
    fillObjectList(byId('objects'), this, objects.filter(isListed), selection, rowOf);
  }

  isExcluded(number) { return this.state.styles[number - 1].isExcluded; }

  // The class of each label and bin. Objects take precedence over lines, the smallest first; with selected objects, nothing else is
  // shown.
  setClasses() {
    const { objects, lines, selection, state: { styles } } = this;
    this.ofBin = selection.length ? new Uint8Array(NUMBER_OF_BINS) : this.numbers;
    this.ofLabel = shownObjects(objects, styles, selection).map((n) => (n ? lines.length + n : 0));
  }

  // The class of each voxel, which is its own number.
  classes() {
    const { labels, bins, lines, ofBin, ofLabel, state: { styles } } = this;
    this.ofVoxels ??= new Uint16Array(labels.length);
    const numbers = Uint16Array.from({ length: lines.length + styles.length + 1 }, (_, n) => n);
    return { values: classesOf(labels, ofLabel, bins, ofBin, this.ofVoxels), numbers };
  }

  // ---- selection ----
  get isPicking() { return this.labels !== null && byId('picking').checked; }
  clicked(isAdded) { if (this.isPicking) this.selectHere(isAdded); }
  objectAt(voxel) { return this.labels ? objectOfClick(this.objects, this.labels[voxel], (n) => this.isExcluded(n)) : 0; }

  selectHere(isAdded = false) {
    const object = this.objectAt(this.voxel);
    this.chain = chainOf(this.objects, this.labels[this.voxel]);
    if (object) this.select({ object, isAdded });
    else this.tell('no region around the voxel under the crosshair has a probability of 1 % or more');
  }

  // Shows only this object; added: also this object, or no longer; 0: all.
  select({ object, isAdded = false }) {
    const others = this.selection.filter((n) => n !== object);
    const isRemoved = isAdded && others.length < this.selection.length;
    this.noteSelection(isAdded ? [...others, ...(isRemoved ? [] : [object])] : [object].filter(Boolean));
    this.recolor();
    this.fillLists();
    this.tell(this.describeSelection());
  }

  // Later, climb() follows the objects that contain the last one, or those that contained the last picked one.
  noteSelection(selection) {
    this.selection = selection;
    if (!this.chain.includes(this.selected)) this.chain = chainOf(this.objects, this.selected);
  }

  describeSelection() {
    const { selection } = this;
    return selection.length ? `${this.describe()}; selected, as a mask: HeatObjects --objects ${selection.join()}` : null;
  }

  // Clicks and the list no longer show the selected objects.
  notThis() {
    const { selection } = this;
    if (!selection.length) { this.tell('select an object first'); return; }
    const styles = this.state.styles.map((style, i) => (selection.includes(i + 1) ? { ...style, isOn: false, isExcluded: true } : style));
    this.noteSelection([]);
    this.change({ styles });
  }

  // The pointer is over a voxel, given by its index; null: over none.
  pointAt(voxel) {
    const object = voxel === null ? 0 : this.objectAt(voxel);
    if (object === this.pointed) return;
    this.pointed = object;
    this.repaintSlices();
    this.tell(object ? `object ${textOf(this.objects[object - 1])}` : this.describeSelection());
  }

  climb(by) {
    const next = this.chain[this.chain.indexOf(this.selected) + by];
    if (!next || !this.selected) return;
    this.noteSelection([...this.selection.slice(0, -1).filter((n) => n !== next), next]);
    this.recolor();
    this.fillLists();
    this.tell(this.describeSelection());
  }

  alterObject(number, part, kind = null) {
    const styles = this.state.styles.map((style, i) => (i + 1 === number ? { ...style, ...part, isExcluded: false } : style));
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
