// A report of a job: one HTML file that holds all it shows and prints well.

import {ensemble_of, section_address} from './actions';
import {get, text} from './api';
import {colour_sections, status_word} from './colours';
import {profile_svg} from './drawing/profile_svg';
import {check_rows, condition_words, decider_words, deciders, distances, has_ensemble, percent, quantile_rows,
  summary_rows} from './ensemble/numbers';
import {bounded} from './section/bounds';
import {number_rows, side_of} from './section/panel';
import type {DistanceSummary, Ensemble, JobMap, ProbabilityZone, Raster, SectionDetail, Zone} from './types';
import {show, spoken, t} from './words';

/** Profiles of more would make a file of many megabytes; the table has all sections. */
const most_profiles = 200;

const style = `
body{font:14px/1.45 system-ui,sans-serif;color:#14242a;max-width:60rem;margin:2rem auto;padding:0 1rem}
h1{font-size:1.6rem}h2{font-size:1.2rem;margin-top:2rem;border-bottom:1px solid #b9c6cb}
table{border-collapse:collapse;width:100%;font-size:.85rem}th,td{border:1px solid #b9c6cb;padding:.2rem .45rem;text-align:left}
td.n{text-align:right;font-variant-numeric:tabular-nums}img,svg{max-width:100%;height:auto}
dl{display:grid;grid-template-columns:max-content 1fr;gap:.15rem .8rem;font-size:.85rem}dd{margin:0;overflow-wrap:anywhere}
pre{white-space:pre-wrap;font-size:.75rem;background:#f2f5f6;padding:.6rem}
.box{display:inline-block;width:.8em;height:.8em;margin-right:.4em;border:1px solid #555}
.scope{border-left:4px solid #d55e00;padding-left:.7rem}article{break-inside:avoid;margin-top:1.4rem}
@media print{body{margin:0;max-width:none}h2{break-after:avoid}@page{margin:15mm}}`;

