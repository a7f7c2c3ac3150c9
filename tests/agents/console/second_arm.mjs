// node second_arm.mjs PIZARRA-CELL SCRATCH: a cell with two arms as processes. The page draws and reads the arm that plays
// the robot's role, and another once that is wired.

import { join } from 'node:path';
import { begin, expect, say, source } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const { folder, page, end } = await begin(scratch, [cell, 'up', join(source, 'examples/06-master-and-slave/cell.scm'), '--console']);
const draws = (arm) => page.waitForFunction((name) => document.getElementById('scene').dataset.arm === name, arm);
const joints = () => page.waitForFunction(() => document.getElementById('readings').innerText.match(/joints\s*([^\n]+)/)?.[1]).then((found) => found.jsonValue());
await draws('robot');
const ofRobot = (await joints()).split(/\s+/).length;
expect(true, `the robot is drawn, of ${ofRobot} axes`);
say([cell, 'repl', '--eval', '(wire console robot slave)'], folder);
await draws('slave');
const ofSlave = (await joints()).split(/\s+/).length;
expect(true, `and then the arm that is wired, of ${ofSlave} axes`);
expect((await page.evaluate(() => document.getElementById('scene').dataset.reach)) === 'true', 'with how far that one reaches');
await end();
