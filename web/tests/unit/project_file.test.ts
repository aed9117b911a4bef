import { strToU8, unzipSync, zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { emptyDocument, type Document } from '../../document/document';
import { addPart, changeSettings } from '../../document/editing';
import { ProjectError, readProject, writeProject } from '../../document/project_file';
import { randomNumbers } from './random';

function sample(): Document {
  const drawn = addPart(emptyDocument(), 'body', [[100, 100], [300, 100], [300.25, 220.5], [100, 220]]);
  const bytes = strToU8('<svg/>');
  const drawing = { name: 'a.svg', kind: 'svg' as const, mime: 'image/svg+xml', bytes };
  const paint = [{ color: '#e27d8a', width: 12, points: [[1, 2], [3.5, 4]] as const }, { color: null, width: 3, points: [[9, 9]] as const }];
  return { ...changeSettings(drawn, { rho: 0.3, sizeMm: 80, inkColor: '#204080', inkWidth: 2 }), name: 'figure', drawing, paint };
}

describe('a project', () => {
  it('reads back as it was, and writes the same bytes again', () => {
    const bytes = writeProject(sample(), new Uint8Array([1, 2, 3]));
    expect(readProject(bytes)).toEqual(sample());
    expect(writeProject(readProject(bytes), new Uint8Array([1, 2, 3]))).toEqual(bytes);
  });

  it('leaves out strokes of paint that are not valid', () => {
    const files = unzipSync(writeProject(sample(), null));
    const head = JSON.parse(new TextDecoder().decode(files['project.json'])) as { paint: object[] };
    const [sound] = head.paint;
    const broken = [{ ...sound, color: 'red' }, { ...sound, width: 0 }, { ...sound, points: [] }, { ...sound, points: [[1, null]] }, 7, null];
    const odd = zipSync({ ...files, 'project.json': strToU8(JSON.stringify({ ...head, paint: [sound, ...broken] })) });
    expect(readProject(odd).paint).toEqual([sound]);
    const none = zipSync({ ...files, 'project.json': strToU8(JSON.stringify({ ...head, paint: 'much' })) });
    expect(readProject(none).paint).toEqual([]);
  });

  it('begins with its uncompressed MIME type', () => {
    const text = new TextDecoder().decode(writeProject(sample(), null).slice(30, 60));
    expect(text).toMatch(/^mimetypeapplication/);
  });

  it('of a newer version is refused for that reason', () => {
    const files = unzipSync(writeProject(sample(), null));
    const head = JSON.parse(new TextDecoder().decode(files['project.json'])) as object;
    const newer = zipSync({ ...files, 'project.json': strToU8(JSON.stringify({ ...head, version: 99 })) });
    expect(() => readProject(newer)).toThrow('newerProject');
  });

  it('of an older version opens without removed settings, and with defaults for new ones', () => {
    const files = unzipSync(writeProject(sample(), null));
    const head = JSON.parse(new TextDecoder().decode(files['project.json'])) as { settings: object };
    const settings = { ...head.settings, literal: true, lambdaShift: undefined };
    const older = zipSync({ ...files, 'project.json': strToU8(JSON.stringify({ ...head, settings })) });
    expect(readProject(older)).toEqual(sample());
  });

  it('ignores all other entries of the archive', () => {
    const files = unzipSync(writeProject(sample(), null));
    const more = zipSync({ ...files, '../../evil.js': strToU8('x'), 'another/drawing': strToU8('x') });
    expect(readProject(more)).toEqual(sample());
  });

  it('that is damaged anywhere is either read or refused', () => {
    const whole = writeProject(sample(), null);
    const random = randomNumbers(7);
    for (let i = 0; i < 2000; i++) {
      const bytes = whole.slice(0, random() < 0.3 ? Math.floor(random() * whole.length) : whole.length);
      for (let k = 0; k < 3; k++) bytes[Math.floor(random() * bytes.length)] = Math.floor(random() * 256);
      try {
        readProject(bytes);
      } catch (error) {
        expect(error).toBeInstanceOf(ProjectError);
      }
    }
  });
});
