// What can be undone: states that are never changed, only replaced.
export class History {
  constructor(state) { Object.assign(this, { state, before: [], after: [], kind: null }); }

  // kind: changes of the same kind one after the other are undone together, such as those of a slider.
  change(state, kind = null) {
    if (kind === null || kind !== this.kind) this.before.push(this.state);
    Object.assign(this, { state, after: [], kind });
  }

  undo() { this.swap(this.before, this.after); }
  redo() { this.swap(this.after, this.before); }

  // Takes the last change back for good.
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
