import { useEffect, useRef } from 'preact/hooks';
import { ModelView } from '../view/model_view';
import { t } from './catalogue';
import type { Editor, Shading } from './editor';
import { EnergyCurve } from './energy_curve';
import { FieldSwitch } from './field_switch';
import { bledTexture } from './pictures';
import { useStore } from './store';

interface ModelPaneProps {
  editor: Editor;
  attach(view: ModelView): void;
  lightHeld(): boolean;
  stop(): void;
}

/** A click that did not turn the model chooses a part; with L held, dragging moves the light. */
function listen(canvas: HTMLCanvasElement, view: ModelView, editor: Editor, lightHeld: () => boolean): void {
  let down: [number, number] | null = null;
  canvas.addEventListener('pointerdown', (event) => {
    down = [event.offsetX, event.offsetY];
  });
  canvas.addEventListener('pointerup', (event) => {
    if (down && Math.hypot(event.offsetX - down[0], event.offsetY - down[1]) < 4)
      editor.select(view.pick(event.offsetX, event.offsetY));
    down = null;
  });
  canvas.addEventListener('pointermove', (event) => {
    if (lightHeld())
      view.aimLight((2 * event.offsetX) / canvas.clientWidth - 1, 1 - (2 * event.offsetY) / canvas.clientHeight);
    else if (event.buttons === 0) editor.set({ hovered: view.pick(event.offsetX, event.offsetY) });
  });
  canvas.addEventListener('pointerleave', () => editor.set({ hovered: null }));
  canvas.addEventListener('dblclick', () => view.turn(0, 0));
}

/** Brings the view up with the editor; each part of it only when it changed. */
function follow(view: ModelView, editor: Editor): () => void {
  let before: readonly unknown[] = [];
  const update = (): void => {
    const { relief, picture, shading, hovered, selected, history } = editor.state;
    const { document } = history;
    const now = [relief, picture ?? document.parts, shading, hovered ?? selected, document.name];
    if (now[1] !== before[1] || now[4] !== before[4])
      view.setPicture(picture || document.parts.length > 0 ? bledTexture(document, picture) : null);
    if (now[0] !== before[0]) view.show(relief?.surface ?? null, document.width, document.height);
    if (now[2] !== before[2]) view.setShading(shading);
    if (now[3] !== before[3]) view.highlight(hovered ?? selected);
    before = now;
  };
  update();
  return editor.subscribe(update);
}

const shadings: readonly [Shading, () => string][] = [
  ['drawing', () => t('shadingDrawing')],
  ['clay', () => t('shadingClay')],
  ['normals', () => t('shadingNormals')],
];

export function ModelPane({ editor, attach, lightHeld, stop }: ModelPaneProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const view = useRef<ModelView>(null);
  const { shading, build, relief, history } = useStore(editor);
  const slow = build.phase === 'full' && history.document.settings.method === 'nonlinear';
  useEffect(() => {
    const node = canvas.current;
    if (!node) return;
    const shown = new ModelView(node);
    view.current = shown;
    attach(shown);
    const observer = new ResizeObserver(() => shown.resize(node.clientWidth, node.clientHeight));
    observer.observe(node);
    listen(node, shown, editor, lightHeld);
    const unfollow = follow(shown, editor);
    return () => {
      observer.disconnect();
      unfollow();
    };
  }, []);
  return (
    <section class="pane model" aria-label={t('relief')} aria-busy={build.phase !== 'idle'}>
      <canvas ref={canvas} class={build.error ? 'stale' : ''} aria-label={t('relief')} role="img" />
      <div class="floating bottom" role="group" aria-label={t('relief')}>
        {shadings.map(([name, label]) => (
          <button type="button" key={name} aria-pressed={name === shading} onClick={() => editor.set({ shading: name })}>
            {label()}
          </button>
        ))}
        <button type="button" onClick={() => view.current?.turn(0, 0)}>{t('front')}</button>
      </div>
      <progress class={build.phase === 'full' ? 'shown' : ''} max={1} value={build.progress} aria-label={t('building')} />
      <FieldSwitch editor={editor} />
      {slow && (
        <div class="stop">
          <EnergyCurve energies={build.energies ?? []} />
          <button type="button" onClick={stop}>{t('stop')}</button>
        </div>
      )}
      {build.error && (
        <p class="trouble" role="alert">
          <strong>{t('failed')}.</strong> {build.error.where && `${build.error.where}: `}{build.error.message}.{' '}
          {relief && t('kept')}
        </p>
      )}
    </section>
  );
}
