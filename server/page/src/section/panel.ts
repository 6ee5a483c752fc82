// A section of a job: profile, how sure it is, numbers with their bounds, warnings, screening, animation, log.

import {open_section, section_address} from '../actions';
import {blob, text} from '../api';
import {status_word} from '../colours';
import {fill, h, save} from '../dom';
import {type Side, extent_of, profile_svg} from '../drawing/profile_svg';
import {has_ensemble} from '../ensemble/numbers';
import {on, state} from '../state';
import {Report, button, facts, warnings} from '../steps/parts';
import type {SectionDetail, XY} from '../types';
import {show, t} from '../words';
import {animation} from './animation';
import {bounded} from './bounds';
import {ensemble_tab} from './ensemble_tab';

export function side_of(section: SectionDetail): Side {
  const slid = (section.crest_to_crest_retrogression_m ?? 0) > 0;
  return {
    before: section.profile_before, after: section.profile_after, crest: section.crest_m, toe: section.toe_m,
    backscarp: slid ? section.result?.backscarp_m : null, front: slid ? section.result?.front_m : null,
  };
}

function audit(value: number | undefined): string | null {
  return value === undefined ? null : value.toExponential(1);
}

export function number_rows(section: SectionDetail): [string, string | null][] {
  const balances = section.result?.balances ?? {};
  return [
    [t('status'), status_word(section.status)],
    [t('reason'), section.reason || null],
    [t('retrogression'), bounded(section.crest_to_crest_retrogression_m, section.retrogression_is)],
    [t('runout'), bounded(section.runout_m, section.runout_is)],
    [t('from_crest'), bounded(section.runout_from_crest_m, section.runout_is)],
    [t('slides'), section.slides === null ? null : show(section.slides)],
    [t('trigger'), section.result?.trigger_used ?? null],
    [t('simulated'), section.simulated_s === null ? null : `${show(section.simulated_s)} s`],
    [t('run_time'), section.run_time_s === null ? null : `${show(section.run_time_s)} s`],
    [t('particles'), section.particles === null ? null : show(section.particles)],
    [t('speed_of_run'), section.ns_per_particle_step === null ? null : `${show(section.ns_per_particle_step)} ns`],
    [t('mass'), audit(balances.mass)], [t('momentum'), audit(balances.momentum)], [t('energy'), audit(balances.energy)],
    [t('attempts'), show(section.attempts)],
    [t('version'), section.version], [t('case_hash'), section.case_sha256], [t('dem_hash'), section.dem_sha256],
  ];
}

/** Members of a document as rows, however deep. */
function as_rows(value: unknown, name = ''): [string, string][] {
  if (Array.isArray(value) && value.every((one) => typeof one !== 'object')) return [[name, value.join('; ')]];
  if (typeof value === 'object' && value !== null) {
    return Object.entries(value).flatMap(([key, one]) => as_rows(one, name ? `${name} · ${key}` : key));
  }
  if (value === null || value === undefined) return [];
  return [[name.replace(/_/g, ' '), typeof value === 'number' ? show(value, 3) : String(value)]];
}

type Tab = 'profile' | 'ensemble' | 'animation' | 'numbers' | 'screening' | 'log';

function tab_content(tab: Tab, section: SectionDetail, job: string): HTMLElement {
  const address = section_address(job, section.name);
  switch (tab) {
    case 'profile': return profile_tab(section);
    case 'ensemble': return ensemble_tab(job, section.name);
    case 'animation': {
      if (!section.run || section.profile_before.length === 0) return h('p', {class: 'quiet'}, t('anim_none'));
      const {x, z} = extent_of([side_of(section)]);
      const deepest = Math.min(z[0], ...(section.profile_after ?? section.profile_before).map((p: XY) => p[1] - 8));
      return animation(address, {x, z: [deepest, z[1]]});
    }
    case 'numbers': return h('div', {}, facts(number_rows(section)), h('h3', {}, t('warnings')),
      warnings(section.warnings), section_files(section, address));
    case 'screening': return section.screening ? facts(as_rows(section.screening)) : h('p', {class: 'quiet'},
      t('none'));
    case 'log': return h('div', {}, h('pre', {class: 'log', tabindex: 0, 'aria-label': t('log')}, section.log ||
      t('none')),
      section.run ? button('download_log', () => void text(`${address}/log`).then((log) =>
        save(new Blob([log], {type: 'text/plain'}), `${section.name}-log.txt`))) : null);
  }
}

