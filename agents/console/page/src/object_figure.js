// An object where the coordinator places it: a white cube with its mark on the face that the camera sees, and its name
// above. The place is the mark's. The end effector's own mark is a plate that the arm carries. What is not seen in this
// look is faint. An ellipsoid shows how far off it may be (spread_figure.js). The target of the arm stands in a ring.

import {
  BoxGeometry,
  CanvasTexture,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  RingGeometry,
  Sprite,
  SpriteMaterial,
  SRGBColorSpace,
  Vector3,
} from 'three';
import { penOn } from './dom.js';
import { SpreadFigure } from './spread_figure.js';

/** @import { Frame } from './camera_frame.js' */
/** @import { Sighting } from './sightings.js' */

const between = 160; // ms
const carried = 'end-effector';
const unseen = 0.45; // of its opacity
/** @type {Record<string, (c: CanvasRenderingContext2D) => void>} */
const marks = {
  circle: (c) => c.arc(64, 64, 34, 0, 2 * Math.PI),
  square: (c) => c.rect(33, 33, 62, 62),
  triangle: (c) =>
    polygon(c, [
      [64, 26],
      [102, 96],
      [26, 96],
    ]),
  cross: (c) =>
    polygon(c, [
      [52, 26],
      [76, 26],
      [76, 52],
      [102, 52],
      [102, 76],
      [76, 76],
      [76, 102],
      [52, 102],
      [52, 76],
      [26, 76],
      [26, 52],
      [52, 52],
    ]),
};

/** @param {CanvasRenderingContext2D} c @param {[x: number, y: number][]} points */
function polygon(c, points) {
  points.forEach(([x, y], i) => (i ? c.lineTo(x, y) : c.moveTo(x, y)));
  c.closePath();
}

/** @param {number} width @param {number} height @param {(c: CanvasRenderingContext2D) => void} draw */
function drawing(width, height, draw) {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  draw(penOn(canvas));
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}

/** @param {string} name */
function face(name) {
  return drawing(128, 128, (c) => {
    const [ground, ink] = name === carried ? ['#14181b', '#f4f6f7'] : ['#f4f6f7', '#14181b'];
    c.fillStyle = ground;
    c.fillRect(0, 0, 128, 128);
    c.fillStyle = ink;
    c.beginPath();
    const mark = name === carried ? marks.triangle : Object.hasOwn(marks, name) ? marks[name] : null;
    if (mark) mark(c);
    c.fill();
    if (mark) return;
    c.font = 'bold 64px system-ui, sans-serif';
    c.textAlign = 'center';
    c.fillText(name.slice(0, 1).toUpperCase(), 64, 86);
  });
}

/** @param {string} name */
function label(name) {
  return drawing(256, 64, (c) => {
    c.font = '600 34px system-ui, sans-serif';
    c.textAlign = 'center';
    c.lineWidth = 7;
    c.strokeStyle = '#0e171e';
    const shown = name.length > 14 ? `${name.slice(0, 13)}…` : name;
    c.strokeText(shown, 128, 44);
    c.fillStyle = '#ffffff';
    c.fillText(shown, 128, 44);
  });
}

export class ObjectFigure {
  group = new Group();
  #size;
  /** @type {Vector3 | null} */
  #from = null;
  /** @type {Vector3 | null} */
  #to = null;
  #since = 0;
  #materials;
  #spread = new SpreadFigure();
  #ring;

  /** @param {string} name @param {number} size */
  constructor(name, size) {
    this.#size = size;
    const white = new MeshStandardMaterial({ color: 0xe6eaec, roughness: 0.8 });
    const map = face(name);
    map.center.set(0.5, 0.5);
    map.rotation = Math.PI / 2;
    const marked = new MeshStandardMaterial({ map, roughness: 0.8 });
    const depth = name === carried ? 4 : size;
    const width = name === carried ? size * 0.7 : size;
    const cube = new Mesh(new BoxGeometry(depth, width, width), [marked, white, white, white, white, white]);
    cube.position.setX(-depth / 2);
    const name_plate = new Sprite(new SpriteMaterial({ map: label(name), depthTest: false }));
    name_plate.scale.set(size * 2.4, size * 0.6, 1);
    name_plate.position.set(-size / 2, 0, size * 0.85);
    this.#materials = [white, marked];
    this.#ring = new Mesh(new RingGeometry(size * 0.85, size * 0.97, 40), new MeshBasicMaterial({ color: 0xf2a33a, side: DoubleSide, transparent: true }));
    this.#ring.position.set(-depth / 2, 0, -width / 2 + 2);
    this.#ring.visible = false;
    this.group.add(cube, name_plate, this.#spread.mesh, this.#ring);
  }

  // What the eyes say of it (sightings.js), and the frame they say it in (camera_frame.js); undefined where they do not.
  /** @param {Sighting | undefined} sighting @param {Frame | null} frame */
  believe(sighting, frame) {
    const faint = sighting && !['seen', 'found'].includes(sighting.state);
    for (const material of this.#materials) {
      material.opacity = faint ? unseen : 1;
      material.transparent = Boolean(faint);
    }
    this.#spread.show(sighting, frame, this.#to);
  }
  hasSpread() {
    return this.#spread.mesh.visible;
  }
  /** @param {boolean} isTarget */
  mark(isTarget) {
    this.#ring.visible = isTarget;
  }

  /** @param {number} x @param {number} y @param {number} z */
  goTo(x, y, z) {
    const next = new Vector3(x, y, z);
    this.#from = this.#to ? this.group.position.clone() : next;
    this.#to = next;
    this.#since = performance.now();
  }

  step() {
    const part = Math.min((performance.now() - this.#since) / between, 1);
    if (this.#from && this.#to) this.group.position.lerpVectors(this.#from, this.#to, part);
    return part < 1;
  }

  top() {
    return this.group.position.clone().add(new Vector3(-this.#size / 2, 0, this.#size / 2));
  }
}
