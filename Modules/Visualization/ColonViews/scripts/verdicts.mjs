import { distance } from '../../../Core/Pages/scripts/math.mjs';
import { element, saveFile } from '../../../Core/Pages/scripts/page.mjs';

const VERDICTS = ['unread', 'polyp', 'not a polyp', 'unsure'], ACCEPTED = 'polyp';
const MORPHOLOGIES = ['', 'flat', 'sessile', 'pedunculated'];
const VERSIONS = [1, 2];
const AT_LESION = 40; // mm; the ends of a caliper are not farther from the center of a lesion
const AT_VALVE = 6;   // mm; the valve is marked on slices up to this distance
const SAME = 6;       // mm from the surface of a candidate; a finding nearer than this may be the same lesion

const wordOf = (words, word) => (words.includes(word) ? word : words[0]);
const numberOf = (x) => (Number.isFinite(x) && x > 0 ? Math.round(10 * x) / 10 : null);
const isPoint = (p) => Array.isArray(p) && p.length === 3 && p.every(Number.isFinite);
const caliperOf = (ends) => (Array.isArray(ends) && ends.length === 2 && ends.every(isPoint) ? ends : null);
// As in report.html.
const scoreOf = (score) => (score < 0.01 ? '< 0.01' : score > 0.99 ? '> 0.99' : score.toFixed(2));
// Recognized as something else, and not listed as a possible polyp in the other position.
const isOther = ({ candidate: c }) => Boolean(c.recognizedAs) && !c.lesion;
const cmOf = (mm) => `${(mm / 10).toFixed(1)} cm from the anal verge`;

// The reader's verdicts on candidates and additional findings, as the list next to the views. Saved as verdicts.json, with the
// assessment and the bookmarks.
export class Verdicts {
  // parts: {assessment, bookmarks}; actions: jump(entry), resize(entry), changed().
  constructor(root, info, exams, parts, actions) {
    Object.assign(this, { root, exam: info.exam, exams, ...parts, actions, chosen: null, isSaved: true });
    this.isSecondReader = info.isSecondReader;
    this.isRevealed = !info.isSecondReader;
    this.entries = exams.flatMap((exam, position) => exam.info.candidates.map((candidate) => ({
      id: (position ? 'second/' : '') + candidate.candidate, position, candidate,
      verdict: VERDICTS[0], note: '', size: null, morphology: '', caliper: null,
    })));
    // Lesions of two positions in the order of the report, then by score; what was recognized as something else last.
    const rank = (entry) => (isOther(entry) ? 1 : 0), lesion = ({ candidate: c }) => (c.lesion ?? '').padStart(2);
    this.entries.sort((a, b) => rank(a) - rank(b) || (lesion(a) < lesion(b) ? -1 : lesion(a) > lesion(b) ? 1 : 0)
      || a.position - b.position || b.candidate.score - a.candidate.score);
    this.findings = [];
    if (info.verdicts) this.take(info.verdicts);
    this.list();
  }

  // What the reader sees, in the order of the list: a second reader asks for the candidates.
  get all() {
    const entries = this.isRevealed ? this.entries : [], isPolyp = (e) => !isOther(e);
    return [...entries.filter(isPolyp), ...this.findings, ...entries.filter(isOther)];
  }

  changed() {
    this.isSaved = false;
    this.actions.changed();
  }

  reveal() {
    if (this.isRevealed) return;
    this.isRevealed = true;
    this.list();
    this.changed();
  }

  // Data of an entry for the views.
  markOf(entry) {
    const chosen = entry === this.chosen, { candidate: c } = entry;
    if (c) return { text: c.candidate, xyz: c.xyz, uv: c.uv, depth: c.place.depth, chosen };
    return { text: entry.id, xyz: entry.lps, uv: entry.uv, depth: (entry.diameter || 0) / 2, chosen };
  }

  // Only what is accepted has a size by the reader.
  isSized(entry) { return !entry.candidate || entry.verdict === ACCEPTED; }

