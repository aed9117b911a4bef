import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { unzipSync } from 'fflate';
import { beforeAll, describe, expect, it } from 'vitest';
import { type Document, emptyDocument, type Point } from '../../document/document';
import { noteCorrections } from '../../document/corrections';
import { addJoin, addPart, bringBefore, changePart, joinParts, removeJoin, removePart, renamePart } from '../../document/editing';
import { readProject, writeProject } from '../../document/project_file';
import { sceneText } from '../../document/scene_text';
import { addStroke, adopt, clearStrokes, partOfStroke, questionOf, segmentationOf } from '../../document/scribbling';
import { isFailure } from '../../engine/messages';
import type { ReliefService } from '../../engine/relief_service';
import { relievo, root, temporaryFolder } from '../support/command_line';
import { pngOf } from '../support/pictures';
import { must, network, shown, startService, usual, usualFile } from './service';

const bear = readFileSync(join(root, 'examples/bear.png'));

const temporary = temporaryFolder();

let service: ReliefService;

beforeAll(async () => {
  service = await startService();
  must(service.openDrawing({ png: bear }, network));
});

function blank(): Document {
  const drawing = { name: 'bear.png', kind: 'image' as const, mime: 'image/png', bytes: new Uint8Array(bear) };
  return { ...emptyDocument(), name: 'bear', width: 900, height: 1000, drawing };
}

function understood(document: Document): Document {
  return adopt(document, must(service.understand(questionOf(document))));
}

/** Returns a stroke as the scribble tool makes it. */
function scribbled(document: Document, ...points: Point[]): Document {
  const part = partOfStroke(document, points, 10);
  return understood(addStroke(document, { kind: 'hard', part, width: 10, points }));
}

function edited(document: Document, next: Document): Document {
  return noteCorrections(document, next);
}

/** Returns the segmentation that the command line proposes for the drawing. */
function native(...more: string[]): Buffer {
  const file = join(mkdtempSync(join(temporary, 'case-')), 'bear.relievo');
  relievo('segment', join(root, 'examples/bear.png'), '-q', ...more, '-o', file);
  return readFileSync(file);
}

