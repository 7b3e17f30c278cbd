// Mouse, touch and keys on a pane turn, move and zoom the camera.

const step = Math.PI / 18;
const keys = {
  ArrowLeft: (orbit) => orbit.turn(-step, 0),
  ArrowRight: (orbit) => orbit.turn(step, 0),
  ArrowUp: (orbit) => orbit.turn(0, step),
  ArrowDown: (orbit) => orbit.turn(0, -step),
  '+': (orbit) => orbit.zoom_by(1.25),
  '=': (orbit) => orbit.zoom_by(1.25),
  '-': (orbit) => orbit.zoom_by(0.8),
  Home: (orbit) => orbit.reset(),
};

const middle = (points) => [
  points.reduce((sum, [x]) => sum + x, 0) / points.length,
  points.reduce((sum, [, y]) => sum + y, 0) / points.length,
];
const spread = ([a, b]) => (b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0);

/** One pointer turns (with Shift or another button than the first it moves), two move and zoom. */
export function listen(pane, orbit, changed) {
  const pointers = new Map();

  pane.addEventListener('pointerdown', (event) => {
    pane.focus({ preventScroll: true });
    pane.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
  });

  pane.addEventListener('pointermove', (event) => {
    if (!pointers.has(event.pointerId)) return;
    const before = [...pointers.values()];
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    const after = [...pointers.values()];
    const edge = Math.min(pane.clientWidth, pane.clientHeight);
    const [right, down] = [0, 1].map((axis) => (middle(after)[axis] - middle(before)[axis]) / edge);
    if (after.length > 1 || event.shiftKey || event.buttons > 1) {
      orbit.move(-right, down);
      if (after.length > 1) orbit.zoom_by(spread(after) / spread(before) || 1);
    } else {
      orbit.turn(-right * Math.PI, down * Math.PI);
    }
    changed();
  });

  for (const name of ['pointerup', 'pointercancel']) {
    pane.addEventListener(name, (event) => pointers.delete(event.pointerId));
  }
  pane.addEventListener('contextmenu', (event) => event.preventDefault());

  // The wheel scrolls the page until the pane was chosen.
  pane.addEventListener(
    'wheel',
    (event) => {
      if (document.activeElement !== pane && !event.ctrlKey) return;
      event.preventDefault();
      orbit.zoom_by(Math.exp(-event.deltaY / 500));
      changed();
    },
    { passive: false },
  );

  pane.addEventListener('keydown', (event) => {
    const action = keys[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action(orbit);
    changed();
  });
}
