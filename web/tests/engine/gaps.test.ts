import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeAll, describe, expect, it } from 'vitest';
import { type Document, emptyDocument, type Point } from '../../document/document';
import { type Gap, keepGap, openGap, openQuestions } from '../../document/gaps';
import { readProject, writeProject } from '../../document/project_file';
import { adopt, questionOf } from '../../document/scribbling';
import type { ReliefService } from '../../engine/relief_service';
import { relievo, temporaryFolder } from '../support/command_line';
import { openRing, openRingSize } from '../support/pictures';
import { must, network, startService } from './service';

const [width, height] = openRingSize;
const png = openRing();

const temporary = temporaryFolder();

let service: ReliefService;
beforeAll(async () => {
  service = await startService();
  must(service.openDrawing({ png }, network));
});

function understood(document: Document): Document {
  return adopt(document, must(service.understand(questionOf(document))));
}

function guessed(): Document {
  return understood({ ...emptyDocument(), name: 'ring', width, height, drawing: { name: 'ring.png', kind: 'image', mime: 'image/png', bytes: png } });
}

function gapsOf(document: Document): readonly Gap[] {
  const gaps = must(service.label(questionOf(document))).bridges.map(({ points, left, right }) => ({
    points: Array.from({ length: points.length / 2 }, (_, i): Point => [points[2 * i]!, points[2 * i + 1]!]), left, right,
  }));
  return openQuestions(document, gaps);
}

/** Returns the segmentation that the command line proposes for the saved project. */
function native(document: Document): Document {
  const [saved, again] = ['saved.relievo', 'again.relievo'].map((name) => join(mkdtempSync(join(temporary, 'case-')), name));
  writeFileSync(saved!, writeProject(document, null));
  relievo('segment', saved!, '-q', '-o', again!);
  return readProject(new Uint8Array(readFileSync(again!)));
}

describe('a gap in a line', () => {
  it('is found, with the part to its right', () => {
    const document = guessed();
    const gaps = gapsOf(document);
    expect([document.parts.length, gaps.length]).toEqual([2, 1]);
    for (const [x, y] of gaps[0]!.points) expect(Math.hypot(x - 370, y - 160)).toBeLessThan(24);
    expect(gaps[0]!.left).toBe(0);
  });

  it('that is opened joins its area to the background, for the command line too', () => {
    const document = guessed();
    const opened = understood(openGap(document, gapsOf(document)[0]!));
    expect(opened.parts.map((part) => part.id)).toEqual([document.parts.find((part) => Math.abs(part.outline[0]![0]![0] - 140) < 120)!.id]);
    expect(gapsOf(opened)).toEqual([]);
    expect(native(opened).parts).toEqual(opened.parts);
  });

  it('that is kept closed changes no part and is no longer asked about', () => {
    const document = guessed();
    const kept = understood(keepGap(document, gapsOf(document)[0]!));
    expect(kept.parts.map((part) => part.id)).toEqual(document.parts.map((part) => part.id));
    expect(kept.segmentation!.labels).toEqual(document.segmentation!.labels);
    expect(gapsOf(kept)).toEqual([]);
    expect(native(kept).parts).toEqual(kept.parts);
  });
});
