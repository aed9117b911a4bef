// What a program in TypeScript may say, and what it may not.
import { type Relief, type Report, load } from 'relievo';

const relievo = await load();
const relief: Relief = relievo.build('{}', { method: 'nonlinear', vertices: 500 });
const report: Report = relief.report;
const bytes: Uint8Array = relief.map('depth', 64);
export const sizes: number = report.faces + bytes.length + relief.solid({ ring: 4 }).volume;
// @ts-expect-error there is no such option
relief.rebuild('{}', { vertexes: 5 });
// @ts-expect-error nor such a format
relief.encode('fbx', 'wolf');
