// node packages.mjs SCRATCH: what the other tests of the page take from npm is there, so that none of those that run
// side by side makes it for another.

import { expect, modulesFolder } from './browser.mjs';

expect(modulesFolder(process.argv[2]) !== '', 'the packages of the lock file are there');
