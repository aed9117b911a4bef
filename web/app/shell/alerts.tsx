import { useEffect, useRef, useState } from 'preact/hooks';
import { t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import type { FileControl } from '../control/file_control';
import type { Keeper } from '../control/keeper';
import { useStore } from '../state/store';

interface AlertsProps {
  editor: Editor;
  files: FileControl;
  keeper: Keeper;
}

/** Asks whether to take over a document that another tab has open, or to open a copy. */
function Elsewhere({ editor, files, keeper, id }: AlertsProps & { id: string }) {
  const [name, setName] = useState('');
  const first = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    void keeper.entry(id).then((entry) => setName(entry?.name ?? ''));
    first.current?.focus();
  }, [id]);
  const leave = (): void => editor.set({ elsewhere: null });
  return (
    <div class="alert question" role="alertdialog" aria-label={t('openElsewhere', { name })} onKeyDown={(event) => event.key === 'Escape' && leave()}>
      <p>{t('openElsewhere', { name })}</p>
      <button type="button" class="primary" id="take-over" ref={first} onClick={() => void files.openKept(id, true)}>{t('takeOver')}</button>
      <button type="button" id="open-copy" onClick={() => void files.openCopy(id)}>{t('openCopy')}</button>
      <button type="button" onClick={leave}>{t('cancel')}</button>
    </div>
  );
}

/** Shows lasting problems and questions until they are resolved. */
export function Alerts({ editor, files, keeper }: AlertsProps) {
  const { alert, elsewhere, open, shelf } = useStore(editor);
  if (elsewhere !== null) return <Elsewhere editor={editor} files={files} keeper={keeper} id={elsewhere} />;
  if (alert === 'none' || (alert === 'takenOver' && !open)) return null;
  return (
    <div class="alert" role="alert" data-alert={alert}>
      <p>{t(alert === 'unsaved' ? 'saveFailed' : 'takenOver')}</p>
      {alert === 'unsaved' && <button type="button" class="primary" id="save-now" onClick={() => void files.saveProject()}>{t('saveNow')}</button>}
      {alert === 'takenOver' && <button type="button" id="take-back" onClick={() => shelf && void files.openKept(shelf.id, true)}>{t('takeBack')}</button>}
    </div>
  );
}
