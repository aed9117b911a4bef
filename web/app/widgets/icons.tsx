import type { ToolName } from '../state/editor';

const paths = {
  select: 'M5 3l13 8-6 1.5L9 18z',
  draw: 'M4 20c1-4 2-6 11-15l4 4C10 18 8 19 4 20zM13 7l4 4',
  join: 'M5 6c0 7 5 5 5 12M19 6c0 7-5 5-5 12M4 12h16',
  order: 'M5 5h9v9H5zM10 14v5h9v-9h-5',
  range: 'M4 17c4-11 12-11 16 0M4 17h.01M20 17h.01',
  hand: 'M8 12V6a1.5 1.5 0 013 0v5V5a1.5 1.5 0 013 0v6V7a1.5 1.5 0 013 0v8c0 4-2 6-5 6-4 0-5-2-8-7 1.5-1.5 3 0 4 1',
  scribble: 'M4 8c3-5 6-4 5 0s-4 7-1 8 5-9 8-9 0 7-2 9 3 3 6 0',
  outline: 'M3 16c3-9 7-11 10-6s5 3 8-3M13 10m-2 0a2 2 0 104 0 2 2 0 10-4 0',
  cue: 'M3 18L12 6l9 12M12 6v12',
  paint: 'M9 15L20 4M9 15a3 3 0 00-4 2c0 2-1 3-2 3 3 1 7 0 7-3a3 3 0 00-1-2z',
  undo: 'M9 7L4 12l5 5M4 12h10a5 5 0 010 10h-2',
  redo: 'M15 7l5 5-5 5M20 12H10a5 5 0 000 10h2',
  close: 'M6 6l12 12M18 6L6 18',
  up: 'M12 19V5M6 11l6-6 6 6',
  down: 'M12 5v14M6 13l6 6 6-6',
} satisfies Record<ToolName, string> & Record<string, string>;

type IconName = keyof typeof paths;

export function Icon({ name }: { name: IconName }) {
  return (
    <svg class="icon" viewBox="0 0 24 24" aria-hidden="true">
      <path d={paths[name]} />
    </svg>
  );
}
