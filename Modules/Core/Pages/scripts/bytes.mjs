// Data blocks: scripts of the form block("name", {header}, "base64 of gzip"), because a page opened from file:// may
// load scripts from its folder but may not fetch() files. The text of a block is released after decoding. A worker decodes
// blocks in the order of their arrival, while the page paints.

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

// Writes the unpacked bytes to `out` from `at` on; returns where they end.
async function gunzip(bytes, out, at) {
  const stream = new DecompressionStream('gzip'), writer = stream.writable.getWriter();
  writer.write(bytes).then(() => writer.close()).catch(() => {}); // the reader throws
  for (const reader = stream.readable.getReader(); ;) {
    const { done, value } = await reader.read();
    if (done) return at;
    out.set(value, at); // throws if the data are longer than stated in the header
    at += value.length;
  }
}

// Reals are stored as integers between the minimum and the maximum of their column.
function realsOf(values, { offset, step }) {
  const out = values.BYTES_PER_ELEMENT > 2 ? new Float64Array(values.length) : new Float32Array(values.length);
  for (let i = 0, k = 0; i < out.length; i++) {
    out[i] = offset[k] + step[k] * values[i];
    if (++k === step.length) k = 0;
  }
  return out;
}

async function decode({ header, parts }) {
  const type = { u8: Uint8Array, u16: Uint16Array, u32: Uint32Array }[header.type];
  const values = new type(header.count), bytes = new Uint8Array(values.buffer);
  let at = 0;
  for (const part of parts) at = await gunzip(part, bytes, at);
  if (at !== bytes.length) throw new Error(`ends after ${at} of ${bytes.length} bytes`);
  const d = header.delta;
  if (d) for (let i = d; i < values.length; i++) values[i] += values[i - d]; // modulo 2^n, as when written
  return header.step ? realsOf(values, header) : values;
}

// Runs in the worker: answers each {id, header, parts} with {id, values} or {id, why}.
function serve() {
  let last = Promise.resolve();
  const answer = async ({ id, ...found }) => {
    try {
      const values = await decode(found);
      postMessage({ id, values }, [values.buffer]);
    } catch (error) { postMessage({ id, why: error.message }); }
  };
  addEventListener('message', ({ data }) => { last = last.then(() => answer(data)); });
}

const waiting = new Map(); // blocks that the worker decodes: id to {done, fail}
let worker = null, next = 0;

function decodeBeside(header, parts) {
  if (!worker) {
    const program = `${[gunzip, realsOf, decode, serve].join('\n')}\nserve();`;
    worker = new Worker(URL.createObjectURL(new Blob([program], { type: 'text/javascript' })));
    worker.onmessage = ({ data: { id, values, why } }) => {
      const { done, fail } = waiting.get(id);
      waiting.delete(id);
      if (values) done(values); else fail(new Error(why));
    };
    worker.onerror = () => { for (const { fail } of waiting.values()) fail(new Error('the browser cannot start a worker')); };
  }
  return new Promise((done, fail) => {
    waiting.set(next, { done, fail });
    worker.postMessage({ id: next++, header, parts }, parts.map((part) => part.buffer));
  });
}

// The array of a block, with its header, or the value of a JSON block. folder: null if all blocks are in the page. version:
// distinguishes a replaced file from the previous one.
export async function readBlock(folder, name, version = '') {
  const damaged = (file, why) => new Error(`The data "${name}" in ${file} is damaged (${why}): create the page again.`);
  const fileOf = (part) => (folder === null ? 'this page' : `${folder}/${part.replaceAll('/', '-')}.js`);
  const take = async (part) => {
    if (!blocks.has(part) && folder !== null) await loadScript(fileOf(part) + version);
    const found = blocks.get(part);
    blocks.delete(part);
    if (!found) throw damaged(fileOf(part), 'truncated');
    return found;
  };
  const { header, body } = await take(name);
  if (!header) return body;
  const parts = await Promise.all(Array.from({ length: header.parts }, (_, i) => take(`${name}.${i + 1}`)));
  try {
    const packed = header.parts ? parts.map((part) => bytesOf(part.body)) : [bytesOf(body)];
    return Object.assign(await decodeBeside(header, packed), { header });
  } catch (error) {
    throw damaged(fileOf(name), error.message);
  }
}
