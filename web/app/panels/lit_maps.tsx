import { useEffect, useRef, useState } from 'preact/hooks';
import type { BuiltRelief } from '../../engine/messages';
import { type Aim, litPicture } from '../../view/lit_picture';
import { t } from '../../words/catalogue';
import type { Exports } from '../control/exports';

/** Longest side of the preview, px. */
const side = 512;
/** How far an arrow key moves the lamp; the picture is 2 wide. */
const step = 0.1;

function within(value: number): number {
  return Math.max(-1, Math.min(1, value));
}

/** Shows the drawing under a lamp that the user drags. The normal map lights it, as in a game. */
export function LitMaps({ exports, relief }: { exports: Exports; relief: BuiltRelief | null }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const [pixels, setPixels] = useState<{ drawing: ImageData; normals: ImageData } | null>(null);
  const [aim, setAim] = useState<Aim>([-0.5, 0.5]);
  useEffect(() => setPixels(null), [relief]);
  useEffect(() => {
    const node = canvas.current;
    if (!node || !pixels) return;
    const { drawing, normals } = pixels;
    node.width = drawing.width;
    node.height = drawing.height;
    node.getContext('2d')?.putImageData(new ImageData(litPicture(drawing.data, normals.data, aim), drawing.width), 0, 0);
  }, [pixels, aim]);
  const follow = (event: PointerEvent): void => {
    const node = canvas.current;
    if (!node || (event.type === 'pointermove' && event.buttons === 0 && event.pointerType !== 'mouse')) return;
    setAim([within((2 * event.offsetX) / node.clientWidth - 1), within(1 - (2 * event.offsetY) / node.clientHeight)]);
  };
  const press = (event: KeyboardEvent): void => {
    const moves: Record<string, Aim> = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] };
    const move = moves[event.key];
    if (!move) return;
    event.preventDefault();
    event.stopPropagation();
    setAim([within(aim[0] + move[0]), within(aim[1] + move[1])]);
  };
  if (!pixels)
    return <button type="button" class="wide" id="lit-maps" onClick={() => void exports.mapPixels(side).then(setPixels)}>{t('litMaps')}</button>;
  return (
    <canvas
      ref={canvas} class="lit-maps" tabIndex={0} role="application" aria-label={t('litMapsHint')} title={t('litMapsHint')}
      onPointerDown={follow} onPointerMove={follow} onKeyDown={press}
    />
  );
}
