// How things are drawn on the map.

import Feature from 'ol/Feature';
import type Geometry from 'ol/geom/Geometry';
import {Circle, Fill, Stroke, Style, Text} from 'ol/style';
import {type Entry, probability_colour} from '../colours';
import type {ProbabilityZone} from '../types';

const white = 'rgba(255,255,255,0.9)';
const font = '12px system-ui, sans-serif';

function label(text: string): Text {
  return new Text({
    text, font, overflow: true, offsetY: -10, fill: new Fill({color: '#1b1b1b'}),
    stroke: new Stroke({color: white, width: 3}),
  });
}

const zone_strokes = {
  release: new Stroke({color: '#a84300', width: 1.5}),
  runout: new Stroke({color: '#005a8e', width: 1.5, lineDash: [6, 3]}),
};

export const zone_styles = {
  release: new Style({fill: new Fill({color: 'rgba(213,94,0,0.28)'}), stroke: zone_strokes.release}),
  runout: new Style({fill: new Fill({color: 'rgba(0,114,178,0.25)'}), stroke: zone_strokes.runout}),
};

/** Over areas of probability, whose colours must stay what the legend says. */
export const zone_outlines = {
  release: new Style({stroke: zone_strokes.release}), runout: new Style({stroke: zone_strokes.runout}),
};

export function probability_style({kind, exceedance}: ProbabilityZone): Style {
  return new Style({
    fill: new Fill({color: probability_colour(kind, exceedance)}),
    stroke: new Stroke({color: 'rgba(30,30,30,0.65)', width: 0.8}),
  });
}

/** Lines of one colour share a style: a style for each of ten thousand lines is slow. */
export class SectionStyles {
  private readonly made = new Map<string, Style[]>();

  of(entry: Entry, name: string | null): Style[] {
    const key = `${entry.colour}${entry.dashed ? '-' : ''}`;
    let lines = this.made.get(key);
    if (!lines) {
      const lineDash = entry.dashed ? [8, 5] : undefined;
      lines = [new Style({stroke: new Stroke({color: entry.colour, width: 2.5, lineDash})})];
      this.made.set(key, lines);
    }
    return name === null ? lines : [lines[0]!, new Style({text: label(name)})];
  }
}

export const chosen_style = [
  new Style({stroke: new Stroke({color: '#ffffff', width: 8})}),
  new Style({stroke: new Stroke({color: '#111111', width: 3.5})}),
];

export function drawn_style(feature: Feature<Geometry>): Style[] {
  const kind = feature.get('kind') as string;
  const colour = kind === 'along' ? '#0072b2' : kind === 'region' ? '#7b3294' : '#d55e00';
  const line = new Style({
    stroke: new Stroke({color: colour, width: 3}),
    fill: new Fill({color: 'rgba(123,50,148,0.12)'}),
    text: label(String(feature.get('name') ?? '')),
  });
  return [new Style({stroke: new Stroke({color: white, width: 6})}), line];
}

export const laid_style = new Style({stroke: new Stroke({color: 'rgba(20,20,20,0.75)', width: 1.5, lineDash: [5, 4]})});
export const left_out_style = new Style({stroke: new Stroke({color: 'rgba(190,0,0,0.8)', width: 1.5, lineDash: [2,
  4]})});

export function point_style(colour: string): Style {
  return new Style({
    image: new Circle({radius: 5, fill: new Fill({color: colour}), stroke: new Stroke({color: '#ffffff', width: 2})}),
  });
}
