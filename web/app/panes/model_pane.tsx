import { useEffect, useRef, useState } from 'preact/hooks';
import { isFailure, errorText } from '../../engine/messages';
import type { Tool } from '../../tools/tool';
import type { ModelShading } from '../../view/model_renderer';
import { ModelView } from '../../view/model_view';
import { listenToOrbit } from '../../view/orbit';
import { dressedSide, isSameLook, lookOf, sheetOf } from '../../view/painted_drawing';
import { t } from '../../words/catalogue';
import { dressedIn, type Editor } from '../state/editor';
import { EnergyCurve } from './energy_curve';
import { FieldSwitch } from './field_switch';
import { ReliefBrush } from './relief_brush';
import { useStore } from '../state/store';

interface ModelPaneProps {
  editor: Editor;
  tool(): Tool;
  attach(view: ModelView): void;
  lightHeld(): boolean;
  stop(): void;
}

/** Returns a function that marks the part under the pointer. It asks the view about one position at a time. */
function hovering(view: ModelView, editor: Editor): (spot: readonly [number, number] | null) => void {
  let wanted: readonly [number, number] | null = null;
  let asking = false;
  const ask = async (): Promise<void> => {
    asking = true;
    while (wanted) {
      const spot = wanted;
      const picked = await view.pick(...spot);
      if (wanted) editor.set({ hovered: picked?.part ?? null });
      if (wanted === spot) wanted = null;
    }
    asking = false;
  };
  return (spot) => {
    wanted = spot;
    if (!spot) editor.set({ hovered: null });
    else if (!asking) void ask();
  };
}

/**
 * Handles the pointer: a click that does not turn the model selects a part, dragging with L held moves the
 * light, a brush paints.
 */
function listen(canvas: HTMLCanvasElement, view: ModelView, editor: Editor, { tool, lightHeld }: Pick<ModelPaneProps, 'tool' | 'lightHeld'>): void {
  let down: [number, number] | null = null;
  const brush = new ReliefBrush(view, tool);
  const paints = (): boolean => editor.state.tool === 'paint' && !lightHeld();
  canvas.addEventListener('pointerdown', (event) => {
    down = [event.offsetX, event.offsetY];
    if (paints() && event.button === 0) brush.down(down, { shift: event.shiftKey, alt: event.altKey });
  });
  canvas.addEventListener('pointerup', (event) => {
    brush.up();
    if (!paints() && down && Math.hypot(event.offsetX - down[0], event.offsetY - down[1]) < 4)
      void view.pick(event.offsetX, event.offsetY).then((picked) => editor.select(picked?.part ?? null));
    down = null;
  });
  const hover = hovering(view, editor);
  canvas.addEventListener('pointermove', (event) => {
    if (lightHeld())
      view.aimLight((2 * event.offsetX) / canvas.clientWidth - 1, 1 - (2 * event.offsetY) / canvas.clientHeight);
    else if (event.buttons === 0) hover([event.offsetX, event.offsetY]);
    else brush.move([event.offsetX, event.offsetY]);
  });
  canvas.addEventListener('pointercancel', () => brush.up());
  canvas.addEventListener('pointerleave', () => hover(null));
  listenToOrbit(canvas, view, () => lightHeld() || brush.isDown, (angle) => editor.set({ turned: editor.state.turned + angle }));
  canvas.addEventListener('dblclick', () => view.turn(0, 0));
}

