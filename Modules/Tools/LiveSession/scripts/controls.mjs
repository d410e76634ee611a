import { byId, element } from '../../../Core/Pages/scripts/page.mjs';
import { KeyTable } from '../../../Core/Pages/scripts/keys.mjs';
import { fillObjectList, listenToObjects, OBJECT_CONTROLS } from '../../../Visualization/HeatViews/scripts/objects.mjs';

const LONGEST = 6; // decades of time steps on the slider
const STEPS_OF_SLIDER = 600;

export const CONTROLS = `
<div><button id="move">Pause</button><button id="once">Step</button>
  <label>steps/s <input id="speed" type="number" min="0" max="1000000" value="0" title="0: as fast as possible"></label></div>
<fieldset id="options"><legend>Shapetons</legend></fieldset>
<div id="change" role="status" title="the last change, which Undo reverts"></div>
<fieldset><legend>Shown</legend>
  <label><input type="radio" name="shown" value="density" checked> density of shapetons</label>
  <label><input type="radio" name="shown" value="heat"> heat after <output id="time"></output> steps</label>
  <input id="slider" type="range" min="0" max="600" aria-label="time steps of the heat">
  <label><input id="served" type="checkbox"> rendered by the server</label></fieldset>
<fieldset><legend>Objects</legend>
  <button id="find" title="chooses window, p, smoothing and time such that objects separate, and lists them">Find objects</button>
  <button id="list" title="lists the objects of this heat">Objects of this heat</button>
  ${OBJECT_CONTROLS}</fieldset>
<fieldset><legend>Region of start or barrier</legend>
  <select id="region" aria-label="region"><option value="everywhere">everywhere</option>
    <option value="sphere">sphere at the crosshair</option><option value="brush">brush on the slices</option>
    <option value="object">connected line at the crosshair</option>
    <option value="selected">selected objects</option><option value="axial">axial plane at the crosshair</option>
    <option value="coronal">coronal plane</option><option value="sagittal">sagittal plane</option>
    <option value="file">mask file</option></select>
  <label>radius, mm <input id="radius" type="number" min="0.1" step="0.5" value="5"></label>
  <label>file <input id="mask" placeholder="labels.nrrd"></label>
  <label>label <input id="label" type="number" min="0" max="65535" value="0" title="0: all labels"></label>
  <label><input id="at-once" type="checkbox" checked> start in each stroke of the brush</label>
  <div><button id="start">Start there</button>
    <button id="exclude" title="heat flows around this region">Not there</button></div></fieldset>
<fieldset><legend>Save</legend><label>name <input id="name" value="session"></label>
  <label><input id="labels" type="checkbox"> labels</label>
  <label><input id="alone" type="checkbox"> of the objects only the selected one</label>
  <button id="save">Save</button><div id="saved" role="status"></div></fieldset>`;

// Options of the walk: numbers with step and range, or words.
const OPTIONS = [
  ['p', { min: 0, max: 1000, step: 0.5 }], ['distance', { min: 0.001, max: 1, step: 0.005 }],
  ['shapetons', { min: 1, max: 100000000, step: 1000 }], ['smoothing', { min: 0, max: 100, step: 0.1 }],
  ['directionSampling', ['solidAngle', 'sectorArea', 'uniform']], ['pathRule', ['endpoint', 'traversal']],
  ['placement', ['uniform', 'initialHeat']], ['seed', { min: 0, max: 2147483647, step: 1 }],
];

const ENDS = ['lower', 'upper']; // of the intensity window

// A number field that is emptied returns to its last value, and its change is not reported.
function keepNumbers(root) {
  root.addEventListener('change', (e) => {
    const { target: field } = e;
    if (field.type !== 'number') return;
    if (field.value === '') {
      e.stopPropagation();
      field.value = field.kept ?? field.defaultValue;
    }
    field.kept = field.value;
  }, true);
}

// See KeyTable; methods of the session.
export const sessionKeys = new KeyTable([['Session', [
  [' ', 'Space', 'pause or move', 'toggleMoving'],
  ['.', '.', 'one step', 'stepOnce'],
  ['d', 'D', 'density or heat', 'toggleShown'],
  ['Ctrl+Enter', 'Ctrl Enter', 'save to the folder of the session', 'saveToFolder'],
]]], [['drag over a slice', 'moves the crosshair, or paints the start region']]);

const stepsOfSlider = (value) => Math.round(10 ** ((LONGEST * value) / STEPS_OF_SLIDER));
const sliderOfSteps = (steps) => Math.round((STEPS_OF_SLIDER * Math.log10(Math.max(1, steps))) / LONGEST);

