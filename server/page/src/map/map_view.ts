// The map: hillshade, what is drawn, and a job's sections and zones.

import Feature, {type FeatureLike} from 'ol/Feature';
import OlMap from 'ol/Map';
import View from 'ol/View';
import {defaults as default_controls} from 'ol/control/defaults';
import ScaleLine from 'ol/control/ScaleLine';
import {getCenter, isEmpty} from 'ol/extent';
import type Geometry from 'ol/geom/Geometry';
import LineString from 'ol/geom/LineString';
import MultiPolygon from 'ol/geom/MultiPolygon';
import Point from 'ol/geom/Point';
import Polygon from 'ol/geom/Polygon';
import Draw from 'ol/interaction/Draw';
import {defaults as default_interactions} from 'ol/interaction/defaults';
import Modify from 'ol/interaction/Modify';
import ImageLayer from 'ol/layer/Image';
import VectorImageLayer from 'ol/layer/VectorImage';
import VectorLayer from 'ol/layer/Vector';
import type Projection from 'ol/proj/Projection';
import ImageStatic from 'ol/source/ImageStatic';
import VectorSource from 'ol/source/Vector';
import {blob} from '../api';
import {type ColourBy, type Entry, colour_sections} from '../colours';
import type {JobMap, ProbabilityZone, Raster, XY, Zone} from '../types';
import {projection_of, to_degrees} from './projection';
import {
  SectionStyles, chosen_style, drawn_style, laid_style, left_out_style, point_style, probability_style, zone_outlines,
  zone_styles,
} from './styles';

type Source = VectorSource<Feature<Geometry>>;
export type ZoneLayerName = 'release' | 'runout' | 'release_probability' | 'runout_probability';
export type LayerName = 'hillshade' | 'sections' | ZoneLayerName;
export type DrawKind = 'along' | 'section' | 'region';

/** Something drawn by hand: a line of the layout, or an area of a soil. */
export interface Drawn {
  id: string;
  kind: DrawKind;
  name: string;
  points: XY[];
}

type Layer = VectorLayer | VectorImageLayer | ImageLayer<ImageStatic>;

/** More sections are drawn into a picture that is moved, and drawn anew when the map has come to rest. */
const most_drawn_in_motion = 1500;

/** Names show while they have room: few sections, or a close look. */
const most_names = 60;

function polygons_of(zones: readonly Zone[]): Feature<Geometry>[] {
  return zones.map((zone) => new Feature<Geometry>({geometry: new MultiPolygon(zone.polygons), zone}));
}

export class MapView {
  readonly map: OlMap;
  private readonly hillshade = new ImageLayer<ImageStatic>();
  private readonly sources: Record<ZoneLayerName | 'sections', Source> = {
    release: new VectorSource(), runout: new VectorSource(), release_probability: new VectorSource(),
    runout_probability: new VectorSource(), sections: new VectorSource(),
  };
  private readonly drawn: Source = new VectorSource();
  private readonly modify = new Modify({source: this.drawn as VectorSource});
  private readonly laid: Source = new VectorSource();
  private readonly chosen: Source = new VectorSource();
  private readonly layers = new Map<LayerName, Layer>();
  private readonly many_sections: VectorImageLayer;
  private readonly job_layers: Layer[];
  private readonly draft_layers: VectorLayer[];
  private projection: Projection | undefined;
  private raster_id = '';
  private hillshade_url = '';
  private colours: Entry[] = [];
  private names: string[] = [];
  private drawing: Draw | null = null;
  private draws_now = false;

  on_pick: (name: string) => void = () => undefined;
  on_drawn_change: (drawn: Drawn) => void = () => undefined;
  on_pointer: (at: XY | null, degrees: number[] | null) => void = () => undefined;

  constructor(target: HTMLElement) {
    const styles = new SectionStyles();
    const of_section = (feature: FeatureLike, resolution: number) => {
      const i = feature.get('i') as number;
      const named = this.names.length <= most_names || resolution < 0.2;
      return styles.of(this.colours[i]!, named ? this.names[i]! : null);
    };
    const sections = new VectorLayer({source: this.sources.sections, style: of_section, declutter: true});
    this.many_sections = new VectorImageLayer({style: of_section, declutter: true, imageRatio: 1.5});
    const zones = (kind: 'release' | 'runout') => new VectorLayer({source: this.sources[kind],
      style: () => (this.has_probability ? zone_outlines : zone_styles)[kind]});
    const probability = (name: 'release_probability' | 'runout_probability') => new VectorLayer({
      source: this.sources[name], opacity: 0.8,
      style: (feature) => probability_style(feature.get('zone') as ProbabilityZone),
    });
    this.layers.set('hillshade', this.hillshade).set('runout_probability', probability('runout_probability'))
      .set('release_probability', probability('release_probability'))
      .set('release', zones('release')).set('runout', zones('runout')).set('sections', sections);
    this.job_layers = [...this.layers.values()].filter((layer) => layer !== this.hillshade);
    const laid = new VectorLayer({
      source: this.laid, style: (feature) => (feature.get('reason') ? left_out_style : laid_style),
    });
    const drawn = new VectorLayer({source: this.drawn, style: (feature) => drawn_style(feature as Feature)});
    this.draft_layers = [laid, drawn];
    this.map = new OlMap({
      target,
      controls: default_controls({attribution: false, rotate: false}).extend([new ScaleLine()]),
      // A double click ends a line that is drawn.
      interactions: default_interactions({doubleClickZoom: false, altShiftDragRotate: false, pinchRotate: false}),
      layers: [
        ...this.layers.values(), this.many_sections, laid, drawn,
        new VectorLayer({source: this.chosen, style: (feature) => feature.get('style') ?? chosen_style}),
      ],
    });
    this.listen();
  }

