import { useState } from 'preact/hooks';

interface NameFieldProps {
  label: string;
  name: string;
  most: number;
  kind?: string;
  /** Another name, or one that is not taken: then the old one comes back. */
  rename(name: string): void;
}

/** A name that can be changed. What is being typed stays, whatever else on the page changes meanwhile. */
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
