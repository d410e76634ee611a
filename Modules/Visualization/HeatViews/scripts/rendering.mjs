import { glProgram } from '../../../Core/Pages/scripts/gl.mjs';
import { add, clamp, cross, dot, scaled, sub, unit } from '../../../Core/Pages/scripts/math.mjs';
import { View } from '../../../Core/Pages/scripts/view.mjs';
import { Cuts } from './cuts.mjs';

const BLOCK = 8, FILLED = 0.88; // edge length of a block, voxels; fraction of the picture filled by the volume
const BUDGET = [200, 1500], LEAST_PART = 0.1; // ms for a coarse and for a fine picture; picture pixels per screen pixel along a side
const MIXED = 1, UNIFORM = 2; // content of a block; 0: invisible

// One triangle covers the picture.
const CORNERS = 'void main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0, 1); }';

// Casts rays through a volume of premultiplied colors, as in RenderVolume: voxels are classified first, then color and opacity
// are interpolated, so interpolation creates no other lines between two voxels.
const RAYS = `
precision highp sampler3D;
uniform sampler3D voxels, blocks;
uniform vec3 origin, across, below, stride, size; // in voxels: of the upper left pixel, to the next ones, to the next sample
uniform vec3 low, high; // first and last voxel that is shown
uniform vec3 toLight, halfway;
uniform mat3 normals;  // maps a per-voxel gradient to a direction in space
uniform float height;  // pixels
out vec4 o;

vec4 at(vec3 p) { return textureLod(voxels, (p + .5) / size, 0.); }

// Gradient of the opacity, from the corners of a tetrahedron.
vec3 gradientAt(vec3 p) {
  const vec2 k = vec2(1, -1);
  return (k.xxx * at(p + k.xxx).a + k.xyy * at(p + k.xyy).a + k.yxy * at(p + k.yxy).a + k.yyx * at(p + k.yyx).a) / 4.;
}

// Opaque objects are opaque throughout; transparent objects are drawn mainly at their surface.
vec4 shaded(vec4 c, vec3 gradient) {
  float steep = min(4. * length(gradient), 1.), inside = c.a * c.a * c.a * c.a;
  float alpha = c.a * (inside + (1. - inside) * min(steep / c.a, 1.));
  vec3 n = normals * gradient;
  float l = length(n), lit = l < 1e-4 ? .9 : .3 + .6 * abs(dot(n, toLight)) / l;
  float shine = l < 1e-4 ? 0. : .2 * pow(abs(dot(n, halfway)) / l, 10.);
  return vec4(min(lit * c.rgb / c.a + shine, 1.), min(alpha, 1.));
}

void main() {
  vec3 start = origin + (gl_FragCoord.x - .5) * across + (height - .5 - gl_FragCoord.y) * below;
  vec3 a = (low - .5 - start) / stride, b = (high + .5 - start) / stride, lo = min(a, b), hi = max(a, b);
  float t = ceil(max(lo.x, max(lo.y, lo.z))), end = min(hi.x, min(hi.y, hi.z)), seen = 1.;
  vec3 color = vec3(0), ahead = step(0., stride);
  for (int n = 0; n < 4096 && t <= end && seen > .004; n++) {
    vec3 p = clamp(start + t * stride, low, high);
    ivec3 block = ivec3(p) / ${BLOCK};
    int content = int(texelFetch(blocks, block, 0).r * 255. + .5);
    if (content < ${MIXED}) {
      vec3 leave = ((vec3(block) + ahead) * ${BLOCK}. - start) / stride;
      t = max(t + 1., ceil(min(leave.x, min(leave.y, leave.z))));
      continue;
    }
    vec4 c = at(p);
    if (c.a > 0.) {
      vec4 s = shaded(c, content > ${MIXED} ? vec3(0) : gradientAt(p));
      color += seen * s.a * s.rgb;
      seen *= 1. - s.a;
    }
    t += 1.;
  }
  o = vec4(color + seen * vec3(18, 19, 25) / 255., 1);
}`;

