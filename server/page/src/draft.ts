// The request that is being made, and the document of it that the server takes.

import presets from './presets.json';
import type {Json, JsonObject, XY} from './types';

export interface Model {
  name: string;
  where: XY[][];
  soil: JsonObject;
}

export interface Draft {
  dem: string;
  name: string;
  sections: JsonObject[];
  models: Model[];
  /** trigger, resolution, stop and whatever else stands beside soil and sections */
  settings: JsonObject;
}

const own_members = ['dem', 'name', 'sections', 'soil'];
const own_of_model = ['name', 'where'];

function copy<T>(value: T): T {
  return JSON.parse(JSON.stringify(value)) as T;
}

function without(object: JsonObject, names: readonly string[]): JsonObject {
  return Object.fromEntries(Object.entries(object).filter(([name]) => !names.includes(name)));
}

export const preset_names = presets.map((preset) => preset.name);

export function preset(index: number): {soil: JsonObject; trigger: JsonObject} {
  const {soil, trigger} = copy(presets[index]!) as unknown as {soil: JsonObject; trigger: JsonObject};
  return {soil, trigger};
}

export function new_draft(): Draft {
  const {soil, trigger} = preset(0);
  return {
    dem: '', name: '', sections: [],
    models: [{name: preset_names[0]!, where: [], soil}],
    settings: {
      trigger, resolution: {cell_m: 1, particles_per_cell: 4}, stop: {max_time_s: 120},
      output: {frame_interval_s: 1}, screening: {skip_stable: true},
    },
  };
}

/** Whether soil is written as a list of models: one that applies everywhere is written plainly. */
export function has_models(draft: Draft): boolean {
  return draft.models.length > 1 || draft.models.some((model) => model.where.length > 0);
}

function soil_of(draft: Draft): JsonObject {
  if (!has_models(draft)) return draft.models[0]!.soil;
  const models = draft.models.map(({name, where, soil}) =>
    ({name, ...(where.length > 0 ? {where: where as Json} : {}), ...soil}));
  return {models};
}

/** Where the soil of a model stands in the request. */
export function model_pointer(draft: Draft, index: number): string {
  return has_models(draft) ? `/inputs/soil/models/${index}` : '/inputs/soil';
}

export function request_of(draft: Draft): {inputs: JsonObject} {
  return copy({
    inputs: {
      name: draft.name, dem: draft.dem, sections: draft.sections as Json, soil: soil_of(draft), ...draft.settings,
    },
  });
}

/** A request back into the form. @throws Error where it is no request of a region */
export function draft_of(request: Json): Draft {
  const inputs = (request as JsonObject | null)?.inputs as JsonObject | undefined;
  if (typeof inputs !== 'object' || inputs === null || Array.isArray(inputs)) throw new Error('"inputs" is missing');
  const soil = inputs.soil as JsonObject | undefined;
  if (typeof soil !== 'object' || soil === null) throw new Error('"inputs.soil" is missing');
  const list = Array.isArray(soil.models) ? (soil.models as JsonObject[]) : [{name: '', ...soil}];
  const sections = inputs.sections ?? [];
  return copy({
    dem: String(inputs.dem ?? ''),
    name: String(inputs.name ?? ''),
    sections: (Array.isArray(sections) ? sections : [sections]) as JsonObject[],
    models: list.map((model) => ({
      name: String(model.name ?? ''),
      where: (model.where ?? []) as unknown as XY[][],
      soil: without(model, own_of_model),
    })),
    settings: without(inputs, own_members),
  });
}

const kept_as = 'leda-draft';

export function kept_draft(): Draft {
  try {
    const kept = JSON.parse(localStorage.getItem(kept_as) ?? '') as Draft;
    if (Array.isArray(kept.sections) && Array.isArray(kept.models) && kept.models.length > 0) return kept;
  } catch {
    // None was kept, or by another version of the page.
  }
  return new_draft();
}

export function keep_draft(draft: Draft): void {
  localStorage.setItem(kept_as, JSON.stringify(draft));
}
