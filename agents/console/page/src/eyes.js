// Teaching: a click into the camera's image is where LEARN begins; FIND, TRACK and END TRACK of what is known.

import { clipped, element, failureText, find } from './dom.js';
import { fact } from './live_answers.js';
import { sym, text } from './datum.js';

export function showEyes(connection, images) {
  const panel = find('eyes');
  const answer = element('pre', { class: 'answer', role: 'status', hidden: true });
  const mode = element('span', { class: 'quiet' });
  let eyes = 'vision';

  const ask = async (...operation) => {
    answer.hidden = false;
    answer.textContent = '…';
    try {
      const values = await connection.request(eyes, operation);
      answer.textContent = clipped(values.join('\n') || 'ok', 2000);
    } catch (failure) {
      answer.textContent = failureText(failure);
    }
  };
  const button = (label, ...operation) =>
    element('button', { type: 'button', onclick: () => ask(...operation) }, label);

  const name = element('input', { id: 'learn-name', maxlength: 64, spellcheck: 'false', placeholder: 'name' });
  const where = element('output', {}, 'click on a shape in the camera’s image');
  const learn = element('button', { type: 'submit', disabled: true }, 'Learn');
  let point = null;
  const form = element('form', { class: 'row' }, element('label', { for: 'learn-name' }, 'Learn'), name, learn, where);
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    if (point) ask(sym('learn'), point.x, point.y, name.value);
  });
  const ready = () => (learn.disabled = !point || !name.value);
  name.addEventListener('input', ready);

  const { plain } = images;
  plain.canvas.classList.add('clickable');
  plain.canvas.addEventListener('click', (event) => {
    if (!plain.shown) return;
    const box = plain.canvas.getBoundingClientRect();
    point = {
      x: Math.round(((event.clientX - box.left) / box.width) * plain.shown.width),
      y: Math.round(((event.clientY - box.top) / box.height) * plain.shown.height),
    };
    where.textContent = `at ${point.x}, ${point.y} of frame ${plain.shown.number}`;
    ready();
  });

  const list = element('ul', { class: 'objects' });
  panel.append(
    element(
      'div',
      { class: 'row' },
      button('Connect', sym('connect')),
      button('Disconnect', sym('disconnect')),
      button('End track', sym('end-track')),
      mode,
    ),
    form,
    answer,
    list,
  );

  let learned = [];
  const tracked = new Map();
  const draw = () => {
    const names = new Map();
    for (const sample of learned) names.set(text(sample[2]), (names.get(text(sample[2])) ?? 0) + 1);
    const rows = [...names].slice(0, 64).map(([object, samples]) => {
      const seen = tracked.get(object);
      const state = seen ? `${text(seen[3])}, ${(seen[5] * 100).toFixed(0)} %` : 'not tracked';
      return element(
        'li',
        {},
        element('strong', {}, clipped(object, 64)),
        element('span', { class: 'quiet' }, `${samples} sample${samples > 1 ? 's' : ''}; ${state}`),
        button('Find', sym('find'), object),
        button('Track', sym('track'), object),
      );
    });
    list.replaceChildren(...rows);
  };
  connection.follow('(vision-mode ?eyes ?mode ?connected)', (answers) => {
    if (!answers.length) return void (mode.textContent = 'no eyes are present');
    const [, who, doing, connected] = fact(answers[0]);
    eyes = text(who);
    mode.textContent = `${eyes}: ${text(doing)}, ${text(connected) === 'yes' ? 'connected' : 'not connected'}`;
  });
  connection.follow('(learned ?eyes ?name ?num ? ? ? ? ? ?)', (answers) => {
    learned = answers.map(fact);
    draw();
  });
  connection.follow('(tracked ?eyes ?name ?state ?frame ?confidence)', (answers) => {
    tracked.clear();
    for (const row of answers.map(fact)) tracked.set(text(row[2]), row);
    draw();
  });
}