describe('a flat drawing', () => {
  it('is segmented exactly as by the command line', () => {
    const own = understood(blank());
    const theirs = readProject(native());
    expect(own.parts).toEqual(theirs.parts);
    expect(own.joins).toEqual(theirs.joins);
    expect(own.robin).toEqual(theirs.robin);
    expect(Buffer.from(own.segmentation!.labels).equals(Buffer.from(theirs.segmentation!.labels))).toBe(true);
    const arrows = (document: Document): unknown[] =>
      document.segmentation!.order.map(({ confidence, ...arrow }) => ({ ...arrow, confidence: confidence.toFixed(12) }));
    expect(arrows(own)).toEqual(arrows(theirs));
  });

  it.each([false, true])('is scribbled on as by the command line, strokes complete: %s', (complete) => {
    const one = scribbled(blank(), [450, 700], [470, 760]);
    const two = scribbled(one, [380, 650], [370, 700]);
    const scribbles = complete ? { ...two.segmentation!.scribbles, complete } : one.segmentation!.scribbles;
    const file = join(mkdtempSync(join(temporary, 'case-')), 'strokes.json');
    writeFileSync(file, JSON.stringify({ format: 'relievo-scribbles', version: 1, ...scribbles, complete }));
    const theirs = readProject(native('--scribbles', file));
    const own = understood({ ...blank(), segmentation: { ...segmentationOf(blank()), scribbles } });
    const shapes = (document: Document): unknown[] => document.parts.map(({ outline }) => outline);
    expect(shapes(own)).toEqual(shapes(theirs));
    expect(theirs.segmentation!.scribbles).toEqual(scribbles);
    expect(own.segmentation!.scribbles).toEqual(scribbles);
    if (complete) expect(own.parts.length).toBe(2);
  });

  it('is segmented on coloured paper in uneven light exactly as by the command line', () => {
    const [width, height] = [400, 300];
    const snowman = (x: number, y: number): readonly number[] => {
      if (Math.hypot(x - 200, y - 100) < 50) return [240, 210, 80];
      return Math.hypot(x - 200, y - 200) < 75 ? [230, 235, 245] : [100, 114, 97];
    };
    const png = pngOf(width, height, (x, y) => {
      const light = 1 - (0.3 * (x + y)) / (width + height);
      const grain = ((x * 7919 + y * 104729 + x * y * 31) % 13) - 6;
      const [red, green, blue] = snowman(x, y).map((value) => Math.round(value * light + grain));
      return [red!, green!, blue!, 255];
    });
    const folder = mkdtempSync(join(temporary, 'case-'));
    writeFileSync(join(folder, 'snowman.png'), png);
    relievo('segment', join(folder, 'snowman.png'), '-q', '-o', join(folder, 'snowman.relievo'));
    const theirs = readProject(readFileSync(join(folder, 'snowman.relievo')));
    must(service.openDrawing({ png }, network));
    const drawing = { name: 'snowman.png', kind: 'image' as const, mime: 'image/png', bytes: png };
    const own = understood({ ...emptyDocument(), name: 'snowman', width, height, drawing });
    expect(own.parts).toEqual(theirs.parts);
    expect(Buffer.from(own.segmentation!.labels).equals(Buffer.from(theirs.segmentation!.labels))).toBe(true);
    must(service.openDrawing({ png: bear }, network));
  });

  it('is segmented within a mask and under strokes exactly as by the command line', () => {
    const folder = mkdtempSync(join(temporary, 'case-'));
    const [mask, strokes] = [join(folder, 'mask.png'), join(folder, 'strokes.json')];
    writeFileSync(mask, pngOf(900, 1000, (_, y) => (y < 660 ? [255, 255, 255, 255] : [0, 0, 0, 255])));
    const { scribbles } = scribbled(blank(), [450, 560], [470, 600]).segmentation!;
    writeFileSync(strokes, JSON.stringify({ format: 'relievo-scribbles', version: 1, ...scribbles, complete: false }));
    for (const more of [[], ['--scribbles', strokes]]) {
      const theirs = readProject(native('--figure', mask, ...more));
      must(service.openDrawing({ png: theirs.drawing!.bytes }, network));
      const said = more.length > 0 ? { segmentation: { ...segmentationOf(blank()), scribbles } } : {};
      const own = understood({ ...blank(), ...said });
      expect(own.parts).toEqual(theirs.parts);
      expect(own.joins).toEqual(theirs.joins);
      expect(Buffer.from(own.segmentation!.labels).equals(Buffer.from(theirs.segmentation!.labels))).toBe(true);
    }
    must(service.openDrawing({ png: bear }, network));
  });

  it('is one part under one stroke, and two under two', () => {
    const guessed = understood(blank());
    const body = scribbled(guessed, [450, 700], [470, 760]);
    expect(body.parts.length).toBeLessThanOrEqual(guessed.parts.length + 1);
    const both = scribbled(body, [380, 650], [370, 700]);
    expect(both.parts.length).toBeGreaterThan(body.parts.length);
    const merged = scribbled(guessed, [420, 640], [340, 860]);
    expect(merged.parts.length).toBe(guessed.parts.length - 1);
    const [stroke] = both.segmentation!.scribbles.strokes;
    const without = understood(clearStrokes(both, { part: both.segmentation!.scribbles.parts[1]! }));
    expect(without.segmentation!.scribbles.strokes).toEqual([stroke]);
    expect(without.parts).toEqual(body.parts);
  });

  it('keeps the corrections of its parts through more strokes', () => {
    const guessed = understood(blank());
    const [back, second, third] = guessed.parts.map((part) => part.id) as [string, string, string];
    let document = edited(guessed, changePart(guessed, back, { c: 1.25, d: -0.5 }));
    document = edited(document, renamePart(document, second, 'Pfote'));
    document = edited(document, bringBefore(document, back, third));
    const gone = document.parts[document.parts.length - 1]!.id;
    document = edited(document, removePart(document, gone));
    const after = scribbled(document, [450, 700], [470, 760]);
    const ids = after.parts.map((part) => part.id);
    expect(after.parts.find((part) => part.id === back)).toMatchObject({ c: 1.25, d: -0.5 });
    expect(ids).toContain('Pfote');
    expect(ids.indexOf(back)).toBeGreaterThan(ids.indexOf(third));
    expect(ids).not.toContain(gone);
    const again = scribbled(after, [450, 300], [400, 250]);
    expect(again.parts.find((part) => part.id === back)).toMatchObject({ c: 1.25, d: -0.5 });
    expect(again.parts.map((part) => part.id)).not.toContain(gone);
  });

  it('keeps joins that the user made, moved or removed, and parts drawn by hand', () => {
    const guessed = understood(blank());
    const { upper, lower, line } = guessed.joins[0]!;
    const separate = edited(guessed, removeJoin(guessed, upper, lower));
    const drawn = edited(separate, addPart(separate, 'hat', [[380, 60], [520, 60], [450, 140]]));
    const joined = edited(drawn, joinParts(drawn, 'hat', drawn.parts[drawn.parts.length - 2]!.id));
    const after = scribbled(joined, [450, 700], [470, 760]);
    expect(after.joins.some((join) => join.upper === upper && join.lower === lower)).toBe(false);
    expect(after.parts.find((part) => part.id === 'hat')).toEqual(drawn.parts.find((part) => part.id === 'hat'));
    const clashing = edited(guessed, addPart(guessed, 'part-99', [[380, 60], [520, 60], [450, 140]]));
    const again = { ...clashing, segmentation: { ...segmentationOf(clashing), parts: [{ label: 98, id: 'lost', completion: 'whole' }] } };
    const ids = scribbled(again, [450, 700], [470, 760]).parts.map((part) => part.id);
    expect(ids).toContain('part-99');
    expect(new Set(ids).size).toBe(ids.length);
    const shifted = edited(guessed, addJoin(guessed, { upper, lower, line: line.slice(2, -2) }));
    const moved = scribbled(shifted, [450, 700], [470, 760]);
    expect(moved.joins.find((join) => join.upper === upper && join.lower === lower)?.line).toEqual(line.slice(2, -2));
  });
});