  private listen(): void {
    this.map.on('singleclick', (event) => {
      if (this.draws_now) return;
      const name = this.near(event.coordinate as XY);
      if (name !== undefined) this.on_pick(name);
    });
    this.map.on('pointermove', (event) => {
      if (event.dragging || !this.projection) return;
      const at = event.coordinate as XY;
      this.on_pointer(at, to_degrees(at, this.projection));
    });
    this.map.getViewport()!.addEventListener('pointerleave', () => this.on_pointer(null, null));
    this.modify.on('modifyend', (event) => event.features.forEach((feature) => this.tell_drawn(feature as Feature)));
    this.map.addInteraction(this.modify);
  }

  /** The name of what runs within some pixels of a point, by its geometry: no canvas is read back. */
  private near(at: XY): string | undefined {
    const reach = 8 * this.map.getView()!.getResolution()!;
    for (const source of this.side === 'job' ? [this.sources.sections] : [this.drawn, this.laid]) {
      const found = source.getClosestFeatureToCoordinate(at, (feature) => feature.get('pick') !== undefined);
      const [x, y] = found?.getGeometry()?.getClosestPoint(at) ?? [Infinity, Infinity];
      if (Math.hypot(x! - at[0], y! - at[1]) <= reach) return found!.get('pick') as string;
    }
    return undefined;
  }

  private tell_drawn(feature: Feature): void {
    const geometry = feature.getGeometry() as LineString;
    const points = geometry.getCoordinates() as unknown as XY[] & XY[][];
    const kind = feature.get('kind') as DrawKind;
    this.on_drawn_change({
      id: feature.get('id') as string, kind, name: feature.get('name') as string,
      points: kind === 'region' ? (points[0] as unknown as XY[]).slice(0, -1) : points,
    });
  }

  /** Puts a DEM under the map and looks at all of it. Nothing changes where it lies there already. */
  async show_raster(raster: Raster | null): Promise<void> {
    if (!raster || raster.id === this.raster_id) return;
    this.raster_id = raster.id;
    const projection = projection_of(raster);
    this.projection = projection;
    this.map.setView(new View({
      projection, center: getCenter(raster.bbox), extent: grown(raster.bbox, 0.6), showFullExtent: true,
      minResolution: 0.02, constrainOnlyCenter: true,
    }));
    this.fit(raster.bbox);
    const picture = await blob(`rasters/${raster.id}/hillshade.png`);
    if (raster.id !== this.raster_id) return;
    URL.revokeObjectURL(this.hillshade_url);
    this.hillshade_url = URL.createObjectURL(picture);
    this.hillshade.setSource(new ImageStatic({
      url: this.hillshade_url, imageExtent: raster.bbox, projection, interpolate: true,
    }));
  }

  fit(box: number[], most_resolution = 0.1): void {
    this.map.getView()!.fit(box, {padding: [40, 40, 40, 40], minResolution: most_resolution});
  }

  show_drawn(drawn: readonly Drawn[]): void {
    this.drawn.clear(true);
    this.drawn.addFeatures(drawn.map(({id, kind, name, points}) => {
      const geometry = kind === 'region'
        ? new Polygon([[...points, points[0]!]])
        : new LineString(points);
      return new Feature<Geometry>({geometry, id, kind, name, pick: kind === 'section' ? name : undefined});
    }));
  }

  show_laid(laid: readonly {name: string; trace: XY[]; reason?: string}[]): void {
    this.laid.clear(true);
    this.laid.addFeatures(laid.map(({name, trace, reason}) =>
      new Feature<Geometry>({geometry: new LineString(trace), pick: name, reason})));
  }

  private has_probability = false;

  /** Looks at all sections of a job the first time it shows; those of a case lie nowhere on the map. */
  private fit_to_job(job: JobMap): void {
    const box = this.sources.sections.getExtent()!;
    if (job.job === this.fitted_to || isEmpty(box)) return;
    this.fitted_to = job.job;
    this.fit(box);
  }
  private fitted_to = '';

