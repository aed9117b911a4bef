import type { Document, Join } from '../../document/document';
import { addJoin } from '../../document/editing';
import { suggestedJoins } from '../../document/suggestions';
import { t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import { useStore } from '../state/store';

/** Joins two parts. The upper one takes the colour of the lower one, since they are one surface now. */
function joined(document: Document, join: Join): Document {
  const color = document.parts.find((part) => part.id === join.lower)?.color;
  const parts = color ? document.parts.map((part) => (part.id === join.upper ? { ...part, color } : part)) : document.parts;
  return addJoin({ ...document, parts }, join);
}

/** The bar of the drawing tool: draw behind all parts, add eyes, join the part that was just drawn. */
export function DrawBar({ editor }: { editor: Editor }) {
  const { tool, behind, eyes, history, selected } = useStore(editor);
  if (tool !== 'draw') return null;
  const { document, done } = history;
  const drawn = done.at(-1)?.label === 'draw' ? suggestedJoins(document).find((join) => join.upper === selected || join.lower === selected) : undefined;
  const other = drawn && (drawn.upper === selected ? drawn.lower : drawn.upper);
  return (
    <div class="scribble-bar draw-bar" role="group" aria-label={t('draw')}>
      <button type="button" id="behind" aria-pressed={behind} title={t('hintBehind')} onClick={() => editor.set({ behind: !behind })}>
        {t('behind')}
      </button>
      <button type="button" id="eyes" aria-pressed={eyes} title={t('hintEyes')} onClick={() => editor.set({ eyes: !eyes })}>
        {t('eyes')}
      </button>
      {drawn && other !== undefined && (
        <button type="button" class="primary" id="join-offer" onClick={() => editor.edit('join', joined(document, drawn))}>
          {t('joinOffer', { name: other })}
        </button>
      )}
    </div>
  );
}
