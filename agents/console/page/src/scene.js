// The cell in three dimensions, as it is believed: the arm moves by its joints, the objects stand where the coordinator
// places them, as sure and as exact as the eyes say; the straight way to the next target; how far the arm reaches; what
// the camera sees. Beside it the same in numbers and words.

import { StraightWay, followTarget } from './arm_target.js';
import { BelievedObjects } from './believed_objects.js';
import { CameraFigure } from './camera_figure.js';
import { ChosenArm } from './chosen_arm.js';
import { followSightings } from './sightings.js';
import { makeView } from './cell_view.js';
import { Readings } from './arm_readings.js';
import { showBeliefs } from './beliefs.js';
import { TruthOverlay } from './truth_overlay.js';

/** @import { Axes } from './axis_names.js' */
/** @import { View } from './cell_view.js' */
/** @import { Connection } from './connection.js' */
/** @import { Roles } from './roles.js' */
/** @import { Sighting } from './sightings.js' */
/** @import { Arm, Hello } from './messages' */

// What is drawn in the view.
/** @param {Connection} connection @param {View} view */
function drawCell(connection, view) {
  const arm = new ChosenArm(view);
  const objects = new BelievedObjects(connection, view);
  const way = new StraightWay();
  /** @type {Map<string, Sighting>} */
  let seen = new Map();
  const camera = new CameraFigure(connection, view, () => objects.believe(seen, camera.frame));
  const truth = new TruthOverlay(connection, view);
  view.scene.add(objects.group, way.line);
  view.moving = () => {
    const moving = [arm.step(), objects.step()];
    way.show(arm.grip, objects.topOfTarget());
    return moving.includes(true);
  };
  followTarget(connection, (target) => objects.mark(target));
  return {
    arm,
    /** @param {Map<string, Sighting>} sightings */
    believe: (sightings) => {
      seen = sightings;
      objects.believe(seen, camera.frame);
      view.ask();
    },
    /** @param {Hello} cell */
    setCell: (cell) => {
      for (const part of [objects, arm, camera, truth]) part.setCell(cell);
    },
  };
}

/** @param {Connection} connection @param {Roles} roles @param {Axes} axes */
export function showScene(connection, roles, axes) {
  const view = makeView();
  const cell = view && drawCell(connection, view);
  const readings = new Readings(connection, axes, (opening) => cell?.arm.open(opening));
  const showSightings = showBeliefs(connection);
  followSightings(connection, (seen) => {
    cell?.believe(seen);
    showSightings(seen);
  });
  let robot = '';
  let firstArm = 'robot';
  // The arm of whoever plays the robot's role.
  const choose = () => {
    robot = roles.server('robot') || firstArm;
    readings.show(robot);
    cell?.arm.choose(robot);
  };
  roles.onChange(() => (roles.server('robot') || robot) !== robot && choose());
  return {
    /** @param {Arm} message */
    moveArm: (message) => cell?.arm.move(message),
    /** @param {Hello} hello */
    setCell: (hello) => {
      firstArm = hello.arms[0] ?? 'robot';
      cell?.setCell(hello);
      choose();
    },
  };
}