// The controls next to the views. session: ask(command) and actions; state: as sent by the server.
export class Controls {
  constructor(session) {
    this.session = session;
    this.fields = new Map(OPTIONS.map(([name, range]) => [name, this.field(name, range)]));
    byId('options').append(...[...this.fields].map(([name, field]) => element('label', { textContent: `${name} ` }, [field])));
    this.ends = ENDS.map((end) => this.endOfWindow(end));
    byId('options').append(element('label', { textContent: 'intensityWindow ' }, this.ends));
    keepNumbers(byId('controls'));
    const on = (id, act) => { byId(id).onclick = (e) => { act(); e.currentTarget.blur(); }; };
    on('move', () => session.toggleMoving());
    on('once', () => session.stepOnce());
    on('start', () => session.startThere());
    on('exclude', () => session.excludeThere());
    on('find', () => session.findObjects(true));
    on('list', () => session.findObjects(false));
    listenToObjects(session);
    on('save', () => session.saveToFolder());
    byId('speed').onchange = () => session.ask({ do: 'speed', stepsPerSecond: Number(byId('speed').value) });
    byId('served').onchange = () => session.askPicture();
    byId('region').onchange = () => session.regionChosen();
    byId('slider').oninput = () => {
      byId('time').textContent = stepsOfSlider(Number(byId('slider').value)).toLocaleString('en');
      this.showHeatSoon();
    };
    for (const radio of document.getElementsByName('shown')) radio.onchange = () => this.showChosen();
  }

  // A change takes effect when the field is left, or at once by its arrows; while it is edited, it is not overwritten.
  field(name, range) {
    const isWord = Array.isArray(range), field = element(isWord ? 'select' : 'input', isWord ? {} : { type: 'number', ...range });
    if (isWord) field.append(...range.map((word) => new Option(word, word)));
    field.id = `option-${name}`;
    field.onchange = () => this.set({ [name]: isWord ? field.value : Number(field.value) });
    return field;
  }

  endOfWindow(end) {
    const field = element('input', { type: 'number', step: 'any', id: `window-${end}`, className: 'end' });
    field.ariaLabel = `${end} end of the window`;
    field.onchange = () => this.set({ intensityWindow: this.ends.map(({ value }) => Number(value)) });
    return field;
  }

  // A refused value is replaced by the current one.
  async set(options) {
    if (!await this.session.ask({ do: 'set', ...options })) this.showOptions(this.session.state0.options, true);
  }

  showOptions({ intensityWindow, ...options }, isForced = false) {
    const write = (field, value) => { if (isForced || document.activeElement !== field) field.value = field.kept = value; };
    for (const [name, field] of this.fields) write(field, options[name]);
    (intensityWindow ?? ['', '']).forEach((value, i) => write(this.ends[i], value)); // a constant volume has no window
  }

  get heatSteps() { return stepsOfSlider(Number(byId('slider').value)); }
  get isHeatChosen() { return document.querySelector('[name=shown]:checked').value === 'heat'; }
  showChosen() { this.session.ask(this.isHeatChosen ? { do: 'heat', timeSteps: this.heatSteps } : { do: 'density' }); }

  // While the slider moves, requests follow one another without a queue.
  async showHeatSoon() {
    this.isWanted = true;
    if (this.isAsking) return;
    this.isAsking = true;
    while (this.isWanted) {
      this.isWanted = false;
      document.querySelector('[name=shown][value=heat]').checked = true;
      await this.session.ask({ do: 'heat', timeSteps: this.heatSteps });
    }
    this.isAsking = false;
  }

  show(state) {
    this.showOptions(state.options);
    if (document.activeElement !== byId('speed')) byId('speed').value = state.speed;
    byId('change').textContent = state.lastChange;
    if (!this.isAsking && document.activeElement !== byId('slider')) {
      byId('slider').value = sliderOfSteps(state.heatSteps);
      byId('time').textContent = state.heatSteps.toLocaleString('en');
    }
    if (!this.isAsking) document.querySelector(`[name=shown][value=${state.shown}]`).checked = true;
    byId('move').textContent = state.isMoving ? 'Pause' : 'Move';
    byId('progress').textContent = state.error || describe(state);
    if (state.objects === null) byId('objects').replaceChildren();
    else if (state.objects !== this.objectsShown) this.session.findObjects(false);
    this.objectsShown = state.objects;
  }

  list({ objects, selection }) {
    const listed = objects.filter(({ number, isOffer }) => !isOffer || selection.includes(number));
    fillObjectList(byId('objects'), this.session, listed, selection);
  }
}

function describe({ shown, stage, share, step, isMoving, stepsPerSecond, coverage, heatSteps, quality }) {
  const coarse = quality === 'coarse' ? ', coarse' : '';
  if (shown === 'heat') {
    const work = stage ? `, ${stage}: ${Math.round(100 * share)} %` : '';
    return `heat after ${heatSteps.toLocaleString('en')} steps${coarse}${work}`;
  }
  const speed = isMoving ? `, ${stepsPerSecond} steps/s` : ', paused';
  return `step ${step.toLocaleString('en')}${speed}, coverage ${(100 * coverage).toFixed(1)} %${coarse}`;
}
