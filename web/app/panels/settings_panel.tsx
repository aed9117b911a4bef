import { changeSettings } from '../../document/editing';
import { t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import { Slider } from '../widgets/slider';
import { useStore } from '../state/store';

function tenTo(power: number): number {
  return Number((10 ** power).toPrecision(3));
}

/** Chooses how the relief is built, how contours are drawn and how parts without a drawing are inked. */
export function SettingsPanel({ editor }: { editor: Editor }) {
  const { history } = useStore(editor);
  const { document } = history;
  const { settings } = document;
  const set = (values: Partial<typeof settings>, gesture: string): void =>
    editor.edit('settings', changeSettings(document, values), gesture);
  return (
    <div class="sheet" role="group" aria-label={t('settings')}>
      <label class="field">
        <span>{t('method')}</span>
        <select
          value={settings.method}
          onChange={(event) => set({ method: event.currentTarget.value as typeof settings.method }, 'method')}
        >
          <option value="approximate">{t('approximate')}</option>
          <option value="nonlinear">{t('nonlinear')}</option>
        </select>
      </label>
      <Slider label={t('vertices')} value={settings.vertices} min={2000} max={100000} step={1000} onInput={(vertices) => set({ vertices }, 'vertices')} />
      <Slider label={t('softness')} value={settings.rho} min={0.05} max={0.5} step={0.01} onInput={(rho) => set({ rho }, 'rho')} />
      {settings.method === 'nonlinear' && (
        <>
          <Slider label={t('lambdaBnd')} value={Math.log10(settings.lambdaBnd)} min={-3} max={2} step={0.1} onInput={(power) => set({ lambdaBnd: tenTo(power) }, 'lambda')} />
          <Slider label={t('lambdaShift')} value={Math.log10(settings.lambdaShift)} min={-2} max={2} step={0.1} onInput={(power) => set({ lambdaShift: tenTo(power) }, 'shift')} />
        </>
      )}
      <label class="check">
        <input type="checkbox" id="contours" checked={settings.contours} onChange={() => set({ contours: !settings.contours }, 'contours')} /> {t('contours')}
      </label>
      {settings.contours && (
        <Slider label={t('contourWidth')} value={settings.contourWidth} min={0.25} max={3} step={0.25} onInput={(contourWidth) => set({ contourWidth }, 'contour width')} />
      )}
      {!document.drawing && (
        <>
          <Slider label={t('inkWidth')} value={settings.inkWidth} min={0} max={4} step={0.25} onInput={(inkWidth) => set({ inkWidth }, 'ink')} />
          <label class="field">
            <span>{t('inkColor')}</span>
            <input type="color" id="ink-color" value={settings.inkColor} onInput={(event) => set({ inkColor: event.currentTarget.value }, 'ink color')} />
          </label>
        </>
      )}
    </div>
  );
}
