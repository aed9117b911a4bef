import { type Document, emptyDocument } from '../document/document';
import { t } from './catalogue';
import type { Files } from './files';
import { samples } from './samples';

interface StartScreenProps {
  files: Files;
  /** What was kept of the last visit. */
  kept: Document | null;
  choose(): void;
}

export function StartScreen({ files, kept, choose }: StartScreenProps) {
  return (
    <main class="start">
      <h1>{t('title')}</h1>
      <p class="tagline">{t('tagline')}</p>
      <div class="choices">
        {kept && (
          <button type="button" class="primary" id="go-on" onClick={() => void files.show(kept)}>
            {t('goOn', { name: kept.name })}
          </button>
        )}
        <button type="button" class={kept ? '' : 'primary'} id="choose" onClick={choose}>
          {t('openFile')}
        </button>
        <button type="button" id="empty" onClick={() => void files.show(emptyDocument())}>
          {t('emptyPage')}
        </button>
      </div>
      <p class="quiet">{t('dropHint')}</p>
      <h2>{t('samples')}</h2>
      <ul class="samples">
        {samples.map(({ name, url }) => (
          <li key={name}>
            <button type="button" data-sample={name} onClick={() => void files.openSample(name, url)}>
              <img src={url} alt="" width={150} height={120} />
              <span>{name}</span>
            </button>
          </li>
        ))}
      </ul>
    </main>
  );
}
