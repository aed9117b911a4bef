import bunny from '../../../examples/bunny.svg?url';
import elephant from '../../../examples/elephant.svg?url';
import farmer from '../../../examples/farmer.svg?url';
import lamb from '../../../examples/lamb.svg?url';
import unicorn from '../../../examples/unicorn.svg?url';
import wolf from '../../../examples/wolf.svg?url';

const thumbnails = import.meta.glob<string>('../../thumbnails/*.webp', { eager: true, query: '?url', import: 'default' });

/** The sample drawings on the first screen. */
export const samples = [
  { name: 'wolf', url: wolf },
  { name: 'bunny', url: bunny },
  { name: 'unicorn', url: unicorn },
  { name: 'elephant', url: elephant },
  { name: 'farmer', url: farmer },
  { name: 'lamb', url: lamb },
] as const;

/** Returns the address of a picture of a sample's relief. */
export function thumbnailOf(name: string): string | undefined {
  return thumbnails[`../../thumbnails/${name}.webp`];
}
