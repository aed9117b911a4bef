import { paintWidths } from '../../document/paint';
import { t } from '../../words/catalogue';
import { ColorChoice } from '../widgets/color_choice';
import type { Editor } from '../state/editor';
import { useStore } from '../state/store';

/** The bar of the painting tool: colour and width of its brush, and rubbing out. */
export function PaintBar({ editor }: { editor: Editor }) {
  const { tool, paint } = useStore(editor);
  if (tool !== 'paint') return null;
  return (
    <div class="scribble-bar paint-bar" role="group" aria-label={t('paint')}>
      <ColorChoice label={t('color')} color={paint.rubs ? null : paint.color} choose={(color) => editor.set({ paint: { ...paint, color, rubs: false } })} />
      <label class="brush-width" title={t('brushWidth')}>
        <span class="hidden">{t('brushWidth')}</span>
        <input
          type="range" min={paintWidths.least} max={paintWidths.most} value={paint.width}
          onInput={(event) => editor.set({ paint: { ...paint, width: Number(event.currentTarget.value) } })}
        />
      </label>
      <button type="button" id="rub-out" aria-pressed={paint.rubs} title={t('hintRubPaint')} onClick={() => editor.set({ paint: { ...paint, rubs: !paint.rubs } })}>
        {t('brushErase')}
      </button>
    </div>
  );
}
