import { KeyTable } from '../../../Core/Pages/scripts/keys.mjs';
import { byId, element, letGo } from '../../../Core/Pages/scripts/page.mjs';

// Objects: {number, parent, isOffer, voxels, volume, score, probability}, the largest first; the number counts from 1, and the parent
// is the smallest object that contains it, or 0. Offers, for voxels in no object, follow; they are too improbable to be objects. The
// label of a voxel is the number of the smallest object there, or else of the smallest offer.
export const MOST_OBJECTS = 200; // in a transfer function, as in SavedTransferFunction
const OPACITY_OF_OBJECT = 0.9, OPACITY_AROUND = 0.3; // the latter of objects that contain others

export const OBJECT_CONTROLS = `
  <label><input id="picking" type="checkbox"> a click selects, Ctrl + click adds</label>
  <div><button id="larger" title="the next larger object">Larger</button><button id="not-this"
    title="clicks and the list no longer show the selected object">Not this</button><button id="all">Show all</button></div>
  <ol id="objects"></ol>`;

// See KeyTable.
export const objectKeys = new KeyTable([['Objects', [
  ['u', 'U', 'the next larger object; Shift: back to the smaller one', 'climb', 1],
  ['Shift+u', '', '', 'climb', -1],
  ['x', 'X', 'not this: clicks and the list no longer show the selected object', 'notThis'],
]]], [
  ['pointer over a slice', 'shows the object there, its volume and probability'],
  ['click on a slice or the rendering', 'selects the most probable object there, if switched on'],
  ['click with Ctrl', 'adds the object to the selected ones, or removes it'],
  ['wheel over the objects, or with Shift', 'selects the next larger or smaller object'],
]);

// page: climb(by), select({object}), notThis().
export function listenToObjects(page) {
  byId('larger').onclick = (e) => { page.climb(1); letGo(e); };
  byId('not-this').onclick = (e) => { page.notThis(); letGo(e); };
  byId('all').onclick = (e) => { page.select({ object: 0 }); letGo(e); };
  byId('objects').onwheel = (e) => { e.preventDefault(); page.climb(Math.sign(-e.deltaY)); };
}

// The object and those that contain it, from the smallest.
export function chainOf(objects, number) {
  const chain = [];
  for (let next = number; next > 0; next = objects[next - 1].parent) chain.push(next);
  return chain;
}

// What a click on a voxel with this label selects, as ObjectOfClick(): the best object or offer there that is not excluded; 0: none.
export function objectOfClick(objects, label, isExcluded = () => false) {
  const chain = chainOf(objects, label).filter((n) => !isExcluded(n));
  return chain.reduce((best, n) => (best && objects[best - 1].score >= objects[n - 1].score ? best : n), 0);
}

// The object and those in it, ascending.
export const labelsOf = (objects, number) => objects.map((o) => o.number).filter((n) => chainOf(objects, n).includes(number));

export const shortVolume = (mm3) => (mm3 < 1000 ? `${Number(mm3.toPrecision(2))} mm³` : `${Number((mm3 / 1000).toPrecision(3))} ml`);

export function textOf({ number, isOffer, volume, probability }) {
  return `${number}: ${shortVolume(volume)}, ${Math.round(100 * probability)} %${isOffer ? ', improbable' : ''}`;
}

// The list of these objects; a click selects one. rowOf: the controls of an object, if any.
export function fillObjectList(root, page, objects, selection, rowOf = () => []) {
  root.replaceChildren(...objects.map((object) => {
    const head = element('button', { className: 'head', textContent: textOf(object), title: 'show only this object; with Ctrl: also' });
    head.onclick = (e) => { page.select({ object: object.number, isAdded: e.ctrlKey || e.metaKey }); letGo(e); };
    const item = element('li', { className: selection.includes(object.number) ? 'selected' : '' }, [head, ...rowOf(object)]);
    item.dataset.object = object.number;
    return item;
  }));
}

// Shows color and opacity of an object. page: alterObject(number, part, kind), pickObject(number).
export function rowOfObject({ number }, { isOn, color, opacity }, page) {
  const label = (text) => ({ title: text, ariaLabel: `${text} of object ${number}` });
  const shown = element('input', { type: 'checkbox', checked: isOn, ...label('show'), onclick: letGo });
  const hue = element('input', { type: 'color', value: color, ...label('color') });
  const share = element('input', { type: 'range', min: 0, max: 1, step: 0.01, value: opacity, ...label('opacity') });
  const hint = label('pick the heat range, also of other parts, as a line');
  const line = element('button', { textContent: 'line', ...hint });
  shown.onchange = () => page.alterObject(number, { isOn: shown.checked });
  hue.oninput = () => { shown.checked = true; page.alterObject(number, { color: hue.value, isOn: true }, 'color'); };
  share.oninput = () => page.alterObject(number, { opacity: Number(share.value) }, 'opacity');
  line.onclick = (e) => { page.pickObject(number); letGo(e); };
  return [element('div', {}, [shown, hue, share, line])];
}

// The colors with which a page opens: objects that contain others are transparent, offers are hidden.
export function stylesOf(objects, colors) {
  const outside = new Set(objects.map((o) => o.parent));
  const opacityOf = (number) => (outside.has(number) ? OPACITY_AROUND : OPACITY_OF_OBJECT);
  return objects.map(({ number, isOffer }, i) => ({
    isOn: i < MOST_OBJECTS && !isOffer, isExcluded: false, color: colors[i % colors.length], opacity: opacityOf(number),
  }));
}

// The number of the smallest shown object of each label; 0 for none. With selected objects, only these are shown.
export function shownObjects(objects, styles, selection) {
  const isShown = (n) => (selection.length ? selection.includes(n) : styles[n - 1].isOn);
  return Uint16Array.from([0, ...objects.map((o) => chainOf(objects, o.number).find(isShown) ?? 0)]);
}

// Class of each voxel: that of its label, or that of its bin.
export function classesOf(labels, classOfLabel, bins, classOfBin, out) {
  for (let i = 0; i < out.length; i++) out[i] = classOfLabel[labels[i]] || classOfBin[bins[i]];
  return out;
}

// The first and the last bin of an object.
export function binsOfObject(objects, number, labels, bins) {
  const isIn = new Uint8Array(objects.length + 1);
  let first = Infinity, last = 0;
  for (const label of labelsOf(objects, number)) isIn[label] = 1;
  for (let i = 0; i < bins.length; i++) {
    if (!isIn[labels[i]]) continue;
    first = Math.min(first, bins[i]);
    last = Math.max(last, bins[i]);
  }
  return [first, last];
}

// The shown objects for savedText(), without offers, which are not in the files of HeatObjects.
export function objectsToSave(objects, styles) {
  return objects.filter(({ number, isOffer }) => styles[number - 1].isOn && !isOffer).map(({ number, voxels }) => {
    const { color, opacity } = styles[number - 1];
    return { number, labels: labelsOf(objects, number), voxels, color, opacity };
  });
}

// The colors of saved objects; the others are not shown. Throws an error with a user message if they are other objects.
export function stylesOfSaved(saved, objects, styles) {
  const isSame = (s) => s.voxels === objects[s.number - 1]?.voxels && String(s.labels) === String(labelsOf(objects, s.number));
  if (!saved.every(isSame)) throw new Error('This transfer function colors other objects than this page has: open it in its own page.');
  const found = new Map(saved.map((s) => [s.number, s]));
  return styles.map((style, i) => {
    const { color, opacity } = found.get(i + 1) ?? style;
    return { color, opacity, isOn: found.has(i + 1), isExcluded: false };
  });
}
