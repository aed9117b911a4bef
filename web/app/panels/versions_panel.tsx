import { useEffect, useRef, useState } from 'preact/hooks';
import type { Document } from '../../document/document';
import type { VersionNote } from '../../document/shelf';
import { drawStamp } from '../../view/paper_view';
import { language, t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import type { Keeper } from '../control/keeper';
import { useStore } from '../state/store';

/** Width of the picture, CSS px. */
const width = 288;

/** Shows every saved version of the document under a slider. Going back to one is a step like any other. */
export function VersionsPanel({ editor, keeper }: { editor: Editor; keeper: Keeper }) {
  const { shelf, history, picture, saved } = useStore(editor);
  const [notes, setNotes] = useState<readonly VersionNote[]>([]);
  const [at, setAt] = useState<number | null>(null);
  const [shown, setShown] = useState<Document | null | 'reading'>('reading');
  const canvas = useRef<HTMLCanvasElement>(null);
  const index = Math.min(at ?? notes.length - 1, notes.length - 1);
  const note = notes[index];
  const { document } = history;
  const height = Math.round((width * document.height) / document.width);

  useEffect(() => {
    if (shelf) void keeper.entry(shelf.id).then((entry) => setNotes(entry?.versions ?? []));
  }, [shelf, saved, history]);
  useEffect(() => {
    let over = false;
    if (shelf && note)
      void keeper.version(shelf.id, note.number).then((version) => {
        if (!over) setShown(version);
      });
    return () => {
      over = true;
    };
  }, [shelf, note?.number]);
  useEffect(() => {
    const context = canvas.current?.getContext('2d');
    if (context && shown && shown !== 'reading') drawStamp(context, shown, picture);
  }, [shown, picture, notes.length > 0]);

  const goBack = (): void => {
    if (!shown || shown === 'reading') return;
    // Versions share one drawing; its paintable form is not saved with them.
    editor.edit('version', { ...shown, drawing: document.drawing });
    setAt(null);
  };
  return (
    <div class="sheet versions" role="group" aria-label={t('versions')}>
      <p class="quiet">{t('versionsHelp')}</p>
      {note && (
        <>
          <canvas ref={canvas} width={2 * width} height={2 * height} role="img" aria-label={t('versions')} />
          <label>
            <span>{t('versionAt', { at: index + 1, all: notes.length, time: new Date(note.time).toLocaleTimeString(language) })}</span>
            <input type="range" min={0} max={notes.length - 1} value={index} onInput={(event) => setAt(Number(event.currentTarget.value))} />
          </label>
          {shown ? (
            <button type="button" class="primary" id="go-back" disabled={index === notes.length - 1} onClick={goBack}>{t('goBackTo')}</button>
          ) : (
            <p>{t('versionDamaged')}</p>
          )}
        </>
      )}
    </div>
  );
}
