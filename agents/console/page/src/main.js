// The page: what each part shows is its own file's affair; here they meet.

import { Activity } from './activity.js';
import { Axes } from './axis_names.js';
import { Connection } from './connection.js';
import { Hands } from './hands.js';
import { find } from './dom.js';
import { pressOnce } from './press_once.js';
import { showAgents } from './agents.js';
import { showCells } from './cells.js';
import { showDrive } from './drive.js';
import { Roles } from './roles.js';
import { showEyes } from './eyes.js';
import { showFacts } from './facts.js';
import { showHandsNote } from './hands_note.js';
import { showHead } from './head.js';
import { showLogIn } from './log_in.js';
import { showImages } from './images.js';
import { showConnectionState } from './connection_state.js';
import { Permission } from './permission.js';
import { showPast } from './past.js';
import { showPlan } from './plan_list.js';
import { showScene } from './scene.js';
import { showServo } from './servo_plot.js';
import { showStop } from './stop.js';
import { showStory } from './story.js';
import { showTabs } from './tabs.js';
import { showWant } from './want.js';
import { WorkEntries } from './work_entries.js';

const connection = new Connection();
const permission = new Permission();
const hands = new Hands(connection, permission);
const roles = new Roles(connection);
const axes = new Axes();

showTabs();
pressOnce();
const logIn = showLogIn(connection);
const line = showConnectionState(permission);
showStop(connection, permission, hands);
showHandsNote(hands);
const scene = showScene(connection, roles, axes);
const images = showImages(connection, roles);
const entries = new WorkEntries(connection);
showWant(connection, permission);
showPlan(connection, entries);
showServo(connection);
const around = { connection, permission, entries, images };
showStory(around, showPast(around));
showHead(connection, permission, images, () => hands.me);
showEyes({ connection, permission, images, roles }, () => hands.me);
showDrive({ connection, permission, hands, axes });
const activity = new Activity(connection);
showFacts(connection, activity, () => hands.me);
showAgents(connection, activity, () => hands.me);
showCells(connection);

connection.onArm = scene.moveArm;
connection.onHello = (hello) => {
  find('cell').textContent = hello.cell;
  hands.me = hello.name;
  permission.set({ mayNot: hello.mayNot });
  axes.set(hello.axes);
  scene.setCell(hello);
};
roles.onChange(() => {
  hands.robot = roles.server('robot') || hands.robot;
  hands.changed();
});
connection.onState = (state, why) => {
  line(state, why);
  logIn(state, why);
};
connection.open();
