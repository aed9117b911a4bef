import { useState } from 'preact/hooks';

interface NameFieldProps {
  label: string;
  name: string;
  most: number;
  kind?: string;
  /** May reject the name by not changing `name`: then the field shows the old name again. */
  rename(name: string): void;
}

/** A field for a name. It keeps what the user is typing when the rest of the page is drawn again. */
export function NameField({ label, name, most, kind = '', rename }: NameFieldProps) {
  const [typed, setTyped] = useState<string | null>(null);
  const settle = (wanted: string): void => {
    setTyped(null);
    rename(wanted);
  };
  return (
    <input
      class={`title ${kind}`} aria-label={label} value={typed ?? name} maxLength={most}
      onInput={(event) => setTyped(event.currentTarget.value)} onChange={(event) => settle(event.currentTarget.value)}
    />
  );
}
