// The cell in three dimensions, as it is believed: the arm moves by its joints, the objects stand where the coordinator
// places them, as sure and as exact as the eyes say; the straight way to the next target; how far the arm reaches; what
// the camera sees.

import { BufferGeometry, Float32BufferAttribute, Group, Line, LineDashedMaterial, Vector3 } from 'three';
import { ArmFigure } from './arm_figure.js';
import { makeView } from './cell_view.js';
import { ObjectFigure } from './object_figure.js';
import { ReachFigure } from './reach_figure.js';
import { TruthOverlay } from './truth_overlay.js';
import { fact } from './live_answers.js';
import { sightingsIn } from './sightings.js';
import { showBeliefs } from './beliefs.js';
import { showCamera } from './camera_figure.js';
import { showReadings } from './readings.js';
import { text } from './datum.js';

const most = 64;
const nobody = { arms: [], reaches: {}, camera: null, cube: 60, truth: false };

// A dashed line between two points that move.
class Way {
  line = new Line(
    new BufferGeometry().setFromPoints([new Vector3(), new Vector3()]),
    new LineDashedMaterial({ color: 0xf2a33a, dashSize: 14, gapSize: 9 }),
  );
  show(from, to) {
    this.line.visible = Boolean(from && to);
    if (!this.line.visible) return;
    const ends = [from, to].flatMap((p) => [p.x, p.y, p.z]);
    this.line.geometry.setAttribute('position', new Float32BufferAttribute(ends, 3));
    this.line.computeLineDistances();
  }
}

// What the arm goes for: the servo's target, and before it moves that of the operation in hand.
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

export function showScene(connection) {
  const view = makeView();
  let arm = null;
  let reach = null;
  let target = '';
  let hello = nobody;
  const objects = new Map();
  const moved = { robot: 'robot', open: (opening) => view && arm?.open(opening) && view.ask() };
  showReadings(connection, moved);
  const showSightings = showBeliefs(connection);
  if (!view) return { moveArm: () => {}, setCell: (told) => (moved.robot = told.arms[0] ?? 'robot') };

  const things = new Group();
  const way = new Way();
  const setCamera = showCamera(connection, view);
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

  let seen = new Map();
  const place = (name, [, , x, y, z]) => {
    if (!objects.has(name)) {
      if (objects.size >= most) return;
      objects.set(name, new ObjectFigure(name, hello.cube));
      things.add(objects.get(name).group);
    }
    objects.get(name).goTo(x, y, z);
    objects.get(name).believe(seen.get(name), hello.camera?.at);
  };
  connection.follow('(place ?name ?x ?y ?z ?frame)', (answers) => {
    const placed = new Map(answers.map((answer) => [text(fact(answer)[1]), fact(answer)]));
    for (const [name, figure] of objects) {
      if (placed.has(name)) continue;
      things.remove(figure.group);
      objects.delete(name);
    }
    for (const [name, told] of placed) place(name, told);
    mark();
  });
  connection.follow('(look ?eyes ?frame ?text ?of)', (answers) => {
    seen = sightingsIn(answers);
    for (const [name, figure] of objects) figure.believe(seen.get(name), hello.camera?.at);
    view.says('spread', [...objects.values()].filter((figure) => figure.hasSpread()).length);
    showSightings(seen);
    view.ask();
  });
  followTarget(connection, (name) => {
    target = name;
    mark();
  });

  return {
    moveArm: (message) => {
      if (message.arm !== moved.robot) return;
      if (!arm) {
        arm = new ArmFigure();
        view.scene.add(arm.group);
      }
      arm.goTo(message);
      reach?.standAt(message.points[0]);
      view.ask();
    },
    setCell: (told) => {
      hello = told;
      moved.robot = told.arms[0] ?? 'robot';
      setCamera(told.camera);
      truth.setCell(told);
      if (reach) view.scene.remove(reach.group);
      const outline = told.reaches[moved.robot];
      reach = outline ? new ReachFigure(outline) : null;
      if (reach) view.scene.add(reach.group);
      view.says('reach', Boolean(reach));
    },
  };
}
