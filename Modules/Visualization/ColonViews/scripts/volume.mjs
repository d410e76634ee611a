// The CT or mask of a position as codes of HU. The cleansed CT differs from the original one in few voxels, which show() exchanges.
export class Volume {
  constructor(data, coarse) {
    Object.assign(this, data.header, { data, coarse, changes: null });
    this.blocks = this.size.map((n) => Math.ceil(n / this.side));
    this.levels = 2 ** (8 * data.BYTES_PER_ELEMENT);
  }

  // at: voxels that differ in the other CT; codes: their codes there.
  setChanges(at, codes) { this.changes = { at, codes }; }

  get name() { return !this.isCt ? 'Lumen mask' : this.isCleansed ? 'Cleansed CT' : 'Original CT'; }

  show(isCleansed) {
    if (!this.changes || isCleansed === this.isCleansed) return;
    const { data, changes: { at, codes } } = this;
    for (let i = 0; i < at.length; i++) {
      const code = data[at[i]];
      data[at[i]] = codes[i];
      codes[i] = code;
    }
    this.isCleansed = isCleansed;
  }

  huOf(code) {
    const [lowest, step, knee, above] = this.hu;
    return lowest + step * Math.min(code, knee) + above * Math.max(0, code - knee);
  }

  // Gray value of each code in a window.
  graysOf(width, level) {
    return Uint8Array.from({ length: this.levels }, (_, code) => {
      const gray = (255 * (this.huOf(code) - level + width / 2)) / width;
      return gray < 0 ? 0 : gray > 255 ? 255 : gray;
    });
  }
}
