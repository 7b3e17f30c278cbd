// What moves while a play button is pressed: nothing is drawn when nothing does.

/** Calls `step(seconds)` with the time since it was started, once a frame, until it answers false or is stopped. */
export class Player {
  constructor(step, on_change) {
    Object.assign(this, { step, on_change, frame: null });
  }

  get is_playing() {
    return this.frame !== null;
  }

  start() {
    if (this.is_playing) return;
    let began = null;
    const tick = (now) => {
      began ??= now;
      this.frame = requestAnimationFrame(tick);
      if (this.step((now - began) / 1000) === false) this.stop();
    };
    this.frame = requestAnimationFrame(tick);
    this.on_change();
  }

  stop() {
    if (!this.is_playing) return;
    cancelAnimationFrame(this.frame);
    this.frame = null;
    this.on_change();
  }

  toggle() {
    if (this.is_playing) this.stop();
    else this.start();
  }
}

/** The clips that poses are of, in the sequence of the poses: [{name, poses: [number, ...]}]. */
export function clips_of(poses) {
  const clips = new Map();
  poses.forEach(({ clip }, pose) => {
    const name = clip ?? null;
    if (!clips.has(name)) clips.set(name, { name, poses: [] });
    clips.get(name).poses.push(pose);
  });
  return [...clips.values()];
}

/** The pose nearest to a moment of a clip that begins again when it is over. Poses stand for parts of equal length. */
export function pose_at(clip, poses, seconds) {
  const times = clip.poses.map((pose) => poses[pose].time);
  const step = times.length > 1 ? (times.at(-1) - times[0]) / (times.length - 1) : 1;
  const length = step * times.length || 1;
  const time = times[0] - step / 2 + (((seconds % length) + length) % length);
  let nearest = 0;
  times.forEach((at, i) => {
    if (Math.abs(at - time) < Math.abs(times[nearest] - time)) nearest = i;
  });
  return clip.poses[nearest];
}
