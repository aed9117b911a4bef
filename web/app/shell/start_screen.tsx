import { useEffect, useState } from 'preact/hooks';
import type { Entry } from '../../document/shelf';
import { chooseLanguage, type Language, language, languages, speak, t } from '../../words/catalogue';
import type { FileControl } from '../control/file_control';
import { Icon } from '../widgets/icons';
import type { Keeper } from '../control/keeper';
import { samples, thumbnailOf } from './samples';
import { isTourOffered, TourOffer } from './tour';

interface StartScreenProps {
  files: FileControl;
  keeper: Keeper;
  choose(): void;
}

/** Returns an address for a picture in memory, valid while the component is shown. */
function usePicture(bytes: Uint8Array | undefined): string | undefined {
  const [url, setUrl] = useState<string>();
  useEffect(() => {
    if (!bytes) return undefined;
    const made = URL.createObjectURL(new Blob([bytes as Uint8Array<ArrayBuffer>], { type: 'image/png' }));
    setUrl(made);
    return () => URL.revokeObjectURL(made);
  }, [bytes]);
  return url;
}

function Card({ entry, open, remove }: { entry: Entry; open(): void; remove(): void }) {
  const url = usePicture(entry.thumbnail);
  const time = new Date(entry.time).toLocaleString(language, { dateStyle: 'medium', timeStyle: 'short' });
  return (
    <li>
      <button type="button" data-kept={entry.id} title={time} onClick={open}>
        {url ? <img src={url} alt="" width={150} height={120} /> : <span class="blank" />}
        <span class="name">{entry.name}</span>
        <span class="quiet small-print">{t('versionCount', { all: entry.versions.length })}</span>
      </button>
      <button type="button" class="bare throw-away" aria-label={t('removeDocument', { name: entry.name })} title={t('removeDocument', { name: entry.name })} onClick={remove}>
        <Icon name="close" />
      </button>
    </li>
  );
}

/** Lists all saved documents, the last changed first. */
function KeptDocuments({ entries, files, keeper, changed }: { entries: Entry[]; files: FileControl; keeper: Keeper; changed(): void }) {
  const [removed, setRemoved] = useState<Entry | null>(null);
  const remove = (entry: Entry): void => {
    setRemoved(entry);
    void keeper.remove(entry.id).then(changed);
  };
  const bringBack = ({ id }: Entry): void => {
    setRemoved(null);
    void keeper.bringBack(id).then(changed);
  };
  return (
    <>
      {entries.length > 0 && <h2>{t('shelf')}</h2>}
      <ul class="samples kept">
        {entries.map((entry) => (
          <Card key={entry.id} entry={entry} open={() => void files.openKept(entry.id)} remove={() => remove(entry)} />
        ))}
      </ul>
      {removed && (
        <p role="status">
          {t('removed', { name: removed.name })} <button type="button" id="bring-back" onClick={() => bringBack(removed)}>{t('bringBack')}</button>
        </p>
      )}
    </>
  );
}

function LanguageChoice({ changed }: { changed(): void }) {
  const choose = (name: Language): void => {
    chooseLanguage(name);
    void speak(name).then(changed);
  };
  return (
    <nav class="languages" aria-label={t('language')}>
      {(Object.keys(languages) as Language[]).map((name) => (
        <button key={name} type="button" class="bare" lang={name} aria-pressed={name === language} onClick={() => choose(name)}>
          {languages[name]}
        </button>
      ))}
    </nav>
  );
}

/** The first screen: saved drawings, samples, and ways to open or start a drawing. */
export function StartScreen({ files, keeper, choose }: StartScreenProps) {
  const [entries, setEntries] = useState<Entry[] | null>(null);
  const [, setSpoken] = useState(language);
  const [offersTour, setOffersTour] = useState(!isTourOffered());
  const look = (): void => void keeper.list().then(setEntries);
  useEffect(look, []);
  if (!entries) return null;
  const [newest] = entries;
  return (
    <main class="start">
      <h1>{t('title')}</h1>
      <p class="tagline">{t('tagline')}</p>
      <div class="choices">
        {newest && (
          <button type="button" class="primary" id="go-on" onClick={() => void files.openKept(newest.id)}>
            {t('goOn', { name: newest.name })}
          </button>
        )}
        <button type="button" class={newest ? '' : 'primary'} id="choose" onClick={choose}>
          {t('openFile')}
        </button>
        <button type="button" id="empty" onClick={() => void files.openEmpty()}>
          {t('emptyPage')}
        </button>
      </div>
      <p class="quiet">{t('dropHint')}</p>
      {offersTour && <TourOffer files={files} close={() => setOffersTour(false)} />}
      <KeptDocuments entries={entries} files={files} keeper={keeper} changed={look} />
      <h2>{t('samples')}</h2>
      <ul class="samples">
        {samples.map(({ name, url }) => (
          <li key={name}>
            <button type="button" data-sample={name} onClick={() => void files.openSample(name, url)}>
              <img src={thumbnailOf(name)} alt="" width={160} height={128} />
              <span>{t(name)}</span>
            </button>
          </li>
        ))}
      </ul>
      <LanguageChoice changed={() => setSpoken(language)} />
    </main>
  );
}
