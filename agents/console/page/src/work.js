// What happened in the last minutes or hours, until now or until the moment that is shown: the picture, and below it
// what was opened in it.

import { clipped, clock, eachFrame, element } from './dom.js';
import { fact } from './live_answers.js';
import { toldBy } from './provenance.js';
import { entryMarks, goalMarks, refusalMarks, servoMarks, sightingMarks } from './work_marks.js';
import { WorkPicture } from './work_picture.js';

const spans = [
  ['10 minutes', 600e6],
  ['1 hour', 3600e6],
  ['8 hours', 8 * 3600e6],
];
const mostChanges = 2000; // of the servo, and of what is in sight
const mostOpened = 20;
const goesOn = 5000; // ms between two drawings of a time in which nothing happens

// While the page is open, a state of the servo and how long it lasted.
function servoChanges(connection, changed) {
  const changes = [];
  connection.follow('(servo ?state ?object ?x ?y ?d)', (answers) => {
    if (connection.moment !== null) return;
    const last = changes.at(-1);
    const [answer] = answers;
    const same = answer && last && !last.ended && fact(last.answer)[1] === fact(answer)[1];
    if (last && !last.ended) last.until = answer ? answer.facts[0].when : last.until;
    if (same) return changed();
    if (last) last.ended = true;
    if (answer) changes.push({ answer, until: answer.facts[0].when, ended: false });
    if (changes.length > mostChanges) changes.shift();
    changed();
  });
  return changes;
}

// What came into sight and went, as far as the page was told of it.
function sightChanges(connection, changed) {
  const changes = new Map();
  connection.follow('(tracked ?eyes ?name ?state ?frame ?confidence)', (answers) => {
    for (const answer of answers) changes.set(answer.ids[0], answer);
    for (const id of [...changes.keys()].slice(0, Math.max(0, changes.size - mostChanges))) changes.delete(id);
    changed();
  });
  return changes;
}

// `entryOf` makes the story's entry of a fact of the story.
export function showWork(connection, entries, entryOf) {
  const opened = element('div', { class: 'timeline', id: 'opened', hidden: true });
  const otherOf = ({ answer, label }) =>
    element('details', {}, element('summary', {}, element('time', {}, clock(answer.facts[0].when)), clipped(label)), element('p', { class: 'quiet' }, toldBy(answer.ids[0], answer.facts[0])));
  const open = (marks) => {
    const made = marks.slice(0, mostOpened).map((mark) => (fact(mark.answer)[0].name === 'event' ? entryOf(mark.answer) : otherOf(mark)));
    const more = marks.length > mostOpened ? [element('p', { class: 'quiet' }, `and ${marks.length - mostOpened} more`)] : [];
    const close = element('button', { type: 'button', class: 'small', onclick: () => (opened.hidden = true) }, 'Close');
    opened.replaceChildren(close, ...made, ...more);
    opened.hidden = false;
    made[0].open = true;
  };
  const picture = new WorkPicture(open);
  const choice = element(
    'select',
    { 'aria-label': 'How much of the past' },
    ...spans.map(([name, length]) => element('option', { value: length, selected: name === '1 hour' }, name)),
  );

  const held = { goals: [], states: [], refusals: [] };
  const draw = eachFrame(() => {
    if (picture.panel.clientWidth === 0) return;
    const until = connection.moment ?? Date.now() * 1000;
    const since = until - Number(choice.value);
    entries.reach(since);
    const marks = [
      ...goalMarks(held.goals, held.states, until),
      ...entryMarks(entries.until(until)),
      ...servoMarks(servo.filter((change) => change.until <= until)),
      ...sightingMarks([...sightings.values()].filter((answer) => answer.facts[0].when <= until)),
      ...refusalMarks(held.refusals),
    ];
    picture.draw(marks, since, until);
  });
  const servo = servoChanges(connection, draw);
  const sightings = sightChanges(connection, draw);
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
    opened,
  );
  return { panel, draw };
}
