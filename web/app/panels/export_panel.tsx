import { useState } from 'preact/hooks';
import type { ExportFormat, MapKind } from '../../engine/messages';
import { type MessageKey, t } from '../../words/catalogue';
import type { Editor } from '../state/editor';
import type { Exports } from '../control/exports';
import { LitMaps } from './lit_maps';
import { RoomButton } from './room_button';
import { SizeField } from '../widgets/size_field';
import { useStore } from '../state/store';

const formats: readonly [ExportFormat, MessageKey][] = [
  ['glb', 'formatGlb'], ['obj', 'formatObj'], ['ply', 'formatPly'], ['stl', 'formatStl'],
  ['usdz', 'formatUsdz'], ['html', 'formatHtml'],
];
const maps: readonly [MapKind, MessageKey][] = [
  ['normal', 'mapNormal'], ['depth', 'mapDepth'], ['part', 'mapPart'],
];

interface ExportPanelProps {
  editor: Editor;
  exports: Exports;
  picture(): Promise<Blob>;
  turntable(): Promise<Uint8Array<ArrayBuffer>>;
}

/** Offers all files that can be exported. */
export function ExportPanel({ editor, exports, picture, turntable }: ExportPanelProps) {
  const { relief, history } = useStore(editor);
  const [greenDown, setGreenDown] = useState(false);
  return (
    <div class="sheet" role="group" aria-label={t('exportTitle')}>
      <SizeField editor={editor} />
      <button type="button" class="wide primary" id="print" onClick={() => editor.set({ panel: 'print', pane: 'model' })}>{t('printOpen')}</button>
      <h3>{t('exportModels')}</h3>
      {formats.map(([format, label]) => (
        <button type="button" class="wide" key={format} data-export={format} onClick={() => void exports.model(format)}>
          {t(label)}
        </button>
      ))}
      <h3>{t('exportMaps')}</h3>
      {maps.map(([kind, label]) => (
        <button type="button" class="wide" key={kind} data-export={kind} onClick={() => void exports.map(kind, greenDown)}>
          {t(label)}
        </button>
      ))}
      <label class="check">
        <input type="checkbox" checked={greenDown} onChange={() => setGreenDown(!greenDown)} /> {t('greenDown')}
      </label>
      <LitMaps exports={exports} relief={relief} />
      <h3>{t('exportPaint')}</h3>
      <button type="button" class="wide" data-export="psd" disabled={history.document.parts.length === 0} onClick={() => void exports.layers()}>
        {t('formatPsd')}
      </button>
      <h3>{t('exportViews')}</h3>
      <button type="button" class="wide" data-export="picture" onClick={() => void exports.picture(picture())}>
        {t('exportPicture')}
      </button>
      <RoomButton editor={editor} />
      <button type="button" class="wide" data-export="turntable" onClick={() => void exports.turntable(turntable)}>
        {t('exportTurntable')}
      </button>
    </div>
  );
}
