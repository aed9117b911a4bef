import { type Cue, type Document, type Join, type Part, type Relation, type RobinRange } from './document';

interface SceneFile {
  format: 'relievo-scene';
  version: 1;
  canvas: { width: number; height: number };
  drawing?: string;
  parts: Omit<Part, 'color'>[];
  joins?: Join[];
  relations?: Relation[];
  robin?: RobinRange[];
  cues?: Cue[];
}

/** Returns the text of a scene file (docs/scene.md) for the engine. The same document gives the same text. */
export function sceneText(document: Document, drawing?: string): string {
  const file: SceneFile = {
    format: 'relievo-scene',
    version: 1,
    canvas: { width: document.width, height: document.height },
    ...(drawing === undefined ? {} : { drawing }),
    parts: document.parts.map(({ id, outline, c, d, flat, lean }) => ({
      id, outline, c, d, ...(flat ? { flat } : {}), ...(lean?.some((slope) => slope !== 0) ? { lean } : {}),
    })),
    joins: [...document.joins],
    relations: [...document.relations],
    robin: [...document.robin],
    ...(document.cues.length > 0 ? { cues: [...document.cues] } : {}),
  };
  return JSON.stringify(file);
}

/** Reads the fields of a document that a scene file holds. Precondition: the engine wrote or accepted the text. */
export function sceneContent(
  text: string,
): Pick<Document, 'width' | 'height' | 'parts' | 'joins' | 'relations' | 'robin' | 'cues'> {
  const file = JSON.parse(text) as SceneFile;
  return {
    width: file.canvas.width,
    height: file.canvas.height,
    parts: file.parts.map((part) => ({ ...part, c: part.c ?? 4, d: part.d ?? 1 })),
    joins: file.joins ?? [],
    relations: file.relations ?? [],
    robin: file.robin ?? [],
    cues: file.cues ?? [],
  };
}
