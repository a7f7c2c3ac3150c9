// node bundle.mjs SCRATCH: the bundle in the tree is what the sources give, and small.

import { spawnSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { expect, folderOfSources, ownFolder, pageFolder, skip } from './browser.mjs';

const out = ownFolder();
const built = spawnSync('node', [join(folderOfSources(process.argv[2]), 'build.mjs'), out], { encoding: 'utf8' });
if (/EBADPLATFORM|could not be found, and is needed/.test(built.stderr))
  skip('esbuild has no program for this machine');
expect(built.status === 0, `it builds ${built.stderr}`);
const committed = join(pageFolder, 'built');
expect(readdirSync(committed).sort().join() === readdirSync(out).sort().join(), 'the same files');
for (const file of readdirSync(out)) {
  expect(readFileSync(join(out, file)).equals(readFileSync(join(committed, file))), `${file} is what the sources give`);
}
const size = gzipSync(readFileSync(join(committed, 'console.js')), { level: 9 }).length;
expect(size < 250 * 1024, `the bundle is small: ${size} bytes gzipped`);
