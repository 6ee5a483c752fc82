// The map page, from its start.

import 'ol/ol.css';
import './page.css';
import {follow_address, go, load_jobs, load_rasters} from './actions';
import {Problem, connect} from './api';
import type {ColourBy} from './colours';
import {fill, h} from './dom';
import {MapView} from './map/map_view';
import {section_panel} from './section/panel';
import {ask_for_token, connection_banner, language_button, legend, readout, step_list, step_word,
  token_button} from './shell';
import {type Step, on, state, steps, tell} from './state';
import {open_section} from './actions';
import {compare_step} from './steps/compare_step';
import {dem_step} from './steps/dem_step';
import {draw_step, drawn_of} from './steps/draw_step';
import {look_step} from './steps/look_step';
import {run_step} from './steps/run_step';
import {regions_of, soil_step} from './steps/soil_step';
import {take_step} from './steps/take_step';
import {spoken, t} from './words';

async function load_lists(): Promise<void> {
  await Promise.all([load_rasters(), load_jobs()]);
}

function step_box(step: Step, content: HTMLElement): HTMLElement {
  const next = steps[steps.indexOf(step) + 1];
  const box = h('div', {class: 'step', 'data-step': step}, content,
    next && steps.indexOf(step) < 3 ? h('p', {class: 'next'}, h('button', {type: 'button', onclick: () => go(next)},
      t('next', {step: step_word(next)}))) : null);
  on('step', () => (box.hidden = state.step !== step));
  return box;
}

/** A place over the map; it may scroll, and the keyboard reaches it. */
function stage_of(name: string): HTMLElement {
  return h('div', {class: 'stage', hidden: true, tabindex: 0, role: 'region', 'aria-label': name});
}

function start(): void {
  document.documentElement.lang = spoken();
  const map_box = h('div', {class: 'map', tabindex: 0, 'aria-label': t('report_map'), role: 'application'});
  const stage = stage_of(t('step_compare'));
  const study_stage = stage_of(t('study_settings'));
  const map = new MapView(map_box);
  const colour = {by: 'status' as ColourBy, changed: () => {
    if (state.job) map.recolour(state.job, colour.by);
    key.draw();
  }};
  const key = legend(map, colour);
  const banner = connection_banner(() => {
    void load_lists().catch(() => undefined);
    tell('back');
    tell('raster');
  });
  connect(ask_for_token, banner.tell);

  const contents: Record<Step, HTMLElement> = {
    dem: dem_step(), draw: draw_step(map), soil: soil_step(map), run: run_step(), look: look_step(colour, study_stage),
    compare: compare_step(stage), take: take_step(map),
  };
  const main = h('main', {}, steps.map((step) => step_box(step, contents[step])));
  fill(document.body,
    h('header', {}, h('h1', {}, t('title')), step_list(), h('div', {class: 'row'}, token_button(), language_button())),
    banner.element, main,
    h('section', {class: 'view', 'aria-label': t('report_map')}, map_box, key.element, readout(map), stage, study_stage,
      section_panel()));
  map.map.setTarget(map_box);

  map.on_pick = (name) => {
    if (state.step === 'look') return void open_section(name);
    state.looked_at = name;
    tell('laid');
  };
  const redraw = () => map.show_drawn([...drawn_of(state.draft.sections), ...regions_of()]);
  on(['draft', 'sections'], redraw);
  on('raster', () => void map.show_raster(state.raster).catch((error) => {
    if (!(error instanceof Problem)) throw error;
  }));
  on('job', () => map.show_job(state.job, colour.by));
  on('step', () => {
    map.show_side(['look', 'compare', 'take'].includes(state.step) ? 'job' : 'draft');
    main.scrollTop = 0;
    if (state.step === 'draw' || state.step === 'soil') tell('laid');
    mark_section();
  });
  const mark_section = () => map.choose(state.step === 'look' ? (state.section?.trace ?? null) : null);
  on('section', mark_section);
  tell('step');
  void begin();
}

/** On start: what the server has, what the address asks for, what was typed before. */
async function begin(): Promise<void> {
  try {
    await load_lists();
    tell('sections');
    await follow_address();
  } catch (error) {
    if (!(error instanceof Problem)) throw error;
  }
}

start();
