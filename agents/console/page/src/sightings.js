// What the eyes say of each object: in their newest look, and of what they do not look for, when it was found last.
//
//   const seen = sightingsIn(looks, found);
//   seen.get('circle')      { state, confidence, range, spread, covariance }; what is not told is undefined
//
// Where several eyes tell of an object, the surest count. `covariance` is that of its place in the frame of the eyes
// (camera_frame.js): xx xy xz yy yz zz.

import { fact } from './live_answers.js';
import { text } from './datum.js';

// Of the upper triangle, row by row, of a place and a turn: what concerns the place.
const ofPlace = [0, 1, 2, 6, 7, 11];
const inTriangle = 21;

function partsIn(parts) {
  const part = (name) => parts.find((one) => Array.isArray(one) && text(one[0]) === name) ?? [];
  const [, range, spread] = part('range');
  const triangle = part('pose')[7];
  const told = Array.isArray(triangle) && triangle.length === inTriangle && triangle.every(Number.isFinite);
  return { range, spread, covariance: told ? ofPlace.map((i) => triangle[i]) : undefined };
}

function addSurest(seen, name, sighting) {
  const known = seen.get(name);
  if (!known || (known.confidence ?? 0) < (sighting.confidence ?? 0)) seen.set(name, sighting);
}

export function sightingsIn(looks, found) {
  const seen = new Map();
  for (const [, , , , objects] of looks.map(fact)) {
    for (const [name, state, ...parts] of objects) {
      const confidence = typeof parts[0] === 'number' ? parts[0] : undefined;
      addSurest(seen, text(name), { state: text(state), confidence, ...partsIn(parts) });
    }
  }
  const lookedFor = new Set(seen.keys());
  for (const [, , name, , confidence, , , , places] of found.map(fact)) {
    if (!lookedFor.has(text(name))) addSurest(seen, text(name), { state: 'found', confidence, ...partsIn(places) });
  }
  return seen;
}
