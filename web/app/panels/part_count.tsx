import { useState } from 'preact/hooks';
import { canScribble, withCount } from '../../document/scribbling';
import { t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import type { SegmentControl } from '../control/segment_control';
import { Slider } from '../widgets/slider';
import { useStore } from '../state/store';

/** Largest number that the slider offers. */
const most = 30;

/** Sets the number of parts of a flat drawing. Fewer parts are merged from those found; more are split. */
export function PartCount({ editor, segments }: { editor: Editor; segments: SegmentControl }) {
  const { history } = useStore(editor);
  const [wanted, setWanted] = useState<number | null>(null);
  const { document } = history;
  if (!document.segmentation || !canScribble(document)) return null;
  const choose = (count: number): void => {
    setWanted(count);
    segments.show(withCount(segments.pending, count));
  };
  const settle = (target: EventTarget | null): void => {
    if (!(target instanceof HTMLInputElement)) return;
    const count = Number(target.value);
    segments.wish('parts', (next) => withCount(next, count));
    setWanted(null);
  };
  return (
    <div class="part-count" onChange={(event) => settle(event.target)}>
      <Slider label={t('partCount')} value={wanted ?? document.parts.length} min={1} max={most} step={1} onInput={choose} />
    </div>
  );
}
