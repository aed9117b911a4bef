import { useState } from 'preact/hooks';
import { partIndex } from '../../document/document';
import { labelOfStroke } from '../../document/scribbling';
import { movePart } from '../../document/editing';
import { inkOf } from '../../view/colors';
import { t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import { useStore } from '../state/store';

/** Lists the parts, nearest first. Dragging or keys change the order. */
export function PartList({ editor }: { editor: Editor }) {
  const { history, selected, hovered, culprit, tool } = useStore(editor);
  const [dragged, setDragged] = useState<string | null>(null);
  const [target, setTarget] = useState<string | null>(null);
  const { document } = history;
  const list = [...document.parts].reverse();
  const ink = (part: string): string | undefined => {
    const label = tool === 'scribble' ? labelOfStroke(document, { part }) : undefined;
    return label === undefined ? undefined : inkOf(label);
  };

  const drop = (onto: string): void => {
    if (dragged) editor.edit('order', movePart(document, dragged, partIndex(document, onto)));
    setDragged(null);
    setTarget(null);
  };
  const step = (event: KeyboardEvent, index: number): void => {
    if (event.key === 'Enter') editor.select(list[index]?.id ?? null);
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    const next = by === undefined ? undefined : list[index + by];
    if (!next) return;
    event.preventDefault();
    editor.select(next.id);
    const item = (event.currentTarget as HTMLElement).parentElement?.children[index + (by ?? 0)];
    (item as HTMLElement | undefined)?.focus();
  };

  if (list.length === 0) return <p class="quiet">{t('noParts')}</p>;
  return (
    <ul class="parts" role="listbox" aria-label={t('parts')} title={t('partsHelp')}>
      {list.map((part, index) => (
        <li
          key={part.id}
          role="option"
          aria-selected={part.id === selected}
          tabIndex={part.id === selected || (selected === null && index === 0) ? 0 : -1}
          class={[
            part.id === hovered ? 'hovered' : '',
            part.id === culprit ? 'culprit' : '',
            part.id === target ? 'target' : '',
          ].join(' ')}
          draggable
          onDragStart={() => setDragged(part.id)}
          onDragOver={(event) => {
            event.preventDefault();
            setTarget(part.id);
          }}
          onDrop={() => drop(part.id)}
          onDragEnd={() => setTarget(null)}
          onClick={() => editor.select(part.id)}
          onPointerEnter={() => editor.set({ hovered: part.id })}
          onPointerLeave={() => editor.set({ hovered: null })}
          onKeyDown={(event) => step(event, index)}
        >
          <span class="number">{index + 1}</span>
          {ink(part.id) && <span class="dot" style={{ background: ink(part.id) }} />}
          <span class="name">{part.id}</span>
          {document.joins.some((join) => join.upper === part.id) && <span class="joined" title={t('join')} />}
          {part.d < 0 && <span class="hollow" title={t('reverse')} />}
        </li>
      ))}
    </ul>
  );
}
