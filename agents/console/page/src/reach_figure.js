// How far the arm reaches over the table, tool down: an edge on both sides of what it reaches, around its foot.

import { BufferGeometry, DoubleSide, Float32BufferAttribute, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial } from 'three';

/** @import { Point, Reach } from './messages' */

const above = 1.5; // mm over the table, so that both are seen

export class ReachFigure {
  group = new Group();

  // `parts`: from where to where, in each direction from x towards y; [0, 0] where it reaches nowhere.
  /** @param {Reach} reach */
  constructor({ parts }) {
    /** @param {number} i @param {number} away */
    const corner = (i, away) => {
      const angle = (2 * Math.PI * i) / parts.length;
      return [away * Math.cos(angle), away * Math.sin(angle), above];
    };
    /** @type {number[]} */
    const area = [];
    /** @type {number[]} */
    const edges = [];
    parts.forEach(([from, to], i) => {
      const next = (i + 1) % parts.length;
      const [nextFrom, nextTo] = parts[next];
      if (to === 0 || nextTo === 0) return;
      const [a, b, c, d] = [corner(i, from), corner(i, to), corner(next, nextTo), corner(next, nextFrom)];
      area.push(...a, ...b, ...c, ...a, ...c, ...d);
      edges.push(...b, ...c, ...a, ...d);
    });
    const ground = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(area, 3));
    const outline = new BufferGeometry().setAttribute('position', new Float32BufferAttribute(edges, 3));
    const faint = { color: 0x7fd18b, transparent: true, opacity: 0.07, side: DoubleSide, depthWrite: false };
    this.group.add(
      new Mesh(ground, new MeshBasicMaterial(faint)),
      new LineSegments(outline, new LineBasicMaterial({ color: 0x4f8f5b })),
    );
  }

  // A track carries it along.
  /** @param {Point} foot */
  standAt([x, y]) {
    this.group.position.set(x, y, 0);
  }
}
