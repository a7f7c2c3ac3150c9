// The visual servo's errors: the last twenty seconds of an approach. Once it is over the curve stays for a look, and the
// note says since when the servo is at rest.

import uPlot from 'uplot';
import { clock, eachFrame, find } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Form } from './messages' */

const seconds = 20;
const legend = 26; // pixels
const serving = ['align', 'lower']; // steps of an operation
const states = ['up', 'align x', 'align depth', 'approach', 'fine'];

const axis = { stroke: '#9fb0bd', grid: { stroke: '#263642', width: 1 }, ticks: { show: false }, font: '11px system-ui' };
/** @param {string} label @param {string} stroke */
const line = (label, stroke) => ({ label, stroke, width: 1.5, points: { show: false } });

// As large as its box.
/** @param {HTMLElement} box */
function makePlot(box) {
  // With the legend below it.
  const size = () => ({ width: Math.max(box.clientWidth, 120), height: Math.min(Math.max(box.clientHeight - legend, 60), 118) });
  const plot = new uPlot(
    {
      ...size(),
      legend: { show: true, live: false },
      cursor: { show: false },
      scales: { x: { time: false, range: [-seconds, 0] } },
      axes: [
        { ...axis, size: 22, values: (_, at) => at.map((v) => `${v} s`) },
        { ...axis, size: 38 },
      ],
      series: [{}, line('x px', '#4fb3ff'), line('y px', '#7fd18b'), line('d mm', '#f2a33a')],
    },
    [[], [], [], []],
    box,
  );
  new ResizeObserver(() => plot.setSize(size())).observe(box);
  return plot;
}

/** @param {Connection} connection */
export function showServo(connection) {
  const box = find('servo-plot');
  const plot = makePlot(box);
  /** @type {number[]} */
  const times = [];
  /** @type {number[][]} */
  const errors = [[], [], []];
  const clear = () => {
    for (const series of [times, ...errors]) series.length = 0;
  };
  const draw = eachFrame(() => {
    const now = times[times.length - 1];
    plot.setData([times.map((time) => Math.round((time - now) * 100) / 100), ...errors]);
    box.classList.toggle('empty', times.length === 0);
  });
  let serves = false;
  /** @type {Form | undefined} */
  let told;
  const say = () => {
    const [, state, object] = told ?? [];
    const since = times.length ? ` since ${clock(times[times.length - 1] * 1e6)}` : '';
    find('servo-note').textContent = serves && told ? `${states[state] ?? state}: ${text(object)}` : `at rest${since}`;
    box.classList.toggle('ended', !serves);
    draw();
  };
  // The fact of the servo stays when an approach is over: the steps that serve say whether one goes on.
  connection.follow('(micro-task ?i ?step ?state)', ([answer]) => {
    const [, , step, state] = answer ? fact(answer) : [];
    serves = text(state) === 'running' && serving.includes(text(step[0]));
    say();
  });
  connection.follow('(servo ?state ?object ?x ?y ?d)', ([answer]) => {
    told = answer && fact(answer);
    if (!answer || !told) return clear(), say();
    const when = answer.facts[0].when / 1e6;
    // Of a moment before.
    if (when < times[times.length - 1]) clear();
    times.push(when);
    told.slice(3).forEach((/** @type {number} */ error, /** @type {number} */ i) => errors[i].push(error));
    while (times[0] < when - seconds) for (const series of [times, ...errors]) series.shift();
    say();
  });
}
