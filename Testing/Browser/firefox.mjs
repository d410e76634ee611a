// Drives Debian's Firefox without npm packages, by the Marionette protocol over a local socket: "length:[type, number, ...]".
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { connect } from 'node:net';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

const wait = (ms) => new Promise((done) => { setTimeout(done, ms); });

// Firefox writes the chosen port into its profile.
async function portOf(profile) {
  const file = join(profile, 'MarionetteActivePort');
  for (const end = Date.now() + 60000; Date.now() < end;) {
    const port = existsSync(file) ? Number(readFileSync(file, 'utf8')) : 0;
    if (port) return port;
    await wait(100);
  }
  throw new Error('Firefox does not respond');
}

// A page with user actions.
class FirefoxPage {
  constructor(child, socket, profile) {
    Object.assign(this, { child, socket, profile, waiting: new Map(), next: 1, rest: Buffer.alloc(0) });
    socket.on('data', (bytes) => this.receive(bytes));
  }

  receive(bytes) {
    this.rest = Buffer.concat([this.rest, bytes]);
    for (;;) {
      const colon = this.rest.indexOf(':'), length = Number(this.rest.subarray(0, Math.max(0, colon)));
      if (colon < 0 || this.rest.length < colon + 1 + length) return;
      const message = JSON.parse(this.rest.subarray(colon + 1, colon + 1 + length));
      this.rest = this.rest.subarray(colon + 1 + length);
      if (Array.isArray(message)) this.answer(message);
    }
  }

  answer([, id, error, result]) {
    const { done, fail } = this.waiting.get(id);
    this.waiting.delete(id);
    if (error) fail(new Error(error.message)); else done(result?.value ?? result);
  }

  send(command, parameters = {}) {
    return new Promise((done, fail) => {
      const text = JSON.stringify([0, this.next, `WebDriver:${command}`, parameters]);
      this.waiting.set(this.next++, { done, fail });
      this.socket.write(`${Buffer.byteLength(text)}:${text}`);
    });
  }

  open(file) { return this.send('Navigate', { url: `file://${resolve(file)}` }); }

  // Evaluates a function in the page.
  evaluate(f, ...args) {
    const script = `const [args, done] = arguments; Promise.resolve((${f})(...args)).then(done);`;
    return this.send('ExecuteAsyncScript', { script, args: [args], sandbox: null, newSandbox: false });
  }

  async until(f, limit = 60000) {
    for (const end = Date.now() + limit; ;) {
      const value = await this.evaluate(f);
      if (value) return value;
      if (Date.now() > end) throw new Error(`timeout while waiting for ${f}`);
      await wait(50);
    }
  }

  act(type, actions) { return this.send('PerformActions', { actions: [{ type, id: type, actions }] }); }

  click(x, y) {
    const at = { type: 'pointerMove', x: Math.round(x), y: Math.round(y) };
    return this.act('pointer', [at, { type: 'pointerDown', button: 0 }, { type: 'pointerUp', button: 0 }]);
  }

  key(value) { return this.act('key', [{ type: 'keyDown', value }, { type: 'keyUp', value }]); }
  async screenshot(file) { writeFileSync(file, Buffer.from(await this.send('TakeScreenshot', { full: false }), 'base64')); }

  async close() {
    const gone = new Promise((done) => { this.child.on('exit', done); });
    this.socket.destroy();
    this.child.kill();
    await gone;
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

// Without WebGL, as on a desktop with a driver that Firefox blocks.
export async function launchFirefox({ width = 1600, height = 1000 } = {}) {
  const profile = mkdtempSync(join(tmpdir(), 'shapeton-firefox-'));
  writeFileSync(join(profile, 'user.js'), 'user_pref("marionette.port", 0);\nuser_pref("webgl.disabled", true);\n');
  const options = ['--headless', '--marionette', '--no-remote', '--profile', profile, '--width', `${width}`, '--height', `${height}`];
  const child = spawn(process.env.FIREFOX || 'firefox-esr', options, { stdio: 'ignore', env: { ...process.env, HOME: profile } });
  const socket = connect(await portOf(profile), '127.0.0.1'), page = new FirefoxPage(child, socket, profile);
  await page.send('NewSession', {});
  await page.send('SetWindowRect', { width, height });
  return page;
}
