// The cell in three dimensions, as it is believed: the arm moves by its joints, the objects stand where the coordinator
// places them, as sure and as exact as the eyes say; the straight way to the next target; how far the arm reaches; what
// the camera sees.

import { BufferGeometry, Float32BufferAttribute, Group, Line, LineDashedMaterial, Vector3 } from 'three';
import { ArmFigure } from './arm_figure.js';
import { CameraFigure } from './camera_figure.js';
import { makeView } from './cell_view.js';
import { ObjectFigure } from './object_figure.js';
import { ReachFigure } from './reach_figure.js';
import { TruthOverlay } from './truth_overlay.js';
import { fact } from './live_answers.js';
import { sightingsIn } from './sightings.js';
import { showBeliefs } from './beliefs.js';
import { Readings } from './readings.js';
import { text } from './datum.js';

/** @import { Axes } from './axes.js' */
/** @import { Connection } from './connection.js' */
/** @import { Roles } from './roles.js' */
/** @import { Sighting } from './sightings.js' */
/** @import { Answer, Arm, Form, Hello } from './messages' */

const most = 64;
const nobody = { arms: [], reaches: {}, cube: 60 };

// A dashed line between two points that move.
class Way {
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

// What the arm goes for: the servo's target, and before it moves that of the operation in hand.
/** @param {Connection} connection @param {(name: string) => void} changed */
function followTarget(connection, changed) {
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

/** @param {Connection} connection @param {Roles} roles @param {Axes} axes */
export function showScene(connection, roles, axes) {
  const view = makeView();
  /** @type {ArmFigure | null} */
  let arm = null;
  /** @type {ReachFigure | null} */
  let reach = null;
  let target = '';
  /** @type {Pick<Hello, 'arms' | 'reaches' | 'cube'>} */
  let hello = nobody;
  let robot = '';
  /** @type {Map<string, ObjectFigure>} */
  const objects = new Map();
  /** @type {Map<string, Arm>} */
  const told = new Map(); // the newest of each arm
  const readings = new Readings(connection, axes, (opening) => view && arm?.open(opening) && view.ask());
  const showSightings = showBeliefs(connection);
  if (!view) {
    roles.onChange(() => readings.show(roles.server('robot') || 'robot'));
    return { moveArm: () => {}, setCell: () => {} };
  }

  const things = new Group();
  const way = new Way();
  /** @type {Map<string, Sighting>} */
  let seen = new Map();
  const camera = new CameraFigure(connection, view, () => believe());
  const truth = new TruthOverlay(connection, view);
  view.scene.add(things, way.line);
  view.moving = () => {
    const armMoves = arm?.step() ?? false;
    const moving = [...objects.values()].map((figure) => figure.step());
    way.show(arm?.grip, objects.get(target)?.top());
    return armMoves || moving.includes(true);
  };
  const mark = () => {
    for (const [name, figure] of objects) figure.mark(name === target);
    view.says('target', objects.has(target) ? target : '');
    view.ask();
  };
  const believe = () => {
    for (const [name, figure] of objects) figure.believe(seen.get(name), camera.frame);
    view.says('spread', [...objects.values()].filter((figure) => figure.hasSpread()).length);
  };

  /** @param {string} name @param {Form} placed */
  const place = (name, [, , x, y, z]) => {
    let figure = objects.get(name);
    if (!figure) {
      if (objects.size >= most) return;
      figure = new ObjectFigure(name, hello.cube);
      objects.set(name, figure);
      things.add(figure.group);
    }
    figure.goTo(x, y, z);
  };
  connection.follow('(place ?name ?x ?y ?z ?frame)', (answers) => {
    const placed = new Map(answers.map((answer) => [text(fact(answer)[1]), fact(answer)]));
    for (const [name, figure] of objects) {
      if (placed.has(name)) continue;
      things.remove(figure.group);
      objects.delete(name);
    }
    for (const [name, told] of placed) place(name, told);
    believe();
    mark();
  });
  /** @type {Record<'looks' | 'found', Answer[]>} */
  const sighted = { looks: [], found: [] };
  /** @param {'looks' | 'found'} name @param {string} query */
  const follow = (name, query) =>
    connection.follow(query, (answers) => {
      sighted[name] = answers;
      seen = sightingsIn(sighted.looks, sighted.found);
      believe();
      showSightings(seen);
      view.ask();
    });
  follow('looks', '(look ?eyes ?frame ?text ?of)');
  follow('found', '(found ?eyes ?name ?frame ?confidence ?second ?margin ?others ?places)');
  /** @param {string} name */
  followTarget(connection, (name) => {
    target = name;
    mark();
  });

  /** @param {Arm} message */
  const drawArm = (message) => {
    if (!arm) {
      arm = new ArmFigure();
      view.scene.add(arm.group);
    }
    arm.goTo(message);
    reach?.standAt(message.points[0]);
    view.ask();
  };
  // The arm of whoever plays the robot's role, and how far that reaches.
  const choose = () => {
    robot = roles.server('robot') || (hello.arms[0] ?? 'robot');
    readings.show(robot);
    for (const figure of [arm, reach]) if (figure) view.scene.remove(figure.group);
    arm = null;
    reach = hello.reaches[robot] ? new ReachFigure(hello.reaches[robot]) : null;
    if (reach) view.scene.add(reach.group);
    view.says('reach', Boolean(reach));
    view.says('arm', robot);
    const newest = told.get(robot);
    if (newest) drawArm(newest);
    view.ask();
  };
  roles.onChange(() => (roles.server('robot') || robot) !== robot && choose());

  return {
    /** @param {Arm} message */
    moveArm: (message) => {
      told.set(message.arm, message);
      if (message.arm === robot) drawArm(message);
    },
    /** @param {Hello} cell */
    setCell: (cell) => {
      hello = cell;
      camera.setCell(cell);
      truth.setCell(cell);
      choose();
    },
  };
}
