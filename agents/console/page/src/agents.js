// Who is there, how busy each is, and what it offers; the processes; who serves whom; whom the board refused what; the
// method.

import { clipped, element, find } from './dom.js';
import { asComponents } from './names.js';
import { fact } from './live_answers.js';
import { showMethod } from './method.js';
import { showProcesses } from './processes.js';
import { showRefusals } from './refusals.js';
import { showServed } from './served.js';
import { text, write } from './datum.js';

/** @import { Activity } from './activity.js' */
/** @import { Connection } from './connection.js' */
/** @import { Activity as Sample, Form } from './messages' */

/** @typedef {NonNullable<Sample['agents']>[number]} Load */
/** @param {Load | undefined} agent @param {number | undefined} restarts */
function load(agent, restarts) {
  const busy = agent ? `${agent.told_per_second.toFixed(1)} told/s, ${agent.waiting} waiting, ${agent.queued} queued` : '';
  const again = restarts === undefined ? '' : `${restarts} restart${restarts === 1 ? '' : 's'}`;
  return [busy, again].filter(Boolean).join(', ');
}

/** @param {Connection} connection @param {Activity} activity @param {() => string} me */
export function showAgents(connection, activity, me) {
  const list = element('div', { class: 'timeline' });
  /** @type {Map<string, Form>} */
  const contracts = new Map();
  const rows = new Map(); // by name, so that what is open stays open
  /** @type {Form[]} */
  let present = [];
  /** @type {Map<string, Load>} */
  let busy = new Map();
  /** @param {string} name */
  const rowOf = (name) => {
    if (rows.has(name)) return rows.get(name);
    const who = element('span', { class: 'quiet' });
    const does = element('span', { class: 'quiet load' });
    const offers = element('pre', {});
    const label = element('strong', { title: name });
    const made = element('details', { 'data-agent': name }, element('summary', {}, label, who, does), offers);
    rows.set(name, { made, label, who, does, offers });
    return rows.get(name);
  };
  const draw = () => {
    const names = present.slice(0, 64).map((agent) => {
      const name = text(agent[1]);
      const { label, who, does, offers } = rowOf(name);
      label.textContent = clipped(asComponents(name, me()), 64);
      who.textContent = `${text(agent[2])} on ${clipped(text(agent[3]), 64)}`;
      does.textContent = load(busy.get(name), processes.restarts.get(name));
      const form = contracts.get(name);
      offers.textContent = form ? clipped(form.map(write).join('\n'), 6000) : 'it told no contract';
      return name;
    });
    for (const name of rows.keys()) if (!names.includes(name)) rows.delete(name);
    list.replaceChildren(...names.map((name) => rows.get(name).made));
  };
  const processes = showProcesses(connection, () => draw());
  find('agents').append(list, processes.panel, showRefusals(connection, activity, me), showServed(connection), showMethod(connection, me));
  activity.shownIn(list, (sample) => {
    busy = new Map((sample?.agents ?? []).map((agent) => [agent.name, agent]));
    draw();
  });
  connection.follow('(agent ?name ?kind ?host)', (answers) => {
    present = answers.map(fact).sort((a, b) => text(a[1]).localeCompare(text(b[1])));
    draw();
  });
  connection.follow('(contract ?name ?form)', (answers) => {
    contracts.clear();
    for (const [, name, form] of answers.map(fact)) contracts.set(text(name), form.filter(Array.isArray));
    draw();
  });
}
