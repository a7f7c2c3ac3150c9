// Hours of work in one picture: a lane for each kind of thing that happened, time to the right. A mark is pressed by
// pointer, or found with the arrow keys and opened with Enter.
//
//   const picture = new WorkPicture((marks) => ...);     // who is told of what was opened
//   picture.draw(marks, since, until);                   // microseconds

import { clipped, clock, drawn } from './dom.js';
import { gathered, lanes } from './work_marks.js';

/** @import { Group, Mark } from './work_marks.js' */

const gutter = 76;
const laneHeight = 19;
const axisHeight = 18;
const narrowest = 5;
const halfTime = 24; // of the width of what a tick says
const second = 1e6;
const minute = 60 * second;
const steps = [30 * second, ...[1, 2, 5, 10, 20, 60, 120].map((minutes) => minutes * minute)];

// With its seconds where the steps are as short.
/** @param {number} moment @param {number} step */
const timeOf = (moment, step) => (step < minute ? clock(moment) : clock(moment).slice(0, 5));

/** @param {Group} group */
function labelOf({ lane, marks, from }) {
  const more = marks.length > 1 ? ` and ${marks.length - 1} more` : '';
  return `${lane}, ${clock(from)}: ${clipped(marks[0].label, 160)}${more}`;
}

/** @typedef {{ made: SVGRectElement, title: SVGTitleElement, group: Group }} Shown */
/** A mark beside this one, or in the lane above or below.
 * @type {Record<string, [beside: number, below: number]>} */
const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export class WorkPicture {
  #opened;
  #ground = drawn('g', {});
  #marks = drawn('g', {});
  /** @type {Map<string, Shown>} */
  #shown = new Map(); // by what each group is, so that what is focused or pressed stays the same element
  #focused = '';
  panel;

  /** @param {(marks: Mark[]) => void} opened */
  constructor(opened) {
    this.#opened = opened;
    const height = axisHeight + lanes.length * laneHeight;
    this.panel = drawn('svg', { id: 'work', height, width: '100%', role: 'group', 'aria-label': 'What happened, over time' }, this.#ground, this.#marks);
    this.panel.addEventListener('keydown', (event) => this.#key(event));
  }

  /** @param {Mark[]} marks @param {number} since @param {number} until */
  draw(marks, since, until) {
    const width = Math.max(this.panel.clientWidth - gutter - 4, 100);
    /** @param {number} moment */
    const at = (moment) => gutter + (width * (Math.min(Math.max(moment, since), until) - since)) / (until - since);
    const seen = marks.filter((mark) => mark.until >= since && mark.from <= until);
    const groups = gathered(seen, (narrowest * (until - since)) / width);
    this.#drawGround(at, width, since, until);
    const named = new Map(groups.map((group) => [`${group.lane} ${group.kind} ${group.from}`, group]));
    for (const [name, { made }] of this.#shown) {
      if (named.has(name)) continue;
      made.remove();
      this.#shown.delete(name);
    }
    for (const [name, group] of named) this.#place(name, group, at);
    this.#giveFocus();
  }

  /** @param {(moment: number) => number} at @param {number} width @param {number} since @param {number} until */
  #drawGround(at, width, since, until) {
    const step = steps.find((each) => (until - since) / each <= 8) ?? steps[steps.length - 1];
    const ticks = [];
    for (let moment = Math.ceil(since / step) * step; moment <= until; moment += step) ticks.push(moment);
    const bottom = axisHeight + lanes.length * laneHeight;
    this.#ground.replaceChildren(
      ...lanes.map((lane, i) => drawn('text', { x: 0, y: axisHeight + i * laneHeight + 13, class: 'lane' }, lane)),
      ...lanes.map((_, i) =>
        drawn('rect', { x: gutter, y: axisHeight + i * laneHeight + 1, width, height: laneHeight - 2, class: 'lane' }),
      ),
      ...ticks.map((moment) => drawn('line', { x1: at(moment), x2: at(moment), y1: axisHeight, y2: bottom, class: 'tick' })),
      ...ticks.filter((moment) => at(moment) < gutter + width - halfTime).map((moment) => drawn('text', { x: at(moment), y: 12, class: 'tick' }, timeOf(moment, step))),
    );
  }

  /** @param {string} name @param {Group} group @param {(moment: number) => number} at */
  #place(name, group, at) {
    const shown = this.#shown.get(name) ?? this.#add(name, group);
    shown.group = group;
    shown.title.textContent = labelOf(group);
    const { made } = shown;
    const x = at(group.from);
    made.setAttribute('x', String(x));
    made.setAttribute('y', String(axisHeight + lanes.indexOf(group.lane) * laneHeight + 3));
    made.setAttribute('width', String(Math.max(at(group.until) - x, narrowest)));
    made.setAttribute('aria-label', labelOf(group));
  }

  /** @param {string} name @param {Group} group */
  #add(name, group) {
    const title = drawn('title', {});
    const made = drawn('rect', { height: laneHeight - 6, rx: 2, role: 'button', tabindex: -1, class: `mark ${group.kind}`, 'data-lane': group.lane }, title);
    made.addEventListener('click', () => this.#open(name));
    made.addEventListener('focus', () => {
      this.#focused = name;
      this.#giveFocus();
    });
    this.#marks.append(made);
    const shown = { made, title, group };
    this.#shown.set(name, shown);
    return shown;
  }

  /** @param {string} name */
  #open(name) {
    const shown = this.#shown.get(name);
    if (shown) this.#opened(shown.group.marks);
  }

  // One of them is reached by Tab: the one that was focused last, or the newest.
  #giveFocus() {
    if (!this.#shown.has(this.#focused)) this.#focused = this.#inOrder().at(-1)?.[0] ?? '';
    for (const [name, { made }] of this.#shown) made.setAttribute('tabindex', name === this.#focused ? '0' : '-1');
  }

  #inOrder() {
    return [...this.#shown].sort(([, a], [, b]) => a.group.from - b.group.from);
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const here = this.#shown.get(this.#focused);
    if (!here) return;
    if (event.key === 'Enter' || event.key === ' ') {
      event.preventDefault();
      return this.#open(this.#focused);
    }
    const step = ways[event.key];
    const next = step && (step[0] ? this.#beside(here, step[0]) : this.#above(here, step[1]));
    if (!next) return;
    event.preventDefault();
    next.made.focus();
  }
  /** @param {Shown} here @param {number} step */
  #beside(here, step) {
    const lane = this.#inOrder().filter(([, { group }]) => group.lane === here.group.lane);
    return lane[lane.findIndex(([, shown]) => shown === here) + step]?.[1];
  }
  // The nearest in time, in the next lane that has any.
  /** @param {Shown} here @param {number} step */
  #above(here, step) {
    /** @param {Shown} shown */
    const away = ({ group }) => Math.abs(group.from - here.group.from);
    for (let i = lanes.indexOf(here.group.lane) + step; i >= 0 && i < lanes.length; i += step) {
      const there = [...this.#shown.values()].filter(({ group }) => group.lane === lanes[i]);
      if (there.length) return there.sort((a, b) => away(a) - away(b))[0];
    }
    return undefined;
  }
}
