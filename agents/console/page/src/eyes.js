// The eyes: their mode and who holds it, teaching, and FIND, TRACK and END TRACK of what is known.

import { arrange, clipped, element, failureText, find } from './dom.js';
import { fact } from './live_answers.js';
import { showCalibration } from './calibration.js';
import { isNamed, LearnedObjects, provisionalName } from './learned_objects.js';
import { nameOf } from './names.js';
import { Reasons } from './reasons.js';
import { sym, text } from './datum.js';
import { Teaching } from './teach.js';
import { templatePicture } from './template_picture.js';

/** @import { Connection } from './connection.js' */
/** @import { Images } from './images.js' */
/** @import { Permission } from './permission.js' */
/** @import { Roles } from './roles.js' */
/** @import { Datum, Form } from './messages' */

/** A client, and the mode that it holds.
 * @typedef {[client: string, mode: string]} Held */

// Why what buttons do is off; '' where it is not. `never`: why all of it is.
/** @param {string} never @param {Held[]} held @param {string} me */
function reasonsFor(never, held, me) {
  if (never) return { connect: never, disconnect: never, find: never, train: never, forget: never, track: never, end: never };
  /** @param {string} mode */
  const by = (mode) => held.filter(([, holds]) => holds === mode).map(([client]) => client);
  /** @param {string} client */
  const named = (client) => nameOf(client, me);
  const trackers = by('tracking');
  const learners = by('learning');
  const tracks = trackers.length ? `${trackers.map(named).join(', ')} ${trackers.includes(me) ? 'track' : 'tracks'}, which excludes learning: end that first` : '';
  const learns = learners.length ? `${named(learners[0])} ${learners[0] === me ? 'are' : 'is'} learning` : '';
  const connected = by('connected').includes(me);
  return {
    connect: connected ? 'you are connected' : '',
    disconnect: connected ? '' : 'you are not connected',
    find: '',
    train: tracks || (learners.includes(me) ? '' : learns),
    forget: tracks || learns,
    track: learns,
    end: trackers.includes(me) ? '' : trackers.length ? `${named(trackers[0])} tracks, and ends it itself` : 'nothing is tracked',
  };
}

// Of `(tracked EYES NAME STATE FRAME CONFIDENCE)`.
/** @param {Form} tracked */
const stateOf = ([, , , state, , confidence]) => (text(state) === 'lost' ? 'lost' : `${text(state)}, ${(confidence * 100).toFixed(0)} %`);

