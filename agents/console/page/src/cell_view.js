// The ground on which a cell is drawn in three dimensions: millimetres, z up, as the facts have it. Drawn only when
// something changes.

import {
  AmbientLight,
  Color,
  DirectionalLight,
  GridHelper,
  HemisphereLight,
  PerspectiveCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { eachFrame, find } from './dom.js';

// A processor that draws in the place of a graphics card has other work: frames are then few while something moves.
const pauseWithoutCard = 80;

/** @param {WebGLRenderer} renderer */
function drawnByProcessor(renderer) {
  const context = renderer.getContext();
  const named = context.getExtension('WEBGL_debug_renderer_info');
  const name = context.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : context.RENDERER);
  return /swiftshader|llvmpipe|software/i.test(name);
}

export class View {
  #dirty;
  /** @param {WebGLRenderer} renderer @param {HTMLCanvasElement} canvas */
  constructor(renderer, canvas) {
    this.canvas = canvas;
    this.box = /** @type {HTMLElement} */ (canvas.parentElement);
    this.renderer = renderer;
    this.pause = drawnByProcessor(renderer) ? pauseWithoutCard : 0;
    this.#dirty = eachFrame(() => this.draw());
    this.moving = () => false;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.scene = new Scene();
    this.scene.background = new Color(0x0e171e);
    this.camera = new PerspectiveCamera(36, 1, 10, 8000);
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(1600, -1090, 880);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.target.set(380, 10, 285);
    this.controls.maxDistance = 4000;
    this.controls.minDistance = 200;
    this.controls.addEventListener('change', () => this.ask());
    this.controls.update();
    this.light();
    new ResizeObserver(() => this.resize()).observe(this.box);
  }
  light() {
    const sun = new DirectionalLight(0xffffff, 2.2);
    sun.position.set(900, -700, 1600);
    const grid = new GridHelper(2000, 20, 0x35505f, 0x1d2c37);
    grid.rotation.x = Math.PI / 2;
    this.scene.add(new HemisphereLight(0xdfeaf2, 0x27343d, 1.3), new AmbientLight(0xffffff, 0.25), sun, grid);
  }
  resize() {
    const { clientWidth: width, clientHeight: height } = this.box;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.ask();
  }
  ask() {
    this.#dirty();
  }
  // What of a kind is drawn, for whoever cannot see it.
  /** @param {string} kind @param {string | number | boolean} what */
  says(kind, what) {
    this.canvas.dataset[kind] = String(what);
  }
  draw() {
    const more = this.moving();
    this.renderer.render(this.scene, this.camera);
    if (!more) return;
    if (this.pause) setTimeout(() => this.ask(), this.pause);
    else this.ask();
  }
}

// Null where the browser draws nothing in three dimensions, which is said.
export function makeView() {
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
