import { cross, distance, norm, sub, third, unit } from '../../../Core/Pages/scripts/math.mjs';
import { pictureOf } from './lens.mjs';

const SIGHT = 200;    // mm; wall farther away counts as unseen
const AROUND = 250;  // mm along the colon, ahead of and behind the eye
const TOLERANCE = 0.2; // mm; avoids self-occlusion of faces

// Faces seen during the flight: the center of the face is inside the picture and not occluded. Interpolated wall is excluded.
// The eye moves immediately; faces are tested in idle time.
export class Seen {
  constructor(exam) {
    const { points: P, faces: F } = exam, n = F.length / 3;
    Object.assign(this, { exam, marks: new Uint8Array(n), area: new Float32Array(n), middles: new Float32Array(3 * n), queue: [] });
    this.total = this.sum = 0;
    for (let f = 0; f < n; f++) {
      const [a, b, c] = [0, 1, 2].map((k) => third(P, F[3 * f + k]));
      for (let k = 0; k < 3; k++) this.middles[3 * f + k] = (a[k] + b[k] + c[k]) / 3;
      this.area[f] = exam.isSynthetic(f) ? 0 : norm(cross(sub(b, a), sub(c, a))) / 2;
      this.total += this.area[f];
    }
  }

  get share() { return this.sum / this.total; }

  // aspect: width over height of the picture.
  look(camera, aspect) {
    const { exam } = this, arc = exam.arc[exam.faces[3 * exam.wall.nearest(camera.eye).face]];
    this.queue.push({ camera, aspect, at: exam.facesBefore(arc - AROUND), to: exam.facesBefore(arc + AROUND) });
  }

  // Works for this number of milliseconds; returns whether work remains.
  work(milliseconds) {
    const end = performance.now() + milliseconds;
    while (this.queue.length && performance.now() < end) {
      const pose = this.queue[0];
      pose.inPicture ??= pictureOf(pose.camera, pose.aspect);
      for (let i = 0; i < 200 && pose.at < pose.to; i++, pose.at++) {
        if (!this.marks[pose.at] && this.sees(pose, pose.at)) this.mark(pose.at);
      }
      if (pose.at >= pose.to) this.queue.shift();
    }
    return this.queue.length > 0;
  }

  mark(face) {
    this.marks[face] = 1;
    this.sum += this.area[face];
  }

  sees({ camera: { eye }, inPicture }, face) {
    const middle = third(this.middles, face), l = distance(middle, eye);
    return l < SIGHT && inPicture(middle) && !this.exam.wall.ray(eye, unit(sub(middle, eye)), l - TOLERANCE, true);
  }
}
