// The camera's view: from where the cell file has it, turned by the head that it stands on, as wide as its model says.
// Nobody knows the view of a head that does not say how it is turned, and none is drawn.

import { BufferGeometry, LineBasicMaterial, LineSegments, Vector3 } from 'three';
import { fact } from './live_answers.js';

// The pair's view: along the base's -x, turned by pan towards +y and by tilt upwards.
function frustum(camera, turn, model) {
  const [, , width, height, focal] = model;
  const far = 320;
  const pan = ((camera.pan + turn.pan) * Math.PI) / 180;
  const tilt = ((camera.tilt + turn.tilt) * Math.PI) / 180;
  const ahead = new Vector3(-Math.cos(pan) * Math.cos(tilt), Math.sin(pan) * Math.cos(tilt), Math.sin(tilt));
  const right = new Vector3(Math.sin(pan), Math.cos(pan), 0);
  const up = new Vector3().crossVectors(ahead, right).multiplyScalar(-1);
  if (up.z < 0) up.negate();
  const eye = new Vector3(...camera.at);
  const corner = (x, y) =>
    eye
      .clone()
      .addScaledVector(ahead, far)
      .addScaledVector(right, (x * far * width) / 2 / focal)
      .addScaledVector(up, (y * far * height) / 2 / focal);
  const corners = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
  const points = corners.flatMap((c, i) => [eye, c, c, corners[(i + 1) % 4]]);
  return new LineSegments(
    new BufferGeometry().setFromPoints(points),
    new LineBasicMaterial({ color: 0x4fb3ff, transparent: true, opacity: 0.6 }),
  );
}

const ahead = { pan: 0, tilt: 0 };

export function showCamera(connection, view) {
  let camera = null;
  let model = null;
  let turn = null;
  let figure = null;
  const show = () => {
    if (figure) view.scene.remove(figure);
    const turned = camera?.head ? turn : ahead;
    figure = camera && turned && model?.[4] > 0 ? frustum(camera, turned, model) : null;
    if (figure) view.scene.add(figure);
    view.says('camera', Boolean(figure));
    view.ask();
  };
  connection.follow('(camera-model ?eyes ?width ?height ?focal ?cx ?cy ?base)', (answers) => {
    model = answers.length ? fact(answers[0]) : null;
    show();
  });
  connection.follow('(head ?pan ?tilt ?state)', (answers) => {
    const [, pan, tilt] = answers.length ? fact(answers[0]) : [];
    turn = answers.length ? { pan, tilt } : null;
    show();
  });
  return (at) => {
    camera = at;
    show();
  };
}
