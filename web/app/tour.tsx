import { useEffect, useRef } from 'preact/hooks';
import { type MessageKey, t } from './catalogue';
import type { Editor } from './editor';
import { useStore } from './store';

/** A step says one thing beside what it speaks of. */
const steps: readonly { text: MessageKey; beside: 'model' | 'side' | 'tools' | 'paper' }[] = [
  { text: 'tour1', beside: 'model' },
  { text: 'tour2', beside: 'side' },
  { text: 'tour3', beside: 'tools' },
  { text: 'tour4', beside: 'tools' },
  { text: 'tourOutline', beside: 'tools' },
  { text: 'tour5', beside: 'paper' },
  { text: 'tourScribble', beside: 'tools' },
];

export function Tour({ editor }: { editor: Editor }) {
  const { tourStep } = useStore(editor);
  const step = tourStep === null ? undefined : steps[tourStep];
  const next = useRef<HTMLButtonElement>(null);
  useEffect(() => next.current?.focus(), [tourStep]);
  if (!step || tourStep === null) return null;
  const last = tourStep === steps.length - 1;
  return (
    <div class={`tour ${step.beside}`} role="dialog" aria-label={t('tour')} aria-live="polite">
      <p>{t(step.text)}</p>
      <div class="row">
        <span class="quiet">{tourStep + 1} / {steps.length}</span>
        <button type="button" onClick={() => editor.set({ tourStep: null })}>{t('close')}</button>
        <button type="button" class="primary" ref={next} onClick={() => editor.set({ tourStep: last ? null : tourStep + 1 })}>
          {last ? t('done') : t('next')}
        </button>
      </div>
    </div>
  );
}
