// node types.mjs SCRATCH: the page's sources keep the types that they name, as `npm run check` says.

import { spawnSync } from 'node:child_process';
import { expect, folderOfSources, skip } from './browser.mjs';

const folder = folderOfSources(process.argv[2]);
const checked = spawnSync('node', ['node_modules/typescript/bin/tsc'], { cwd: folder, encoding: 'utf8' });
if (/Unable to resolve @typescript/.test(checked.stderr)) skip('typescript has no program for this machine');
expect(checked.status === 0, `the types hold ${checked.stdout}${checked.stderr}`);
