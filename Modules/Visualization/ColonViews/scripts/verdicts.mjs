import { element, saveFile } from '../../../Core/Report/scripts/page.mjs';

const VERDICTS = ['unread', 'polyp', 'not a polyp', 'unsure'];

// The reader's verdicts on candidates and additional findings, as the list next to the views. Saved as verdicts.json.
export class Verdicts {
  // actions: jump(mark), resize(finding), changed().
  constructor(root, info, exams, actions) {
    Object.assign(this, { root, exam: info.exam, exams, actions, chosen: null, isSaved: true });
    this.entries = exams.flatMap((exam, position) => exam.info.candidates.map((candidate) => ({
      id: (position ? 'second/' : '') + candidate.candidate, position, candidate, verdict: VERDICTS[0], note: '',
    })));
    this.findings = [];
    if (info.verdicts) this.take(info.verdicts);
    this.list();
  }

  get all() { return [...this.entries, ...this.findings]; }

  changed() {
    this.isSaved = false;
    this.actions.changed();
  }

  // Data of an entry for the views.
  markOf(entry) {
    const chosen = entry === this.chosen, { candidate: c } = entry;
    if (c) return { text: c.candidate, xyz: c.xyz, wall: c.place.xyz, uv: c.uv, diameter: c.diameter || 0, chosen };
    return { text: entry.id, xyz: entry.lps, wall: entry.lps, uv: entry.uv, diameter: entry.diameter || 0, chosen };
  }

  marks(position) { return this.all.filter((e) => e.position === position).map((e) => this.markOf(e)); }

  // Selects the next or previous entry.
  step(by) {
    const { all } = this, n = all.length;
    if (n) this.choose(all[(all.indexOf(this.chosen) + by + (this.chosen || by > 0 ? 0 : 1) + n) % n]);
  }

  choose(entry) {
    this.chosen = entry;
    for (const item of this.root.children) item.classList.toggle('chosen', item.dataset.id === entry?.id);
    if (!entry) return;
    this.itemOf(entry).scrollIntoView({ block: 'nearest' });
    this.actions.jump(entry);
  }

  itemOf(entry) { return [...this.root.children].find((item) => item.dataset.id === entry.id); }

  // Changes the chosen entry to its next verdict.
  nextVerdict() {
    if (!this.chosen?.candidate) return;
    this.chosen.verdict = VERDICTS[(VERDICTS.indexOf(this.chosen.verdict) + 1) % VERDICTS.length];
    this.itemOf(this.chosen).querySelector('select').value = this.chosen.verdict;
    this.changed();
  }

  writeNote() { if (this.chosen) this.itemOf(this.chosen).querySelector('.note').focus(); }

  addFinding(position, place) {
    const number = 1 + Math.max(0, ...this.findings.map((f) => Number(f.id.slice(1))));
    const finding = { id: `F${number}`, position, lps: place.xyz, uv: place.uv, diameter: null, note: '' };
    this.findings.push(finding);
    this.changed();
    this.list();
    this.choose(finding);
  }

  removeFinding(finding) {
    this.findings = this.findings.filter((f) => f !== finding);
    if (this.chosen === finding) this.chosen = null;
    this.changed();
    this.list();
  }

  setDiameter(finding, diameter) {
    finding.diameter = Math.round(10 * diameter) / 10;
    this.changed();
    this.list();
  }

  list() {
    this.root.replaceChildren(...this.all.map((e) => this.item(e)));
    for (const item of this.root.children) item.classList.toggle('chosen', item.dataset.id === this.chosen?.id);
  }

  item(entry) {
    const head = element('button', { type: 'button', className: 'head', textContent: this.titleOf(entry) });
    head.onclick = () => this.choose(entry);
    const note = element('input', { className: 'note', placeholder: 'note', value: entry.note });
    note.setAttribute('aria-label', `note on ${entry.id}`);
    note.oninput = () => { entry.note = note.value; this.changed(); };
    const item = element('li', {}, [head, ...(entry.candidate ? [this.select(entry)] : this.buttons(entry)), note]);
    item.dataset.id = entry.id;
    return item;
  }

  titleOf(entry) {
    const c = entry.candidate, where = this.exams.length > 1 ? ` (${this.exams[entry.position].info.name || entry.position + 1})` : '';
    if (!c) return `${entry.id}${where} · own finding${entry.diameter ? ` · ${entry.diameter} mm` : ''}`;
    const other = c.otherCandidate ? ` · also ${c.otherCandidate} in the other` : '';
    const parts = [`${c.candidate}${where}`, c.segment || 'segment unknown', `${(c.place.arc / 10).toFixed(0)} cm`];
    if (c.diameter) parts.push(`${c.diameter.toFixed(1)} mm`);
    parts.push(`score ${c.score.toFixed(2)}`);
    return parts.join(' · ') + (c.remark ? ` · ${c.remark}` : '') + other;
  }

  select(entry) {
    const select = element('select', {}, VERDICTS.map((v) => new Option(v, v, false, v === entry.verdict)));
    select.setAttribute('aria-label', `verdict on ${entry.id}`);
    select.onchange = () => { entry.verdict = select.value; this.changed(); };
    return select;
  }

  buttons(finding) {
    const size = element('button', { type: 'button', textContent: 'size', title: 'measure with two clicks' });
    size.onclick = () => this.actions.resize(finding);
    const remove = element('button', { type: 'button', textContent: 'remove' });
    remove.onclick = () => this.removeFinding(finding);
    return [size, remove];
  }

  document() {
    const candidates = this.entries.map(({ id, verdict, note }) => ({ id, verdict, note }));
    return { version: 1, exam: this.exam, candidates, findings: this.findings };
  }

  save() {
    saveFile('verdicts.json', `${JSON.stringify(this.document(), null, 2)}\n`, 'application/json');
    this.isSaved = true;
    this.actions.changed();
  }

  // Replaces all entries by the entries in the text of a file. Throws an error with a user message, and changes nothing, if invalid.
  open(text) {
    let saved;
    try { saved = JSON.parse(text); } catch { throw new Error('This file is not JSON: choose a verdicts.json saved by this page.'); }
    if (saved?.version !== 1 || !Array.isArray(saved.candidates) || !Array.isArray(saved.findings)) {
      throw new Error('This file contains no verdicts: choose a verdicts.json saved by this page.');
    }
    if (saved.exam?.sha256 !== this.exam.sha256) throw new Error('These verdicts belong to another examination; nothing was changed.');
    this.take(saved);
    this.isSaved = true;
    this.list();
    this.actions.changed();
  }

  take(saved) {
    for (const entry of this.entries) {
      const { verdict, note } = saved.candidates.find((c) => c.id === entry.id) || {};
      Object.assign(entry, { verdict: VERDICTS.includes(verdict) ? verdict : VERDICTS[0], note: String(note ?? '') });
    }
    this.findings = saved.findings.map((f) => ({ ...f, position: f.position ?? 0 }));
    this.chosen = null;
  }
}
