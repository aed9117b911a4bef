import { useEffect, useState } from 'preact/hooks';
import { bledTexture, dressedSide, lookOf, sheetOf } from '../../view/painted_drawing';
import { t } from '../../words/catalogue';
import { whyOf } from '../control/exports';
import { dressedIn, type Editor } from '../state/editor';

/** The WebXR sessions that can show the model, in the order of preference: in the real room, then in a virtual one. */
const modes = ['immersive-ar', 'immersive-vr'] as const;

async function supportedMode(): Promise<XRSessionMode | null> {
  for (const mode of modes) if (await navigator.xr?.isSessionSupported(mode).catch(() => false)) return mode;
  return null;
}

/** Shows the model in the user's room. The button appears only if the browser and the device can do that. */
export function RoomButton({ editor }: { editor: Editor }) {
  const [mode, setMode] = useState<XRSessionMode | null>(null);
  useEffect(() => void supportedMode().then(setMode), []);
  const { relief, picture } = editor.state;
  if (!mode || !relief) return null;
  const enter = async (): Promise<void> => {
    try {
      // Browsers start such sessions only directly from a user's action, so this comes first.
      const session = await navigator.xr?.requestSession(mode);
      if (!session) return;
      const { document } = editor;
      const { showInRoom } = await import('../../view/room');
      const dressed = dressedIn(editor.state, lookOf(document, picture));
      const [surface, drawing] = dressed
        ? [dressed.surface, bledTexture(sheetOf(dressed), dressed.picture, dressedSide)]
        : [relief.surface, bledTexture(document, picture)];
      await showInRoom(session, { surface, drawing, sizeMm: document.settings.sizeMm });
    } catch (error) {
      editor.set({ notice: `${t('failed')}: ${whyOf(error)}` });
    }
  };
  return <button type="button" class="wide" id="room" onClick={() => void enter()}>{t('viewInRoom')}</button>;
}
