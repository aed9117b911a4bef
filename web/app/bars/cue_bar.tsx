import { clearCues, cueRanges } from '../../document/cues';
import type { Cue } from '../../document/document';
import { type MessageKey, t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import { useStore } from '../state/store';

const kinds: readonly { kind: Cue['kind']; label: MessageKey; hint: MessageKey }[] = [
  { kind: 'bulge', label: 'cueBulge', hint: 'hintBulge' },
  { kind: 'slope', label: 'cueSlope', hint: 'hintSlope' },
  { kind: 'crease', label: 'cueCrease', hint: 'hintCrease' },
];

/** Chooses what the next line of the profile tool does. */
export function CueBar({ editor }: { editor: Editor }) {
  const { tool, cue, history, selected } = useStore(editor);
  if (tool !== 'cue') return null;
  const { least, most, step } = cueRanges[cue.kind];
  const { document } = history;
  const own = document.cues.filter(({ part }) => part === selected).length;
  return (
    <div class="scribble-bar" role="group" aria-label={t('cue')}>
      {kinds.map(({ kind, label, hint }) => (
        <button type="button" key={kind} data-cue={kind} aria-pressed={cue.kind === kind} title={t(hint)} onClick={() => editor.set({ cue: { kind, value: cueRanges[kind].usual } })}>
          {t(label)}
        </button>
      ))}
      <label class="brush-width">
        <span class="hidden">{t('cueValue')}</span>
        <input type="range" min={least} max={most} step={step} value={cue.value} onInput={(event) => editor.set({ cue: { ...cue, value: Number(event.currentTarget.value) } })} />
      </label>
      <output>{cue.kind === 'bulge' ? `× ${cue.value}` : `${cue.value}°`}</output>
      {selected !== null && own > 0 && (
        <button type="button" data-cue="clear" onClick={() => editor.edit('cue', clearCues(document, selected))}>{t('clearCues', { name: selected })}</button>
      )}
    </div>
  );
}
