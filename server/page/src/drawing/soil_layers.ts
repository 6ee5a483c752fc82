// The layers of a soil model on a profile, as the server places them.

import type {JsonObject, XY} from '../types';
import type {Layer} from './profile_svg';

function number(value: unknown): number | null {
  return typeof value === 'number' && Number.isFinite(value) ? value : null;
}

/** Bottoms from the first layer to the base; a layer that states none yet ends the list. */
export function layers_on(profile: readonly XY[], toe_z: number, soil: JsonObject): Layer[] {
  const list = Array.isArray(soil.layers) ? (soil.layers as JsonObject[]) : [];
  const below = number(soil.base_below_toe_m);
  const base = number(soil.base_m) ?? (below === null ? null : toe_z - below);
  const layers: Layer[] = [];
  let top: XY[] = [...profile];
  for (const [i, layer] of list.entries()) {
    const last = i === list.length - 1;
    const thickness = number(layer.thickness_m);
    const below_toe = number(layer.bottom_below_toe_m);
    const level = last ? base : number(layer.bottom_m) ?? (below_toe === null ? null : toe_z - below_toe);
    let bottom: XY[];
    if (thickness !== null && !last) bottom = profile.map(([x, z]) => [x, z - thickness]);
    else if (level !== null) bottom = profile.map(([x]) => [x, level]);
    else break;
    // A layer ends nowhere above the one over it.
    bottom = bottom.map(([x, z], at) => [x, Math.min(z, top[at]![1])]);
    layers.push({name: String(layer.material ?? ''), bottom});
    top = bottom;
  }
  return layers;
}
