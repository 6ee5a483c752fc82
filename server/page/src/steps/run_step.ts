// Dry run, what it would cost, and submit.

import {go, load_jobs, show_job} from '../actions';
import {type Fault, Problem, send} from '../api';
import {request_of} from '../draft';
import {fill, h} from '../dom';
import {mark_faults} from '../form/faults';
import {on, settle, state, step_of, tell} from '../state';
import type {DryRun, Job} from '../types';
import {type Word, show, t} from '../words';
import {Report, button, facts, field} from './parts';

const most_notes = 50;

function bytes(count: number): string {
  const units = ['B', 'kB', 'MB', 'GB', 'TB'];
  const power = Math.min(Math.floor(Math.log10(Math.max(count, 1)) / 3), units.length - 1);
  return `${show(count / 1000 ** power)} ${units[power]}`;
}

/** Few hours also in a unit that says something. */
function core_hours(hours: number): string {
  const minutes = hours * 60;
  if (hours >= 2) return show(hours);
  return `${show(hours, 3)} (${minutes >= 2 ? `${show(minutes, 0)} min` : `${show(minutes * 60, 0)} s`})`;
}

/** Fewer where an ensemble may end before its last member. */
function hours_of({core_hours_at_least: least, core_hours: likely, core_hours_at_most: most}: DryRun['estimate']): string {
  return [least < likely ? `${t('est_at_least')} ${core_hours(least)}` : '', core_hours(likely),
    `${t('est_at_most')} ${core_hours(most)}`].filter(Boolean).join('; ');
}

function estimate_of({estimate, sections}: DryRun): HTMLElement {
  const notes = sections.filter(({reason, warnings}) => reason || warnings.length > 0);
  return h('div', {},
    h('p', {class: 'good'}, t('dry_ok')),
    facts([
      [t('est_runs'), show(estimate.runs)],
      [t('est_left_out'), show(estimate.left_out)],
      [t('est_stable'), show(estimate.stable)],
      [t('est_particles'), show(estimate.particles, 0)],
      [t('est_core_hours'), hours_of(estimate)],
      [t('est_disk'), bytes(estimate.disk_bytes)],
      [t('est_basis'), estimate.based_on],
    ]),
    notes.length === 0 ? null : h('details', {}, h('summary', {}, `${t('section_notes')}: ${notes.length}`),
      h('ul', {class: 'warnings'}, notes.slice(0, most_notes).map(({name, reason, warnings}) =>
        h('li', {}, h('strong', {}, name), ` ${[reason, ...warnings].filter(Boolean).join('; ')}`)))));
}

/** What a newcomer has not done yet is said as such. */
function in_plain_words(fault: Fault): Fault {
  const {draft} = state;
  if (fault.pointer === '/inputs/name' && draft.name === '') return {...fault, detail: t('need_name')};
  if (fault.pointer === '/inputs/dem' && draft.dem === '') return {...fault, detail: t('need_dem')};
  if (fault.pointer === '/inputs/sections' && draft.sections.length === 0) return {...fault, detail: t('need_sections')};
  return fault;
}

/** Faults, each with a way to the field it is about. */
function fault_list(): HTMLElement {
  const {faults} = state;
  return h('div', {}, h('p', {class: 'bad', role: 'alert'}, faults.length === 1 ? t('fault_one') : t('faults',
    {count: faults.length})),
    h('ul', {class: 'warnings'}, faults.map(({pointer, detail}) => {
      const step = step_of(pointer);
      return h('li', {}, h('code', {}, pointer), ` ${detail} `,
        step === 'run' ? null : h('button', {type: 'button', class: 'small', onclick: () => {
          go(step);
          document.querySelector('main .step:not([hidden]) .fault')?.scrollIntoView({block: 'center'});
        }}, `${t('fault_go')}: ${t(`step_${step}` as Word)}`));
    })));
}

export function run_step(): HTMLElement {
  const report = new Report();
  const outcome = h('div');
  const name = h('input', {type: 'text', maxlength: 200, value: state.draft.name, autocomplete: 'off', oninput: () => {
    state.draft.name = name.value;
    settle('/inputs/name');
    tell('draft');
  }});
  const form = field(t('job_name'), name, '/inputs/name');

  const buttons = [button('dry_run', () => void dry()), button('submit', () => void submit(), 'primary')];
  const ask = async <T>(body: object): Promise<T | null> => {
    report.say(t('submitting'));
    fill(outcome);
    // A second click would be a second job.
    buttons.forEach((one) => (one.disabled = true));
    state.faults = [];
    try {
      const answer = await send<T>('POST', 'processes/map-region/execution', body);
      report.say('');
      return answer;
    } catch (error) {
      if (error instanceof Problem && error.faults.length > 0) {
        state.faults = error.faults.map(in_plain_words);
        report.say(error.message, true);
        fill(outcome, fault_list());
      } else {
        report.problem(error);
      }
      return null;
    } finally {
      buttons.forEach((one) => (one.disabled = false));
      tell('faults');
    }
  };
  const dry = async () => {
    const answer = await ask<DryRun>({...request_of(state.draft), dryRun: true});
    if (answer) fill(outcome, estimate_of(answer));
  };
  const submit = async () => {
    const job = await ask<Job>(request_of(state.draft));
    if (!job) return;
    await load_jobs();
    await show_job(job.jobID);
    go('look');
  };
  on('faults', () => mark_faults(form, state.faults));
  on('draft', () => {
    if (name.value !== state.draft.name) name.value = state.draft.name;
  });
  return h('section', {}, h('h2', {}, t('step_run')), h('p', {}, t('run_intro')), form,
    h('div', {class: 'row'}, buttons),
    report.element, outcome);
}
