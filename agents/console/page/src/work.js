// What happened in the last minutes or hours, until now or until the moment that is shown: the picture, and below it
// what was opened in it.

import { eachFrame, element } from './dom.js';
import { OpenedMarks } from './opened_marks.js';
import { WorkChanges } from './work_changes.js';
import { entryMarks, goalMarks, refusalMarks, servoMarks, sightingMarks } from './work_marks.js';
import { WorkPicture } from './work_picture.js';

/** @import { Connection } from './connection.js' */
/** @import { WorkEntries } from './work_entries.js' */
/** @import { Answer } from './messages' */

/** @type {[name: string, length: number][]} */
const spans = [
  ['2 minutes', 120e6],
  ['10 minutes', 600e6],
  ['1 hour', 3600e6],
  ['8 hours', 8 * 3600e6],
];
const goesOn = 5000; // ms between two drawings of a time in which nothing happens

// `entryOf` makes the story's entry of a fact of the story.
/** @param {Connection} connection @param {WorkEntries} entries @param {(answer: Answer) => HTMLDetailsElement} entryOf */
export function showWork(connection, entries, entryOf) {
  const opened = new OpenedMarks(entryOf);
  const picture = new WorkPicture((marks) => opened.open(marks));
  const choice = element(
    'select',
    { 'aria-label': 'How much of the past' },
    ...spans.map(([name, length]) => element('option', { value: length, selected: name === '10 minutes' }, name)),
  );

  /** @type {Record<'goals' | 'states' | 'refusals', Answer[]>} */
  const held = { goals: [], states: [], refusals: [] };
  const draw = eachFrame(() => {
    if (picture.panel.clientWidth === 0) return;
    const until = connection.moment ?? Date.now() * 1000;
    const since = until - Number(choice.value);
    entries.reach(since);
    const marks = [
      ...goalMarks(held.goals, held.states, until),
      ...entryMarks(entries.until(until)),
      ...servoMarks(changes.servo(until)),
      ...sightingMarks(changes.sightings(until)),
      ...refusalMarks(held.refusals),
    ];
    picture.draw(marks, since, until);
  });
  const changes = new WorkChanges(connection, draw);
  /** @param {string} query @param {'goals' | 'states' | 'refusals'} name */
  const follow = (query, name) =>
    connection.follow(query, (answers) => {
      held[name] = answers;
      draw();
    });
  follow('(goal ?n ?facts)', 'goals');
  follow('(goal-state ?n ?state ?detail)', 'states');
  follow('(board-refusal ?client ?symbol ?count ?sentence)', 'refusals');
  choice.addEventListener('change', draw);
  new ResizeObserver(draw).observe(picture.panel);
  setInterval(draw, goesOn);
  const panel = element(
    'section',
    { 'aria-label': 'Over time' },
    element('div', { class: 'row' }, element('h2', {}, 'Over time'), element('label', {}, 'The last ', choice)),
    picture.panel,
    opened.panel,
  );
  return { panel, draw };
}
