// What the arm goes for: the servo's target, and before it moves that of the operation in hand; and the straight way from
// the grip to it.

import { BufferGeometry, Float32BufferAttribute, Line, LineDashedMaterial, Vector3 } from 'three';
import { fact } from './live_answers.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */

// `changed` is told the target's name; '' where no goal is pursued.
/** @param {Connection} connection @param {(name: string) => void} changed */
export function followTarget(connection, changed) {
  const state = { servo: '', operation: '', pursued: false };
  const tell = () => changed(state.pursued ? state.servo || state.operation : '');
  connection.follow('(servo ?state ?object ?x ?y ?d)', (answers) => {
    state.servo = answers.length ? text(fact(answers[0])[2]) : '';
    tell();
  });
  connection.follow('(operation ?i ?operation ?state)', (answers) => {
    const [, , operation, doing] = answers.length ? fact(answers[0]) : [];
    state.operation = text(doing) === 'running' ? text(operation.at(-1)) : '';
    tell();
  });
  connection.follow('(goal-state ?n ?state ?detail)', (answers) => {
    state.pursued = answers.some((answer) => text(fact(answer)[2]) === 'running');
    tell();
  });
}

// A dashed line between two points that move.
export class StraightWay {
  line = new Line(
    new BufferGeometry().setFromPoints([new Vector3(), new Vector3()]),
    new LineDashedMaterial({ color: 0xf2a33a, dashSize: 14, gapSize: 9 }),
  );
  /** @param {Vector3 | null | undefined} from @param {Vector3 | undefined} to */
  show(from, to) {
    this.line.visible = Boolean(from && to);
    if (!from || !to) return;
    const ends = [from, to].flatMap((p) => [p.x, p.y, p.z]);
    this.line.geometry.setAttribute('position', new Float32BufferAttribute(ends, 3));
    this.line.computeLineDistances();
  }
}
