import { readFrame } from './frames.mjs';

const WAITS = [0.5, 1, 2, 4, 8]; // s between attempts to reconnect; the last one repeats
const OPEN = 1, GOING_AWAY = 1001; // state of a socket; code with which the server closes it when the session ends

// The WebSocket to the server that has sent the page; a lost connection is renewed. Commands are answered in order.
// listener: onOpen(), after each connection; onFrame(frame); onLost(seconds until the next attempt); onEnd().
export class Connection {
  constructor(listener) {
    const { host, pathname } = globalThis.location;
    Object.assign(this, { listener, url: `ws://${host}${pathname}live`, waiting: new Map(), next: 1, attempts: 0 });
    this.connect();
  }

  connect() {
    const { listener } = this;
    this.socket = new WebSocket(this.url);
    this.socket.binaryType = 'arraybuffer';
    this.socket.onopen = () => { this.attempts = 0; listener.onOpen(); };
    this.socket.onmessage = ({ data }) => {
      if (typeof data === 'string') this.answer(JSON.parse(data)); else listener.onFrame(readFrame(data));
    };
    this.socket.onclose = ({ code }) => this.closed(code === GOING_AWAY);
  }

  closed(isOver) {
    this.waiting.forEach(({ fail }) => fail(new Error(isOver ? 'The session has ended.' : 'The connection was lost.')));
    this.waiting.clear();
    if (isOver) { this.listener.onEnd(); return; }
    const wait = WAITS[Math.min(this.attempts++, WAITS.length - 1)];
    this.listener.onLost(wait);
    setTimeout(() => this.connect(), 1000 * wait);
  }

  answer(message) {
    const asked = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.kind === 'error') asked?.fail(new Error(message.text)); else asked?.done(message);
  }

  // Sends a command; resolves with the answer.
  async ask(command) {
    if (this.socket.readyState !== OPEN) throw new Error('There is no connection to the session.');
    const id = this.next++;
    return new Promise((done, fail) => {
      this.waiting.set(id, { done, fail });
      this.socket.send(JSON.stringify({ ...command, id }));
    });
  }

  // Requests the next frame.
  ready() { if (this.socket.readyState === OPEN) this.socket.send('{"do": "ready"}'); }
}
