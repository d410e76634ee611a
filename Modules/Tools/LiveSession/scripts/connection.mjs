import { readFrame } from './frames.mjs';

// The WebSocket to the server that has sent the page. listener: onFrame(frame), onEnd(). Commands are answered in order.
export class Connection {
  constructor(listener) {
    const { host, pathname } = globalThis.location;
    this.waiting = new Map();
    this.next = 1;
    this.socket = new WebSocket(`ws://${host}${pathname}live`);
    this.socket.binaryType = 'arraybuffer';
    this.socket.onmessage = ({ data }) => {
      if (typeof data === 'string') this.answer(JSON.parse(data)); else listener.onFrame(readFrame(data));
    };
    this.socket.onclose = () => {
      this.waiting.forEach(({ fail }) => fail(new Error('The session has ended.')));
      this.waiting.clear();
      listener.onEnd();
    };
    this.opened = new Promise((done) => { this.socket.onopen = done; });
  }

  answer(message) {
    const asked = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.kind === 'error') asked?.fail(new Error(message.text)); else asked?.done(message);
  }

  // Sends a command; resolves with the answer.
  ask(command) {
    const id = this.next++;
    return new Promise((done, fail) => {
      this.waiting.set(id, { done, fail });
      this.socket.send(JSON.stringify({ ...command, id }));
    });
  }

  // Requests the next frame.
  ready() { if (this.socket.readyState === 1) this.socket.send('{"do": "ready"}'); }
  close() { this.socket.close(); }
}
