import type { Point } from '../document/document';
import type { ModelView } from './model_view';

/**
 * Lets the user turn, move and zoom the model: dragging and arrow keys turn it, the middle button and
 * two fingers move it, the wheel and pinching zoom. While `held` returns true, the pointer is used for
 * something else. `turned` is called with each angle, radians.
 */
export function listenToOrbit(canvas: HTMLCanvasElement, view: ModelView, held: () => boolean, turned: (angle: number) => void): void {
  const pointers = new Map<number, Point>();
  let moving = false;

  const turnBy = (dx: number, dy: number): void => {
    const { yaw, pitch } = view.angles;
    const turn = (2 * Math.PI) / Math.max(1, canvas.clientHeight);
    view.turn(yaw - turn * dx, pitch + turn * dy);
    turned(turn * Math.hypot(dx, dy));
  };
  const pinch = (id: number, before: Point, now: Point): void => {
    const other = [...pointers].find(([key]) => key !== id)?.[1];
    if (!other) return;
    const span = (p: Point): number => Math.max(1, Math.hypot(p[0] - other[0], p[1] - other[1]));
    view.zoom(span(now) / span(before));
    view.pan((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
  };

  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
    moving = event.button === 1;
  });
  canvas.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId);
    if (!before || held()) return;
    const now: Point = [event.offsetX, event.offsetY];
    pointers.set(event.pointerId, now);
    if (pointers.size > 1) pinch(event.pointerId, before, now);
    else if (moving) view.pan(now[0] - before[0], now[1] - before[1]);
    else if (event.buttons !== 2) turnBy(now[0] - before[0], now[1] - before[1]);
  });
  for (const end of ['pointerup', 'pointercancel'] as const)
    canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    view.zoom(Math.exp((-event.deltaY * (event.deltaMode === 1 ? 16 : 1)) / 600));
  }, { passive: false });
  canvas.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (!step) return;
    event.preventDefault();
    turnBy(20 * (step[0] as number), 20 * (step[1] as number));
  });
}
