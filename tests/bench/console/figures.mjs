// What the measuring scripts share.

import { existsSync, readFileSync } from 'node:fs';

export const say = (name, value) => console.log(`${name} ${value}`);
export const mean = (values) => values.reduce((a, b) => a + b, 0) / values.length;
export const p99 = (values) => values.toSorted((a, b) => a - b)[Math.min(values.length - 1, Math.floor(values.length * 0.99))];
export const pause = (ms) => new Promise((later) => setTimeout(later, ms));

// The n-th that the console said, as soon as it has.
export async function addressOf(file, n) {
  while (true) {
    const lines = existsSync(file) ? readFileSync(file, 'utf8').split('\n') : [];
    if (lines.length > n) return lines[n - 1];
    await pause(50);
  }
}
