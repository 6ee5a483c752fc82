// The map is drawn in the DEM's own coordinate system.

import {Projection, get as known, transform} from 'ol/proj';
import {register} from 'ol/proj/proj4';
import proj4 from 'proj4';
import type {Raster} from '../types';

export function projection_of(raster: Raster): Projection {
  const found = known(raster.crs);
  if (found) return found;
  if (raster.proj4) {
    try {
      proj4.defs(raster.crs, raster.proj4);
      register(proj4);
      const made = known(raster.crs);
      if (made) return made;
    } catch {
      // A projection that proj4js does not know: drawn all the same, without longitude and latitude.
    }
  }
  return new Projection({code: raster.crs, units: 'm'});
}

/** Longitude and latitude; null where the projection is not known. */
export function to_degrees(point: number[], projection: Projection): number[] | null {
  try {
    const degrees = transform(point, projection, 'EPSG:4326');
    return degrees.every(Number.isFinite) ? degrees : null;
  } catch {
    return null;
  }
}