  calipers(position) {
    const shown = this.all.filter((e) => e.position === position && e.caliper);
    return shown.map((e) => ({ ends: e.caliper, text: `${(e.candidate ? e.size : e.diameter).toFixed(1)} mm` }));
  }

  // The valve is marked, too, if it is known.
  marks(position) {
    const { valve } = this.exams[position], marks = this.all.filter((e) => e.position === position).map((e) => this.markOf(e));
    return valve ? [...marks, { text: 'valve', ...valve, depth: AT_VALVE, chosen: false }] : marks;
  }

  // Selects the next or previous entry.
  step(by) {
    const { all } = this, n = all.length;
    if (n) this.choose(all[(all.indexOf(this.chosen) + by + (this.chosen || by > 0 ? 0 : 1) + n) % n]);
  }

  choose(entry) {
    this.chosen = entry;
    this.markChosen();
    if (!entry) return;
    this.itemOf(entry).scrollIntoView({ block: 'nearest' });
    this.actions.jump(entry);
  }

  markChosen() {
    for (const item of this.root.children) item.classList.toggle('chosen', Boolean(this.chosen) && item.dataset.id === this.chosen.id);
  }

  itemOf(entry) { return [...this.root.children].find((item) => item.dataset.id === entry.id); }

  // Gives the chosen candidate a verdict.
  give(verdict) { if (this.chosen?.candidate) this.setVerdict(this.chosen, verdict); }

  // One verdict for the candidates of a lesion in both positions.
  setVerdict(entry, verdict) {
    const lesion = entry.candidate?.lesion;
    for (const one of this.entries) if (one === entry || (lesion && one.candidate.lesion === lesion)) one.verdict = verdict;
    this.changed();
    this.list();
  }

  // Moves the cursor to the note or the size of what is chosen.
  write(field) { if (this.chosen) this.itemOf(this.chosen).querySelector(`.${field}`)?.focus(); }

  // Opens a link of the report to a candidate of the first position; a second reader sees its place only.
  goTo(id) {
    const entry = this.entries.find((e) => e.id === id);
    if (entry && this.isRevealed) this.choose(entry); else if (entry) this.actions.jump(entry);
  }

  addFinding(position, place) {
    const number = 1 + Math.max(0, ...this.findings.map((f) => Number(f.id.slice(1))));
    const finding = this.findingOf({ id: `F${number}`, position, lps: place.xyz, uv: place.uv });
    this.findings.push(finding);
    this.changed();
    this.list();
    this.choose(finding);
  }

  // A complete finding; files of version 1 lack its place along the colon.
  findingOf({ id, position = 0, lps, uv, diameter, note, segment, arcLength, morphology, caliper, extracolonic }) {
    const place = this.exams[position].fromXyz(lps);
    return {
      id, position, lps, uv, diameter: numberOf(diameter), note: String(note ?? ''),
      segment: segment ?? this.exams[position].nameOfSegment(place.face),
      arcLength: arcLength ?? Math.round(10 * place.arc) / 10,
      morphology: wordOf(MORPHOLOGIES, morphology), caliper: caliperOf(caliper), extracolonic: extracolonic === true,
    };
  }

  removeFinding(finding) {
    this.findings = this.findings.filter((f) => f !== finding);
    if (this.chosen === finding) this.chosen = null;
    this.changed();
    this.list();
  }

  // The size by a measurement, which stays; false if it is not at the entry.
  setCaliper(entry, mm, places) {
    const center = entry.candidate ? entry.candidate.xyz : entry.lps;
    if (places.some(({ xyz }) => distance(xyz, center) > AT_LESION)) return false;
    this.setSize(entry, mm, places.map(({ xyz }) => Array.from(xyz, (x) => Math.round(10 * x) / 10)));
    return true;
  }

