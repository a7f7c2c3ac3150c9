// How far an object may be off its place: the ellipsoid of twice its standard deviations, fifty times enlarged. Where the
// eyes tell a pose with its covariance it is that of the place; where they tell a distance alone it is thin, and lies
// along the line of sight.

import { Matrix4, Mesh, MeshBasicMaterial, SphereGeometry, Vector3 } from 'three';

/** @import { Frame } from './camera_frame.js' */
/** @import { Sighting } from './sightings.js' */

const enlarged = 50;
const deviations = 2;
const scale = enlarged * deviations;
const thin = 0.04; // mm, of what is not known
const ball = new SphereGeometry(1, 20, 14);
const colour = new MeshBasicMaterial({ color: 0x6cc0ff, depthTest: false, transparent: true, opacity: 0.75 });

/** @template T @typedef {[x: T, y: T, z: T]} Columns */

// Columns L with L L' = C (Cholesky): the unit sphere becomes the ellipsoid of C. Null where C is no covariance.
/** @param {number[]} covariance @returns {Columns<number[]> | null} */
function rootOf([xx, xy, xz, yy, yz, zz]) {
  const a = Math.sqrt(xx);
  const [b, c] = [xy / a, xz / a];
  const d = Math.sqrt(yy - b * b);
  const e = (yz - b * c) / d;
  const f = Math.sqrt(zz - c * c - e * e);
  return [a, d, f].every((root) => root > 0) ? [[a, b, c], [0, d, e], [0, 0, f]] : null;
}

// The columns in the cell's frame; null where nothing is known.
/** @param {Sighting} sighting @param {Frame} frame @param {Vector3} place @returns {Columns<Vector3> | null} */
function shapeOf({ spread, covariance }, { eye, right, down, ahead }, place) {
  const root = covariance && rootOf(covariance);
  if (root) {
    /** @param {number[]} column */
    const turned = ([x, y, z]) => new Vector3().addScaledVector(right, x).addScaledVector(down, y).addScaledVector(ahead, z);
    return [turned(root[0]), turned(root[1]), turned(root[2])];
  }
  if (spread === undefined || !(spread > 0)) return null;
  const sight = new Vector3().subVectors(place, eye).normalize();
  const beside = new Vector3().crossVectors(sight, down).normalize();
  const under = new Vector3().crossVectors(sight, beside);
  return [sight.multiplyScalar(spread), beside.multiplyScalar(thin), under.multiplyScalar(thin)];
}

export class SpreadFigure {
  mesh = new Mesh(ball, colour);

  constructor() {
    this.mesh.matrixAutoUpdate = false;
    this.mesh.visible = false;
  }

  // `sighting` (sightings.js) of what stands at `place`, seen from `frame` (camera_frame.js); any of them may be missing.
  /** @param {Sighting | undefined} sighting @param {Frame | null} frame @param {Vector3 | null} place */
  show(sighting, frame, place) {
    const shape = sighting && frame && place ? shapeOf(sighting, frame, place) : null;
    this.mesh.visible = shape !== null;
    if (!shape) return;
    const [x, y, z] = shape;
    this.mesh.matrix = new Matrix4().makeBasis(x, y, z).scale(new Vector3(scale, scale, scale));
    this.mesh.matrixWorldNeedsUpdate = true;
  }
}
