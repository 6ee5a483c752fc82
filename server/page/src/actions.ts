// What several parts of the page do: load lists, show a job, open a section.

import {Problem, get} from './api';
import {settle, state, tell} from './state';
import type {Step} from './state';
import type {Ensemble, Job, JobMap, Raster, SectionDetail} from './types';

export function go(step: Step): void {
  state.step = step;
  tell('step');
}

export async function load_rasters(): Promise<void> {
  state.rasters = (await get<{rasters: Raster[]}>('rasters')).rasters;
  if (!state.raster) {
    const wanted = state.draft.dem;
    const named = state.rasters.find(({id, name}) => id === wanted || name === wanted);
    const known = wanted ? named : state.rasters[0];
    if (known) use_raster(known);
  }
  tell('rasters');
}

/** Puts a DEM on the map, and into the request. */
export function use_raster(raster: Raster): void {
  state.raster = raster;
  state.draft.dem = raster.name;
  if (!state.draft.name) state.draft.name = raster.name;
  settle('/inputs/dem');
  settle('/inputs/name');
  tell('raster');
  tell('draft');
}

export async function load_jobs(): Promise<void> {
  state.jobs = (await get<{jobs: Job[]}>('jobs?limit=100')).jobs;
  tell('jobs');
}

/** The address of the page says which job and section show, so that it can be kept and sent. */
function write_address(): void {
  const parts = [];
  if (state.job) parts.push(`job=${encodeURIComponent(state.job.job)}`);
  if (state.section) parts.push(`section=${encodeURIComponent(state.section.name)}`);
  history.replaceState(null, '', parts.length > 0 ? `#${parts.join('&')}` : location.pathname + location.search);
}

export function section_address(job: string, name: string): string {
  return `jobs/${job}/sections/${encodeURIComponent(name)}`;
}

/** Sections of a case or a study have profiles, and no place on the ground. */
export function lies_on_map(job: JobMap): boolean {
  return job.sections.trace.some((trace) => trace.length > 0);
}

/** What the members of a section say; nothing where the first of them are not over. */
export async function ensemble_of(job: string, section: string): Promise<Ensemble | null> {
  try {
    return await get<Ensemble>(`${section_address(job, section)}/ensemble`);
  } catch (error) {
    if (error instanceof Problem && error.status === 404) return null;
    throw error;
  }
}

/** Loads a job for the map; what showed of another goes away. */
export async function show_job(id: string): Promise<void> {
  const job = await get<JobMap>(`jobs/${id}/map`);
  if (state.job?.job !== id) state.section = null;
  state.job = job;
  if (job.dem && job.dem !== state.raster?.id) {
    const raster = state.rasters.find((one) => one.id === job.dem) ?? (await get<Raster>(`rasters/${job.dem}`));
    state.raster = raster;
    tell('raster');
  }
  write_address();
  tell('job');
}

export async function open_section(name: string | null): Promise<void> {
  state.section = name && state.job ? await get<SectionDetail>(section_address(state.job.job, name)) : null;
  write_address();
  tell('section');
}

/** What the address asks for, on start. */
export async function follow_address(): Promise<void> {
  const wanted = new URLSearchParams(location.hash.slice(1));
  const id = wanted.get('job') ?? '';
  const name = wanted.get('section');
  if (!id) return;
  try {
    await show_job(id);
    go('look');
    if (name) await open_section(name);
  } catch (error) {
    if (!(error instanceof Problem) || error.status !== 404) throw error;
  }
}
