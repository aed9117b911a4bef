import type { Pair, Part, RelationKind } from '../../document/document';
import { partIndex } from '../../document/document';
import {
  changePart, colorPart, movePart, neighbours, ordered, type PartValues, relate, removePart, removeRanges, renamePart, toggleJoin,
} from '../../document/editing';
import { t } from '../../words/catalogue';
import { ColorChoice } from '../widgets/color_choice';
import type { Editor } from '../state/editor';
import { Icon } from '../widgets/icons';
import { NameField } from '../widgets/name_field';
import { Slider } from '../widgets/slider';
import { useStore } from '../state/store';

/** Shows and changes how the selected part meets one other part. */
function Neighbour({ editor, part, other }: { editor: Editor; part: Part; other: Part }) {
  const { document } = editor;
  const pair = ordered(document, part.id, other.id);
  const same = (entry: Pair): boolean =>
    entry.upper === pair.upper && entry.lower === pair.lower;
  const joined = document.joins.some(same);
  const relation = document.relations.find((entry) => same(entry) && !entry.range)?.relation ?? '';
  const setRelation = (value: string): void =>
    editor.edit('relation', relate(document, part.id, other.id, value === '' ? null : (value as RelationKind)));
  return (
    <li class="neighbour" onPointerEnter={() => editor.set({ hovered: other.id })} onPointerLeave={() => editor.set({ hovered: null })}>
      <span class="name" title={other.id}>{other.id}</span>
      <button type="button" class="chip" aria-pressed={joined} onClick={() => editor.edit('join', toggleJoin(document, part.id, other.id))}>
        {joined ? t('unjoin') : t('joinPair')}
      </button>
      <select aria-label={`${t('touches')}: ${other.id}`} value={relation} onChange={(event) => setRelation(event.currentTarget.value)}>
        <option value="">{t('relationDefault')}</option>
        <option value="equal">{t('relationEqual')}</option>
        <option value="joined">{t('relationJoined')}</option>
        <option value="above">{t('relationAbove')}</option>
        <option value="free">{t('relationFree')}</option>
      </select>
      {document.robin.some(same) && (
        <button type="button" class="chip" onClick={() => editor.edit('range', removeRanges(document, pair.upper, pair.lower))}>
          {t('clearRange')}
        </button>
      )}
    </li>
  );
}

/** Shows and changes the properties of the selected part. */
export function PartPanel({ editor }: { editor: Editor }) {
  const { history, selected } = useStore(editor);
  const { document } = history;
  const index = selected === null ? -1 : partIndex(document, selected);
  const part = document.parts[index];
  if (!part) return null;
  const [leanRight, leanDown] = part.lean ?? [0, 0];
  const set = (values: PartValues, gesture: string): void =>
    editor.edit(gesture, changePart(document, part.id, values), `${gesture} ${part.id}`);
  const paint = (color: string, drag: boolean): void =>
    editor.edit('color', colorPart(document, part.id, color), drag ? `color ${part.id}` : null);
  const rename = (name: string): void => {
    const renamed = renamePart(document, part.id, name);
    editor.edit('rename', renamed);
    if (renamed !== document) editor.select(name.trim());
  };
  return (
    <div class="card part-panel">
      <div class="row">
        <NameField key={part.id} label={t('rename')} name={part.id} most={60} rename={rename} />
        <button type="button" class="bare" title={`${t('nearer')} (Page Up)`} aria-label={t('nearer')} onClick={() => editor.edit('order', movePart(document, part.id, index + 1))}>
          <Icon name="up" />
        </button>
        <button type="button" class="bare" title={`${t('farther')} (Page Down)`} aria-label={t('farther')} onClick={() => editor.edit('order', movePart(document, part.id, index - 1))}>
          <Icon name="down" />
        </button>
        <button type="button" class="bare" title={`${t('remove')} (Delete)`} aria-label={t('remove')} onClick={() => editor.edit('remove', removePart(document, part.id))}>
          <Icon name="close" />
        </button>
      </div>
      {(part.color !== undefined || !document.drawing) && <ColorChoice label={t('color')} color={part.color ?? null} choose={paint} />}
      <Slider label={t('inflation')} value={part.c} min={0.25} max={8} step={0.05} onInput={(c) => set({ c }, 'c')} />
      <Slider label={t('depth')} value={Math.abs(part.d)} min={0.1} max={2.5} step={0.05} onInput={(d) => set({ d: Math.sign(part.d) * d }, 'd')} />
      <Slider label={t('profile')} value={part.flat ?? 0} min={0} max={1} step={0.05} onInput={(flat) => set({ flat }, 'profile')} />
      <Slider label={t('leanRight')} value={leanRight} min={-1} max={1} step={0.05} onInput={(x) => set({ lean: [x, leanDown] }, 'lean')} />
      <Slider label={t('leanDown')} value={leanDown} min={-1} max={1} step={0.05} onInput={(y) => set({ lean: [leanRight, y] }, 'lean')} />
      <label class="check">
        <input type="checkbox" checked={part.d < 0} onChange={() => set({ d: -part.d }, 'reverse')} /> {t('reverse')}
      </label>
      <h3>{t('touches')}</h3>
      <ul class="neighbours">
        {neighbours(document, part.id).map((other) => (
          <Neighbour key={other.id} editor={editor} part={part} other={other} />
        ))}
      </ul>
    </div>
  );
}
