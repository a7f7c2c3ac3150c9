// The cell in three dimensions, as it is believed: the arm moves by its joints, the objects stand where the coordinator
// places them. Millimetres, z up, as the facts have it. Drawn only when something changes.

import {
  AmbientLight,
  BufferGeometry,
  Color,
  DirectionalLight,
  Float32BufferAttribute,
  GridHelper,
  Group,
  HemisphereLight,
  Line,
  LineBasicMaterial,
  LineDashedMaterial,
  LineSegments,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { ArmFigure } from './arm_figure.js';
import { ObjectFigure } from './object_figure.js';
import { eachFrame, element, find } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

const line = (points, material) => new Line(new BufferGeometry().setFromPoints(points), material);

// The pair's view: along the base's -x, turned by pan towards +y and by tilt upwards.
function frustum(camera, model) {
  const [, , width, height, focal] = model;
  const far = 320;
  const pan = (camera.pan * Math.PI) / 180;
  const tilt = (camera.tilt * Math.PI) / 180;
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

// A processor that draws in the place of a graphics card has other work: frames are then few while something moves.
const pauseWithoutCard = 80;

function drawnByProcessor(renderer) {
  const context = renderer.getContext();
  const named = context.getExtension('WEBGL_debug_renderer_info');
  const name = context.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : context.RENDERER);
  return /swiftshader|llvmpipe|software/i.test(name);
}

class View {
  #dirty;
  constructor(renderer, canvas) {
    this.canvas = canvas;
    this.renderer = renderer;
    this.pause = drawnByProcessor(renderer) ? pauseWithoutCard : 0;
    this.#dirty = eachFrame(() => this.draw());
    this.moving = () => false;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.scene = new Scene();
    this.scene.background = new Color(0x0e171e);
    this.camera = new PerspectiveCamera(36, 1, 10, 8000);
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(1500, -1010, 770);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.target.set(400, 10, 235);
    this.controls.maxDistance = 4000;
    this.controls.minDistance = 200;
    this.controls.addEventListener('change', () => this.ask());
    this.controls.update();
    this.light();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }
  light() {
    const sun = new DirectionalLight(0xffffff, 2.2);
    sun.position.set(900, -700, 1600);
    const grid = new GridHelper(2000, 20, 0x35505f, 0x1d2c37);
    grid.rotation.x = Math.PI / 2;
    this.scene.add(new HemisphereLight(0xdfeaf2, 0x27343d, 1.3), new AmbientLight(0xffffff, 0.25), sun, grid);
  }
  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.ask();
  }
  ask() {
    this.#dirty();
  }
  draw() {
    const more = this.moving();
    this.renderer.render(this.scene, this.camera);
    if (!more) return;
    if (this.pause) setTimeout(() => this.ask(), this.pause);
    else this.ask();
  }
}

function makeView() {
  const canvas = find('scene');
  let renderer;
  try {
    renderer = new WebGLRenderer({ canvas, antialias: true });
  } catch {
    find('scene-note').hidden = false;
    find('scene-note').textContent = 'This browser draws nothing in three dimensions (WebGL is off). All else works.';
    return null;
  }
  return new View(renderer, canvas);
}

const rounded = (action) => action.replace(/\d+\.\d+/g, (number) => String(Math.round(number * 10) / 10));

// (arm-pose ROBOT X Y Z RX RY RZ), (gripper ROBOT OPENING) and (arm ROBOT STATE ACTION), in words.
function showReadings(connection, moved) {
  const readings = {};
  const show = () => {
    const rows = Object.entries(readings).filter(([, value]) => value);
    find('readings').replaceChildren(
      ...rows.flatMap(([name, value]) => [element('dt', {}, name), element('dd', {}, value)]),
    );
  };
  const of = (answers) => answers.map(fact).find((told) => text(told[1]) === moved.robot);
  connection.follow('(arm-pose ?robot ?x ?y ?z ?rx ?ry ?rz)', (answers) => {
    const pose = of(answers);
    readings.grip =
      pose &&
      `${pose
        .slice(2, 5)
        .map((v) => v.toFixed(0))
        .join('  ')} mm`;
    const turned = pose?.slice(5).map((v) => v.toFixed(0));
    readings.turned = turned && `${turned.join('  ')} °`;
    show();
  });
  connection.follow('(gripper ?robot ?opening)', (answers) => {
    const opening = of(answers)?.[2];
    readings.gripper = opening !== undefined && `${opening.toFixed(0)} mm`;
    moved.open(opening);
    show();
  });
  connection.follow('(arm ?robot ?state ?action)', (answers) => {
    const arm = of(answers);
    readings.arm = arm && `${text(arm[2])}  ${rounded(text(arm[3])).slice(0, 40)}`;
    show();
  });
}

