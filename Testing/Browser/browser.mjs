// Drives Debian's Chromium without npm packages, by the DevTools protocol over a pipe (file descriptors 3 and 4, 0-terminated).
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

const FLAGS = [
  '--headless=new', '--no-sandbox', '--remote-debugging-pipe', '--no-first-run', '--disable-extensions', '--disable-component-update',
  '--disable-background-networking', '--disable-gpu-compositing', // as in a browser without a graphics card
];
const SOFTWARE_GL = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
const NO_GL = ['--disable-gpu', '--disable-3d-apis'];

// Sends requests and receives responses over the pipe; dispatches events to the listeners.
class Pipe {
  constructor(child) {
    const [, , , to, from] = child.stdio;
    Object.assign(this, { to, waiting: new Map(), listeners: [], next: 1, rest: '' });
    from.setEncoding('utf8');
    from.on('data', (text) => this.receive(text));
    child.on('exit', () => this.waiting.forEach(({ fail }) => fail(new Error('Chromium has ended'))));
  }

  receive(text) {
    const parts = (this.rest + text).split('\0');
    this.rest = parts.pop();
    for (const message of parts.map((part) => JSON.parse(part))) {
      const asked = this.waiting.get(message.id);
      this.waiting.delete(message.id);
      if (!asked) this.listeners.forEach((listen) => listen(message));
      else if (message.error) asked.fail(new Error(JSON.stringify(message.error)));
      else asked.done(message.result);
    }
  }

  send(method, params = {}, sessionId = undefined) {
    return new Promise((done, fail) => {
      this.waiting.set(this.next, { done, fail });
      this.to.write(`${JSON.stringify({ id: this.next++, method, params, sessionId })}\0`);
    });
  }
}

// A page with user actions. errors: exceptions and logged errors; requests: requested addresses.
class Page {
  constructor(child, pipe, session, profile) {
    Object.assign(this, { child, pipe, session, profile, errors: [], requests: [], dialogs: [] });
    pipe.listeners.push((m) => this.note(m));
  }

  note({ method, params }) {
    const { exceptionDetails: thrown, args } = params;
    if (method === 'Runtime.exceptionThrown') this.errors.push(thrown.exception?.description || thrown.text);
    const isError = method === 'Runtime.consoleAPICalled' && params.type === 'error';
    if (isError) this.errors.push(args.map((a) => a.value ?? a.description).join(' '));
    if (method === 'Network.requestWillBeSent') this.requests.push(params.request.url.slice(0, 200));
    if (method === 'Page.javascriptDialogOpening') {
      this.dialogs.push(params.type);
      this.send('Page.handleJavaScriptDialog', { accept: true });
    }
  }

  send(method, params) { return this.pipe.send(method, params, this.session); }

  open(file) { return this.visit(`file://${resolve(file)}`); }

  async visit(url) {
    const loaded = new Promise((done) => { this.pipe.listeners.push((m) => { if (m.method === 'Page.loadEventFired') done(); }); });
    await this.send('Page.navigate', { url });
    await loaded;
  }

  // Evaluates a function in the page.
  async evaluate(f, ...args) {
    const expression = `(${f})(...${JSON.stringify(args)})`;
    const { result, exceptionDetails } = await this.send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description || exceptionDetails.text);
    return result.value;
  }

  async until(f, limit = 60000, ...args) {
    for (const end = Date.now() + limit; ;) {
      const value = await this.evaluate(f, ...args);
      if (value) return value;
      if (Date.now() > end) throw new Error(`timeout while waiting for ${f}`);
      await new Promise((done) => { setTimeout(done, 50); });
    }
  }

  mouse(type, x, y, extra = {}) {
    const isMove = type === 'mouseMoved';
    return this.send('Input.dispatchMouseEvent', { type, x, y, button: isMove ? 'none' : 'left', clickCount: isMove ? 0 : 1, ...extra });
  }

  async click(x, y, extra = {}) {
    await this.move(x, y);
    await this.mouse('mousePressed', x, y, extra);
    await this.mouse('mouseReleased', x, y, extra);
  }

  move(x, y) { return this.mouse('mouseMoved', x, y); }

  wheel(x, y, deltaY, extra = {}) { return this.mouse('mouseWheel', x, y, { button: 'none', deltaX: 0, deltaY, ...extra }); }

  // modifiers: 2 is Ctrl, 8 is Shift.
  async key(key, modifiers = 0) {
    const text = key.length === 1 && modifiers !== 2 ? key : undefined;
    await this.send('Input.dispatchKeyEvent', { type: 'keyDown', key, text, modifiers });
    await this.send('Input.dispatchKeyEvent', { type: 'keyUp', key, modifiers });
  }

  async chooseFile(selector, file) {
    const { root } = await this.send('DOM.getDocument', {});
    const { nodeId } = await this.send('DOM.querySelector', { nodeId: root.nodeId, selector });
    await this.send('DOM.setFileInputFiles', { files: [resolve(file)], nodeId });
  }

  // The file of this name that act() saves in the folder `downloads` of launch(), after at most 5 s.
  async saved(name, act) {
    const file = join(this.downloads, name);
    rmSync(file, { force: true });
    await act();
    for (let i = 0; i < 100 && !existsSync(file); i++) await new Promise((done) => { setTimeout(done, 50); });
    return file;
  }

  async screenshot(file) {
    const { data } = await this.send('Page.captureScreenshot', { format: 'png' });
    writeFileSync(file, Buffer.from(data, 'base64'));
  }

  async size(width, height, deviceScaleFactor = 1) {
    await this.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor, mobile: false });
  }

  async close() {
    const gone = new Promise((done) => { this.child.on('exit', done); });
    this.pipe.send('Browser.close').catch(() => this.child.kill());
    await gone;
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

// hasGl: with software WebGL or without WebGL; downloads: folder of saved files.
export async function launch({ width = 1600, height = 1000, downloads = null, hasGl = true } = {}) {
  const profile = mkdtempSync(join(tmpdir(), 'shapeton-browser-'));
  const flags = [...FLAGS, ...(hasGl ? SOFTWARE_GL : NO_GL), `--user-data-dir=${profile}`, `--window-size=${width},${height}`];
  const stdio = ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'];
  const child = spawn(process.env.CHROMIUM || 'chromium', [...flags, 'about:blank'], { stdio });
  const pipe = new Pipe(child);
  const { targetId } = await pipe.send('Target.createTarget', { url: 'about:blank' });
  const { sessionId } = await pipe.send('Target.attachToTarget', { targetId, flatten: true });
  const page = new Page(child, pipe, sessionId, profile);
  for (const domain of ['Page', 'Runtime', 'Network', 'DOM']) await page.send(`${domain}.enable`);
  await page.size(width, height);
  page.downloads = downloads && resolve(downloads);
  if (downloads) await pipe.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: page.downloads });
  return page;
}
