import { type MessageKey, t } from '../../words/catalogue';

const rows: readonly [string, MessageKey][] = [
  ['1 … 9, B', 'keyTools'],
  [', . arrows', 'keyGrip'],
  ['Page Up, Page Down, Home, End', 'keyOrder'],
  ['J', 'keyJoin'],
  ['H', 'keyReverse'],
  ['Delete', 'keyDelete'],
  ['Space, wheel', 'keyPan'],
  ['Ctrl wheel, + −', 'keyZoom'],
  ['0', 'keyFit'],
  ['V', 'keyPeek'],
  ['L', 'keyLight'],
  ['N', 'keyShade'],
  ['F', 'keyField'],
  ['D', 'keyTint'],
  ['Ctrl Z, Ctrl ⇧ Z', 'keyUndo'],
  ['Ctrl O, Ctrl S, Ctrl E', 'keyFile'],
  ['Esc', 'keyEscape'],
  ['[ ]', 'keyBrush'],
  ['Shift', 'keyExtend'],
  ['Alt', 'keyErase'],
  ['Arrows, Enter', 'keyScribble'],
];

/** Lists the keys and what they do. */
export function KeysPanel() {
  return (
    <div class="sheet keys" role="group" tabIndex={0} aria-label={t('keys')}>
      <dl>
        {rows.map(([keys, label]) => (
          <div key={label}>
            <dt><kbd>{keys}</kbd></dt>
            <dd>{t(label)}</dd>
          </div>
        ))}
      </dl>
    </div>
  );
}