  // mm, or null
  setSize(entry, size, caliper = null) {
    entry[entry.candidate ? 'size' : 'diameter'] = numberOf(size);
    entry.caliper = caliper;
    this.changed();
    this.list();
  }

  list() {
    const polyps = this.entries.filter((e) => !isOther(e)), others = this.entries.filter(isOther);
    const order = this.exams.length > 1 ? 'by lesion as in the report' : 'highest score first';
    const part = (title, all, remark = '') => (all.length ? [this.heading(title, remark), ...all.map((e) => this.item(e))] : []);
    this.root.replaceChildren(
      ...(this.isRevealed ? part(`Candidates, ${order}`, polyps, 'Scores are calibrated on synthetic patients.') : []),
      ...part('Reader findings', this.findings),
      ...(this.isRevealed ? part('Recognized as something else, or parts of another candidate', others) : []),
    );
    this.markChosen();
  }

  heading(title, remark) {
    return element('li', { className: 'title' }, [title, ...(remark ? [element('small', { textContent: remark })] : [])]);
  }

  item(entry) {
    const [title, ...facts] = entry.candidate ? this.factsOf(entry) : this.factsOfFinding(entry);
    const head = element('button', { type: 'button', className: 'head' }, [element('b', { textContent: title }), ` ${facts.join(' · ')}`]);
    head.onclick = () => this.choose(entry);
    const note = element('input', { className: 'note', placeholder: 'note', value: entry.note });
    note.setAttribute('aria-label', `note on ${entry.id}`);
    note.oninput = () => { entry.note = note.value; this.changed(); };
    const verdict = entry.candidate ? [this.select(entry, 'verdict', VERDICTS)] : [];
    const item = element('li', {}, [
      head, ...verdict, ...(this.isSized(entry) ? this.measures(entry) : []), note,
      ...(entry.candidate ? [] : [this.outside(entry), this.removal(entry)]),
    ]);
    item.dataset.id = entry.id;
    return item;
  }

  attenuationOf({ uncleansedAttenuation, meanAttenuation }) {
    const ct = uncleansedAttenuation === null ? null : Math.round(uncleansedAttenuation), cleansed = Math.round(meanAttenuation);
    return ct === null || ct === cleansed ? `${cleansed} HU` : `${ct} HU in the CT, ${cleansed} HU after cleansing`;
  }

  lesionOf({ lesion }) { return lesion ? `Lesion ${lesion}: ` : ''; }

  whereOf(entry) { return this.exams.length > 1 ? ` (${this.exams[entry.position].info.name || entry.position + 1})` : ''; }

  // The numbers of report.html.
  factsOf(entry) {
    const c = entry.candidate;
    const facts = [`${this.lesionOf(c)}${c.candidate}${this.whereOf(entry)}`, `score ${scoreOf(c.score)}`];
    facts.push(`${c.segment || 'segment unknown'}${c.arcLength === null ? '' : `, ${cmOf(c.arcLength)}`}`);
    const larger = c.lesionSize > c.diameter ? `; ${c.lesionSize.toFixed(1)} mm in the other position counts` : '';
    facts.push(`${c.diameter.toFixed(1)} mm${larger}`);
    if (c.plane) facts.push(`greatest in the ${c.plane} plane`);
    if (c.morphology) facts.push(c.morphology);
    if (c.meanAttenuation !== null) facts.push(`mean attenuation ${this.attenuationOf(c)}`);
    if (c.recognizedAs && !c.remark?.includes(c.recognizedAs)) facts.push(c.recognizedAs);
    if (c.remark) facts.push(c.remark);
    if (c.otherCandidate) facts.push(`also candidate ${c.otherCandidate} in the other position`);
    return facts;
  }

