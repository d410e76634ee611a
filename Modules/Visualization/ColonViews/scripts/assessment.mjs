import { element } from '../../../Core/Pages/scripts/page.mjs';

// C-RADS 2023 (Yee et al., Radiology 2024) with the names of its first version. The descriptions are help only.
const CATEGORIES = {
  colonic: {
    '': 'not entered',
    C0: 'inadequate, or waits for earlier studies',
    C1: 'normal, or benign lesion',
    C2: 'as C2a, without the subdivision of 2023',
    C2a: '1 or 2 polyps of 6 to 9 mm, or indeterminate',
    C2b: 'likely benign diverticular finding',
    C3: 'polyp of 10 mm or more, or 3 or more of 6 to 9 mm',
    C4: 'likely malignant; a mass is 30 mm or more',
  },
  extracolonic: {
    '': 'not entered',
    E0: 'limited examination',
    E1: 'normal, or variant',
    E2: 'unimportant',
    'E1/E2': 'E1 or E2, as in C-RADS 2023',
    E3: 'likely unimportant, incompletely characterized',
    E4: 'potentially important',
  },
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
    for (const [name, words] of Object.entries(CATEGORIES)) this[name] = Object.hasOwn(words, saved[name]) ? saved[name] : '';
    this.note = String(saved.note ?? '');
    this.show();
  }

  show() {
    const selects = Object.entries(CATEGORIES).map(([name, words]) => {
      const select = element('select', { name }, Object.entries(words).map(([word, help]) =>
        new Option(word ? `${word}: ${help}` : help, word, false, word === this[name])));
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
