// What pages with scripts have in common around their views. A page has an element #notices for sentences to the reader.
export const byId = (id) => document.getElementById(id);

export function element(tag, properties = {}, children = []) {
  const e = Object.assign(document.createElement(tag), properties);
  e.append(...children);
  return e;
}

// After a click with the mouse keys go to the views again; who came by keyboard stays.
export const letGo = (e) => { if (e.detail) e.target.blur(); };

// A sentence for the reader that stays.
export function notice(text) {
  byId('notices').append(element('p', { textContent: text }));
}

// Why nothing can be shown at all.
function refuse(text) {
  document.body.classList.add('failed');
  notice(text);
}

// Opens the page, or says in a sentence why it cannot.
export async function openPage(open) {
  if (typeof DecompressionStream === 'undefined') {
    refuse('This browser cannot unpack the data (it lacks DecompressionStream): use Firefox 113, Chrome 80, Safari 16.4 or newer.');
    return;
  }
  try {
    await open();
  } catch (error) {
    refuse(error.message);
    throw error;
  }
}

// Hands a text to the reader as a file.
export function saveFile(name, text, type) {
  const url = URL.createObjectURL(new Blob([text], { type }));
  element('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}
