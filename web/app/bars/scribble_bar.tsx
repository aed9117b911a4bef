import { canScribble, clearStrokes, labelOfStroke, scribblesOf } from '../../document/scribbling';
import type { Brush, BrushKind } from '../../tools/scribble_tool';
import { inkOf } from '../../view/colors';
import { type MessageKey, t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import type { FileControl } from '../control/file_control';
import type { SegmentControl } from '../control/segment_control';
import { useStore } from '../state/store';

const kinds: readonly { kind: BrushKind; label: MessageKey; hint: MessageKey }[] = [
  { kind: 'auto', label: 'brushAuto', hint: 'hintBrushAuto' },
  { kind: 'outside', label: 'brushOutside', hint: 'hintBrushOutside' },
  { kind: 'hole', label: 'brushHole', hint: 'hintBrushHole' },
  { kind: 'erase', label: 'brushErase', hint: 'hintBrushErase' },
  { kind: 'move', label: 'brushMove', hint: 'hintBrushMove' },
];

/** Widths of the scribble brush, CSS px. */
export const brushWidths = { least: 4, most: 60 } as const;

/** Lists the strokes of each part and of the background, with their number and a button to remove them. */
export function StrokeList({ editor, segments }: { editor: Editor; segments: SegmentControl }) {
  const { history, pending, brush, tool } = useStore(editor);
  const document = pending ?? history.document;
  const { parts, strokes } = scribblesOf(document);
  const count = (of: (typeof strokes)[number]['part'], kind?: string): number =>
    strokes.filter((stroke) => (kind === undefined ? stroke.part === of : stroke.kind === kind)).length;
  const take = (values: Partial<Brush>): void => editor.set({ brush: { ...brush, ...values } });
  const background = (['outside', 'hole'] as const).filter((kind) => count(undefined, kind) > 0);
  if (tool !== 'scribble' || strokes.length === 0) return null;
  return (
    <ul class="stroke-list" aria-label={t('strokes')}>
      {parts.map((part) => (
        <li key={part}>
          <button
            type="button"
            class="chip"
            aria-pressed={brush.kind === 'part' && brush.part === part}
            title={t('brushPart', { name: part })}
            onClick={() => take({ kind: 'part', part })}
          >
            <span class="dot" style={{ background: inkOf(labelOfStroke(document, { part }) ?? 0) }} /> {part} · {count(part)}
          </button>
          <button type="button" class="bare small" aria-label={t('clearStrokes', { name: part })} title={t('clearStrokes', { name: part })} onClick={() => segments.wish('erase', (next) => clearStrokes(next, { part }))}>×</button>
        </li>
      ))}
      {background.map((kind) => {
        const name = t(kind === 'outside' ? 'brushOutside' : 'brushHole');
        return (
          <li key={kind}>
            <span class="chip flat">{name} · {count(undefined, kind)}</span>
            <button type="button" class="bare small" aria-label={t('clearStrokes', { name })} title={t('clearStrokes', { name })} onClick={() => segments.wish('erase', (next) => clearStrokes(next, { kind }))}>×</button>
          </li>
        );
      })}
    </ul>
  );
}

function chooseMask(files: FileControl): void {
  const input = document.createElement('input');
  input.type = 'file';
  input.accept = '.png,.jpg,.jpeg,.gif,.bmp,.webp';
  input.addEventListener('change', () => {
    const [mask] = input.files ?? [];
    if (mask) void files.cutFigure(mask);
  });
  input.click();
}

/** The bar of the scribble tool: kind, width and softness of its brush, and the figure mask. */
export function ScribbleBar({ editor, files }: { editor: Editor; files: FileControl }) {
  const { tool, brush, history, tint, pending } = useStore(editor);
  if (tool !== 'scribble' || !canScribble(history.document)) return null;
  const take = (kind: BrushKind): void => editor.set({ brush: { ...brush, kind, part: null } });
  const step = (event: KeyboardEvent): void => {
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (by === undefined || event.target instanceof HTMLInputElement) return;
    event.preventDefault();
    const at = kinds.findIndex(({ kind }) => kind === brush.kind);
    const next = kinds[(Math.max(0, at) + by + kinds.length) % kinds.length];
    if (!next) return;
    take(next.kind);
    (event.currentTarget as HTMLElement).querySelector<HTMLElement>(`[data-brush=${next.kind}]`)?.focus();
  };
  return (
    <div class="scribble-bar" role="toolbar" aria-label={t('brush')} data-tint-ms={tint ? Math.round(tint.ms) : undefined} data-pending={pending !== null} onKeyDown={step}>
      {kinds.map(({ kind, label, hint }) => (
        <button
          type="button"
          key={kind}
          data-brush={kind}
          aria-pressed={brush.kind === kind}
          tabIndex={brush.kind === kind || (brush.kind === 'part' && kind === 'auto') ? 0 : -1}
          title={t(hint)}
          onClick={() => take(kind)}
        >
          {t(label)}
        </button>
      ))}
      <label class="check" title={t('hintBrushSoft')}>
        <input type="checkbox" id="soft" checked={brush.soft} onChange={() => editor.set({ brush: { ...brush, soft: !brush.soft } })} /> {t('brushSoft')}
      </label>
      <label class="brush-width" title={t('brushWidth')}>
        <span class="hidden">{t('brushWidth')}</span>
        <input
          type="range"
          min={brushWidths.least}
          max={brushWidths.most}
          value={brush.width}
          onInput={(event) => editor.set({ brush: { ...brush, width: Number(event.currentTarget.value) } })}
        />
      </label>
      <button type="button" id="figure-mask" title={t('hintFigureMask')} onClick={() => chooseMask(files)}>{t('figureMask')}</button>
    </div>
  );
}
