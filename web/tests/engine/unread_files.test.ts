import { beforeAll, expect, it } from 'vitest';
import type { ReliefService } from '../../engine/relief_service';
import { startService } from './service';

let service: ReliefService;
beforeAll(async () => {
  service = await startService();
});

it('says what a file of another program is, and nothing of others', () => {
  const told = (text: string): string | undefined => service.unreadFile(Buffer.from(text, 'latin1'))?.remedy;
  expect(told('gimp xcf v011\0')).toContain('OpenRaster');
  expect(told('%PDF-1.7')).toContain('SVG');
  expect(told('<svg/>')).toBeUndefined();
  expect(told('\x01\x02')).toBeUndefined();
});
