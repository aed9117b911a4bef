import { useRef } from 'preact/hooks';
import { type MessageKey, t } from '../../words/catalogue';
import type { Editor, ToolName } from '../state/editor';
import { Icon } from '../widgets/icons';
import { useStore } from '../state/store';

export const tools: readonly { name: ToolName; key: string; label: MessageKey; hint: MessageKey }[] = [
  { name: 'select', key: '1', label: 'select', hint: 'hintSelect' },
  { name: 'draw', key: '2', label: 'draw', hint: 'hintDraw' },
  { name: 'join', key: '3', label: 'join', hint: 'hintJoin' },
  { name: 'order', key: '4', label: 'order', hint: 'hintOrder' },
  { name: 'range', key: '5', label: 'range', hint: 'hintRange' },
  { name: 'hand', key: '6', label: 'hand', hint: 'hintHand' },
  { name: 'scribble', key: '7', label: 'scribble', hint: 'hintScribble' },
  { name: 'outline', key: '8', label: 'outline', hint: 'hintOutline' },
  { name: 'cue', key: '9', label: 'cue', hint: 'hintCue' },
  { name: 'paint', key: 'b', label: 'paint', hint: 'hintPaint' },
];

/** The tools. The bar is a single tab stop; arrow keys move from tool to tool. */
export function Toolbar({ editor }: { editor: Editor }) {
  const { tool } = useStore(editor);
  const bar = useRef<HTMLDivElement>(null);
  const step = (event: KeyboardEvent): void => {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    const at = tools.findIndex((entry) => entry.name === tool);
    const next = tools[(at + by + tools.length) % tools.length]?.name ?? 'select';
    editor.set({ tool: next, notice: '' });
    bar.current?.querySelector<HTMLElement>(`[data-tool=${next}]`)?.focus();
  };
  return (
    <div class="toolbar" role="toolbar" aria-label={t('tools')} aria-orientation="vertical" ref={bar} onKeyDown={step}>
      {tools.map((entry) => (
        <button
          type="button"
          key={entry.name}
          data-tool={entry.name}
          tabIndex={entry.name === tool ? 0 : -1}
          aria-pressed={entry.name === tool}
          title={`${t(entry.label)} (${entry.key.toUpperCase()}) — ${t(entry.hint)}`}
          aria-label={`${t(entry.label)} ${entry.key}`}
          onClick={() => editor.set({ tool: entry.name, notice: '' })}
        >
          <Icon name={entry.name} />
          <kbd>{entry.key.toUpperCase()}</kbd>
        </button>
      ))}
    </div>
  );
}
