import { add, clamp, cross, distance, dot, norm, scaled, sub, third, unit } from '../../../Core/Pages/scripts/math.mjs';

// The camera of a candidate, by the rules of the pictures in the report (ChooseEye() in C++).
const NEAREST = 15, FARTHEST = 60, BEST = 25; // mm from the head to an eye on the centerline
const SLANT = 1.5;       // cost of a slanted view relative to a distance that is wrong by a factor of e
const ENOUGH = 0.4;      // visible share of the head; its other side is never visible
const SAMPLES = 60;      // faces of a head that are tested
const TIMES_HEAD = 4;    // width of the picture
const NARROWEST = Math.PI / 6, WIDEST = (70 * Math.PI) / 180;
const ABOVE = [25, 20, 15, 10, 6, 4, 3], RING = 8, TILT = 0.7; // mm above a head that is invisible from the centerline
const STEP = 2;          // centerline points
const HEAD_MARGIN = 1.1; // of the radius
const BACK = 0.3;        // of the radius; faces that look at the center from farther away are the opposite wall

// Points and normals (into the lumen) of the faces of a head.
function headOf({ details: { points: P, faces: F } }, { xyz, place: { depth } }) {
  const head = [], reach = HEAD_MARGIN * depth;
  for (let f = 0; f < F.length; f += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => third(P, F[f + k])), middle = scaled(add(a, add(b, c)), 1 / 3);
    if (distance(middle, xyz) > reach) continue;
    const outward = cross(sub(b, a), sub(c, a)), area = norm(outward), normal = scaled(outward, -1 / (area || 1));
    if (dot(normal, sub(middle, xyz)) >= -BACK * depth) head.push({ middle, normal, area });
  }
  return head;
}

// Places for the eye, best first: points of the centerline, then points above the head, farthest first.
function placesOf(exam, apex, axis) {
  const onLine = [];
  for (let i = 0; i < exam.center.length; i += STEP) {
    const { xyz } = exam.center[i], way = sub(xyz, apex), l = norm(way);
    if (l < NEAREST || l > FARTHEST) continue;
    onLine.push({ cost: Math.abs(Math.log(l / BEST)) + SLANT * (1 - dot(way, axis) / l), index: i, eye: xyz, isOnLine: true });
  }
  onLine.sort((a, b) => a.cost - b.cost);
  const side = unit(cross(axis, Math.abs(axis[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0])), other = cross(axis, side), above = [];
  for (const l of ABOVE) {
    above.push({ eye: add(apex, scaled(axis, l)) });
    for (let k = 0; k < RING; k++) {
      const a = (2 * Math.PI * k) / RING, tilted = add(scaled(side, TILT * Math.cos(a)), scaled(other, TILT * Math.sin(a)));
      above.push({ eye: add(apex, scaled(unit(add(axis, tilted)), l)) });
    }
  }
  return [...onLine, ...above];
}

function shareSeen(exam, samples, eye) {
  const isSeen = ({ middle, normal }) => {
    const l = distance(eye, middle);
    return dot(normal, sub(eye, middle)) > 0 && !exam.hidden(eye, middle, Math.min(2, 0.3 * l));
  };
  return samples.filter(isSeen).length / samples.length;
}

// Best view of the head of a candidate: {index of the centerline, eye or null on the centerline, fov, share of the head seen}, or
// null for a head without faces.
export function viewOfHead(exam, candidate) {
  const head = headOf(exam, candidate), { xyz, place: { arc, depth } } = candidate;
  if (!head.length) return null;
  const axis = unit(head.reduce((sum, { normal, area }) => add(sum, scaled(normal, area)), [0, 0, 0]));
  const apex = add(xyz, scaled(axis, Math.max(0, ...head.map(({ middle }) => dot(sub(middle, xyz), axis)))));
  const step = Math.max(1, Math.floor(head.length / SAMPLES)), samples = head.filter((_, i) => i % step === 0);
  let best = { share: -1 };
  for (const at of placesOf(exam, apex, axis)) {
    const share = shareSeen(exam, samples, at.eye);
    if (share > best.share) best = { ...at, share };
    if (share >= ENOUGH) break;
  }
  const fov = clamp(2 * Math.atan((0.5 * TIMES_HEAD * 2 * depth) / distance(best.eye, xyz)), NARROWEST, WIDEST);
  return { index: best.index ?? exam.centerAt(arc), eye: best.isOnLine ? null : best.eye, fov, share: best.share };
}