  factsOfFinding(f) {
    const where = f.extracolonic ? ['extracolonic'] : [f.segment || 'segment unknown', cmOf(f.arcLength)];
    const facts = [`${f.id}${this.whereOf(f)}`, ...where];
    if (f.diameter) facts.push(`${f.diameter.toFixed(1)} mm`);
    const isAt = (e) => e.position === f.position && distance(e.candidate.xyz, f.lps) < e.candidate.place.depth + SAME;
    const same = this.isRevealed && this.entries.find(isAt);
    if (same && !f.extracolonic) {
      facts.push(`at candidate ${same.id}: if it is the same lesion, give the verdict there and remove this finding`);
    }
    return facts;
  }

  select(entry, name, words, empty = '') {
    const select = element('select', { name }, words.map((w) => new Option(w || empty, w, false, w === entry[name])));
    select.setAttribute('aria-label', `${name} of ${entry.id}`);
    select.onchange = () => {
      if (name === 'verdict') { this.setVerdict(entry, select.value); return; }
      entry[name] = select.value;
      this.changed();
    };
    return select;
  }

  // Size and morphology by the reader.
  measures(entry) {
    const value = (entry.candidate ? entry.size : entry.diameter) ?? '';
    const size = element('input', { className: 'size', type: 'number', min: 0, step: 0.1, placeholder: 'size, mm', value });
    size.setAttribute('aria-label', `size of ${entry.id} in mm`);
    size.onchange = () => this.setSize(entry, size.valueAsNumber);
    const measure = element('button', { type: 'button', textContent: 'measure', title: 'measure with two clicks' });
    measure.onclick = () => this.actions.resize(entry);
    return [size, measure, ...(entry.extracolonic ? [] : [this.select(entry, 'morphology', MORPHOLOGIES, 'morphology')])];
  }

  // Whether a finding is outside the colon: it is listed apart and not counted as a polyp.
  outside(finding) {
    const box = element('input', { type: 'checkbox', className: 'outside', checked: finding.extracolonic });
    box.onchange = () => { finding.extracolonic = box.checked; this.changed(); this.list(); };
    return element('label', {}, [box, 'extracolonic']);
  }

  removal(finding) {
    const remove = element('button', { type: 'button', textContent: 'remove' });
    remove.onclick = () => this.removeFinding(finding);
    return remove;
  }

  document() {
    return {
      version: 2,
      exam: this.exam,
      secondReader: this.isSecondReader,
      candidatesRevealed: this.isRevealed,
      assessment: this.assessment.value,
      candidates: this.entries.map(({ id, verdict, note, size, morphology, caliper }) => ({
        id, verdict, note, size, morphology, ...(caliper ? { caliper } : {}),
      })),
      findings: this.findings.map(({ caliper, ...finding }) => ({ ...finding, ...(caliper ? { caliper } : {}) })),
      bookmarks: this.bookmarks.list,
    };
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
    if (!VERSIONS.includes(saved?.version) || !Array.isArray(saved.candidates) || !Array.isArray(saved.findings)) {
      throw new Error('This file contains no verdicts: choose a verdicts.json saved by this page.');
    }
    if (saved.exam?.sha256 !== this.exam.sha256) throw new Error('These verdicts belong to another examination; nothing was changed.');
    this.take(saved);
    this.isSaved = true;
    this.list();
    this.actions.changed();
  }

  // A reading remains that of a second reader, and candidates once shown remain so.
  take(saved) {
    const findings = saved.findings.map((f) => this.findingOf(f)); // throws before anything is changed
    this.isSecondReader ||= saved.secondReader === true;
    this.isRevealed ||= saved.candidatesRevealed === true;
    for (const entry of this.entries) {
      const { verdict, note, size, morphology, caliper } = saved.candidates.find((c) => c.id === entry.id) || {};
      const texts = { verdict: wordOf(VERDICTS, verdict), note: String(note ?? ''), morphology: wordOf(MORPHOLOGIES, morphology) };
      Object.assign(entry, texts, { size: numberOf(size), caliper: numberOf(size) && caliperOf(caliper) });
    }
    this.findings = findings;
    this.assessment.take(saved.assessment);
    this.bookmarks.take(saved.bookmarks);
    this.chosen = null;
  }
}
