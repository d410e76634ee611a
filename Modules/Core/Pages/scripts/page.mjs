// Functions shared by script pages. A page has an element #notices for messages to the reader.
export const byId = (id) => document.getElementById(id);

export function element(tag, properties = {}, children = []) {
  const e = Object.assign(document.createElement(tag), properties);
  e.append(...children);
  return e;
}

// After a mouse click, returns the keyboard focus to the views; keyboard users keep their focus.
export const letGo = (e) => { if (e.detail) e.target.blur(); };

// Shows a permanent message.
export function notice(text) {
  byId('notices').append(element('p', { textContent: text }));
}

// Shows the reason why the page cannot be opened.
function refuse(text) {
  document.body.classList.add('failed');
  notice(text);
}

// Opens the page, or shows the reason why it cannot be opened.
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

// Saves a text as a file.
export function saveFile(name, text, type) {
  const url = URL.createObjectURL(new Blob([text], { type }));
  element('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

// Lets the page load and paint between two long computations.
export const pause = () => new Promise((done) => { setTimeout(done); });
