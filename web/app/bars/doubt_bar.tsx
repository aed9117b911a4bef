import type { Document } from '../../document/document';
import { type Doubt, doubtsOf, refuseGuess, sameDoubt, takeGuess } from '../../document/doubts';
import { keepGap, openGap } from '../../document/gaps';
import { canScribble } from '../../document/scribbling';
import { t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import type { SegmentControl } from '../control/segment_control';
import { useStore } from '../state/store';

function questionOf(doubt: Doubt): string {
  if (doubt.kind === 'gap') return t('doubtGap');
  return t(doubt.kind === 'order' ? 'doubtOrder' : 'doubtJoin', { upper: doubt.upper, lower: doubt.lower });
}

/** A chip that counts the uncertain guesses about a flat drawing and asks about one after the other. */
export function DoubtBar({ editor, segments }: { editor: Editor; segments: SegmentControl }) {
  const { history, pending, tint, doubt } = useStore(editor);
  const { document } = history;
  if (!document.segmentation || !canScribble(document)) return null;
  const doubts = doubtsOf(pending ?? document, tint?.gaps ?? []);
  if (doubts.length === 0) return null;
  const chosen = sameDoubt(doubts, doubt);
  const next = doubts[(chosen ? doubts.indexOf(chosen) + 1 : 0) % doubts.length] ?? null;
  const answer = (isSo: boolean): void => {
    if (!chosen) return;
    editor.set({ doubt: next === chosen ? null : next });
    if (chosen.kind === 'gap') {
      const settle = (next: Document): Document => (isSo ? keepGap : openGap)(next, chosen.gap);
      segments.wish(isSo ? 'keep gap' : 'open gap', settle);
    } else if (isSo) editor.edit('confirm', takeGuess(document, chosen));
    else editor.edit(chosen.kind, refuseGuess(document, chosen));
  };
  return (
    <div class="doubt-bar" role="group" aria-label={t('doubts', { all: doubts.length })} data-doubts={doubts.length} data-kind={chosen?.kind}>
      <button type="button" data-doubt="next" aria-expanded={chosen !== undefined} onClick={() => editor.set({ doubt: next, pane: 'paper' })}>
        {chosen ? t('doubtAt', { at: doubts.indexOf(chosen) + 1, all: doubts.length }) : t('doubts', { all: doubts.length })}
      </button>
      {chosen && (
        <>
          <span role="status">{questionOf(chosen)}</span>
          <button type="button" data-doubt="yes" title={chosen.kind === 'gap' ? t('hintKeepGap') : ''} onClick={() => answer(true)}>{t(chosen.kind === 'gap' ? 'keepGap' : 'yes')}</button>
          <button type="button" data-doubt="no" title={chosen.kind === 'gap' ? t('hintOpenGap') : ''} onClick={() => answer(false)}>{t(chosen.kind === 'gap' ? 'openGap' : 'no')}</button>
          <button type="button" data-doubt="close" aria-label={t('close')} onClick={() => editor.set({ doubt: null })}>×</button>
        </>
      )}
    </div>
  );
}
