// The simulated world's truth over what is believed, as wire frames of a colour that nothing else has. It comes from the
// world to this page alone: no fact tells it, and no agent reads it.

import { BoxGeometry, EdgesGeometry, Group, LineBasicMaterial, LineSegments } from 'three';
import { element, find } from './dom.js';
import { text } from './datum.js';

/** @import { View } from './cell_view.js' */
/** @import { Connection } from './connection.js' */
/** @import { Form, Hello } from './messages' */

const material = new LineBasicMaterial({ color: 0xff4fd8, depthTest: false, transparent: true });

export class TruthOverlay {
  #group = new Group();
  /** @type {Map<string, LineSegments>} */
  #cubes = new Map();
  #size = 60;
  #note = element('span', { id: 'truth-note', class: 'quiet' });
  #box = element('input', { type: 'checkbox', id: 'truth' });
  #label = element('label', { class: 'over', id: 'truth-choice', hidden: true }, this.#box, ' The world’s truth ', this.#note);

  /** @param {Connection} connection @param {View} view */
  constructor(connection, view) {
    this.view = view;
    view.scene.add(this.#group);
    find('scene-card').append(this.#label);
    this.#box.addEventListener('change', () => {
      this.#show([]);
      this.#note.textContent = '';
      connection.layTruth(this.#box.checked ? (truth, why) => this.#take(truth, why) : null);
    });
  }

  /** @param {Hello} cell */
  setCell({ truth, cube }) {
    this.#label.hidden = !truth;
    this.#size = cube;
  }

  /** @param {Form | null} truth @param {string} [why] */
  #take(truth, why) {
    if (!this.#box.checked) return;
    const cubes = (truth ?? []).filter((part) => text(part[0]) === 'cube' && text(part[7]) !== 'gone');
    this.#note.textContent = truth ? `pink: ${cubes.length} objects, known to no agent` : (why ?? '');
    this.#show(cubes);
  }

  /** @param {Form[]} cubes */
  #show(cubes) {
    const names = new Set(cubes.map((cube) => text(cube[1])));
    for (const [name, figure] of this.#cubes) {
      if (names.has(name)) continue;
      this.#group.remove(figure);
      this.#cubes.delete(name);
    }
    for (const [, name, x, y, z, yaw] of cubes) {
      const figure = this.#cubes.get(text(name)) ?? this.#add(text(name));
      figure.position.set(x, y, z);
      figure.rotation.z = (yaw * Math.PI) / 180;
    }
    this.view.says('truth', this.#cubes.size);
    this.view.ask();
  }

  /** @param {string} name */
  #add(name) {
    const edges = new EdgesGeometry(new BoxGeometry(this.#size, this.#size, this.#size));
    const figure = new LineSegments(edges, material);
    figure.renderOrder = 1;
    this.#cubes.set(name, figure);
    this.#group.add(figure);
    return figure;
  }
}
