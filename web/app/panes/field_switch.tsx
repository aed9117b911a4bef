import { type MessageKey, t } from '../../words/catalogue';
import type { Field } from '../../engine/messages';
import type { Editor } from '../state/editor';
import { useStore } from '../state/store';

const fields: readonly [Field, MessageKey][] = [
  ['relief', 'fieldRelief'], ['inflation', 'fieldInflation'], ['shift', 'fieldShift'],
];

export function nextField(field: Field): Field {
  const at = fields.findIndex(([name]) => name === field);
  return fields[(at + 1) % fields.length]?.[0] ?? 'relief';
}

/**
 * Chooses whether the relief shows h, f or g. It appears with the non-linear method only, which finds f and g
 * apart.
 */
export function FieldSwitch({ editor }: { editor: Editor }) {
  const { field, history } = useStore(editor);
  if (history.document.settings.method !== 'nonlinear' && field === 'relief') return null;
  return (
    <div class="floating fields" role="group" aria-label={t('field')}>
      {fields.map(([name, label]) => (
        <button type="button" key={name} data-field={name} aria-pressed={name === field} onClick={() => editor.set({ field: name })}>
          {t(label)}
        </button>
      ))}
    </div>
  );
}
