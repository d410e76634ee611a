// Data blocks: scripts of the form block("name", {header}, "base64 of gzip"), because a page opened from file:// may
// load scripts from its folder but may not fetch() files. The text of a block is released after decoding.

const blocks = new Map();
globalThis.block = (name, header, body) => blocks.set(name, { header, body });

function loadScript(src) {
  return new Promise((done, fail) => {
    const script = document.createElement('script');
    script.onload = () => { script.remove(); done(); };
    script.onerror = () => fail(new Error(`The file ${src} of this page is missing.`));
    script.src = src;
    document.head.append(script);
  });
}

function bytesOf(base64) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(base64); // newer browsers; 10 times faster
  const text = atob(base64);
  const out = new Uint8Array(text.length);
  for (let i = 0; i < out.length; i++) out[i] = text.charCodeAt(i);
  return out;
}

async function gunzip(bytes, size) {
  const out = new Uint8Array(size);
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip')).getReader();
  let at = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    out.set(value, at); // throws if the data are longer than stated in the header
    at += value.length;
  }
  if (at !== size) throw new Error(`ends after ${at} of ${size} bytes`);
  return out;
}

const TYPES = { u8: Uint8Array, u16: Uint16Array, u32: Uint32Array };

// Reals are stored as integers between the minimum and the maximum of their column.
function realsOf(values, { offset, step }) {
  const out = values.BYTES_PER_ELEMENT > 2 ? new Float64Array(values.length) : new Float32Array(values.length);
  for (let i = 0, k = 0; i < out.length; i++) {
    out[i] = offset[k] + step[k] * values[i];
    if (++k === step.length) k = 0;
  }
  return out;
}

async function decode({ header, body }) {
  const type = TYPES[header.type];
  const values = new type((await gunzip(bytesOf(body), header.count * type.BYTES_PER_ELEMENT)).buffer);
  const d = header.delta;
  if (d) for (let i = d; i < values.length; i++) values[i] += values[i - d]; // modulo 2^n, as when written
  return Object.assign(header.step ? realsOf(values, header) : values, { header });
}

// The array of a block, with its header, or the value of a JSON block. folder: null if all blocks are in the page. version:
// distinguishes a replaced file from the previous one.
export async function readBlock(folder, name, version = '') {
  const file = folder === null ? 'this page' : `${folder}/${name.replaceAll('/', '-')}.js`;
  if (!blocks.has(name) && folder !== null) await loadScript(file + version);
  const found = blocks.get(name);
  blocks.delete(name);
  const damaged = (why) => new Error(`The data "${name}" in ${file} is damaged (${why}): create the page again.`);
  if (!found) throw damaged('truncated');
  if (!found.header) return found.body;
  try {
    return await decode(found);
  } catch (error) {
    throw damaged(error.message);
  }
}
