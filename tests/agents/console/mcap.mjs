// node mcap.mjs PIZARRA-CELL SCRATCH: a demo's journal as an MCAP file, judged by the public reader @mcap/core.

import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { expect, modulesFolder, ownFolder } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const { McapIndexedReader, McapStreamReader } = createRequire(join(modulesFolder(scratch), 'x.js'))('@mcap/core');
const folder = ownFolder();
const run = (...words) => {
  const done = spawnSync(cell, words, { cwd: folder, encoding: 'utf8', env: { ...process.env, XDG_RUNTIME_DIR: folder } });
  if (done.status !== 0) throw new Error(`${words.join(' ')}: ${done.status} ${done.stderr}`);
  return done.stdout;
};

run('demo', '--seed', '11', '--journal', 'run.txt');
const said = run('replay', 'run.txt', '--mcap', 'run.mcap');
const written = Number(said.match(/: (\d+) messages/)[1]);
const bytes = readFileSync(join(folder, 'run.mcap'));

// Everything from the first byte to the last, checksums included.
const stream = new McapStreamReader({ validateCrcs: true });
stream.append(bytes);
const records = [];
for (let record = stream.nextRecord(); record; record = stream.nextRecord()) records.push(record.type);
expect(stream.done() && records.includes('Footer'), 'it is whole');

const readableOf = (file) => ({
  size: async () => BigInt(file.length),
  read: async (offset, size) => new Uint8Array(file.subarray(Number(offset), Number(offset + size))),
});
const reader = await McapIndexedReader.Initialize({ readable: readableOf(bytes) });
const channels = new Map([...reader.channelsById].map(([id, channel]) => [id, channel]));
const schemas = [...channels.values()].map((channel) => {
  const schema = reader.schemasById.get(channel.schemaId);
  JSON.parse(new TextDecoder().decode(schema.data));
  return `${channel.topic} ${schema.name} ${schema.encoding} ${channel.messageEncoding}`;
});
expect(
  schemas.sort().join(', ') ===
    '/facts pizarra.Fact jsonschema json, /scene foxglove.SceneUpdate jsonschema json, ' +
      '/story foxglove.Log jsonschema json, /tf foxglove.FrameTransform jsonschema json',
  'its channels say what they hold',
);
const messages = [];
let latest = 0n;
for await (const message of reader.readMessages()) {
  if (message.logTime < latest) throw new Error('times go back');
  latest = message.logTime;
  messages.push([channels.get(message.channelId).topic, JSON.parse(new TextDecoder().decode(message.data)), message]);
}
expect(messages.length === written, `all ${written} messages are found by its index`);
expect(BigInt(written) === reader.statistics.messageCount, 'its statistics count as many');
const of = (topic) => messages.filter(([on]) => on === topic).map(([, message]) => message);
const grips = of('/tf');
expect(
  grips.length > 100 && grips.every(({ rotation: r }) => Math.abs(Math.hypot(r.x, r.y, r.z, r.w) - 1) < 1e-9),
  'the grip moves, and its rotations are rotations',
);
expect(of('/story').some(({ name, message }) => name === 'result' || /reached|built/.test(message)), 'the story is told to its end');
const names = new Set(of('/scene').flatMap(({ entities }) => entities.map((entity) => entity.id)));
expect(['circle', 'triangle', 'square'].every((name) => names.has(name)), 'the objects stand in the scene');
expect(of('/facts').some(({ gone }) => gone) && of('/facts').every(({ text }) => text.startsWith('(')), 'facts come and go');
const half = [];
for await (const message of reader.readMessages({ startTime: latest / 2n, topics: ['/story'] })) half.push(message);
expect(half.length > 0 && half.length < of('/story').length, 'a part of it is read by its index');

// With what a console kept of it: the images between the journal's ends, as they are.
const pixel = Buffer.from(
  '/9j/4AAQSkZJRgABAQEASABIAAD/2wBDAP//////////////////////////////////////////////////////////////////////////////////////wgALCAABAAEBAREA/8QAFBABAAAAAAAAAAAAAAAAAAAAAP/aAAgBAQABPxA=',
  'base64',
);
const kept = join(folder, 'kept');
const moments = [Number(latest) / 4000, Number(latest) / 2000, Number(latest) / 1000 + 5_000_000].map(Math.floor);
for (const stream of ['vision-colour', 'vision-annotated', 'vision-right']) {
  mkdirSync(join(kept, stream), { recursive: true });
  moments.forEach((at, i) => writeFileSync(join(kept, stream, `${at}_${i + 1}_1x1.jpg`), pixel));
}
run('replay', 'run.txt', '--mcap', 'seen.mcap', '--pictures', 'kept');
const seen = await McapIndexedReader.Initialize({ readable: readableOf(readFileSync(join(folder, 'seen.mcap'))) });
const images = [];
for await (const message of seen.readMessages({ topics: ['/camera', '/annotated'] })) {
  const image = JSON.parse(new TextDecoder().decode(message.data));
  images.push([seen.channelsById.get(message.channelId).topic, Number(message.logTime) / 1000, image]);
}
expect(images.length === 4, `images of the run, and of no other time or kind: ${images.length}`);
expect(
  images.every(([, at, { data, format }]) => moments.includes(at) && format === 'jpeg' && Buffer.from(data, 'base64').equals(pixel)),
  'each of its moment, as it was kept',
);
expect(new Set(images.map(([topic]) => topic)).size === 2, 'plain, and annotated');

const later = run('replay', 'run.txt', '--at', '@20', '--mcap', 'later.mcap');
expect(Number(later.match(/: (\d+) messages/)[1]) < written, 'it may begin later');
