// The keys of a page, the single source of behavior and help. groups: [title, [[key, key name, text, act, value],
// ...]]; act: the page method called with the value. A key without a name is not listed.
export class KeyTable {
  constructor(groups, mouse) {
    Object.assign(this, { groups, mouse });
    this.actions = new Map(groups.flatMap(([, keys]) => keys.map(([key, , , act, value]) => [key, { act, value }])));
  }

  // One table of several; later ones take precedence.
  with(...others) { return new KeyTable([this, ...others].flatMap((t) => t.groups), [this, ...others].flatMap((t) => t.mouse)); }

  listen(page) {
    addEventListener('keydown', (e) => {
      const action = this.actionOf(e);
      if (!action) return;
      e.preventDefault();
      page[action.act](action.value);
    });
  }

  // The action of a key event, or undefined; fields and buttons handle the keys they need.
  actionOf(e) {
    const isLetter = /^[a-z]$/i.test(e.key), key = isLetter ? e.key.toLowerCase() : e.key, isCtrl = e.ctrlKey || e.metaKey;
    const isText = /^(INPUT|SELECT|TEXTAREA)$/.test(e.target.tagName) && e.target.type !== 'checkbox';
    const isButton = /^(BUTTON|SUMMARY)$/.test(e.target.tagName) || e.target.type === 'checkbox';
    if (e.altKey || (isText && !isCtrl && key !== 'Escape') || (isButton && (key === ' ' || key === 'Enter'))) return undefined;
    const shift = e.shiftKey && (isLetter || key.startsWith('Arrow')) ? 'Shift+' : '';
    return this.actions.get(`${isCtrl ? 'Ctrl+' : ''}${shift}${key}`);
  }

  fillHelp(dialog) {
    const close = document.createElement('button');
    close.textContent = 'close';
    close.onclick = () => dialog.close();
    dialog.append(close);
    for (const [title, keys] of this.groups) {
      dialog.append(tableOf(title, keys.map(([, name, text]) => [name, text]).filter(([name]) => name)));
    }
    dialog.append(tableOf('Mouse', this.mouse));
  }
}

function tableOf(title, rows) {
  const table = document.createElement('table');
  table.createCaption().textContent = title;
  for (const texts of rows) {
    const row = table.insertRow();
    for (const text of texts) row.insertCell().textContent = text;
  }
  return table;
}

// A dialog opened and closed by the same key.
export function toggle(dialog) { if (dialog.open) dialog.close(); else dialog.showModal(); }
