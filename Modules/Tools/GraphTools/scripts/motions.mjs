// Complex numbers are arrays [re, im]. A motion {a, b} with |a|^2 - |b|^2 = 1 is the Moebius transformation of the unit disk
// z -> (a z + b) / (conj(b) z + conj(a)), an isometry of the hyperbolic plane, as in shapetonModelSpace.cxx.
export const plus = (p, q) => [p[0] + q[0], p[1] + q[1]];
export const minus = (p, q) => [p[0] - q[0], p[1] - q[1]];
export const times = (p, q) => [p[0] * q[0] - p[1] * q[1], p[0] * q[1] + p[1] * q[0]];
export const polar = (r, angle) => [r * Math.cos(angle), r * Math.sin(angle)];
const conjugate = (p) => [p[0], -p[1]];

function quotient(p, q) {
  const n = q[0] * q[0] + q[1] * q[1];
  return [(p[0] * q[0] + p[1] * q[1]) / n, (p[1] * q[0] - p[0] * q[1]) / n];
}

export const movedBy = (m, p) => quotient(plus(times(m.a, p), m.b), plus(times(conjugate(m.b), p), conjugate(m.a)));

// Composition: first n, then m.
export const product = (m, n) => ({
  a: plus(times(m.a, n.a), times(m.b, conjugate(n.b))),
  b: plus(times(m.a, n.b), times(m.b, conjugate(n.a))),
});

// Translation of 0 to p along their geodesic.
export function toPlace(p) {
  const s = 1 / Math.sqrt(1 - p[0] * p[0] - p[1] * p[1]);
  return { a: [s, 0], b: [s * p[0], s * p[1]] };
}

export const inverseOf = (m) => ({ a: conjugate(m.a), b: [-m.b[0], -m.b[1]] });

// Renormalizes: rounding in long products of motions violates |a|^2 - |b|^2 = 1.
export function normalized({ a, b }) {
  const n = Math.sqrt(a[0] ** 2 + a[1] ** 2 - b[0] ** 2 - b[1] ** 2);
  return { a: [a[0] / n, a[1] / n], b: [b[0] / n, b[1] / n] };
}
