import { useEffect, useRef } from 'preact/hooks';
import { isFailure } from '../../engine/messages';
import { type MessageKey, t } from '../../words/catalogue';
import type { Editor, EditorState } from '../state/editor';
import type { FileControl } from '../control/file_control';
import { useStore } from '../state/store';

interface Step {
  readonly text: MessageKey;
  readonly beside: 'drawing' | 'relief';
  /** Selector of the element that the user needs for this step. */
  readonly hand: string;
  /** Returns whether the user has done this step. */
  done(state: EditorState): boolean;
}

/** Angle by which the user has to turn the relief, radians. */
const turned = 0.4;

/** The steps of the tour. Doing one leads to the next. */
const steps: readonly Step[] = [
  {
    text: 'tourDraw', beside: 'drawing', hand: '.paper canvas',
    done: ({ history: { document, done } }) =>
      done.at(-1)?.label === 'draw' && document.joins.some(({ upper, lower }) => [upper, lower].includes(document.parts.at(-1)?.id ?? '')),
  },
  { text: 'tourTurn', beside: 'relief', hand: '.model canvas', done: (state) => state.turned > turned },
  { text: 'tourPrint', beside: 'relief', hand: '#export', done: ({ panel, solid }) => panel === 'print' && solid !== null && !isFailure(solid) },
  { text: 'tourEnd', beside: 'relief', hand: '[data-solid="3mf"]', done: () => false },
];

const offeredKey = 'tour';

/** Returns whether the tour was offered in this browser before, or whether that cannot be stored. */
export function isTourOffered(): boolean {
  try {
    return localStorage.getItem(offeredKey) !== null;
  } catch {
    return true;
  }
}

function noteTourOffered(): void {
  try {
    localStorage.setItem(offeredKey, 'offered');
  } catch {
    // Without storage the tour is never offered.
  }
}

/** Offers the tour on the first screen, once. */
export function TourOffer({ files, close }: { files: FileControl; close(): void }) {
  const answer = (go: boolean): void => {
    noteTourOffered();
    close();
    if (go) void files.openTour();
  };
  return (
    <section class="tour-offer" aria-label={t('tour')}>
      <p>{t('tourOffer')}</p>
      <button type="button" class="primary" id="begin-tour" onClick={() => answer(true)}>{t('tourBegin')}</button>
      <button type="button" onClick={() => answer(false)}>{t('notNow')}</button>
    </section>
  );
}

/** The card of the current step of the tour. */
export function Tour({ editor }: { editor: Editor }) {
  const state = useStore(editor);
  const { tourStep } = state;
  const step = tourStep === null ? undefined : steps[tourStep];
  const card = useRef<HTMLDivElement>(null);
  const isDone = step?.done(state) ?? false;
  useEffect(() => {
    if (isDone && tourStep !== null) editor.set({ tourStep: tourStep + 1 });
  }, [isDone, tourStep]);
  useEffect(() => card.current?.focus(), [tourStep]);
  if (!step || tourStep === null) return null;
  const last = tourStep === steps.length - 1;
  const close = (): void => editor.set({ tourStep: null });
  const show = (): void => {
    editor.set({ pane: step.hand.startsWith('.paper') ? 'paper' : 'model' });
    document.querySelector<HTMLElement>(step.hand)?.focus();
  };
  return (
    <div class={`tour beside-${step.beside}`} role="dialog" aria-label={t('tour')} aria-describedby="tour-text" tabIndex={-1} ref={card} data-step={tourStep}>
      <p id="tour-text">{t(step.text, { export: t('export'), print: t('printOpen') })}</p>
      <div class="row">
        <span class="quiet">{tourStep + 1} / {steps.length}</span>
        {!last && <button type="button" onClick={close}>{t('close')}</button>}
        <button type="button" class="primary" onClick={last ? close : show}>{t(last ? 'done' : 'tourShow')}</button>
      </div>
    </div>
  );
}
