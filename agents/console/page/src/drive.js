// The arm in hand: spring slides that send what they show when they are let go, and the operations that need no number.
// Nothing here moves an arm that is not in these hands: its agent refuses who is not its commander.

import { clipped, element, failureText, find, clock } from './dom.js';
import { read, write } from './datum.js';

const slides = [
  {
    label: 'Retract / extend',
    unit: 'mm',
    most: 100,
    form: (v) => (v > 0 ? `(extend keep-height ${v})` : `(retract ${-v})`),
  },
  { label: 'Turn left / right', unit: '°', most: 45, form: (v) => `(turn ${v > 0 ? 'right' : 'left'} ${Math.abs(v)})` },
  {
    label: 'Move left / right',
    unit: 'mm',
    most: 100,
    form: (v) => `(move-h ${v > 0 ? 'right' : 'left'} ${Math.abs(v)})`,
  },
  { label: 'Move down / up', unit: 'mm', most: 100, form: (v) => `(move-v ${v > 0 ? 'up' : 'down'} ${Math.abs(v)})` },
  { label: 'Tool down / up', unit: '°', most: 45, form: (v) => `(turn-ef ${v > 0 ? 'up' : 'down'} ${Math.abs(v)})` },
  {
    label: 'Wrist left / right',
    unit: '°',
    most: 90,
    form: (v) => `(turn-wrist ${v > 0 ? 'right' : 'left'} ${Math.abs(v)})`,
  },
];

export function showDrive(connection, hands) {
  const panel = find('drive');
  const log = element('ol', { class: 'log', 'aria-label': 'What was sent, newest first' });
  const controls = [];

  const send = async (form) => {
    const item = element('li', {}, element('time', {}, clock(Date.now() * 1000)), element('code', {}, form), ' …');
    log.prepend(item);
    while (log.children.length > 40) log.lastChild.remove();
    try {
      const values = await connection.request(hands.robot, read(form));
      item.lastChild.textContent = ` ${clipped(values.join(' ') || 'ok', 200)}`;
    } catch (failure) {
      item.lastChild.textContent = ` ${failureText(failure)}`;
      item.className = 'bad';
    }
  };
  const button = (label, form) => {
    const made = element('button', { type: 'button', onclick: () => send(form) }, label);
    controls.push(made);
    return made;
  };

  const slide = ({ label, unit, most, form }) => {
    const shown = element('output', {}, `0 ${unit}`);
    const input = element('input', { type: 'range', min: -most, max: most, value: 0, 'aria-label': label });
    const show = () => (shown.textContent = `${input.value} ${unit}`);
    input.addEventListener('input', show);
    input.addEventListener('change', () => {
      const value = Number(input.value);
      input.value = 0;
      show();
      if (value !== 0) send(form(value));
    });
    controls.push(input);
    return element('label', { class: 'slide' }, element('span', {}, label), input, shown);
  };

  // One that stands where it is put.
  const setting = ({ label, unit, least, most, value, form }) => {
    const shown = element('output', {}, `${value} ${unit}`);
    const input = element('input', { type: 'range', min: least, max: most, value, 'aria-label': label });
    const show = () => (shown.textContent = `${input.value} ${unit}`);
    input.addEventListener('input', show);
    input.addEventListener('change', () => send(form(input.value)));
    controls.push(input);
    const put = (given) => {
      input.value = given;
      show();
    };
    return { row: element('label', { class: 'slide' }, element('span', {}, label), input, shown), put };
  };
  const opening = setting({
    label: 'Gripper',
    unit: 'mm',
    least: 0,
    most: 100,
    value: 80,
    form: (v) => `(gripper ${v})`,
  });
  const speed = setting({ label: 'Speed', unit: '%', least: 1, most: 100, value: 50, form: (v) => `(speed ${v})` });

  const note = element('span', { class: 'quiet' });
  const take = element('button', { type: 'button', id: 'take-arm', class: 'strong' }, 'Take the arm in hand');
  take.addEventListener('click', () => hands.toggle().catch((failure) => (note.textContent = failureText(failure))));
  hands.onChange((mine, holder) => {
    take.textContent = mine ? 'Let the arm go' : holder ? `Take over from ${holder}` : 'Take the arm in hand';
    note.textContent = mine
      ? 'Only you move the arm now.'
      : holder
        ? ''
        : 'Anybody may move the arm: a goal, a prompt.';
    for (const control of controls) {
      control.disabled = !mine;
      control.title = mine ? '' : 'Take the arm in hand first';
    }
  });

  panel.append(
    element('div', { class: 'row' }, take, note),
    element(
      'div',
      { class: 'row' },
      button('Home', '(home)'),
      button('Ready', '(ready)'),
      button('Get control', '(get-control)'),
      button('Monitor', '(monitor)'),
      button('Finish: stop', '(finish stop)'),
    ),
    element('div', { class: 'slides' }, ...slides.map(slide), opening.row, speed.row),
    log,
  );
  connection.follow('(robot-speed ?robot ?percent)', (answers) => {
    const told = answers.map((answer) => read(answer.facts[0].text)).find((row) => write(row[1]) === hands.robot);
    if (told) speed.put(told[2]);
  });
}
