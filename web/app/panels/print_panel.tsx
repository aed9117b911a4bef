import { type Failure, isFailure, type PrintFinding, type Solid, type SolidFormat, errorText } from '../../engine/messages';
import { type MessageKey, t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import type { Exports } from '../control/exports';
import type { PrintChoice, PrintKind } from '../state/print_choice';
import { SizeField } from '../widgets/size_field';
import { Slider } from '../widgets/slider';
import { useStore } from '../state/store';

const kinds: readonly [PrintKind, MessageKey][] = [
  ['plaque', 'kindPlaque'], ['cutout', 'kindCutout'], ['medal', 'kindMedal'], ['figure', 'kindFigure'],
];
const hangs: readonly [PrintChoice['hang'], MessageKey][] = [['none', 'hangNone'], ['hole', 'hangHole'], ['ring', 'hangRing']];
const formats: readonly [SolidFormat, MessageKey][] = [
  ['3mf', 'format3mf'], ['stl', 'formatStl'], ['glb', 'formatGlb'], ['usdz', 'formatUsdz'],
];
const troubles: readonly [PrintFinding['trouble'], MessageKey][] = [
  ['loose', 'printLoose'], ['thin', 'printThin'], ['neck', 'printNeck'], ['overhang', 'printOverhang'],
];
/** Most parts that a finding names. */
const mostNamed = 3;

/** Shows size and volume of a solid, its weak spots, and how to fix them. */
function Findings({ solid }: { solid: Solid }) {
  const sides = solid.size.map((side) => side.toFixed(1)).join(' × ');
  return (
    <>
      <p role="status" id="solid-facts">{sides} mm, {(solid.volume / 1000).toFixed(1)} cm³</p>
      {troubles.map(([trouble, message]) => {
        const found = solid.findings.filter((finding) => finding.trouble === trouble);
        if (found.length === 0) return null;
        const parts = found.slice(0, mostNamed).map(({ part }) => part).join(', ') + (found.length > mostNamed ? ' …' : '');
        const size = Math.max(...found.map(({ enough }) => enough));
        return <p class="finding" key={trouble} data-trouble={trouble}>{t(message, { parts, size })}</p>;
      })}
    </>
  );
}

function State({ solid }: { solid: Solid | Failure | null }) {
  if (!solid) return <p role="status">{t('printWorking')}</p>;
  return isFailure(solid) ? <p class="finding" role="status">{errorText(solid.error)}</p> : <Findings solid={solid} />;
}

/** Chooses an object to print and its size, and exports its files. The relief's pane shows it meanwhile. */
export function PrintPanel({ editor, exports }: { editor: Editor; exports: Exports }) {
  const { print, solid } = useStore(editor);
  const set = (values: Partial<PrintChoice>): void => editor.set({ print: { ...print, ...values } });
  return (
    <div class="sheet print" role="group" aria-label={t('printTitle')}>
      <div class="choices" role="group" aria-label={t('printTitle')}>
        {kinds.map(([kind, label]) => (
          <button type="button" key={kind} data-kind={kind} aria-pressed={kind === print.kind} onClick={() => set({ kind })}>{t(label)}</button>
        ))}
      </div>
      <SizeField editor={editor} />
      <Slider label={t('printHeight')} value={print.height} min={0} max={60} step={0.5} onInput={(height) => set({ height })} />
      <label class="check">
        <input type="checkbox" checked={print.detail} disabled={print.height === 0} onChange={() => set({ detail: !print.detail })} /> {t('printDetail')}
      </label>
      {print.kind !== 'figure' && (
        <>
          <Slider label={t('printThickness')} value={print.thickness} min={0.5} max={10} step={0.5} onInput={(thickness) => set({ thickness })} />
          <label class="field">
            <span>{t('printHang')}</span>
            <select value={print.hang} onChange={(event) => set({ hang: event.currentTarget.value as PrintChoice['hang'] })}>
              {hangs.map(([hang, label]) => <option key={hang} value={hang}>{t(label)}</option>)}
            </select>
          </label>
        </>
      )}
      <State solid={solid} />
      {formats.map(([format, label]) => (
        <button type="button" class="wide" key={format} data-solid={format} onClick={() => void exports.solid(format)}>{t(label)}</button>
      ))}
    </div>
  );
}