/** @param {{ connection: Connection, permission: Permission, images: Images, roles: Roles }} around @param {() => string} me */
export function showEyes({ connection, permission, images, roles }, me) {
  const panel = find('eyes');
  const answer = element('pre', { class: 'answer', id: 'eyes-answer', role: 'status', hidden: true });
  const mode = element('span', { id: 'eyes-mode', class: 'chip' }, 'no eyes');
  const holders = element('span', { class: 'quiet' });
  const tracking = element('pre', { class: 'answer', 'aria-label': 'What TRACK says', hidden: true });
  const objects = new LearnedObjects(roles);
  let eyes = 'vision';
  let present = false;
  /** @type {Held[]} */
  let held = [];

  /** @param {Datum[]} operation */
  const request = (...operation) => connection.request(eyes, operation);
  // Why the eyes gave that reply.
  /** @param {string} reply */
  const whyFailed = async (reply) => {
    const answers = await connection.ask([sym('vision-failed'), sym(eyes), sym('?'), reply, sym('?'), sym('?sentence')]);
    return answers.length ? text(fact(answers[0])[5]) : 'no reason was told';
  };
  /** @param {Datum[]} operation */
  const ask = async (...operation) => {
    answer.hidden = false;
    answer.textContent = '…';
    try {
      const values = await request(...operation);
      const why = / FAIL\)/.test(values[0] ?? '') ? `\n${await whyFailed(values[0])}` : '';
      answer.textContent = clipped((values.join('\n') || 'ok') + why, 2000);
    } catch (failure) {
      answer.textContent = failureText(failure);
    }
  };
  /** @param {string} label @param {Datum[]} operation */
  const button = (label, ...operation) =>
    element('button', { type: 'button', onclick: () => ask(...operation) }, label);

  const connect = button('Connect', sym('connect'));
  const disconnect = button('Disconnect', sym('disconnect'));
  const end = button('End track', sym('end-track'));
  const teaching = new Teaching({
    ask: request,
    objects,
    provisional: () => provisionalName(me().replace(/\D+/g, '-').replace(/^-/, '')),
    why: whyFailed,
  });
  images.onPoint((point) => teaching.take(point));
  const reasons = new Reasons('why-eyes');
  const list = element('ul', { class: 'objects', 'aria-label': 'Learned objects' });
  panel.append(
    showCalibration(connection),
    element('div', { class: 'row' }, mode, holders),
    element('div', { class: 'row' }, connect, disconnect, end),
    reasons.note,
    teaching.panel,
    answer,
    tracking,
    list,
  );

  /** @type {Map<string, Form>} */
  const tracked = new Map();
  const rows = new Map(); // of each name; made anew only where what it shows, `of`, has changed
  const showStates = () => {
    for (const [name, { state }] of rows) {
      const seen = tracked.get(name);
      state.textContent = seen ? stateOf(seen) : 'not tracked';
    }
  };
  /** @param {string} name */
  const row = (name) => {
    const samples = objects.samples(name);
    const of = JSON.stringify([samples, objects.alike(name)]);
    if (rows.get(name)?.of === of) return rows.get(name);
    const state = element('span', {});
    const look = button('Find', sym('find'), name);
    const track = button('Track', sym('track'), name);
    const forget = button('Forget', sym('forget'), name);
    const more = element('button', { type: 'button', onclick: () => teaching.more(name) }, 'Add sample');
    const by = [...new Set(samples.map((one) => one.eyes))].join(', ');
    const alike = objects.alike(name).map((sentence) => element('small', { class: 'warn' }, clipped(sentence, 160)));
    const item = element(
      'li',
      {},
      element(
        'span',
        { class: 'templates' },
        ...samples.map((one) => templatePicture(one.picture, one.tone, `Sample ${one.num} of ${clipped(name, 64)}`)),
      ),
      element(
        'span',
        {},
        element('strong', {}, isNamed(name) ? clipped(name, 64) : 'not named yet'),
        element('span', { class: 'quiet' }, ` ${samples.length} sample${samples.length > 1 ? 's' : ''} by ${clipped(by, 64)}; `, state),
        ...alike,
      ),
      element('span', { class: 'buttons' }, look, track, more, forget),
    );
    rows.set(name, { of, item, state, look, more, track, forget });
    return rows.get(name);
  };
  const draw = () => {
    holders.textContent = held.map(([client, holds]) => `${nameOf(client, me())}: ${holds}`).join(', ');
    const names = objects.names().slice(0, 64);
    for (const name of rows.keys()) if (!names.includes(name)) rows.delete(name);
    const shown = names.map(row);
    const why = reasonsFor(permission.command('request') || (present ? '' : 'no eyes are present'), held, me());
    reasons.set('Connect', [connect], why.connect);
    reasons.set('Disconnect', [disconnect], why.disconnect);
    reasons.set('End track', [end], why.end);
    reasons.set('Training', [teaching.training], why.train);
    reasons.set('Add sample', shown.map(({ more }) => more), why.train);
    reasons.set('Find', shown.map(({ look }) => look), why.find);
    reasons.set('Track', shown.map(({ track }) => track), why.track);
    reasons.set('Forget', shown.map(({ forget }) => forget), why.forget);
    arrange(list, shown.map(({ item }) => item));
    showStates();
  };
  objects.onChange(draw);
  permission.onChange(draw);
  roles.follow('eyes', '(vision-mode ?eyes ?mode ?connected)', ([told]) => {
    present = Boolean(told);
    eyes = told ? text(told[1]) : eyes;
    const doing = told ? text(told[2]) : 'no eyes';
    mode.textContent = told ? `${eyes}: ${doing}` : doing;
    mode.className = `chip ${present ? (doing === 'idle' ? '' : 'busy') : 'bad'}`;
    document.body.dataset.eyes = doing;
    draw();
  });
  roles.follow('eyes', '(vision-held ?eyes ?client ?mode)', (facts) => {
    held = facts.map((one) => [text(one[2]), text(one[3])]);
    draw();
  });
  roles.follow('eyes', '(tracked ?eyes ?name ?state ?frame ?confidence)', (facts) => {
    tracked.clear();
    for (const one of facts) tracked.set(text(one[2]), one);
    showStates();
  });
  roles.follow('eyes', '(look ?eyes ?frame ?text ?of)', ([look]) => {
    tracking.hidden = !look;
    if (look) tracking.textContent = clipped(text(look[3]), 1000);
  });
}
