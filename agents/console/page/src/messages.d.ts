// The messages of the console to its page (agents/console/session.hpp says when), and types that the page's files share.

import type { Sym } from './datum.js';

export type Datum = Sym | string | number | Datum[];

// A list whose contract says what stands where: the board has checked that of a fact, so it is not checked again.
export type Form = any[];

export type Failure = { symbol?: string; sentence?: string; place?: string; said?: string };

export type ToldFact = { text: string; teller: string; when: number; because: number[] };
export type Answer = { ids: number[]; bindings: Record<string, string>; facts: ToldFact[]; read?: Form };
export type Change = { resynchronised: boolean; cut: number; removed: number[][]; added: Answer[] };
// What lasted until then: a state of the servo, what came into sight or went.
export type Lasting = { answer: Answer; until: number };

export type Point = [x: number, y: number, z: number];
export type Camera = { at: Point; pan: number; tilt: number; roll: number; head: boolean };
export type Reach = { height: number; parts: [from: number, to: number][] };
export type Hello = {
  version: string; // of the page that the console serves
  name: string;
  cell: string;
  arms: string[];
  axes: Record<string, [name: string, unit: string][]>;
  reaches: Record<string, Reach>;
  camera: Camera | null;
  cube: number;
  truth: boolean;
  // Why the key of the page forbids a word of its ('goal', 'stop', 'jog', ...), by that word.
  mayNot: Record<string, string>;
  images: { path: string; lanes: number };
};
export type Arm = { arm: string; points: Point[]; grip: Point; approach: Point; closing: Point };
export type Pulse = { pulse: number; deadline: number; rtt: number };

export type Spread = { count: number; p50: number; p90: number; p99: number };
export type Activity = {
  revision: number;
  facts: number;
  transactions_per_second: number;
  journey: { committed_us: number; acknowledged_us: number; delivered_us: number } | null;
  agents: { name: string; told_per_second: number; waiting: number; queued: number }[] | null;
  relations: {
    name: string;
    facts: number;
    told_per_second: number;
    watches: number;
    tellers: string[];
    told_us: Spread | null;
    delivered_us: Spread | null;
  }[];
  clients: { name: string; requests_per_second: number }[];
};

export type Cell = {
  path: string;
  fault: string | null;
  agents: number;
  goal: string;
  arms: string;
  stops: string;
  leads: string;
  said: string;
  console: string;
};

export type Component = { name: string; physical: boolean; performance: boolean; abstraction: boolean };
export type Wrapper = {
  component: string;
  offered: number;
  abstraction: { wrapped: string; operations: number; functions: number; i_abstract: number }[];
  parts: string[];
};
export type Way = {
  from: string;
  to: string;
  pattern: string;
  about: string[];
  count: number;
  p50_ms: number;
  p99_ms: number;
  recommended: string;
  remark: string;
};
export type Method = {
  seconds: number;
  i_cpx: number;
  i_struct: number;
  i_cnx: number;
  components: Component[];
  wrappers: Wrapper[];
  connections: Way[];
  scales: { subscribers: number; p50_ms: number }[];
  faults: { symbol: string; subject: string; sentence: string }[];
};

type Refused = { error: Failure; said?: string };
export type Reply = { values: any[] } | Refused;
export type Fed =
  | { truth: string | null; said?: string }
  | { activity: Activity | null; said?: string }
  | { work: 'servo' | 'sightings'; changes: Lasting[] };
export type Message =
  | { hello: Hello }
  | (Arm & { past?: number })
  | ({ watch: number; past?: number } & (Change | Refused))
  | ({ reply: number } & ({ values: string[] } | Refused))
  | Fed
  | Pulse;

export type Picture = { bitmap: ImageBitmap; number: number; captured: number; width: number; height: number };
export type PointInImage = { x: number; y: number; frame: number };
