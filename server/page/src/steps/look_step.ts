// Jobs, how far they are, and the sections of the one on the map.

import {lies_on_map, load_jobs, open_section, show_job} from '../actions';
import {send} from '../api';
import {type ColourBy, colour_sections, status_word} from '../colours';
import {fill, h, later} from '../dom';
import {follow, is_finished} from '../events';
import {swatch} from '../section/animation';
import {on, state, tell} from '../state';
import type {Job} from '../types';
import {type Word, show, t} from '../words';
import {Report, button} from './parts';
import {study_box} from './study';

const rows_at_once = 200;

function name_of(job: Job): string {
  return job.name || job.processID;
}

function when(job: Job): string {
  return new Date(job.created).toLocaleString();
}

/** Listens to every unfinished job that shows; one that finished is loaded once more. */
class Watch {
  private readonly stops = new Map<string, () => void>();
  private loading = false;
  private again = false;

  update(): void {
    for (const job of state.jobs) {
      const shown = state.job?.job === job.jobID;
      if (is_finished(job) || this.stops.has(job.jobID) || !(shown || this.stops.size < 3)) continue;
      this.stops.set(job.jobID, follow(job.jobID, (now) => this.hear(now)));
    }
  }

  private hear(job: Job): void {
    const at = state.jobs.findIndex(({jobID}) => jobID === job.jobID);
    if (at >= 0) state.jobs[at] = job;
    if (is_finished(job)) this.stops.delete(job.jobID);
    tell('jobs');
    if (state.job?.job === job.jobID) void this.reload();
  }

  /** Loads the job on the map again, never more than a quarter of the time. */
  private async reload(): Promise<void> {
    this.again = this.loading;
    if (this.loading || !state.job) return;
    this.loading = true;
    const start = performance.now();
    await show_job(state.job.job).catch(() => undefined);
    const took = performance.now() - start;
    setTimeout(() => {
      this.loading = false;
      if (this.again) void this.reload();
    }, Math.max(500, 3 * took));
  }
}

function job_card(job: Job, report: Report): HTMLElement {
  const shown = state.job?.job === job.jobID;
  const failed = shown && state.job!.sections.state.includes('failed');
  const act = async (method: string, path: string) => {
    try {
      await send(method, path);
      await load_jobs();
      if (shown) await show_job(job.jobID);
    } catch (error) {
      report.problem(error);
    }
  };
  const id = job.jobID;
  return h('li', {class: shown ? 'card chosen' : 'card', 'data-job': id},
    h('div', {class: 'row'},
      h('strong', {}, name_of(job)),
      shown ? null : h('button', {type: 'button', 'aria-label': `${t('job_show')}: ${name_of(job)}, ${when(job)}`,
        onclick: () => void show_job(id).catch((error) => report.problem(error))}, t('job_show'))),
    h('div', {class: 'quiet'}, `${t(job.status)} · ${when(job)}`),
    is_finished(job) ? null : h('progress', {max: 100, value: job.progress, 'aria-label': t('progress')}),
    h('div', {class: 'quiet'}, job.message),
    h('div', {class: 'row'},
      is_finished(job) ? null : button('job_cancel', () => void act('DELETE', `jobs/${id}`)),
      failed && is_finished(job) ? button('job_retry', () => void act('POST', `jobs/${id}/retry`)) : null));
}

