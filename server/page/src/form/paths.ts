// Where numbers stand in a request: JSON pointers, as the inputs of an ensemble name them.

import type {Json, JsonObject} from '../types';
import {pointer_part} from './schema';

/** Parts of a request that may be uncertain. */
const parts = ['soil', 'trigger'];

function pointers(value: Json | undefined, at: string): string[] {
  if (typeof value === 'number') return [at];
  if (typeof value !== 'object' || value === null) return [];
  return Object.entries(value).flatMap(([name, one]) => pointers(one as Json, `${at}/${pointer_part(name)}`));
}

/** Pointers to the numbers of soil and trigger; what several materials have also as one, with a star. */
export function paths_to_numbers(inputs: JsonObject): string[] {
  const found = parts.flatMap((part) => pointers(inputs[part], `/${part}`));
  const of_all = found.map((path) => path.replace(/\/materials\/[^/]+\//, '/materials/*/'));
  const shared = of_all.filter((path, i) => path !== found[i] && of_all.indexOf(path) !== i);
  return [...new Set([...shared, ...found])];
}
