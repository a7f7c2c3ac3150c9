// node mcap.mjs PIZARRA-CELL SCRATCH: a demo's journal as an MCAP file, judged by the public reader @mcap/core.

import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
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

const reader = await McapIndexedReader.Initialize({
  readable: {
    size: async () => BigInt(bytes.length),
    read: async (offset, size) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + size))),
  },
});
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
const later = run('replay', 'run.txt', '--at', '@20', '--mcap', 'later.mcap');
expect(Number(later.match(/: (\d+) messages/)[1]) < written, 'it may begin later');
