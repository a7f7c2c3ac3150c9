// The method of the thesis on the running cell, as `./pizarra method --live` has it: Divide, Wrap, Connect, and what is
// wrong.

import { asComponents } from './names.js';
import { drawn, element, failureText } from './dom.js';
import { table } from './tables.js';

/** @import { Connection } from './connection.js' */
/** @import { Child } from './dom.js' */
/** @import { Cell } from './tables.js' */
/** @import { Method, Way } from './messages' */

const seconds = 10;
const size = 560;
const circle = 220;
const box = { width: 104, height: 26 };
const patterns = ['QUERY', 'SEND', 'PUSH', 'EVENT', 'STREAM'];
const longest = 15; // of a name in its box

/** @param {string} name */
const shortened = (name) => (name.length > longest ? `${name.slice(0, longest - 1)}…` : name);

// Components on a circle, an arrow for each connection, each pattern in a lane beside the line between the two.
/** @param {Method} seen */
function graph({ components, connections }) {
  const places = new Map(
    components.map(({ name }, i) => {
      const angle = (2 * Math.PI * i) / components.length - Math.PI / 2;
      return [name, { x: size / 2 + (circle + 10) * Math.cos(angle), y: size / 2 + circle * Math.sin(angle) }];
    }),
  );
  /** @param {Way} way */
  const arrow = ({ from, to, pattern, about }) => {
    const [a, b] = [places.get(from), places.get(to)];
    if (!a || !b) return null;
    const length = Math.max(Math.hypot(b.x - a.x, b.y - a.y), 1);
    const [ux, uy] = [(b.x - a.x) / length, (b.y - a.y) / length];
    const aside = 4 + 5 * patterns.indexOf(pattern);
    const cut = Math.min(box.width / 2 / Math.max(Math.abs(ux), 0.01), box.height / 2 / Math.max(Math.abs(uy), 0.01)) + 4;
    const line = { x1: a.x + ux * cut + uy * aside, y1: a.y + uy * cut - ux * aside, x2: b.x - ux * cut + uy * aside, y2: b.y - uy * cut - ux * aside };
    const title = drawn('title', {}, `${from} ${pattern} ${to}: ${about.join(' ')}`);
    return drawn('line', { ...line, class: `way ${pattern}`, 'marker-end': `url(#end-${pattern})` }, title);
  };
  const markers = patterns.map((pattern) =>
    drawn(
      'marker',
      { id: `end-${pattern}`, markerWidth: 7, markerHeight: 7, refX: 6, refY: 3, orient: 'auto' },
      drawn('path', { d: 'M0,0 L6,3 L0,6 z', class: pattern }),
    ),
  );
  const boxes = [...places].flatMap(([name, { x, y }]) => [
    drawn('rect', { x: x - box.width / 2, y: y - box.height / 2, ...box, rx: 5, class: 'component' }),
    drawn('text', { x, y: y + 4, 'text-anchor': 'middle' }, shortened(name)),
  ]);
  return drawn(
    'svg',
    { class: 'graph', viewBox: `0 0 ${size} ${size}`, role: 'img', 'aria-label': `${components.length} components and ${connections.length} connections` },
    drawn('defs', {}, ...markers),
    ...connections.map(arrow).filter(Boolean),
    ...boxes,
  );
}

/** @type {['physical' | 'performance' | 'abstraction', string][]} */
const marks = [['physical', 'a device'], ['performance', 'a reaction time'], ['abstraction', 'a function']];

/** @param {Method} seen */
function wrapperRows({ components, wrappers }) {
  const wrapped = new Map(wrappers.map((wrapper) => [wrapper.component, wrapper]));
  return components.map((component) => {
    const wrapper = wrapped.get(component.name);
    const reasons = marks.filter(([reason]) => component[reason]).map(([, said]) => said);
    const hides = (wrapper?.abstraction ?? []).map((index) => `${index.wrapped} ${index.operations}/${index.functions} = ${index.i_abstract.toFixed(3)}`);
    return [component.name, reasons.join(', ') || 'none told', wrapper?.offered ?? 0, hides.join('; ') || '–', (wrapper?.parts ?? []).join(' ')];
  });
}

/** @param {Method} seen */
function connectionRows({ connections }) {
  return connections.map((one) => [
    `${one.from} → ${one.to}`,
    one.pattern,
    one.count,
    one.p50_ms ? `${one.p50_ms.toFixed(1)} / ${one.p99_ms.toFixed(1)}` : '–',
    one.about.join(' '),
    one.remark || (one.recommended === one.pattern ? 'as the tables have it' : one.recommended),
  ]);
}

/** @param {string} name @param {Child[]} children */
function section(name, ...children) {
  return element('section', { 'aria-label': name }, element('h2', {}, name), ...children);
}

/** @param {string} id @param {string[]} heads @param {Cell[][]} rows */
function filled(id, heads, rows) {
  const made = table({ id }, heads);
  made.fill(rows);
  return element('div', { class: 'scroll', tabindex: 0, role: 'group', 'aria-label': heads[0] }, made.panel);
}

/** @param {Method} seen */
function report(seen) {
  const { i_cpx: cpx, i_struct: struct, i_cnx: cnx } = seen;
  const scales = seen.scales.map(({ subscribers, p50_ms: ms }) => `${subscribers}: ${ms.toFixed(2)} ms`).join(', ');
  return [
    section(
      'Divide',
      element('p', { id: 'indices' }, `I_cpx ${cpx.toFixed(3)}, I_struct ${struct.toFixed(3)}, I_cnx ${cnx.toFixed(3)}`),
      graph(seen),
      element('p', { class: 'quiet' }, 'QUERY blue, SEND violet, PUSH green, EVENT orange, STREAM grey.'),
    ),
    section('Wrap', filled('wrappers', ['Component', 'Is one for', 'Operations', 'I_abstract', 'Parts of a wrapper'], wrapperRows(seen))),
    section('Connect', filled('connections', ['Connection', 'Pattern', 'Times', 'ms p50 / p99', 'About', 'The tables say'], connectionRows(seen))),
    section(
      'What is wrong',
      seen.faults.length
        ? filled('faults', ['Fault', 'Of', 'Why'], seen.faults.map((fault) => [fault.symbol, fault.subject, fault.sentence]))
        : element('p', {}, 'no fault was found'),
      scales && element('p', { class: 'quiet' }, `A fact reaches so many readers: ${scales}.`),
    ),
  ];
}

// As people call them.
/** @param {Method} seen @param {string} me @returns {Method} */
const withPagesNamed = (seen, me) => JSON.parse(JSON.stringify(seen), (_, value) => (typeof value === 'string' ? asComponents(value, me) : value));

/** @param {Connection} connection @param {() => string} me */
export function showMethod(connection, me) {
  const note = element('span', { class: 'quiet', role: 'status', id: 'method-note' });
  const seen = element('div', { id: 'method' });
  const button = element('button', { type: 'button', id: 'method-look' }, `Look for ${seconds} s`);
  button.addEventListener('click', async () => {
    button.disabled = true;
    note.textContent = 'looking at who asks, answers, tells and watches …';
    try {
      const found = withPagesNamed(await connection.method(seconds), me());
      seen.replaceChildren(...report(found).filter(Boolean));
      note.textContent = `seen for ${found.seconds} s`;
    } catch (failure) {
      note.textContent = failureText(failure);
    }
    button.disabled = false;
  });
  return element('details', { class: 'goals' }, element('summary', {}, 'The method: Divide, Wrap, Connect'), element('div', { class: 'row' }, button, note), seen);
}
