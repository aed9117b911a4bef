import type { Document } from '../document/document';
import { type Gap, keepGap, openGap, openQuestions, sameGap } from '../document/gaps';
import { canScribble } from '../document/scribbling';
import { t } from './catalogue';
import type { Editor } from './editor';
import type { SegmentControl } from './segment_control';
import { useStore } from './store';

/** The gaps in the lines that were closed, one after the other, while scribbles are in hand. */
export function GapBar({ editor, segments }: { editor: Editor; segments: SegmentControl }) {
  const { tool, history, pending, tint, gap } = useStore(editor);
  if (tool !== 'scribble' || !tint || !canScribble(history.document)) return null;
  const gaps = openQuestions(pending ?? history.document, tint.gaps);
  if (gaps.length === 0) return null;
  const chosen = sameGap(gaps, gap);
  const at = chosen ? gaps.indexOf(chosen) : -1;
  const answer = (label: string, say: (document: Document, gap: Gap) => Document): void => {
    if (!chosen) return;
    editor.set({ gap: gaps[(at + 1) % gaps.length] ?? null });
    segments.wish(label, (document) => say(document, chosen));
  };
  return (
    <div class="gap-bar" role="group" aria-label={t('gaps')} data-gaps={gaps.length}>
      <span>{chosen ? t('gapOf', { at: at + 1, all: gaps.length }) : t('gapsFound', { all: gaps.length })}</span>
      {(!chosen || gaps.length > 1) && <button type="button" data-gap="next" onClick={() => editor.set({ gap: gaps[(at + 1) % gaps.length] ?? null })}>{t('nextGap')}</button>}
      {chosen && <button type="button" data-gap="keep" title={t('hintKeepGap')} onClick={() => answer('keep gap', keepGap)}>{t('keepGap')}</button>}
      {chosen && <button type="button" data-gap="open" title={t('hintOpenGap')} onClick={() => answer('open gap', openGap)}>{t('openGap')}</button>}
    </div>
  );
}
