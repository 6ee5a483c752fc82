// Numbers of a section that may be lower bounds, in words.

import {show, t} from '../words';

/** "at least 103.2 m" where the number is a bound. */
export function bounded(value: number | null, is: string | null, unit = 'm'): string {
  if (value === null) return '–';
  return `${is === 'lower-bound' ? `${t('at_least')} ` : ''}${show(value)} ${unit}`;
}

export interface Bounded {
  value: number | null;
  is: string | null;
}

/** Later minus first; a word why not where one of the two is a bound. */
export function difference_words(from: Bounded, to: Bounded, unit = 'm'): string {
  if (from.value === null || to.value === null) return '–';
  if (from.is === 'lower-bound' || to.is === 'lower-bound') return t('unknown_for_bound');
  const more = to.value - from.value;
  return `${more > 0 ? '+' : ''}${show(more)} ${unit}`;
}