  show_job(job: JobMap | null, by: ColourBy): void {
    for (const source of Object.values(this.sources)) source.clear(true);
    if (!job) return;
    this.colours = colour_sections(job, by).of;
    this.names = job.sections.name;
    this.sources.sections.addFeatures(job.sections.trace.map((trace, i) =>
      new Feature<Geometry>({geometry: new LineString(trace), pick: this.names[i], i})));
    const many = this.names.length > most_drawn_in_motion;
    (this.layers.get('sections') as VectorLayer).setSource(many ? null : this.sources.sections);
    this.many_sections.setSource(many ? this.sources.sections : null);
    this.fit_to_job(job);
    this.has_probability = job.probability_zones.length > 0;
    this.sources.release.addFeatures(polygons_of(job.release_zones));
    this.sources.runout.addFeatures(polygons_of(job.runout_zones));
    // The likelier areas lie within the others and are drawn over them.
    const nested = [...job.probability_zones].sort((a, b) => a.exceedance - b.exceedance);
    for (const kind of ['release', 'runout'] as const) {
      this.sources[`${kind}_probability`].addFeatures(polygons_of(nested.filter((zone) => zone.kind === kind)));
    }
  }

  recolour(job: JobMap, by: ColourBy): void {
    this.colours = colour_sections(job, by).of;
    this.sources.sections.changed();
  }

  /** A job's layers, or what is drawn for the next one. */
  show_side(side: 'draft' | 'job'): void {
    for (const layer of this.job_layers) layer.setVisible(side === 'job' && !this.hidden.has(layer));
    for (const layer of this.draft_layers) layer.setVisible(side === 'draft');
    this.many_sections.setVisible(this.layers.get('sections')!.getVisible());
    this.modify.setActive(side === 'draft');
    this.side = side;
    this.choose(null);
  }
  private side: 'draft' | 'job' = 'draft';
  private readonly hidden = new Set<unknown>();

  set_visible(name: LayerName, visible: boolean): void {
    const layer = this.layers.get(name)!;
    if (visible) this.hidden.delete(layer);
    else this.hidden.add(layer);
    layer.setVisible(visible && (layer === this.hillshade || this.side === 'job'));
    this.many_sections.setVisible(this.layers.get('sections')!.getVisible());
  }

  /** Marks a trace, with points of its crest and toe. */
  choose(trace: readonly XY[] | null, points: readonly {at: XY; colour: string}[] = []): void {
    this.chosen.clear(true);
    if (!trace) return;
    this.chosen.addFeature(new Feature<Geometry>({geometry: new LineString(trace as XY[])}));
    this.chosen.addFeatures(points.map(({at, colour}) =>
      new Feature<Geometry>({geometry: new Point(at), style: point_style(colour)})));
  }

  /** Lets the user draw one line or area. */
  draw(kind: DrawKind, done: (points: XY[]) => void): void {
    this.stop_drawing();
    const type = kind === 'region' ? 'Polygon' : 'LineString';
    this.drawing = new Draw({type, maxPoints: kind === 'section' ? 2 : undefined});
    this.draws_now = true;
    this.drawing.on('drawend', (event) => {
      const geometry = event.feature.getGeometry() as LineString;
      const points = geometry.getCoordinates() as unknown as XY[] & XY[][];
      this.stop_drawing();
      done(kind === 'region' ? (points[0] as unknown as XY[]).slice(0, -1) : points);
    });
    this.map.addInteraction(this.drawing);
  }

  stop_drawing(): void {
    if (this.drawing) this.map.removeInteraction(this.drawing);
    this.drawing = null;
    // The click that ended it is still on its way to `singleclick`.
    setTimeout(() => (this.draws_now = this.drawing !== null), 400);
  }

  /** What the map shows now, as the address of a PNG. */
  picture(): string {
    const canvas = document.createElement('canvas');
    const [width, height] = this.map.getSize() ?? [1, 1];
    canvas.width = width!;
    canvas.height = height!;
    const to = canvas.getContext('2d')!;
    to.fillStyle = '#ffffff';
    to.fillRect(0, 0, canvas.width, canvas.height);
    for (const from of this.map.getViewport()!.querySelectorAll<HTMLCanvasElement>('.ol-layer canvas')) {
      if (from.width > 0) to.drawImage(from, 0, 0, canvas.width, canvas.height);
    }
    return canvas.toDataURL('image/png');
  }
}

function grown(box: readonly number[], share: number): number[] {
  const dx = (box[2]! - box[0]!) * share;
  const dy = (box[3]! - box[1]!) * share;
  return [box[0]! - dx, box[1]! - dy, box[2]! + dx, box[3]! + dy];
}
