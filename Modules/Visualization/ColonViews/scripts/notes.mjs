import { element, notice } from '../../../Core/Pages/scripts/page.mjs';

const LIMITATIONS = [
  'For research use; not a diagnosis, and not a medical device.',
  'The list of candidates may miss polyps. A candidate may be stool, the ileocecal valve or the end of a fold.',
  'Scores are calibrated on synthetic patients.',
  'Light gray wall is interpolated (no CT data): polyps there are not shown.',
  'Wall that cannot be flattened, such as heads on stalks, is not shown on the unfolded view: look at the slices.',
  'Electronic cleansing may remove or add structures: check each finding on the original CT.',
  'Sizes on the unfolded view are distorted: measure on slices or along the wall.',
  'The volume ends 15 mm beyond the colon: the page does not suit extracolonic findings.',
  'Check that both directions of the fly-through have been seen; wall behind folds is visible from one side only.',
];

// Items of a folded list; warnings that differ only in numbers are folded again.
function itemOf({ text, warnings }) {
  if (warnings.length === 1) return element('li', { textContent: warnings[0] });
  const all = element('ul', {}, warnings.map((w) => element('li', { textContent: w })));
  return element('li', {}, [element('details', {}, [element('summary', { textContent: `${warnings.length} times: ${text}` }), all])]);
}

const sentence = (text) => element('li', { textContent: text });

function folded(id, title, items) {
  return element('details', { id }, [element('summary', { textContent: title }), element('ul', {}, items)]);
}

// The folded lists of warnings and limitations.
export function fillNotes(root, { warnings, positions, stated }, exams, bits) {
  const number = warnings.reduce((sum, kind) => sum + kind.warnings.length, 0);
  const limits = [...LIMITATIONS, ...positions.map(({ name }, k) => evaluableOf(exams[k], positions.length > 1 ? name || k + 1 : ''))];
  if (bits === 8) limits.push('HU are stored in steps of 6 up to 320 HU, and of 40 up to 1560 HU.');
  root.replaceChildren(folded('warnings', `Warnings of the examination (${number})`, warnings.map(itemOf)),
    folded('stated', `Limitations of this examination (${stated.limitations.length})`, stated.limitations.map(sentence)),
    folded('limitations', `Limits of this page (${limits.length})`, limits.map(sentence)));
}

// Share of the centerline around which the wall is evaluable.
function evaluableOf({ center }, name) {
  const good = center.filter((c) => !c.hindrance).length / center.length;
  return `The wall is evaluable along ${Math.floor(100 * good)} % of the centerline${name ? ` (${name})` : ''}.`;
}

// "sigmoid 46 %": segments of which less than 90 % of the length is evaluable.
const hiddenSegments = ({ segments }) => segments.filter((s) => s.share < 0.9).map((s) => `${s.name} ${Math.round(100 * s.share)} %`);

// Notices to show before reading.
export function tellMissing(info, painter) {
  const [{ name }] = info.positions;
  if (info.stated.note) notice(info.stated.note);
  else if (info.positions.length === 1) notice(`${name || 'Position unknown'}; one position only, so the examination is incomplete.`);
  for (const position of info.positions) {
    const hidden = hiddenSegments(position);
    if (hidden.length) notice(`Evaluable length${info.positions.length > 1 ? ` (${position.name})` : ''}: ${hidden.join(', ')}.`);
  }
  if (!painter.gl) notice('This browser has no WebGL 2: unfolded view, slices and verdicts work, both 3D views do not.');
  for (const position of info.positions) {
    const { missing, name } = position, what = missing.filter((m) => m !== 'CT');
    if (missing.includes('CT')) notice('This run is based on a lumen mask: slices show the mask, not a CT.');
    if (what.length) notice(`The run has no ${what.join(', ')}${name ? ` (${name})` : ''}.`);
  }
  if (info.positions.length > 1 && !info.hasMap) notice('The run has no registration: the positions are not linked.');
}
