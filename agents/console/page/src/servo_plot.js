// The visual servo's errors, live: the last twenty seconds.

import uPlot from 'uplot';
import { eachFrame, find } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */

const seconds = 20;
const states = ['up', 'align x', 'align depth', 'approach', 'fine'];

/** @param {Connection} connection */
export function showServo(connection) {
  const box = find('servo-plot');
  /** @type {number[]} */
  const times = [];
  /** @type {number[][]} */
  const errors = [[], [], []];
  const axis = {
    stroke: '#9fb0bd',
    grid: { stroke: '#263642', width: 1 },
    ticks: { show: false },
    font: '11px system-ui',
  };
  /** @param {string} label @param {string} stroke */
  const line = (label, stroke) => ({ label, stroke, width: 1.5, points: { show: false } });
  const plot = new uPlot(
    {
      width: Math.max(box.clientWidth, 120),
      height: 118,
      legend: { show: true, live: false },
      cursor: { show: false },
      scales: { x: { time: false } },
      axes: [
        { ...axis, size: 22, values: (_, at) => at.map((v) => `${v} s`) },
        { ...axis, size: 38 },
      ],
      series: [{}, line('x px', '#4fb3ff'), line('y px', '#7fd18b'), line('d mm', '#f2a33a')],
    },
    [[], [], [], []],
    box,
  );
  new ResizeObserver(() => plot.setSize({ width: Math.max(box.clientWidth, 120), height: 118 })).observe(box);

  const draw = eachFrame(() => {
    const now = times[times.length - 1];
    plot.setData([times.map((time) => Math.round((time - now) * 100) / 100), ...errors]);
  });
  connection.follow('(servo ?state ?object ?x ?y ?d)', (answers) => {
    if (answers.length === 0) {
      find('servo-note').textContent = 'at rest';
      return;
    }
    const [, state, object, ...now] = fact(answers[0]);
    find('servo-note').textContent = `${states[state] ?? state}: ${text(object)}`;
    times.push(answers[0].facts[0].when / 1e6);
    now.forEach((error, i) => errors[i].push(error));
    while (times[0] < times[times.length - 1] - seconds) {
      times.shift();
      for (const series of errors) series.shift();
    }
    draw();
  });
}