export function showScene(connection) {
  const view = makeView();
  const figures = { arm: null, objects: new Map(), hello: null, model: null, frustum: null };
  const moved = { robot: 'robot', open: (opening) => view && figures.arm?.open(opening) && view.ask() };
  showReadings(connection, moved);
  if (!view) return { moveArm: () => {}, setCell: (hello) => (moved.robot = hello.arms[0] ?? 'robot') };

  const things = new Group();
  const way = line(
    [new Vector3(), new Vector3()],
    new LineDashedMaterial({ color: 0xf2a33a, dashSize: 14, gapSize: 9 }),
  );
  way.visible = false;
  view.scene.add(things, way);
  view.moving = () => {
    const armMoves = figures.arm?.step() ?? false;
    const moving = [...figures.objects.values()].map((figure) => figure.step());
    showWay();
    return armMoves || moving.includes(true);
  };

  let target = '';
  let pursued = false;
  const showWay = () => {
    const object = pursued ? figures.objects.get(target) : undefined;
    way.visible = Boolean(object && figures.arm?.grip);
    if (!way.visible) return;
    const ends = [figures.arm.grip, object.top()];
    way.geometry.setAttribute(
      'position',
      new Float32BufferAttribute(
        ends.flatMap((p) => [p.x, p.y, p.z]),
        3,
      ),
    );
    way.computeLineDistances();
  };

  const showFrustum = () => {
    if (figures.frustum) view.scene.remove(figures.frustum);
    figures.frustum =
      figures.hello?.camera && figures.model?.[4] > 0 ? frustum(figures.hello.camera, figures.model) : null;
    if (figures.frustum) view.scene.add(figures.frustum);
    view.ask();
  };

  connection.follow('(place ?name ?x ?y ?z ?frame)', (answers) => {
    const placed = new Map(answers.map((answer) => [text(fact(answer)[1]), fact(answer)]));
    for (const [name, figure] of figures.objects) {
      if (placed.has(name)) continue;
      things.remove(figure.group);
      figures.objects.delete(name);
    }
    for (const [name, [, , x, y, z]] of placed) {
      if (!figures.objects.has(name)) {
        if (figures.objects.size >= 64) continue;
        figures.objects.set(name, new ObjectFigure(name, figures.hello?.cube ?? 60));
        things.add(figures.objects.get(name).group);
      }
      figures.objects.get(name).goTo(x, y, z);
    }
    view.ask();
  });
  connection.follow('(servo ?state ?object ?x ?y ?d)', (answers) => {
    target = answers.length ? text(fact(answers[0])[2]) : '';
    view.ask();
  });
  connection.follow('(goal-state ?n running ?detail)', (answers) => {
    pursued = answers.length > 0;
    view.ask();
  });
  connection.follow('(camera-model ?eyes ?width ?height ?focal ?cx ?cy ?base)', (answers) => {
    figures.model = answers.length ? fact(answers[0]) : null;
    showFrustum();
  });

  return {
    moveArm: (message) => {
      if (message.arm !== moved.robot) return;
      if (!figures.arm) {
        figures.arm = new ArmFigure();
        view.scene.add(figures.arm.group);
      }
      figures.arm.goTo(message);
      view.ask();
    },
    setCell: (hello) => {
      figures.hello = hello;
      moved.robot = hello.arms[0] ?? 'robot';
      showFrustum();
    },
  };
}
