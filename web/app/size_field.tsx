import { changeSettings } from '../document/editing';
import { t } from './catalogue';
import type { Editor } from './editor';
import { useStore } from './store';

/** The longest side of what is exported, mm. */
export function SizeField({ editor }: { editor: Editor }) {
  const { document } = useStore(editor).history;
  const setSize = (value: number): void => {
    if (value >= 1 && value <= 10_000) editor.edit('size', changeSettings(document, { sizeMm: value }), 'size');
  };
  return (
    <label class="field">
      <span>{t('size')}</span>
      <input type="number" min={1} max={10000} value={document.settings.sizeMm} onChange={(event) => setSize(Number(event.currentTarget.value))} />
    </label>
  );
}