export function escape(value: unknown): string {
  const written = value === null || value === undefined ? '–' : String(value);
  return written.replace(/[&<>"']/g, (one) => `&#${one.charCodeAt(0)};`);
}

function table(head: readonly string[], rows: readonly (readonly string[])[]): string {
  const cell = (content: string) => (/^(≥ |&#62;)?[-+–]?[\d\s.,\u00a0\u202f]*( m| s| %)?$/.test(content)
    ? `<td class="n">${content}</td>` : `<td>${content}</td>`);
  return `<table><thead><tr>${head.map((one) => `<th>${escape(one)}</th>`).join('')}</tr></thead>
<tbody>${rows.map((row) => `<tr>${row.map(cell).join('')}</tr>`).join('\n')}</tbody></table>`;
}

function facts(rows: readonly (readonly [string, string | null])[]): string {
  return `<dl>${rows.filter(([, value]) => value !== null)
    .map(([name, value]) => `<dt>${escape(name)}</dt><dd>${escape(value)}</dd>`).join('')}</dl>`;
}

function section_table(job: JobMap): string {
  const {sections} = job;
  const {of} = colour_sections(job, 'status');
  return table([t('section'), t('status'), `${t('retrogression')}, m`, `${t('runout')}, m`, `${t('run_time')}, s`,
    t('warnings')],
    sections.name.map((name, i) => [
      escape(name),
      `<span class="box" style="background:${of[i]!.colour}"></span>${escape(status_word(sections.status[i]!))}`,
      (sections.retrogression_is[i] === 'lower-bound' ? '≥ ' : '') + show(sections.retrogression_m[i]),
      (sections.runout_is[i] === 'lower-bound' ? '≥ ' : '') + show(sections.runout_m[i]),
      show(sections.run_time_s[i]), show(sections.warnings[i])]));
}

function zone_table(job: JobMap): string {
  const rows = (zones: readonly Zone[], name: string) => zones.map((zone) => [
    escape(name), escape(zone.sections.join(', ')), bounded(zone.largest_distance_m, zone.distance_is),
    bounded(zone.mean_distance_m, null), escape(zone.warnings.join('; ') || '–')]);
  return table([t('zone'), t('report_sections'), t('largest'), t('mean'), t('warnings')],
    [...rows(job.release_zones, t('layer_release')), ...rows(job.runout_zones, t('layer_runout'))]);
}

function probability_table(zones: readonly ProbabilityZone[]): string {
  if (zones.length === 0) return '';
  return `<h3>${escape(t('report_probability'))}</h3>${table([t('zone'), t('report_sections'), t('exceeded_by'), t('members'),
    t('largest'), t('warnings')], zones.map((zone) => [
    escape(t(zone.kind === 'release' ? 'layer_release_probability' : 'layer_runout_probability')),
    escape(zone.sections.join(', ')), percent(zone.exceedance), show(zone.members),
    bounded(zone.largest_distance_m, zone.distance_is), escape(zone.warnings.join('; ') || '–')]))}`;
}

function distance_part(name: string, summary: DistanceSummary): string {
  const decide = [...deciders(summary).map((one): [string, string] => [one.name, decider_words(one)]),
    ...check_rows(summary)];
  return `<h5>${escape(name)}</h5>${table([t('exceeded_by'), t('distance'), t('by_ranks')],
    quantile_rows(summary).map((row) => row.map(escape)))}
<p>${escape(t('decides'))}: ${escape(t('share_of_variance'))}</p>${decide.length > 0 ? facts(decide)
    : `<p>${escape(t('few_members'))}</p>`}`;
}

/** @param drawing SVG of the server, which brings all it shows */
export function ensemble_part(ensemble: Ensemble, drawing: string): string {
  const bytes = new TextEncoder().encode(drawing);
  const packed = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  return `<h4>${escape(t('ensemble'))}</h4><p class="scope">${escape(condition_words(ensemble.condition))}</p>
${facts(summary_rows(ensemble))}<img alt="${escape(t('beyond_retrogression'))}" src="data:image/svg+xml;base64,${packed}">
${distances.map((of) => distance_part(t(of), ensemble[of])).join('\n')}`;
}

async function ensemble_article(job: string, section: string): Promise<string> {
  const ensemble = await ensemble_of(job, section);
  return ensemble ? ensemble_part(ensemble, await text(`${section_address(job, section)}/ensemble?f=svg`)) : '';
}

function article(section: SectionDetail, ensemble: string): string {
  const drawing = section.profile_before.length > 0
    ? profile_svg(side_of(section), {width: 900, height: 260}).outerHTML : `<p>${escape(section.reason)}</p>`;
  const notes = section.warnings.length > 0
    ? `<ul>${section.warnings.map((one) => `<li>${escape(one)}</li>`).join('')}</ul>` : '';
  return `<article><h3>${escape(section.name)}</h3>${drawing}${facts(number_rows(section))}${notes}${ensemble}</article>`;
}

/** @param progress told after every section that was fetched. @throws Problem */
export async function make_report(job: JobMap, raster: Raster | null, map: string,
                                  progress: (done: number, all: number) => void): Promise<string> {
  const names = job.sections.name.slice(0, most_profiles);
  const articles: string[] = [];
  for (const name of names) {
    articles.push(article(await get<SectionDetail>(section_address(job.job, name)),
      has_ensemble(job) ? await ensemble_article(job.job, name) : ''));
    progress(articles.length, names.length);
  }
  const title = t('report_title', {name: job.name || job.job});
  const more = job.sections.name.length > names.length ? `<p>${escape(t('report_only', {count: names.length}))}</p>`
    : '';
  return `<!doctype html>
<html lang="${spoken()}"><head><meta charset="utf-8"><title>${escape(title)}</title><style>${style}</style></head><body>
<h1>${escape(title)}</h1>
<p class="scope">${escape(t('report_scope'))}</p>
${facts([[t('job'), job.job], [t('status'), `${t(job.status)}: ${job.message}`], [t('report_made'),
  new Date().toLocaleString()],
    [t('step_dem'), raster ? `${raster.name}, ${raster.crs}` : null]])}
<h2>${escape(t('report_map'))}</h2><img src="${map}" alt="${escape(t('report_map'))}">
<h2>${escape(t('report_zones'))}</h2>${zone_table(job)}${probability_table(job.probability_zones)}
<h2>${escape(t('report_sections'))}</h2>${section_table(job)}
<h2>${escape(t('report_profiles'))}</h2>${more}${articles.join('\n')}
<h2>${escape(t('report_hashes'))}</h2>${facts([[t('dem_hash'), raster?.sha256 ?? null]])}
<h2>${escape(t('report_settings'))}</h2><pre>${escape(JSON.stringify(job.request, null, 1))}</pre>
</body></html>
`;
}
