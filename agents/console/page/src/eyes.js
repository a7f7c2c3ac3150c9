// The eyes: their mode and who holds it, teaching, and FIND, TRACK and END TRACK of what is known.

import { clipped, element, find } from './dom.js';
import { EyesRequests } from './eyes_requests.js';
import { LearnedObjects, provisionalName } from './learned_objects.js';
import { nameOf } from './names.js';
import { ObjectList } from './object_list.js';
import { Reasons } from './reasons.js';
import { showCalibration } from './calibration.js';
import { sym, text } from './datum.js';
import { Teaching } from './teach.js';
import { allOff, whyEyesOff } from './why_eyes_off.js';

/** @import { Connection } from './connection.js' */
/** @import { Images } from './images.js' */
/** @import { Permission } from './permission.js' */
/** @import { Roles } from './roles.js' */
/** @import { Held } from './why_eyes_off.js' */

// The mode of the eyes that play the role, and whether any do.
/** @param {Roles} roles @param {(eyes: string, present: boolean) => void} changed */
function showMode(roles, changed) {
  const chip = element('span', { id: 'eyes-mode', class: 'chip' }, 'no eyes');
  roles.follow('eyes', '(vision-mode ?eyes ?mode ?connected)', ([told]) => {
    const doing = told ? text(told[2]) : 'no eyes';
    chip.textContent = told ? `${text(told[1])}: ${doing}` : doing;
    chip.className = `chip ${told ? (doing === 'idle' ? '' : 'busy') : 'bad'}`;
    document.body.dataset.eyes = doing;
    changed(told ? text(told[1]) : '', Boolean(told));
  });
  return chip;
}

// The text of the newest look.
/** @param {Roles} roles */
function showNewestLook(roles) {
  const panel = element('pre', { class: 'answer', 'aria-label': 'What TRACK says', hidden: true });
  roles.follow('eyes', '(look ?eyes ?frame ?text ?of)', ([look]) => {
    panel.hidden = !look;
    if (look) panel.textContent = clipped(text(look[3]), 1000);
  });
  return panel;
}

/** @param {{ connection: Connection, permission: Permission, images: Images, roles: Roles }} around @param {() => string} me */
export function showEyes({ connection, permission, images, roles }, me) {
  const objects = new LearnedObjects(roles);
  const requests = new EyesRequests(connection);
  const teaching = new Teaching(requests, objects, () => provisionalName(me().replace(/\D+/g, '-').replace(/^-/, '')));
  images.onPoint((point) => teaching.take(point));
  const list = new ObjectList(objects, requests, (name) => teaching.more(name));
  const reasons = new Reasons('why-eyes');
  const connect = requests.button('Connect', sym('connect'));
  const disconnect = requests.button('Disconnect', sym('disconnect'));
  const end = requests.button('End track', sym('end-track'));
  const holders = element('span', { class: 'quiet' });
  let present = false;
  /** @type {Held[]} */
  let held = [];

  const draw = () => {
    holders.textContent = held.map(([client, holds]) => `${nameOf(client, me())}: ${holds}`).join(', ');
    list.draw();
    const never = permission.command('request') || (present ? '' : 'no eyes are present');
    const why = never ? allOff(never) : whyEyesOff(held, me());
    reasons.set('Connect', [connect], why.connect);
    reasons.set('Disconnect', [disconnect], why.disconnect);
    reasons.set('End track', [end], why.end);
    reasons.set('Training', [teaching.training], why.train);
    list.gate(reasons, why);
  };
  objects.onChange(draw);
  permission.onChange(draw);
  const mode = showMode(roles, (eyes, there) => {
    requests.eyes = eyes || requests.eyes;
    present = there;
    draw();
  });
  roles.follow('eyes', '(vision-held ?eyes ?client ?mode)', (facts) => {
    held = facts.map((one) => [text(one[2]), text(one[3])]);
    draw();
  });
  roles.follow('eyes', '(tracked ?eyes ?name ?state ?frame ?confidence)', (facts) => list.showTracked(facts));
  find('eyes').append(
    showCalibration(connection),
    element('div', { class: 'row' }, mode, holders),
    element('div', { class: 'row' }, connect, disconnect, end),
    reasons.note,
    teaching.panel,
    requests.panel,
    showNewestLook(roles),
    list.panel,
  );
}
