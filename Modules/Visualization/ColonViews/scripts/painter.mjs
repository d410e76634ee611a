import { glProgram } from '../../../Core/Pages/scripts/gl.mjs';
import { cross, dot, matricesOf, norm, sub, unit } from '../../../Core/Pages/scripts/math.mjs';
import { FISHEYE_LIMIT } from './lens.mjs';

const VERTEX = `
in vec3 position; in vec4 normal, color;
uniform mat4 view, projection;
uniform vec3 fisheye; // half the angle of view, aspect, farthest distance; 0 for perspective
out vec3 N, E; out vec4 C;
void main() {
  vec4 e = view * vec4(position, 1);
  E = e.xyz;
  N = mat3(view) * normal.xyz;
  C = color;
  float l = length(e.xyz), side = length(e.xy);
  vec2 away = side > 0. ? e.xy / side : vec2(0);
  gl_Position = fisheye.x > 0.
    ? vec4(away * acos(clamp(-e.z / l, -1., 1.)) / fisheye.x / vec2(fisheye.y, 1), 2. * l / fisheye.z - 1., 1)
    : projection * e;
}`;

// Lit from the eye. reach: range of the light inside the colon in mm, 0 outside; clear: rim opacity of a transparent wall.
const FRAGMENT = `
in vec3 N, E; in vec4 C;
uniform float reach, clear, behind;
out vec4 o;
void main() {
  if (-normalize(E).z < behind || C.a < .001) discard; // triangles around the eye cross a fisheye picture; replaced by details
  float d = abs(dot(normalize(N), normalize(E)));
  float fade = reach > 0. ? exp(-length(E) / reach) : 1.;
  o = vec4(C.rgb * (.18 + .82 * d) * fade, clear > 0. ? clear * pow(1. - d, 2.) + .04 : 1.);
}`;

// One WebGL2 context for all views in space: a view draws, then copies the picture into a separate canvas, where crosshairs and
// labels are added. A browser allows few contexts, and buffers are shared. Without WebGL2 `gl` is null.
export class Painter {
  constructor() {
    this.canvas = document.createElement('canvas');
    this.gl = this.canvas.getContext('webgl2', { antialias: false, alpha: false, powerPreference: 'high-performance' });
    if (this.gl) Object.assign(this, glProgram(this.gl, VERTEX, FRAGMENT));
  }

  // points Float32Array, normals Int8Array of 4, colors Uint8Array of 4, faces Uint32Array.
  mesh(points, normals, colors, faces) {
    const { gl } = this, mesh = { array: gl.createVertexArray(), count: faces.length };
    gl.bindVertexArray(mesh.array);
    const attribute = (name, data, size, type, isNormalized) => {
      const buffer = gl.createBuffer(), place = gl.getAttribLocation(this.program, name);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, type, isNormalized, 0, 0);
      return buffer;
    };
    attribute('position', points, 3, gl.FLOAT, false);
    attribute('normal', normals, 4, gl.BYTE, true);
    mesh.colors = attribute('color', colors, 4, gl.UNSIGNED_BYTE, true);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, faces, gl.STATIC_DRAW);
    gl.bindVertexArray(null);
    return mesh;
  }

  recolor(mesh, colors) {
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, mesh.colors);
    this.gl.bufferSubData(this.gl.ARRAY_BUFFER, 0, colors);
  }

  begin(w, h) {
    const { gl, canvas } = this;
    if (canvas.width < w || canvas.height < h) { // grows only
      canvas.width = Math.max(w, canvas.width);
      canvas.height = Math.max(h, canvas.height);
    }
    gl.viewport(0, canvas.height - h, w, h);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(0, canvas.height - h, w, h);
    gl.clearColor(0.07, 0.07, 0.08, 1);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
  }

  // items: [{mesh, reach, clear, from, to: faces}], opaque ones first. The picture is in the upper left corner of the canvas.
  draw(w, h, camera, items) {
    const { gl, uniforms } = this, { view, projection } = matricesOf(camera, w / h);
    this.begin(w, h);
    gl.useProgram(this.program);
    gl.uniformMatrix4fv(uniforms.view, false, view);
    gl.uniformMatrix4fv(uniforms.projection, false, projection);
    gl.uniform3f(uniforms.fisheye, (camera.fisheye || 0) / 2, w / h, camera.far);
    gl.uniform1f(uniforms.behind, camera.fisheye ? Math.cos(FISHEYE_LIMIT) : -2);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    for (const { mesh, reach = 0, clear = 0, from = 0, to = mesh.count / 3 } of items) {
      gl.uniform1f(uniforms.reach, reach);
      gl.uniform1f(uniforms.clear, clear);
      gl.depthMask(!clear);
      if (clear) gl.enable(gl.BLEND); else gl.disable(gl.BLEND);
      gl.bindVertexArray(mesh.array);
      gl.drawElements(gl.TRIANGLES, 3 * (to - from), gl.UNSIGNED_INT, 12 * from);
    }
    gl.disable(gl.BLEND);
    gl.depthMask(true);
    return this.canvas;
  }
}

const SIDES = 4;

// A tube around a polyline, to draw a thick line.
export function tube(painter, line, radius, color) {
  const points = [], normals = [], faces = [];
  let side = [0, 0, 1];
  line.forEach((p, i) => {
    const d = unit(sub(line[Math.min(line.length - 1, i + 1)], line[Math.max(0, i - 1)]));
    side = sub(side, d.map((x) => x * dot(side, d)));
    side = norm(side) < 1e-3 ? unit(cross(d, [1, 0.3, 0])) : unit(side);
    const other = cross(d, side), at = points.length / 3;
    for (let k = 0; k < SIDES; k++) {
      const a = (2 * Math.PI * k) / SIDES, n = side.map((x, j) => Math.cos(a) * x + Math.sin(a) * other[j]);
      points.push(...p.map((x, j) => x + radius * n[j]));
      normals.push(...n.map((x) => Math.round(127 * x)), 0);
      const next = at + ((k + 1) % SIDES);
      if (i) faces.push(at + k - SIDES, at + k, next - SIDES, next - SIDES, at + k, next);
    }
  });
  const colors = new Uint8Array((4 * points.length) / 3);
  for (let i = 0; i < colors.length; i += 4) colors.set([...color, 255], i);
  return painter.mesh(new Float32Array(points), new Int8Array(normals), colors, new Uint32Array(faces));
}
