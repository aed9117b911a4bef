import { useState } from 'preact/hooks';
import type { ExportFormat, MapKind } from '../engine/messages';
import { type MessageKey, t } from './catalogue';
import type { Editor } from './editor';
import type { Files } from './files';
import { LitMaps } from './lit_maps';
import { RoomButton } from './room_button';
import { SizeField } from './size_field';
import { useStore } from './store';

const formats: readonly [ExportFormat, MessageKey][] = [
  ['glb', 'formatGlb'], ['obj', 'formatObj'], ['ply', 'formatPly'], ['stl', 'formatStl'],
  ['usdz', 'formatUsdz'], ['html', 'formatHtml'],
];
const maps: readonly [MapKind, MessageKey][] = [
  ['normal', 'mapNormal'], ['depth', 'mapDepth'], ['part', 'mapPart'],
];

interface ExportPanelProps {
  editor: Editor;
  files: Files;
  picture(): Promise<Blob>;
  turntable(): Promise<Uint8Array<ArrayBuffer>>;
}

export function ExportPanel({ editor, files, picture, turntable }: ExportPanelProps) {
  const { relief } = useStore(editor);
  const [greenDown, setGreenDown] = useState(false);
  return (
    <div class="sheet" role="group" aria-label={t('exportTitle')}>
      <SizeField editor={editor} />
      <button type="button" class="wide primary" id="print" onClick={() => editor.set({ panel: 'print', pane: 'model' })}>{t('printOpen')}</button>
      <h3>{t('exportModels')}</h3>
      {formats.map(([format, label]) => (
        <button type="button" class="wide" key={format} data-export={format} onClick={() => void files.exportModel(format)}>
          {t(label)}
        </button>
      ))}
      <h3>{t('exportMaps')}</h3>
      {maps.map(([kind, label]) => (
        <button type="button" class="wide" key={kind} data-export={kind} onClick={() => void files.exportMap(kind, greenDown)}>
          {t(label)}
        </button>
      ))}
      <label class="check">
        <input type="checkbox" checked={greenDown} onChange={() => setGreenDown(!greenDown)} /> {t('greenDown')}
      </label>
      <LitMaps files={files} relief={relief} />
      <h3>{t('exportViews')}</h3>
      <button type="button" class="wide" data-export="picture" onClick={() => void files.exportPicture(picture())}>
        {t('exportPicture')}
      </button>
      <RoomButton editor={editor} />
      <button type="button" class="wide" data-export="turntable" onClick={() => void files.exportTurntable(turntable)}>
        {t('exportTurntable')}
      </button>
    </div>
  );
}