// Content of each block, including one voxel beyond its far sides for interpolation. numbers: the line of each bin;
// colors: its color and, in the highest byte, its opacity.
export function contentsOf(bins, numbers, colors, [nx, ny, nz]) {
  const bx = Math.ceil(nx / BLOCK), by = Math.ceil(ny / BLOCK), bz = Math.ceil(nz / BLOCK), any = new Uint8Array(bx * by * bz);
  const least = new Uint16Array(any.length).fill(65535), most = new Uint16Array(any.length), isSeen = colors.map((color) => color >>> 24);
  for (let z = 0, v = 0; z < nz; z++) {
    for (let y = 0; y < ny; y++) {
      const own = ((z >> 3) * by + (y >> 3)) * bx, rows = [own];
      if (y > 0 && y % BLOCK === 0) rows.push(own - bx);
      if (z > 0 && z % BLOCK === 0) rows.push(...rows.map((row) => row - bx * by));
      for (let b = 0; b < bx; b++) {
        const isFirstSeen = isSeen[bins[v]];
        let all = 0, low = 65535, high = 0;
        for (const end = Math.min(nx, BLOCK * (b + 1)) - BLOCK * b + v; v < end; v++) {
          const bin = bins[v], line = numbers[bin];
          all |= isSeen[bin];
          if (line < low) low = line;
          if (line > high) high = line;
        }
        if (low < least[own + b]) least[own + b] = low;
        if (high > most[own + b]) most[own + b] = high;
        if (all) for (const row of rows) any[row + b] = MIXED;
        if (isFirstSeen && b > 0) for (const row of rows) any[row + b - 1] = MIXED;
      }
    }
  }
  return markUniform(any, least, most, [bx, by, bz]);
}

// Blocks with a single line that all their neighbors share: the gradient is 0.
function markUniform(any, least, most, [bx, by, bz]) {
  const out = any.slice();
  for (let b = 0; b < any.length; b++) {
    if (any[b] !== MIXED || least[b] !== most[b]) continue;
    const [x, y, z] = [b % bx, Math.floor(b / bx) % by, Math.floor(b / (bx * by))];
    let isUniform = true;
    for (let k = Math.max(0, z - 1); k <= Math.min(bz - 1, z + 1) && isUniform; k++) {
      for (let j = Math.max(0, y - 1); j <= Math.min(by - 1, y + 1); j++) {
        for (let i = Math.max(0, x - 1); i <= Math.min(bx - 1, x + 1); i++) {
          const near = (k * by + j) * bx + i;
          isUniform &&= least[near] === least[b] && most[near] === most[b];
        }
      }
    }
    if (isUniform) out[b] = UNIFORM;
  }
  return out;
}

// Casts the rays with WebGL 2.
class RayCaster {
  constructor(size) {
    this.canvas = document.createElement('canvas');
    this.gl = this.canvas.getContext('webgl2', { antialias: false, alpha: false, powerPreference: 'high-performance' });
    if (!this.gl) return;
    const { gl } = this;
    Object.assign(this, { size, blocks: size.map((n) => Math.ceil(n / BLOCK)) }, glProgram(gl, CORNERS, RAYS));
    this.voxels = this.texture(gl.LINEAR, gl.RGBA8, size);
    this.words = new Uint32Array(size[0] * size[1] * size[2]);
    this.contents = this.texture(gl.NEAREST, gl.R8, this.blocks);
  }

