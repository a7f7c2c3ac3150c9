// An arm as its links: through the points that its axes give, and a gripper at the end. Between two of its joints'
// facts, a tenth of a second apart, it is drawn on its way.

import {
  BoxGeometry,
  CylinderGeometry,
  Group,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  Quaternion,
  SphereGeometry,
  Vector3,
} from 'three';

/** @import { BufferGeometry } from 'three' */
/** @import { Arm } from './messages' */

const between = 110; // ms
const link = new MeshStandardMaterial({ color: 0xe9a23b, roughness: 0.55, metalness: 0.1 });
const joint = new MeshStandardMaterial({ color: 0x43515c, roughness: 0.5, metalness: 0.35 });
const steel = new MeshStandardMaterial({ color: 0xa9b7c2, roughness: 0.4, metalness: 0.5 });
const along = new Vector3(0, 1, 0);

// What it is made of, as numbers that can be mixed: the points, the grip centre and the two directions.
/** @param {Arm} message */
const flat = (message) => [...message.points, message.grip, message.approach, message.closing].flat();

/** @typedef {{ links: Mesh[], joints: Mesh[], foot: Mesh, stem: Mesh, palm: Mesh, fingers: Mesh[] }} Parts */
export class ArmFigure {
  group = new Group();
  /** @type {Vector3 | null} */
  grip = null;
  /** @type {Parts | null} */
  #parts = null;
  /** @type {number[]} */
  #from = [];
  /** @type {number[]} */
  #to = [];
  #since = 0;
  #opening = 80;

  /** @param {Arm} message */
  goTo(message) {
    const next = flat(message);
    this.#parts ??= this.#built(message.points.length);
    this.#from = this.#to.length === next.length ? this.#now() : next;
    this.#to = next;
    this.#since = performance.now();
  }

  /** @param {number | undefined} opening */
  open(opening) {
    if (opening === undefined || opening === this.#opening) return false;
    this.#opening = opening;
    return true;
  }

  // Whether it is still on its way.
  step() {
    if (!this.#parts) return false;
    this.#place(this.#parts, this.#now());
    return performance.now() - this.#since < between;
  }

  #now() {
    const part = Math.min((performance.now() - this.#since) / between, 1);
    return this.#to.map((value, i) => this.#from[i] + (value - this.#from[i]) * part);
  }

  /** @param {BufferGeometry} geometry @param {MeshStandardMaterial} material */
  #mesh(geometry, material) {
    const mesh = new Mesh(geometry, material);
    this.group.add(mesh);
    return mesh;
  }

  /** @param {number} count @returns {Parts} */
  #built(count) {
    /** @param {number} i */
    const thickness = (i) => 58 - 30 * (i / Math.max(count - 1, 1));
    const links = [];
    for (let i = 0; i + 1 < count; ++i) {
      links.push(this.#mesh(new CylinderGeometry(thickness(i + 1) * 0.8, thickness(i) * 0.8, 1, 24), link));
    }
    const joints = [];
    for (let i = 0; i < count; ++i) joints.push(this.#mesh(new SphereGeometry(thickness(i), 24, 16), joint));
    const finger = () => this.#mesh(new BoxGeometry(9, 24, 52), steel);
    const foot = this.#mesh(new CylinderGeometry(95, 110, 24, 40), joint);
    foot.rotation.x = Math.PI / 2;
    return {
      links,
      joints,
      foot,
      stem: this.#mesh(new CylinderGeometry(16, 20, 1, 20), steel),
      palm: this.#mesh(new BoxGeometry(1, 34, 18), joint),
      fingers: [finger(), finger()],
    };
  }

  /** @param {Mesh} mesh @param {Vector3} a @param {Vector3} b */
  #stretch(mesh, a, b) {
    const way = b.clone().sub(a);
    mesh.visible = way.length() > 1;
    mesh.position.copy(a).addScaledVector(way, 0.5);
    mesh.scale.set(1, Math.max(way.length(), 1), 1);
    mesh.quaternion.setFromUnitVectors(along, way.normalize());
  }

  /** @param {Parts} parts @param {number[]} numbers */
  #place(parts, numbers) {
    /** @type {Vector3[]} */
    const vectors = [];
    for (let i = 0; i < numbers.length; i += 3) vectors.push(new Vector3(numbers[i], numbers[i + 1], numbers[i + 2]));
    const [grip, approach, closing] = vectors.splice(-3);
    const { links, joints, foot, stem, palm, fingers } = parts;
    foot.position.copy(vectors[0]).setZ(12);
    links.forEach((mesh, i) => this.#stretch(mesh, vectors[i], vectors[i + 1]));
    joints.forEach((mesh, i) => mesh.position.copy(vectors[i]));
    this.grip = grip;
    const turned = new Quaternion().setFromRotationMatrix(
      new Matrix4().makeBasis(closing, new Vector3().crossVectors(approach, closing), approach),
    );
    const wrist = grip.clone().addScaledVector(approach, -58);
    this.#stretch(stem, vectors[vectors.length - 1], wrist);
    palm.position.copy(wrist);
    palm.quaternion.copy(turned);
    palm.scale.setX(this.#opening + 26);
    fingers.forEach((mesh, i) => {
      mesh.position
        .copy(grip)
        .addScaledVector(approach, -26)
        .addScaledVector(closing, (i ? 1 : -1) * (this.#opening / 2 + 5));
      mesh.quaternion.copy(turned);
    });
  }
}
