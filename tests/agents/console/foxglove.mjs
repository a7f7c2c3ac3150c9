// node foxglove.mjs PIZARRA-CELL PIZARRA-BOARD SCRATCH: a story as Foxglove sees it, judged by the public client @foxglove/ws-protocol.

import { createRequire } from 'node:module';
import { join } from 'node:path';
import { expect, modulesFolder, ownFolder, start, storyBoard } from './browser.mjs';

const [cell, board, scratch] = process.argv.slice(2);
const require = createRequire(join(modulesFolder(scratch), 'x.js'));
const { FoxgloveClient } = require('@foxglove/ws-protocol');
const WebSocket = require('ws');

const origin = 'https://viewer.example';
const folder = ownFolder();
const told = storyBoard(board, folder);
const served = start([cell, 'console', '--board', told.at, '--foxglove', '--foxglove-origin', origin], folder);
const address = await served.said(/for Foxglove: (ws:\S+)/);
const connect = (to, options = {}) => new WebSocket(to, [FoxgloveClient.SUPPORTED_SUBPROTOCOL], options);

// Who is let in.
const refused = (socket) =>
  new Promise((resolve) => {
    socket.on('unexpected-response', (_, response) => resolve(response.statusCode));
    socket.on('open', () => resolve('let in'));
    socket.on('error', () => {});
  });
expect((await refused(connect(address.replace(/\w{64}$/, '0'.repeat(64))))) === 403, 'a wrong token is refused');
expect((await refused(connect(address.replace(/\?.*/, '')))) === 403, 'so is none');
expect((await refused(connect(address, { origin: 'https://other.example' }))) === 403, 'and a page of another origin');
expect((await refused(new WebSocket(address, ['something.else']))) === 400, 'and who speaks something else');

const viewer = new FoxgloveClient({ ws: connect(address, { origin }) });
const first = (event) => new Promise((resolve) => viewer.on(event, resolve));
const [info, advertised] = await Promise.all([first('serverInfo'), first('advertise')]);
expect(info.name.startsWith('Pizarra') && info.capabilities.length === 0, `it says who it is: ${info.name}`);
const schemas = advertised.map(({ topic, schemaName, encoding, schemaEncoding, schema }) => {
  JSON.parse(schema);
  return `${topic} ${schemaName} ${schemaEncoding} ${encoding}`;
});
expect(
  schemas.sort().join(', ') ===
    '/annotated foxglove.CompressedImage jsonschema json, /camera foxglove.CompressedImage jsonschema json, ' +
      '/facts pizarra.Fact jsonschema json, /scene foxglove.SceneUpdate jsonschema json, ' +
      '/story foxglove.Log jsonschema json, /tf foxglove.FrameTransform jsonschema json',
  'its channels are those of an MCAP file, and the images',
);

// What is heard of each topic, and who waits for more of it.
const heard = new Map(advertised.map(({ topic }) => [topic, []]));
const waiting = new Set();
const topics = new Map();
viewer.on('message', ({ subscriptionId, timestamp, data }) => {
  heard.get(topics.get(subscriptionId)).push({ at: timestamp, ...JSON.parse(new TextDecoder().decode(data)) });
  for (const look of waiting) look();
});
const until = (holds) =>
  new Promise((resolve) => {
    const look = () => holds() && waiting.delete(look) | resolve();
    waiting.add(look);
    look();
  });
const subscribe = (topic) => {
  const number = viewer.subscribe(advertised.find((channel) => channel.topic === topic).id);
  topics.set(number, topic);
  return number;
};
for (const topic of heard.keys()) subscribe(topic);

const relations = () => new Set(heard.get('/facts').map(({ relation }) => relation));
await until(
  () => ['/tf', '/scene', '/story'].every((topic) => heard.get(topic).length === 1) && relations().size === 3,
);
expect(true, 'who subscribes is told what stands');

// What is told from now on; the last of it is that a place has gone.
told.tell();
await until(() => heard.get('/scene').some(({ deletions }) => deletions.some(({ id }) => id === 'square')));
const scene = heard.get('/scene').flatMap(({ entities }) => entities);
expect(scene.map(({ id }) => id).join() === 'cross,circle,square', 'objects come to stand in the scene, and go');
expect(Math.abs(scene[1].spheres[0].pose.position.x - 0.4) < 1e-9, 'in metres');
const poses = 31;
await until(() => heard.get('/tf').length === poses);
const moved = heard.get('/tf');
expect(
  moved.every(({ rotation: r }) => Math.abs(Math.hypot(r.x, r.y, r.z, r.w) - 1) < 1e-9) &&
    moved.every(({ translation }, i) => Math.abs(translation.z - 0.099 - i / 1000) < 1e-9),
  'the grip moves step by step, and its rotations are rotations',
);
const since = (Date.now() - 600_000) * 1e6;
expect(moved.every(({ at }) => Number(at) > since), 'times are of now, in nanoseconds');
await until(() => heard.get('/story').length === 7);
expect(heard.get('/story').some(({ message, name }) => message === 'new plan' && name === 'plan'), 'the story is told');
await until(() => heard.get('/facts').some(({ gone, relation }) => gone && relation === 'place'));
expect(heard.get('/facts').every(({ text }) => text.startsWith('(')), 'facts come and go');

// Who comes later is told what stands, too.
topics.set(subscribe('/scene'), 'later');
heard.set('later', []);
await until(() => heard.get('later').flatMap(({ entities }) => entities).length === 2);
expect(true, 'who subscribes later is told what stands');

// It reads, and nothing else.
const answer = (ask) => {
  const status = new Promise((resolve) => {
    const take = (message) => viewer.off('status', take) ?? resolve(message.message);
    viewer.on('status', take);
  });
  ask();
  return status;
};
const advertise = () => viewer.advertise({ topic: '/facts', encoding: 'json', schemaName: 'pizarra.Fact' });
expect(/read alone/.test(await answer(advertise)), 'who would tell is refused in words');
expect(/no such channel/.test(await answer(() => viewer.subscribe(99))), 'so is a channel that is not there');
const closed = first('close');
viewer.close();
await closed;
expect((await served.end()) === 0, 'it ends in order');
await told.end();

// The images of a cell that lives.
const live = start([cell, 'console', '--foxglove'], ownFolder());
const eyes = new FoxgloveClient({ ws: connect(await live.said(/for Foxglove: (ws:\S+)/)) });
const images = await new Promise((resolve) => eyes.on('advertise', resolve));
const seen = new Map();
const enough = new Promise((resolve) =>
  eyes.on('message', ({ subscriptionId, timestamp, data }) => {
    const image = JSON.parse(new TextDecoder().decode(data));
    seen.get(subscriptionId).push({ at: timestamp, format: image.format, jpeg: Buffer.from(image.data, 'base64') });
    if ([...seen.values()].every((of) => of.length >= 5)) resolve();
  }),
);
for (const topic of ['/camera', '/annotated'])
  seen.set(eyes.subscribe(images.find((channel) => channel.topic === topic).id), []);
await enough;
const isPicture = ({ format, jpeg }) => format === 'jpeg' && jpeg.readUInt16BE(0) === 0xffd8 && jpeg.length > 2000;
for (const of of seen.values()) {
  expect(of.every(isPicture) && of.every(({ at }, i) => i === 0 || at > of[i - 1].at), 'images come, one after another');
}
eyes.close();
expect((await live.end()) === 0, 'it ends in order');
process.exit(0);
