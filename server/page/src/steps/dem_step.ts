// Bring a DEM: upload it, see what the server found, choose one that is known.

import {load_rasters, use_raster} from '../actions';
import {Problem, upload} from '../api';
import {fill, h} from '../dom';
import {on, state} from '../state';
import type {Raster} from '../types';
import {show, t} from '../words';
import {Report, button, facts, field, warnings} from './parts';

function about(raster: Raster): HTMLElement {
  const cell = raster.cell_on_ground_m;
  const missing = raster.share_without_data;
  return h('div', {class: 'about'},
    facts([
      [t('crs'), raster.crs],
      [t('size'), `${show(raster.size[0])} × ${show(raster.size[1])} ${t('cells')}`],
      [t('cell'), cell ? `${show(cell[0], 2)} × ${show(cell[1], 2)} m` : null],
      [t('elevation'), `${show(raster.lowest_m)} – ${show(raster.highest_m)} m`],
      [t('no_data'), missing === null ? null : t('share_no_data', {percent: show(missing * 100, 2)})],
    ]),
    h('h4', {}, t('warnings')), warnings(raster.warnings));
}

function known_list(list: HTMLElement): void {
  fill(list, state.rasters.length === 0 ? h('p', {class: 'quiet'}, t('dem_none')) : h('ul', {class: 'cards'},
    state.rasters.map((raster) => {
      const used = raster.id === state.raster?.id;
      return h('li', {class: used ? 'card chosen' : 'card'},
        h('div', {class: 'row'}, h('strong', {}, raster.name), used ? h('span', {class: 'badge'}, t('dem_in_use'))
          : h('button', {type: 'button', 'aria-label': `${t('dem_use')}: ${raster.name}`,
            onclick: () => use_raster(raster)}, t('dem_use'))),
        used ? about(raster) : null);
    })));
}

/** "my dem.v2.tif" to a name that the server takes. */
export function name_from(file: string): string {
  return file.replace(/\.[^.]*$/, '').replace(/[^\p{L}\p{N} _.()-]/gu, '-').replace(/^[.\s]+/, '').slice(0, 100);
}

export function dem_step(): HTMLElement {
  const report = new Report();
  const file = h('input', {type: 'file', accept: '.tif,.tiff,image/tiff', 'aria-label': t('dem_file'), class: 'file'});
  const name = h('input', {type: 'text', maxlength: 100, autocomplete: 'off'});
  const epsg = h('input', {type: 'text', inputmode: 'numeric', autocomplete: 'off', placeholder: '2950'});
  const unit = h('select', {}, ['', 'm', 'ft', 'us-ft'].map((one) => h('option', {value: one}, one ||
    t('dem_as_in_file'))));
  const nodata = h('input', {type: 'text', autocomplete: 'off', placeholder: '-9999'});
  const progress = h('progress', {max: 1, value: 0, hidden: true, 'aria-label': t('progress')});
  const chosen = h('strong', {});
  let picked: File | null = null;

  const pick = (one: File | undefined) => {
    if (!one) return;
    picked = one;
    chosen.textContent = one.name;
    if (!name.value) name.value = name_from(one.name);
    report.say('');
  };
  file.addEventListener('change', () => pick(file.files?.[0]));
  const drop = h('div', {class: 'drop',
    ondragover: (event: DragEvent) => {
      event.preventDefault();
      drop.classList.add('over');
    },
    ondragleave: () => drop.classList.remove('over'),
    ondrop: (event: DragEvent) => {
      event.preventDefault();
      drop.classList.remove('over');
      pick(event.dataTransfer?.files[0]);
    }}, h('p', {}, t('dem_drop'), ' '), h('label', {class: 'button'}, t('dem_choose'), file), chosen);

  const path = () => {
    const query = new URLSearchParams({name: name.value.trim()});
    if (epsg.value.trim()) query.set('epsg', epsg.value.trim());
    if (unit.value) query.set('vertical_unit', unit.value);
    if (nodata.value.trim()) query.set('nodata', nodata.value.trim());
    return `rasters?${query}`;
  };
  const upload_it = async () => {
    if (!picked) return report.say(t('dem_no_file'), true);
    send.disabled = true;
    progress.hidden = false;
    try {
      const raster = await upload<Raster>(path(), picked, (share) => {
        progress.value = share;
        report.say(share < 1 ? t('dem_sending', {percent: Math.round(share * 100)}) : t('dem_checking'));
      });
      report.say('');
      await load_rasters();
      use_raster(raster);
    } catch (error) {
      if (error instanceof Problem && error.status === 0) report.say(t('dem_lost'), true);
      else report.problem(error);
    } finally {
      send.disabled = false;
      progress.hidden = true;
    }
  };
  const send = button('dem_send', () => void upload_it(), 'primary');

  const list = h('div', {'data-pointer': '/inputs/dem'});
  on(['rasters', 'raster'], () => known_list(list));
  known_list(list);
  return h('section', {}, h('h2', {}, t('step_dem')), h('p', {}, t('dem_intro')), drop, field(t('dem_name'), name),
    h('details', {}, h('summary', {}, t('dem_more')), field(t('dem_epsg'), epsg), field(t('dem_unit'), unit),
      field(t('dem_nodata'), nodata)),
    h('div', {class: 'row'}, send, progress), report.element, h('h3', {}, t('dem_known')), list);
}
