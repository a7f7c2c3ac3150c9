// What the eyes say of each object in their newest look: { state, confidence, range, spread }, by name; what is not told
// is undefined. Where several eyes look, the surest counts.

import { fact } from './live_answers.js';
import { text } from './datum.js';

export function sightingsIn(answers) {
  const seen = new Map();
  for (const [, , , , objects] of answers.map(fact)) {
    for (const [name, state, ...parts] of objects) {
      const confidence = typeof parts[0] === 'number' ? parts[0] : undefined;
      const [, range, spread] = parts.find((part) => Array.isArray(part) && text(part[0]) === 'range') ?? [];
      const known = seen.get(text(name));
      if (known && (known.confidence ?? 0) >= (confidence ?? 0)) continue;
      seen.set(text(name), { state: text(state), confidence, range, spread });
    }
  }
  return seen;
}
