import { element, letGo } from '../../../Core/Pages/scripts/page.mjs';

export const shortNumber = (x) => String(Number(x.toPrecision(4)));

// The list of lines next to the views. page: lines, chosen, sizeOf(line), and the button actions.
export function fillLineList(root, page) {
  root.replaceChildren(...page.lines.map((line, i) => itemOf(line, i, page)));
}

function itemOf(line, i, page) {
  const label = (text) => ({ title: text, ariaLabel: `${text} of line ${i + 1}` });
  const isOn = element('input', { type: 'checkbox', checked: line.isOn, ...label('show'), onclick: letGo });
  const color = element('input', { type: 'color', value: line.color, ...label('color') });
  const opacity = element('input', { type: 'range', min: 0, max: 1, step: 0.01, value: line.opacity, ...label('opacity') });
  const number = element('output', { textContent: line.opacity.toFixed(2) });
  const head = element('button', { className: 'head', textContent: `${shortNumber(line.lower)} to ${shortNumber(line.upper)}` });
  const open = element('button', { textContent: 'open up', ...label('give the whole axis to this range') });
  const remove = element('button', { textContent: '×', ...label('remove') });
  isOn.onchange = () => page.alterLine(i, { isOn: isOn.checked });
  color.oninput = () => page.alterLine(i, { color: color.value }, 'color');
  opacity.oninput = () => {
    number.textContent = Number(opacity.value).toFixed(2);
    page.alterLine(i, { opacity: Number(opacity.value) }, 'opacity');
  };
  head.onclick = (e) => { page.choose(i); letGo(e); };
  open.onclick = (e) => { page.openRange(line.lower, line.upper); letGo(e); };
  remove.onclick = () => page.removeLine(i);
  const size = element('small', { textContent: page.sizeOf(line) });
  const row = element('div', {}, [isOn, color, opacity, number, open, remove]);
  return element('li', { className: i === page.chosen ? 'chosen' : '' }, [head, size, row]);
}
