import { element } from '../../../Core/Pages/scripts/page.mjs';

const SNAPSHOT_WIDTH = 900; // pixels of a snapshot

// A picture of views side by side in two rows, as a data URL.
export function snapshotOf(views) {
  const w = SNAPSHOT_WIDTH / 2, heights = views.map((v) => Math.round((w * v.h) / v.w));
  const rows = [0, 2].map((i) => Math.max(...heights.slice(i, i + 2)));
  const page = element('canvas', { width: SNAPSHOT_WIDTH, height: rows[0] + rows[1] }), g = page.getContext('2d');
  views.forEach((view, i) => {
    const x = (i % 2) * w, y = i < 2 ? 0 : rows[0];
    view.paint();
    g.drawImage(view.canvas, x, y, w, heights[i]);
    g.font = '13px sans-serif';
    g.fillStyle = '#ffc';
    g.fillText(view.label.textContent, x + 6, y + 14);
  });
  return page.toDataURL('image/png');
}

// Places that the reader wants to return to, each with a snapshot.
export class Bookmarks {
  // actions: go(bookmark), changed().
  constructor(root, actions) {
    Object.assign(this, { root, actions, list: [] });
    this.show();
  }

  add(position, lps, label, picture) {
    const number = 1 + Math.max(0, ...this.list.map((b) => Number(b.id.slice(1))));
    this.list.push({ id: `B${number}`, position, lps, label, picture });
    this.changed();
  }

  changed() {
    this.show();
    this.actions.changed();
  }

  // saved: the member `bookmarks` of a file, absent in version 1.
  take(saved = []) {
    const isPicture = (text) => /^data:image\/png;base64,[A-Za-z0-9+/=]+$/.test(text);
    this.list = saved.map(({ id, position, lps, label, picture }) => ({
      id: String(id), position: position ?? 0, lps, label: String(label ?? ''), picture: isPicture(picture) ? picture : '',
    }));
    this.show();
  }

  show() {
    this.root.replaceChildren(...this.list.map((b) => this.item(b)));
    if (this.list.length) this.root.prepend(element('li', { className: 'title', textContent: 'Bookmarks' }));
  }

  item(bookmark) {
    const picture = element('img', { src: bookmark.picture, alt: '' });
    const head = element('button', { type: 'button', className: 'head' }, [picture, bookmark.id]);
    head.onclick = () => this.actions.go(bookmark);
    const label = element('input', { className: 'note', placeholder: 'label', value: bookmark.label });
    label.setAttribute('aria-label', `label of ${bookmark.id}`);
    label.oninput = () => { bookmark.label = label.value; this.actions.changed(); };
    const remove = element('button', { type: 'button', textContent: 'remove' });
    remove.onclick = () => { this.list = this.list.filter((b) => b !== bookmark); this.changed(); };
    return element('li', {}, [head, label, remove]);
  }
}
