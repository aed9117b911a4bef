import { inks } from '../../document/editing';
import { detailInk } from '../../document/strokes';
import { t } from '../../words/catalogue';

interface ColorChoiceProps {
  label: string;
  color: string | null;
  /** `drag` is true while the user still moves through the colours of the picker. */
  choose(color: string, drag: boolean): void;
}

/** Offers a palette of matching colours and a picker for any other. */
export function ColorChoice({ label, color, choose }: ColorChoiceProps) {
  return (
    <div class="swatches" role="group" aria-label={label}>
      {[...inks, detailInk, '#fffdf8'].map((ink) => (
        <button
          type="button" key={ink} data-color={ink} aria-label={`${label} ${ink}`} aria-pressed={color === ink}
          style={{ background: ink }} onClick={() => choose(ink, false)}
        />
      ))}
      <input type="color" aria-label={t('otherColor')} value={color ?? '#d9d4c7'} onInput={(event) => choose(event.currentTarget.value, true)} />
    </div>
  );
}
