// Which of its orders a state is drawn in: the same cells as in framework/foredraw/runtime/order_table.h, without the
// margin around them.

/** The number of the nearest keyframe among those of all clips, of two the earlier one; null: no such clip. */
function keyframe_at(table, pose) {
  if (table.clips.length === 0) return 0;
  let first = 0;
  for (const { name, times } of table.clips) {
    if (name === pose.clip && times.length > 0) {
      let nearest = 0;
      for (let i = 1; i < times.length; ++i) {
        if (Math.abs(times[i] - pose.time) < Math.abs(times[nearest] - pose.time)) nearest = i;
      }
      return first + nearest;
    }
    first += times.length;
  }
  return null;
}

/**
 * @param table  of the page's JSON; null: there is one order
 * @param pose   {clip, time}
 * @param towards_camera  [x, y, z] of any length, from the subject's centre
 */
export function order_at(table, pose, [x, y, z]) {
  if (!table) return 0;
  const keyframe = keyframe_at(table, pose);
  if (keyframe === null) return 0;
  const { 'theta-steps': theta_steps, 'phi-steps': phi_steps } = table;
  const theta = Math.atan2(Math.hypot(x, z), y) / Math.PI; // 0 at +Y, 1 at -Y
  const phi = (Math.atan2(z, x) + Math.PI) / (2 * Math.PI);
  const theta_cell = Math.min(theta_steps - 1, Math.floor(theta * theta_steps));
  const phi_cell = Math.floor(phi * phi_steps) % phi_steps;
  return table.order[(keyframe * theta_steps + theta_cell) * phi_steps + phi_cell] ?? 0;
}