  texture(filter, format, size) {
    const { gl } = this, texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_3D, texture);
    gl.texStorage3D(gl.TEXTURE_3D, 1, format, ...size);
    for (const name of ['WRAP_S', 'WRAP_T', 'WRAP_R']) gl.texParameteri(gl.TEXTURE_3D, gl[`TEXTURE_${name}`], gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_3D, gl.TEXTURE_MIN_FILTER, filter);
    gl.texParameteri(gl.TEXTURE_3D, gl.TEXTURE_MAG_FILTER, filter);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    return texture;
  }

  load(values, numbers, colors) {
    const { gl, words } = this, fill = (texture, size, format, bytes) => {
      gl.bindTexture(gl.TEXTURE_3D, texture);
      gl.texSubImage3D(gl.TEXTURE_3D, 0, 0, 0, 0, ...size, format, gl.UNSIGNED_BYTE, bytes);
    };
    for (let i = 0; i < words.length; i++) words[i] = colors[values[i]];
    fill(this.voxels, this.size, gl.RGBA, new Uint8Array(words.buffer));
    fill(this.contents, this.blocks, gl.RED, contentsOf(values, numbers, colors, this.size));
  }

  // view: origin, across, below, stride, low, high, toLight, halfway, normals.
  draw(w, h, view) {
    const { gl, canvas, uniforms } = this;
    if (canvas.width !== w || canvas.height !== h) Object.assign(canvas, { width: w, height: h });
    gl.viewport(0, 0, w, h);
    gl.useProgram(this.program);
    [['voxels', this.voxels], ['blocks', this.contents]].forEach(([name, texture], i) => {
      gl.activeTexture(gl.TEXTURE0 + i);
      gl.bindTexture(gl.TEXTURE_3D, texture);
      gl.uniform1i(uniforms[name], i);
    });
    const vectors = ['origin', 'across', 'below', 'stride', 'low', 'high', 'toLight', 'halfway'];
    for (const name of vectors) gl.uniform3fv(uniforms[name], view[name]);
    gl.uniform3fv(uniforms.size, this.size);
    gl.uniformMatrix3fv(uniforms.normals, false, view.normals);
    gl.uniform1f(uniforms.height, h);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    return canvas;
  }
}

// The volume in space, by parallel projection. During changes the picture is coarse; a fine one follows.
export class RenderingView extends View {
  constructor(root, page) {
    super(root, 'rendering', 'rendering');
    Object.assign(this, { page, azimuth: 0, elevation: 0, enlarged: 1, isCoarse: false, caster: new RayCaster(page.volume.size) });
    Object.assign(this, { cost: null, picture: document.createElement('canvas'), budget: BUDGET });
    this.cuts = new Cuts(this, page.info.planes);
    const { spacing, axes } = page.volume, [x, y, z] = axes, volume = dot(x, cross(y, z));
    this.rows = [cross(y, z), cross(z, x), cross(x, y)].map((row, k) => scaled(row, 1 / (volume * spacing[k]))); // from mm to voxels
  }

  get isPossible() { return Boolean(this.caster.gl); }
  toIndex(v) { return this.rows.map((row) => dot(row, v)); }

  toSpace(index) {
    const { origin, axes, spacing } = this.page.volume;
    return axes.reduce((sum, axis, k) => add(sum, scaled(axis, index[k] * spacing[k])), origin);
  }

  load(values, numbers, colors) {
    if (!this.isPossible) return;
    this.caster.load(values, numbers, colors);
    this.cost = null; // the cost of rays through opaque voxels does not predict the cost of transparent ones
    this.quickly();
  }

  // Draws a coarse picture immediately, and a fine one after a pause.
  quickly() {
    clearTimeout(this.timer);
    Object.assign(this, { isCoarse: true, isStale: true });
    this.changed();
    this.timer = setTimeout(() => {
      Object.assign(this, { isCoarse: false, isStale: true });
      this.changed();
    }, 350);
  }

  // Directions of the screen, and mm of a pixel of a picture w x h.
  projection(w, h) {
    const [a, e] = [this.azimuth, this.elevation].map((degrees) => (degrees * Math.PI) / 180), { size, axes, spacing } = this.page.volume;
    const forward = [-Math.sin(a) * Math.cos(e), Math.cos(a) * Math.cos(e), -Math.sin(e)], right = [Math.cos(a), Math.sin(a), 0];
    const up = cross(right, forward), sides = size.map((n, k) => n * spacing[k]);
    const half = (v) => axes.reduce((sum, axis, k) => sum + (Math.abs(dot(axis, v)) * sides[k]) / 2, 0);
    const mm = (2 * Math.max(half(right) / w, half(up) / h)) / (FILLED * this.enlarged);
    return { right, up, forward, mm, middle: this.toSpace(size.map((n) => (n - 1) / 2)) };
  }

