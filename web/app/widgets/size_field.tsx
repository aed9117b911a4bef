import { useState } from 'preact/hooks';
import { changeSettings } from '../../document/editing';
import { t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import { useStore } from '../state/store';

/** A field for the longest side of exported models, mm. */
export function SizeField({ editor }: { editor: Editor }) {
  const { document } = useStore(editor).history;
  // Keeps what the user is typing when the page is drawn again.
  const [typed, setTyped] = useState<string | null>(null);
  const setSize = (value: number): void => {
    setTyped(null);
    if (value >= 1 && value <= 10_000) editor.edit('size', changeSettings(document, { sizeMm: value }), 'size');
  };
  return (
    <label class="field">
      <span>{t('size')}</span>
      <input
        type="number" min={1} max={10000} value={typed ?? document.settings.sizeMm}
        onInput={(event) => setTyped(event.currentTarget.value)} onChange={(event) => setSize(Number(event.currentTarget.value))}
      />
    </label>
  );
}
