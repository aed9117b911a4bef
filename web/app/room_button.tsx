import { useEffect, useState } from 'preact/hooks';
import { bledTexture } from '../view/painted_drawing';
import { t } from './catalogue';
import type { Editor } from './editor';

/** The kinds of sessions that show a room, the real one first. */
const modes = ['immersive-ar', 'immersive-vr'] as const;

async function supportedMode(): Promise<XRSessionMode | null> {
  for (const mode of modes) if (await navigator.xr?.isSessionSupported(mode).catch(() => false)) return mode;
  return null;
}

/** Leads into the room, where the browser and the device can. */
export function RoomButton({ editor }: { editor: Editor }) {
  const [mode, setMode] = useState<XRSessionMode | null>(null);
  useEffect(() => void supportedMode().then(setMode), []);
  const { relief, picture } = editor.state;
  if (!mode || !relief) return null;
  const enter = async (): Promise<void> => {
    try {
      // At once: browsers begin such sessions only from a deed of a person.
      const session = await navigator.xr?.requestSession(mode);
      if (!session) return;
      const { document } = editor;
      const { showInRoom } = await import('../view/room');
      await showInRoom(session, { surface: relief.surface, drawing: bledTexture(document, picture), sizeMm: document.settings.sizeMm });
    } catch (error) {
      editor.set({ notice: `${t('failed')}: ${error instanceof Error ? error.message : String(error)}` });
    }
  };
  return <button type="button" class="wide" id="room" onClick={() => void enter()}>{t('viewInRoom')}</button>;
}
