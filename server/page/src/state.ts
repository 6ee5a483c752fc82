// What the page knows, and who is told when it changes.

import type {Fault} from './api';
import {type Draft, keep_draft, kept_draft} from './draft';
import type {Job, JobMap, LaidSection, Raster, SectionDetail} from './types';

export type Step = 'dem' | 'draw' | 'soil' | 'run' | 'look' | 'compare' | 'take';
export type Topic =
  | 'step' | 'rasters' | 'raster' | 'draft' | 'sections' | 'laid' | 'faults' | 'jobs' | 'job' | 'section' | 'back';

export const steps: readonly Step[] = ['dem', 'draw', 'soil', 'run', 'look', 'compare', 'take'];

export const state = {
  step: 'dem' as Step,
  rasters: [] as Raster[],
  raster: null as Raster | null,
  draft: kept_draft() as Draft,
  laid: [] as LaidSection[],
  /** the drawn section whose profile shows */
  looked_at: '',
  faults: [] as Fault[],
  jobs: [] as Job[],
  job: null as JobMap | null,
  /** the section of the job whose panel is open */
  section: null as SectionDetail | null,
};

const listeners = new Map<Topic, (() => void)[]>();

export function on(topics: Topic | readonly Topic[], listener: () => void): void {
  for (const topic of [topics].flat() as Topic[]) {
    listeners.set(topic, [...(listeners.get(topic) ?? []), listener]);
  }
}

export function tell(topic: Topic): void {
  if (topic === 'draft' || topic === 'sections') keep_draft(state.draft);
  for (const listener of listeners.get(topic) ?? []) listener();
}

/** What was refused and is typed anew is no fault any more, until the server says so again. */
export function settle(pointer: string): void {
  const left = state.faults.filter((fault) => fault.pointer !== pointer && !fault.pointer.startsWith(`${pointer}/`));
  if (left.length === state.faults.length) return;
  state.faults = left;
  tell('faults');
}

/** The step in which the value of a fault is typed. */
export function step_of(pointer: string): Step {
  if (pointer.startsWith('/inputs/dem')) return 'dem';
  if (pointer.startsWith('/inputs/sections')) return 'draw';
  if (pointer === '/inputs/name' || !pointer.startsWith('/inputs/')) return 'run';
  return 'soil';
}