function section_files(section: SectionDetail, address: string): HTMLElement {
  const report = new Report();
  const fields = () => blob(`${address}/fields.h5`).then((file) => save(file, `${section.name}-fields.h5`))
    .catch((error) => report.problem(error));
  return h('div', {}, h('div', {class: 'row'}, button('download_json', () =>
    save(new Blob([JSON.stringify(section, null, 2)], {type: 'application/json'}), `${section.name}.json`)),
    section.run ? button('download_fields', () => void fields()) : null), report.element);
}

function profile_tab(section: SectionDetail): HTMLElement {
  if (section.profile_before.length === 0) return h('p', {class: 'fault'}, section.reason || t('no_result'));
  const box = h('div', {class: 'wide-profile'});
  const draw = () => {
    const width = Math.max(box.clientWidth, 280);
    fill(box, profile_svg(side_of(section), {width, height: Math.max(box.clientHeight,
      180)}) as unknown as HTMLElement);
  };
  new ResizeObserver(draw).observe(box);
  const strip = [
    `${t('retrogression')} ${bounded(section.crest_to_crest_retrogression_m, section.retrogression_is)}`,
    `${t('runout')} ${bounded(section.runout_m, section.runout_is)}`,
    status_word(section.status),
  ].map((one) => h('span', {class: 'badge'}, one));
  return h('div', {class: 'profile-tab'}, h('div', {class: 'row'}, strip, section.warnings.length > 0
    ? h('span', {class: 'badge warn', title: section.warnings.join('\n')},
      `${t('warnings')}: ${section.warnings.length}`) : null,
    button('download_svg', () => {
      const svg = box.querySelector('svg')!;
      svg.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
      save(new Blob([svg.outerHTML], {type: 'image/svg+xml'}), `${section.name}.svg`);
    }, 'small')), box);
}

export function section_panel(): HTMLElement {
  const tabs: Tab[] = ['profile', 'ensemble', 'animation', 'numbers', 'screening', 'log'];
  let tab: Tab = 'profile';
  let shown = '';
  /** of the job, when an ensemble was asked for: more members say more */
  let sure_at = '';
  const title = h('h2', {});
  const content = h('div', {class: 'content', role: 'tabpanel', id: 'section-content', tabindex: 0});
  const buttons = tabs.map((name) => h('button', {type: 'button', role: 'tab', id: `tab-${name}`,
    'aria-controls': 'section-content', onclick: () => {
    tab = name;
    draw();
  }, onkeydown: (event: KeyboardEvent) => {
    const turn = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    if (turn === 0) return;
    const there = buttons.filter((one) => !one.hidden);
    const next = there[(there.indexOf(buttons[tabs.indexOf(name)]!) + turn + there.length) % there.length]!;
    next.click();
    next.focus();
  }}, t(name)));
  const panel = h('section', {class: 'panel', hidden: true, 'aria-label': t('section')},
    h('div', {class: 'row head'}, title, h('div', {role: 'tablist', class: 'tabs'}, buttons),
      h('button', {type: 'button', class: 'small', 'aria-label': t('close'), onclick: () => void open_section(null)},
        '×')), content);

  const draw = () => {
    const {section, job} = state;
    panel.hidden = !section || !job || state.step !== 'look';
    shown = '';
    if (panel.hidden || !section || !job) return;
    shown = `${job.job} ${section.name} ${section.run} ${section.state}`;
    title.textContent = section.name;
    buttons[tabs.indexOf('ensemble')]!.hidden = !has_ensemble(job);
    if (tab === 'ensemble' && !has_ensemble(job)) tab = 'profile';
    sure_at = job.status;
    buttons.forEach((one, i) => {
      one.setAttribute('aria-selected', String(tabs[i] === tab));
      one.tabIndex = tabs[i] === tab ? 0 : -1;
    });
    content.setAttribute('aria-labelledby', `tab-${tab}`);
    fill(content, tab_content(tab, section, job.job));
  };
  on('section', draw);
  on('step', draw);
  // A section that finishes while its panel is open shows what came out.
  on('job', () => {
    const {section, job} = state;
    if (!section || !job || shown === '') return;
    const at = job.sections.name.indexOf(section.name);
    if (at >= 0 && job.sections.state[at] !== section.state) void open_section(section.name);
    else if (tab === 'ensemble' && job.status !== sure_at) draw();
  });
  return panel;
}
