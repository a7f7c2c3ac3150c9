// What is wanted: goals typed, the plan with the operation in hand, and what became of it.

import { clipped, element, failureText, find } from './dom.js';
import { fact } from './live_answers.js';
import { showTowers } from './towers.js';
import { text, write } from './datum.js';

// `done` before the one in hand, its state for that one.
function showPlan(plan, inHand) {
  const list = find('plan');
  list.replaceChildren();
  find('plan-note').textContent = plan ? `for goal ${plan[1]}` : 'none yet';
  if (!plan) return;
  plan[2].forEach((operation, index) => {
    const state = !inHand || index > inHand[1] ? '' : index < inHand[1] ? 'done' : text(inHand[3]);
    const item = element('li', { class: state }, element('code', {}, clipped(write(operation), 80)));
    if (state) item.append(element('span', { class: 'mark' }, state));
    if (state === 'running') item.setAttribute('aria-current', 'step');
    list.append(item);
  });
  // In its own list alone: the page stays where it is.
  const current = list.querySelector('.running');
  if (current) list.scrollTop = current.offsetTop - list.offsetTop - list.clientHeight / 2;
}

export function showWant(connection) {
  const towers = showTowers();
  const answer = find('goal-answer');
  const say = (sentence, kind = '') => {
    answer.hidden = false;
    answer.className = kind;
    answer.textContent = sentence;
  };

  const accepted = async (typed) => {
    say('asking …');
    try {
      const [number] = await connection.goal(typed, (end) => {
        if (end.error) say(failureText(end.error), 'bad');
        else say(`goal ${number} ${end.values[0]}`, end.values[0] === 'reached' ? 'good' : '');
      });
      say(`goal ${number} accepted`);
    } catch (failure) {
      say(failureText(failure), 'bad');
    }
  };
  find('goal-form').addEventListener('submit', (event) => {
    event.preventDefault();
    accepted(find('goal-text').value);
  });
  find('cancel').addEventListener('click', async () => {
    try {
      await connection.request('coordinator', '(cancel)');
    } catch (failure) {
      say(failureText(failure), 'bad');
    }
  });

  let plan;
  let inHand;
  const show = () => showPlan(plan, inHand && plan ? inHand : undefined);
  connection.follow('(plan ?n ?operations)', (answers) => {
    plan = answers.length ? fact(answers[0]) : undefined;
    show();
  });
  connection.follow('(operation ?i ?operation ?state)', (answers) => {
    inHand = answers.length ? fact(answers[0]) : undefined;
    show();
  });

  connection.follow('(goal-state ?n ?state ?detail)', (answers) => {
    const newest = answers.map(fact).reduce((a, b) => (!a || b[1] > a[1] ? b : a), undefined);
    const chip = find('goal-chip');
    chip.hidden = !newest;
    if (!newest) return;
    const state = text(newest[2]);
    chip.textContent = `goal ${newest[1]}: ${state}`;
    chip.className = `chip ${state === 'reached' ? 'good' : state === 'running' ? 'busy' : 'warn'}`;
    find('cancel').disabled = state !== 'running';
  });

  // What may be typed: a pair of what has been learned.
  connection.follow('(learned ?eyes ?name 1 ? ? ? ? ? ?)', (answers) => {
    const names = [...new Set(answers.map((learned) => text(fact(learned)[2])))].slice(0, 12);
    const goals = names.flatMap((a) => names.filter((b) => b !== a).map((b) => `(on ${a} ${b})`));
    towers.setNames(names.filter((name) => name !== 'end-effector'));
    find('goal-words').replaceChildren(...goals.map((goal) => element('option', { value: goal })));
  });
}