function section_rows(filter: string, count: number): {rows: HTMLElement[]; left: number} {
  const {sections} = state.job!;
  const wanted = filter.trim().toLowerCase();
  const found = sections.name.map((_, i) => i).filter((i) => sections.name[i]!.toLowerCase().includes(wanted));
  const bound = (is: string | null | undefined) => (is === 'lower-bound' ? '≥ ' : '');
  const {of} = colour_sections(state.job!, 'status');
  const rows = found.slice(0, count).map((i) => h('tr', {class: state.section?.name === sections.name[i] ? 'chosen'
    : ''},
    h('td', {}, h('button', {type: 'button', class: 'link', 'data-section': sections.name[i],
      onclick: () => void open_section(sections.name[i]!)}, sections.name[i]!)),
    h('td', {}, swatch(of[i]!.colour), h('span', {title: status_word(sections.status[i]!)},
      status_word(sections.status[i]!))),
    h('td', {class: 'number'}, sections.retrogression_m[i] === null ? '–'
      : bound(sections.retrogression_is[i]) + show(sections.retrogression_m[i])),
    h('td', {class: 'number'}, sections.runout_m[i] === null ? '–'
      : bound(sections.runout_is[i]) + show(sections.runout_m[i]))));
  return {rows, left: found.length - rows.length};
}

/** @param stage over the map, for jobs that have something else to show */
export function look_step(colour: {by: ColourBy; changed: () => void}, stage: HTMLElement): HTMLElement {
  const report = new Report();
  const jobs = h('ul', {class: 'cards jobs'});
  const study = study_box(stage, report);
  const no_map = h('p', {class: 'quiet'}, t('not_on_map'));
  const table_box = h('div');
  const watch = new Watch();
  let count = rows_at_once;

  const show_jobs = () => {
    const shown = state.jobs.filter(({jobID}) => jobID === state.job?.job);
    const others = state.jobs.filter(({jobID}) => jobID !== state.job?.job);
    fill(jobs, state.jobs.length === 0 ? h('li', {class: 'quiet'}, t('jobs_none')) : [
      ...shown.map((job) => job_card(job, report)),
      shown.length > 0 && others.length > 0 ? h('li', {}, h('details', {}, h('summary', {},
        `${t('jobs')}: ${others.length}`),
        h('ul', {class: 'cards'}, others.map((job) => job_card(job, report))))) : null,
      ...(shown.length > 0 ? [] : others.map((job) => job_card(job, report))),
    ]);
    watch.update();
  };

  const by = h('select', {value: colour.by, onchange: () => {
    colour.by = by.value as ColourBy;
    colour.changed();
  }}, (['status', 'retrogression', 'runout', 'cost'] as const).map((name) => h('option', {value: name},
    t(`by_${name}` as Word))));
  const find = h('input', {type: 'search', 'aria-label': t('filter'), placeholder: t('filter'), oninput: later(150,
    () => {
    count = rows_at_once;
    show_table();
  })});
  const body = h('tbody');
  const more = h('button', {type: 'button', onclick: () => {
    count += 5 * rows_at_once;
    show_table();
  }});
  const table = h('table', {class: 'sections'}, h('thead', {}, h('tr', {}, [t('section'), t('status'),
    `${t('retrogression')}, m`, `${t('runout')}, m`]
    .map((word) => h('th', {scope: 'col'}, word)))), body);
  const show_table = () => {
    if (!state.job) return;
    const {rows, left} = section_rows(find.value, count);
    fill(body, rows);
    more.hidden = left === 0;
    more.textContent = t('more_rows', {count: Math.min(left, 5 * rows_at_once)});
  };
  fill(table_box, h('div', {class: 'row'}, h('label', {}, t('colour_by'), ' ', by), find), table, more);

  const show_sections = () => {
    table_box.hidden = !state.job || state.job.sections.name.length === 0;
    no_map.hidden = !state.job || lies_on_map(state.job) || state.job.sections.name.length === 0;
    show_table();
  };
  on('jobs', show_jobs);
  on('job', () => {
    show_jobs();
    show_sections();
  });
  on('section', show_table);
  // The newest job shows by itself: it is what one comes for.
  on('step', () => {
    const newest = state.jobs[0];
    if (state.step === 'look' && !state.job && newest) void show_job(newest.jobID).catch((error) => report.problem(
      error));
  });
  show_jobs();
  show_sections();
  return h('section', {}, h('h2', {}, t('jobs')), report.element, jobs, study, no_map, table_box);
}
