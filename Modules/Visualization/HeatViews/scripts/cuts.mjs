import { element, letGo } from '../../../Core/Pages/scripts/page.mjs';

const LOWER = 1, UPPER = -1; // what a plane hides: the voxels before it, or those behind it; 0: nothing

// The voxels that are shown, as the first and the last one along each axis. cuts: {through, hides, at} for each plane.
export function shownBox(cuts, size) {
  const low = [0, 0, 0], high = size.map((n) => n - 1);
  for (const { through, hides, at } of cuts) {
    if (hides === LOWER) low[through] = at;
    if (hides === UPPER) high[through] = at;
  }
  return { low, high };
}

// Planes that cut a rendering, one through each axis. Each hides the side of the viewer, then the other side, then nothing.
// planes: as written by HeatExplorer.
export class Cuts {
  constructor(view, planes) {
    const { size } = view.page.volume;
    this.view = view;
    this.cuts = planes.map(({ name, through }, i) => {
      const button = element('button', { textContent: `cut ${name}`, title: 'hides the front at the crosshair, the back, nothing' });
      const slider = element('input', { type: 'range', min: 0, max: size[through] - 1, hidden: true });
      slider.ariaLabel = `place of the ${name} cut`;
      button.onclick = (e) => { this.next(i); letGo(e); };
      slider.oninput = () => this.set(i, { at: Number(slider.value) });
      return { through, hides: 0, first: LOWER, at: 0, button, slider };
    });
    view.box.append(element('div', { className: 'cuts' }, this.cuts.map(({ button, slider }) => element('div', {}, [button, slider]))));
  }

  get box() { return shownBox(this.cuts, this.view.page.volume.size); }

  // A new cut is made at the crosshair.
  next(i) {
    const { hides, first, through } = this.cuts[i], { view } = this;
    const near = view.toIndex(view.projection(1, 1).forward)[through] > 0 ? LOWER : UPPER;
    if (!hides) this.set(i, { hides: near, first: near, at: Math.round(view.page.place[through]) });
    else this.set(i, { hides: hides === first ? -first : 0 });
  }

  set(i, part) {
    const cut = Object.assign(this.cuts[i], part);
    cut.button.classList.toggle('on', cut.hides !== 0);
    cut.slider.hidden = cut.hides === 0;
    cut.slider.value = cut.at;
    this.view.quickly();
  }
}