  draw(g, w, h, ratio) {
    if (!this.isPossible) { this.say(g, 'The rendering requires WebGL 2.'); return; }
    const key = [w, h, ratio].join();
    if (this.isStale || key !== this.key) this.cast(w, h, ratio);
    this.key = key;
    g.drawImage(this.picture, 0, 0, w, h);
    const [x, y] = this.pixelOf(this.page.place);
    this.cross(g, x, y, true);
  }

  // Chooses the resolution for the time budget by the cost of the last picture; repeats at higher resolution if time is left.
  cast(w, h, ratio) {
    const budget = this.budget[this.isCoarse ? 0 : 1];
    if (this.cost === null) this.render(w, h, LEAST_PART); // measures the cost
    const part = clamp(Math.sqrt(budget / (this.cost * w * h)), LEAST_PART, ratio), time = this.render(w, h, part);
    this.page.times[this.isCoarse ? 'coarse' : 'fine'] = time;
    this.isStale = !this.isCoarse && part < ratio && time < budget / 2;
    if (this.isStale) this.changed();
  }

  // Draws a picture with this number of pixels per screen pixel along each side, and measures their cost. Returns the time, ms.
  render(w, h, part) {
    const started = performance.now();
    const [W, H] = [w, h].map((n) => Math.max(1, Math.round(n * part))), { right, up, forward, mm, middle } = this.projection(W, H);
    const { origin, spacing } = this.page.volume;
    const corner = add(sub(middle, scaled(right, (mm * (W - 1)) / 2)), scaled(up, (mm * (H - 1)) / 2));
    const toLight = unit(sub(sub(scaled(up, 0.5), scaled(right, 0.4)), forward));
    const stride = this.toIndex(scaled(forward, Math.min(...spacing))).map((x) => x || 1e-9); // rays are divided by it
    const drawn = this.caster.draw(W, H, {
      origin: this.toIndex(sub(corner, origin)), across: this.toIndex(scaled(right, mm)), below: this.toIndex(scaled(up, -mm)), stride,
      toLight, halfway: unit(sub(toLight, forward)), normals: this.rows.flat(), ...this.cuts.box,
    });
    Object.assign(this.picture, { width: W, height: H });
    this.picture.getContext('2d', { willReadFrequently: true }).drawImage(drawn, 0, 0); // waits for the GPU
    const time = performance.now() - started;
    this.cost = time / (W * H);
    return time;
  }

  pixelOf(index) {
    const { w, h } = this, { right, up, mm, middle } = this.projection(w, h), d = sub(this.toSpace(index), middle);
    return [(w - 1) / 2 + dot(d, right) / mm, (h - 1) / 2 - dot(d, up) / mm];
  }

  // Moves the crosshair to the first voxel of a line on the ray through the pixel.
  pick(x, y) {
    const { shown: { values, colors }, volume: { size, spacing, origin } } = this.page, { w, h } = this;
    const { right, up, forward, mm, middle } = this.projection(w, h), { low, high } = this.cuts.box;
    const far = Math.hypot(...size.map((n, k) => n * spacing[k])), step = Math.min(...spacing) / 2;
    const at = add(add(middle, scaled(right, (x - (w - 1) / 2) * mm)), scaled(up, ((h - 1) / 2 - y) * mm));
    for (let t = -far; t < far; t += step) {
      const index = this.toIndex(sub(add(at, scaled(forward, t)), origin)).map(Math.round);
      if (!index.every((i, k) => i >= low[k] && i <= high[k])) continue;
      if (colors[values[(index[2] * size[1] + index[1]) * size[0] + index[0]]] >>> 24 > 12) { this.page.moveTo(index); return true; }
    }
    return false;
  }

  drag(dx, dy) { this.turn([-dx / 2, dy / 2]); }
  clicked(isAdded) { this.page.clicked(isAdded); }
  wheel(d, at, isScaling, amount, isClimbing) { if (isClimbing) this.page.climb(-d); else this.enlarge(1.15 ** -d); }
  enlarge(by) { this.enlarged = clamp(this.enlarged * by, 0.5, 8); this.quickly(); }

  turn([azimuth, elevation]) {
    this.azimuth += azimuth;
    this.elevation = clamp(this.elevation + elevation, -90, 90);
    this.quickly();
  }
}
