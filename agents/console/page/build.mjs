// Bundles src/ into built/, which is what the console serves: run by `npm ci && npm run build` after a change here.
// Running the console needs none of it. `node build.mjs FOLDER` writes elsewhere, for the test that compares.

import { build } from 'esbuild';
import { createHash } from 'node:crypto';
import { copyFile, mkdir, readFile, writeFile } from 'node:fs/promises';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const out = resolve(process.argv[2] ?? join(here, 'built'));

await mkdir(out, { recursive: true });
const unknown = 'version-of-this-page';
// Three carries its notice in its source; uPlot's stands in a file.
const notice = await readFile(join(here, 'node_modules/uplot/LICENSE'), 'utf8');
const { outputFiles } = await build({
  entryPoints: [join(here, 'src/main.js')],
  write: false,
  define: { PAGE_VERSION: JSON.stringify(unknown) },
  absWorkingDir: here,
  bundle: true,
  minify: true,
  format: 'esm',
  target: ['chrome110', 'firefox115'],
  legalComments: 'inline',
  footer: { js: `/*! uPlot\n${notice.trim()}\n*/` },
});
const script = outputFiles[0].text;
const styles = [join(here, 'node_modules/uplot/dist/uPlot.min.css'), join(here, 'src/console.css')];
const texts = await Promise.all(styles.map((file) => readFile(file, 'utf8')));
const page = await readFile(join(here, 'src/index.html'), 'utf8');
// A page knows the version that it was loaded as, and the console the one that it serves.
const version = createHash('sha256').update([script, page, ...texts].join('\n')).digest('hex').slice(0, 16);
await writeFile(join(out, 'console.js'), script.replaceAll(unknown, version));
await writeFile(join(out, 'version'), `${version}\n`);
await writeFile(join(out, 'console.css'), texts.join('\n'));
for (const file of ['index.html', 'icon.svg']) await copyFile(join(here, 'src', file), join(out, file));
