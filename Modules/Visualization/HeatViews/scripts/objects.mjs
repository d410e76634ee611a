import { KeyTable } from '../../../Core/Pages/scripts/keys.mjs';
import { byId, element, letGo } from '../../../Core/Pages/scripts/page.mjs';

// Objects: {number, parent, voxels, volume, probability}, the largest first; the number counts from 1, and the parent is the smallest
// object that contains it, or 0. The label of a voxel is the number of the smallest object there.
export const MOST_OBJECTS = 200; // in a transfer function, as in SavedTransferFunction
const OPACITY_OF_OBJECT = 0.9, OPACITY_AROUND = 0.3; // the latter of objects that contain others

export const OBJECT_CONTROLS = `
  <label><input id="picking" type="checkbox"> a click selects</label>
  <div><button id="larger" title="the next larger object">Larger</button><button id="all">Show all</button></div>
  <ol id="objects"></ol>`;

// See KeyTable.
export const objectKeys = new KeyTable([['Objects', [
  ['u', 'U', 'the next larger object; Shift: back to the smaller one', 'climb', 1],
  ['Shift+u', '', '', 'climb', -1],
]]], [
  ['click on a slice or the rendering', 'selects the smallest object there, if switched on'],
  ['wheel over the objects, or with Shift', 'selects the next larger or smaller object'],
]);

// page: climb(by), select({object}).
export function listenToObjects(page) {
  byId('larger').onclick = (e) => { page.climb(1); letGo(e); };
  byId('all').onclick = (e) => { page.select({ object: 0 }); letGo(e); };
  byId('objects').onwheel = (e) => { e.preventDefault(); page.climb(Math.sign(-e.deltaY)); };
}

// The object and those that contain it, from the smallest.
export function chainOf(objects, number) {
  const chain = [];
  for (let next = number; next > 0; next = objects[next - 1].parent) chain.push(next);
  return chain;
}

// The object and those in it, ascending.
export const labelsOf = (objects, number) => objects.map((o) => o.number).filter((n) => chainOf(objects, n).includes(number));

export const shortVolume = (mm3) => (mm3 < 1000 ? `${Number(mm3.toPrecision(2))} mm³` : `${Number((mm3 / 1000).toPrecision(3))} ml`);

// The list of objects; a click selects one. rowOf: the controls of an object, if any.
export function fillObjectList(root, page, objects, selected, rowOf = () => []) {
  root.replaceChildren(...objects.map((object) => {
    const text = `${object.number}: ${shortVolume(object.volume)}, ${Math.round(100 * object.probability)} %`;
    const head = element('button', { className: 'head', textContent: text, title: 'show only this object' });
    head.onclick = (e) => { page.select({ object: object.number }); letGo(e); };
    return element('li', { className: object.number === selected ? 'selected' : '' }, [head, ...rowOf(object)]);
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

// The colors with which a page opens: objects that contain others are transparent.
export function stylesOf(objects, colors) {
  const outside = new Set(objects.map((o) => o.parent));
  return objects.map(({ number }, i) => ({
    isOn: i < MOST_OBJECTS, color: colors[i % colors.length], opacity: outside.has(number) ? OPACITY_AROUND : OPACITY_OF_OBJECT,
  }));
}

// The number of the smallest shown object of each label; 0 for none. With a selected object, only this one is shown.
export function shownObjects(objects, styles, selected) {
  const isShown = (n) => (selected ? n === selected : styles[n - 1].isOn);
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

// The shown objects for savedText().
export function objectsToSave(objects, styles) {
  return objects.filter(({ number }) => styles[number - 1].isOn).map(({ number, voxels }) => {
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
    return { color, opacity, isOn: found.has(i + 1) };
  });
}
