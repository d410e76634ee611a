// Vectors are arrays of three numbers, matrices are arrays of 16 in column-major order, as in WebGL.
export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (a, t) => [t * a[0], t * a[1], t * a[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const norm = (a) => Math.hypot(a[0], a[1], a[2]);
export const unit = (a) => scaled(a, 1 / (norm(a) || 1));
export const distance = (a, b) => norm(sub(a, b));
export const clamp = (x, lo, hi) => Math.min(hi, Math.max(lo, x));
export const third = (a, i) => [a[3 * i], a[3 * i + 1], a[3 * i + 2]];

// A camera at eye, directed at at; fov is the vertical field of view in radians.
export function axesOf(camera) {
  const back = unit(sub(camera.eye, camera.at));
  const right = unit(cross(camera.up, back));
  return { right, up: cross(back, right), back };
}

export function matricesOf(camera, aspect) {
  const { right: s, up: u, back: b } = axesOf(camera);
  const { eye: e, near: n, far: r } = camera;
  const f = 1 / Math.tan(camera.fov / 2);
  return {
    view: [s[0], u[0], b[0], 0, s[1], u[1], b[1], 0, s[2], u[2], b[2], 0, -dot(s, e), -dot(u, e), -dot(b, e), 1],
    projection: [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (r + n) / (n - r), -1, 0, 0, (2 * r * n) / (n - r), 0],
  };
}

// Pixel of a point, or null behind the camera.
export function project(camera, w, h, p) {
  const { right, up, back } = axesOf(camera);
  const q = sub(p, camera.eye);
  const z = -dot(q, back);
  if (z <= camera.near) return null;
  const f = h / 2 / Math.tan(camera.fov / 2) / z;
  return [w / 2 + dot(q, right) * f, h / 2 - dot(q, up) * f];
}

// Direction of the ray through a pixel.
export function rayThrough(camera, w, h, x, y) {
  const { right, up, back } = axesOf(camera);
  const f = Math.tan(camera.fov / 2) / (h / 2);
  return unit(sub(add(scaled(right, (x - w / 2) * f), scaled(up, (h / 2 - y) * f)), back));
}
