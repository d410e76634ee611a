import { element } from '../../../Core/Report/scripts/page.mjs';

const CATEGORIES = { // C-RADS 2023
  colonic: ['', 'C0', 'C1', 'C2', 'C2a', 'C2b', 'C3', 'C4'],
  extracolonic: ['', 'E0', 'E1', 'E2', 'E3', 'E4'],
};

// The reader's assessment of the examination. Nothing is preselected.
export class Assessment {
  constructor(root, changed) {
    Object.assign(this, { root, changed, colonic: '', extracolonic: '', note: '' });
    this.show();
  }

  get value() { return { colonic: this.colonic, extracolonic: this.extracolonic, note: this.note }; }

  // saved: the member `assessment` of a file, absent in version 1.
  take(saved = {}) {
    for (const [name, words] of Object.entries(CATEGORIES)) this[name] = words.includes(saved[name]) ? saved[name] : '';
    this.note = String(saved.note ?? '');
    this.show();
  }

  show() {
    const selects = Object.entries(CATEGORIES).map(([name, words]) => {
      const select = element('select', { name }, words.map((w) => new Option(w || 'not entered', w, false, w === this[name])));
      select.onchange = () => { this[name] = select.value; this.changed(); };
      return element('label', {}, [`${name} `, select]);
    });
    const note = element('input', { name: 'assessmentNote', className: 'note', placeholder: 'note', value: this.note });
    note.setAttribute('aria-label', 'note on the assessment');
    note.oninput = () => { this.note = note.value; this.changed(); };
    this.root.replaceChildren(element('h3', { textContent: 'Assessment' }), ...selects, note,
      element('small', { textContent: 'Category (C-RADS): entered by the reader' }));
  }
}