/** Paints a black line of this width through the points on white paper. */
function inked(width: number, height: number, pen: number, lines: Point[][]) {
  const rgba = new Uint8Array(4 * width * height).fill(255);
  for (const line of lines)
    for (let i = 0; i + 1 < line.length; i++) {
      const [[ax, ay], [bx, by]] = [line[i]!, line[i + 1]!];
      const steps = Math.ceil(Math.hypot(bx - ax, by - ay));
      for (let k = 0; k <= steps; k++)
        for (let dy = 0; dy < pen; dy++)
          for (let dx = 0; dx < pen; dx++) {
            const x = Math.round(ax + ((bx - ax) * k) / steps) + dx;
            const y = Math.round(ay + ((by - ay) * k) / steps) + dy;
            rgba.fill(20, 4 * (y * width + x), 4 * (y * width + x) + 3);
          }
    }
  return { rgba, width, height };
}

function width(outline: Document['parts'][number]['outline']): number {
  const across = outline.flat().map(([x]) => x);
  return Math.max(...across) - Math.min(...across);
}

it('accepts strokes where there are lines alone', () => {
  const ruled = Array.from({ length: 9 }, (_, i): Point[] => [[60 + 40 * i, 0], [60 + 40 * i, 396]]);
  must(service.openDrawing({ pixels: inked(440, 400, 4, ruled) }, network));
  const paper: Document = { ...blank(), width: 440, height: 400 };
  const points: Point[] = [[75, 100], [75, 300]];
  const first = addStroke(paper, { kind: 'hard', part: partOfStroke(paper, points, 5), width: 12, points });
  const found = understood(addStroke(first, { kind: 'outside', width: 12, points: [[20, 20], [420, 20]] }));
  // Ink without strokes remains as separate parts, except for narrow pieces.
  const widest = Math.max(...found.parts.filter(({ id }) => id !== 'part-1').map(({ outline }) => width(outline)));
  expect(found.parts.map((part) => part.id)).toContain('part-1');
  expect(widest).toBeLessThan(8);
  must(service.openDrawing({ png: bear }, network));
});

describe('a project of a flat drawing', () => {
  it('opens, is edited and saved without losing anything', () => {
    const bytes = native();
    const opened = readProject(bytes);
    expect(isFailure(service.checkSegmentation(questionOf(opened)))).toBe(false);
    const saved = unzipSync(writeProject(opened, null));
    const came = unzipSync(bytes);
    for (const name of ['drawing', 'labels.png'])
      expect(Buffer.from(saved[name]!).equals(Buffer.from(came[name]!))).toBe(true);
    const record = (files: typeof came): unknown =>
      (JSON.parse(Buffer.from(files['project.json']!).toString()) as { segmentation: unknown }).segmentation;
    expect(record(saved)).toEqual(record(came));
    expect(readProject(writeProject(opened, null))).toEqual(opened);
  });

  it('is built by the command line as in the editor, and can be segmented again there', () => {
    let document = scribbled(readProject(native()), [380, 650], [370, 700]);
    document = edited(document, changePart(document, document.parts[1]!.id, { c: 3.5, flat: 0.7 }));
    const folder = mkdtempSync(join(temporary, 'case-'));
    const [file, model, anew] = ['a.relievo', 'a.glb', 'b.relievo'].map((name) => join(folder, name)) as [string, string, string];
    writeFileSync(file, writeProject(document, null));
    relievo('build', file, '-q', '--vertices', '20000', '-o', model, '-o', join(folder, 'a.stl'));
    must(service.build({ scene: sceneText(document), options: usual, ...shown }, () => undefined));
    const [stl] = must(service.encode('stl', 'a', usualFile, null)).files;
    expect(Buffer.from(stl!.bytes).equals(readFileSync(join(folder, 'a.stl')))).toBe(true);
    relievo('segment', file, '-q', '-o', anew);
    const proposed = readProject(readFileSync(anew));
    const said = ({ parts }: Document): unknown => parts.map(({ id, c, flat = 0 }) => ({ id, c, flat }));
    expect(said(proposed)).toEqual(said(document));
    expect(proposed.segmentation!.scribbles).toEqual(document.segmentation!.scribbles);
  });

  it('is refused with the key that is wrong if its segmentation is not valid', () => {
    const { project, labels } = questionOf(understood(blank()));
    const broken: Record<string, string> = {
      'segmentation.scribbles.surprise': project.replace('"scribbles":{', '"scribbles":{"surprise":1,'),
      'segmentation.parts[0].label': project.replace('"label":', '"label":-'),
      'segmentation.corrections.robin': project.replace('"robin":[]', '"robin":"<script>"'),
    };
    for (const [where, text] of Object.entries(broken)) {
      const checked = service.checkSegmentation({ project: text, labels });
      expect(isFailure(checked) && checked.error.where).toContain(where);
    }
    const damaged = service.checkSegmentation({ project, labels: labels.slice(0, 100) });
    expect(isFailure(damaged) && damaged.error.where).toContain('labels.png');
  });
});
