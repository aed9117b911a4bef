import { useEffect, useRef, useState } from 'preact/hooks';
import { ModelView } from '../../view/model_view';
import type { Viewport } from '../../view/viewport';
import { type Editor } from '../state/editor';
import { useStore } from '../state/store';

/** Largest tilt, radians. */
const lean = 0.6;
const springMs = 260;

interface PeekOverlayProps {
  editor: Editor;
  view(): Viewport | null;
}

/**
 * Shows the relief over the drawing while the key is held and tilts it with the pointer. Seen from the
 * front the two coincide, since building a relief moves no point in x or y. On release it springs back.
 */
export function PeekOverlay({ editor, view }: PeekOverlayProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const model = useRef<ModelView>(null);
  const { peeking, relief } = useStore(editor);
  const [ready, setReady] = useState(false);
  const active = peeking && relief !== null;

  useEffect(() => () => model.current?.dispose(), []);

  useEffect(() => {
    const node = canvas.current;
    const paper = view();
    if (!node || !active || !relief || !paper) return;
    model.current ??= new ModelView(node);
    const shown = model.current;
    const { document, state } = editor;
    shown.resize(node.clientWidth, node.clientHeight);
    shown.paint(document, state.picture);
    shown.show(relief.surface, document.width, document.height);
    shown.align(paper);
    shown.turn(0, 0);
    let over = false;
    void shown.drawn().then(() => {
      if (!over) setReady(true);
    });
    const follow = (event: PointerEvent): void => {
      const box = node.getBoundingClientRect();
      const right = (2 * (event.clientX - box.left)) / box.width - 1;
      const down = (2 * (event.clientY - box.top)) / box.height - 1;
      const limit = (value: number): number => Math.max(-1, Math.min(1, value));
      shown.turn(lean * limit(right), -lean * limit(down));
    };
    window.addEventListener('pointermove', follow);
    return () => {
      over = true;
      setReady(false);
      window.removeEventListener('pointermove', follow);
      springBack(shown, node);
    };
  }, [active, relief]);

  return <canvas ref={canvas} class={active ? `peek ${ready ? 'shown' : 'coming'}` : 'peek'} aria-hidden="true" />;
}

function springBack(model: ModelView, canvas: HTMLCanvasElement): void {
  const { yaw, pitch } = model.angles;
  const calm = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
  const start = performance.now();
  canvas.classList.add('leaving');
  const step = (now: number): void => {
    const t = calm ? 1 : Math.min(1, (now - start) / springMs);
    const rest = (1 - t) ** 3;
    model.turn(yaw * rest, pitch * rest);
    if (t < 1) requestAnimationFrame(step);
    else canvas.classList.remove('leaving');
  };
  requestAnimationFrame(step);
}
