// Undo history of immutable states.
export class History {
  constructor(state) { Object.assign(this, { state, before: [], after: [], kind: null }); }

  // kind: consecutive changes of one kind, such as slider moves, are undone together.
  change(state, kind = null) {
    if (kind === null || kind !== this.kind) this.before.push(this.state);
    Object.assign(this, { state, after: [], kind });
  }

  undo() { this.swap(this.before, this.after); }
  redo() { this.swap(this.after, this.before); }

  // Reverts the last change without redo.
  drop() {
    this.undo();
    this.after.pop();
  }

  swap(from, to) {
    if (!from.length) return;
    to.push(this.state);
    Object.assign(this, { state: from.pop(), kind: null });
  }
}