/** Keeps the view up to date with the editor and redraws only what changed. Returns a function that ends this. */
function follow(view: ModelView, editor: Editor): () => void {
  let before: readonly unknown[] = [];
  let look: readonly unknown[] = [];
  const update = (): void => {
    const { relief, picture, shading, hovered, selected, history, preview, solid: made } = editor.state;
    const document = preview ?? history.document;
    const solid = made && !isFailure(made) ? made : null;
    const looks = lookOf(document, picture);
    const pictured = solid ?? dressedIn(editor.state, looks);
    const surface = (pictured ?? relief)?.surface ?? null;
    const now = [surface, pictured, shading, hovered ?? selected, document.name];
    if (now[1] !== before[1] || now[4] !== before[4] || !isSameLook(looks, look)) {
      look = looks;
      if (pictured) view.paint(sheetOf(pictured), pictured.picture, dressedSide);
      else view.paint(picture || document.parts.length > 0 ? document : null, picture, preview ? previewSide : undefined);
    }
    if (surface !== before[0]) {
      const [width, height] = solid?.size ?? [document.width, document.height];
      view.show(surface, width, height);
      const shown = solid ?? relief;
      void view.drawn().then(() => {
        if (before[0] === surface) editor.set({ shown });
      });
    }
    if (now[2] !== before[2]) view.setShading(shading);
    if (now[3] !== before[3]) view.highlight(hovered ?? selected);
    before = now;
  };
  update();
  return editor.subscribe(update);
}

/** Longest side of the texture while the pen is down, px, so that it keeps up. */
const previewSide = 768;

const shadings: readonly [ModelShading, () => string][] = [
  ['drawing', () => t('shadingDrawing')],
  ['clay', () => t('shadingClay')],
  ['normals', () => t('shadingNormals')],
];

export function ModelPane({ editor, tool, attach, lightHeld, stop }: ModelPaneProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const view = useRef<ModelView>(null);
  const { shading, build, relief, dressed, history, plainGraphics, lighting } = useStore(editor);
  const [attempt, setAttempt] = useState(0);
  const slow = build.phase === 'full' && history.document.settings.method === 'nonlinear';
  useEffect(() => {
    const node = canvas.current;
    if (!node) return;
    const angles = view.current?.angles;
    const shown = new ModelView(node, () => setAttempt(attempt + 1));
    view.current = shown;
    if (angles) shown.turn(angles.yaw, angles.pitch);
    void shown.isSoftware().then((isSoftware) => editor.set({ plainGraphics: isSoftware }));
    attach(shown);
    const observer = new ResizeObserver(() => shown.resize(node.clientWidth, node.clientHeight));
    observer.observe(node);
    listen(node, shown, editor, { tool, lightHeld });
    const unfollow = follow(shown, editor);
    return () => {
      observer.disconnect();
      unfollow();
      shown.dispose();
    };
  }, [attempt]);
  return (
    <section class="pane model" aria-label={t('relief')} aria-busy={build.phase !== 'idle'} data-contours={dressed?.relief === relief ? dressed?.contourWidth : undefined}>
      <canvas key={attempt} ref={canvas} class={build.error ? 'stale' : ''} aria-label={t('relief')} role="application" tabIndex={0} />
      <div class="floating bottom" role="group" aria-label={t('relief')}>
        {shadings.map(([name, label]) => (
          <button type="button" key={name} aria-pressed={name === shading} onClick={() => editor.set({ shading: name })}>
            {label()}
          </button>
        ))}
        <button type="button" onClick={() => view.current?.turn(0, 0)}>{t('front')}</button>
        <button type="button" id="light" aria-pressed={lighting} title={t('hintLight')} onClick={() => editor.set({ lighting: !lighting })}>{t('light')}</button>
      </div>
      <button type="button" class="swap" aria-label={t('showLarge', { name: t('relief') })} onClick={() => editor.set({ pane: 'model' })} />
      <progress class={build.phase === 'full' ? 'shown' : ''} max={1} value={build.progress} aria-label={t('building')} />
      <FieldSwitch editor={editor} />
      {slow && (
        <div class="stop">
          <EnergyCurve energies={build.energies ?? []} />
          <button type="button" onClick={stop}>{t('stop')}</button>
        </div>
      )}
      {plainGraphics && <p class="plain-graphics" role="status">{t('plainGraphics')}</p>}
      {build.error && (
        <p class="trouble" role="alert">
          <strong>{t('failed')}.</strong> {errorText(build.error)}.{' '}
          {relief && t('kept')}
        </p>
      )}
    </section>
  );
}
