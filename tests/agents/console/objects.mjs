// node objects.mjs PIZARRA-CELL SCRATCH: the person of the cell of examples/01-blocks teaches its objects once, for all
// tests that need them and not how they are taught.

import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { cellWithObjects, ownFolder, say, taughtObjects } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const objects = join(scratch, taughtObjects);
rmSync(objects, { recursive: true, force: true });
const folder = ownFolder();
// It has taught them before the first form is read.
say([cell, 'repl', cellWithObjects(folder, objects), '--eval', '(objects)'], folder);
