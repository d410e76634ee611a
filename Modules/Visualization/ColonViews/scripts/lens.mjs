import { axesOf, dot, norm, project, rayThrough, sub } from '../../../Core/Pages/scripts/math.mjs';

export const FISHEYE = (160 * Math.PI) / 180;         // across the height of the picture, equidistant
export const FISHEYE_LIMIT = (115 * Math.PI) / 180;   // from the axis; the picture is black beyond it

// A camera with the member fisheye, an angle across the height, shows the angle from its axis as the distance from the center of
// the picture. Other cameras are perspective.

// Pixel of a point, or null outside the view.
export function pixelOf(camera, w, h, p) {
  if (!camera.fisheye) return project(camera, w, h, p);
  const { right, up, back } = axesOf(camera), q = sub(p, camera.eye), x = dot(q, right), y = dot(q, up);
  const angle = Math.atan2(Math.hypot(x, y), -dot(q, back)), side = Math.hypot(x, y) || 1;
  if (angle > FISHEYE_LIMIT) return null;
  const r = (angle * h) / camera.fisheye;
  return [w / 2 + (r * x) / side, h / 2 - (r * y) / side];
}

// Pixels per mm at a point.
export function scaleAt(camera, h, p) {
  const l = norm(sub(p, camera.eye)) || 1;
  return h / l / (camera.fisheye || 2 * Math.tan(camera.fov / 2));
}

// Direction of the ray through a pixel, or null outside the view.
export function rayOf(camera, w, h, x, y) {
  if (!camera.fisheye) return rayThrough(camera, w, h, x, y);
  const { right, up, back } = axesOf(camera), a = x - w / 2, b = h / 2 - y, r = Math.hypot(a, b), angle = (r * camera.fisheye) / h;
  if (angle > FISHEYE_LIMIT) return null;
  const s = Math.sin(angle) / (r || 1), c = Math.cos(angle);
  return right.map((_, k) => s * (a * right[k] + b * up[k]) - c * back[k]);
}

// Function of a point: whether it is inside the picture. aspect: width over height.
export function pictureOf(camera, aspect) {
  const { right, up, back } = axesOf(camera);
  if (camera.fisheye) {
    return (p) => {
      const at = norm(sub(p, camera.eye)) && pixelOf(camera, aspect, 1, p);
      return Boolean(at) && at[0] > 0 && at[0] < aspect && at[1] > 0 && at[1] < 1;
    };
  }
  const high = Math.tan(camera.fov / 2), wide = high * aspect;
  return (p) => {
    const q = sub(p, camera.eye), z = -dot(q, back);
    return z > 0 && Math.abs(dot(q, up)) < high * z && Math.abs(dot(q, right)) < wide * z;
  };
}
