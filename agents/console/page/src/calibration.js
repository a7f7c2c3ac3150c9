// A calibration that goes on, as `./pizarra calibrate --tell` tells of it: where the boards stood that were taken, where
// the board stands now, and what is still missing, in words and as the parts of the image that no board came to.

import { BoardOutlines } from './board_outlines.js';
import { clipped, element } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Form } from './messages' */

/** @type {Record<string, string>} */
const states = { looking: 'looking for boards', fitting: 'fitting', done: 'done', failed: 'failed' };
/** @type {Record<string, string>} */
const kinds = { done: 'good', failed: 'bad' };
// Anybody may tell such facts.
const mostBoards = 64;
const mostLacks = 32;

/** `now` is `(calibration STATE SENTENCE WIDTH HEIGHT BOARDS WANTED)`.
 * @typedef {{ now: Form | undefined, taken: number[][][], newest: number[][], sees: string, lacks: Form[] }} Progress */

/** @param {Connection} connection @param {(progress: Progress) => void} changed */
function followProgress(connection, changed) {
  /** @type {Progress} */
  const progress = { now: undefined, taken: [], newest: [], sees: '', lacks: [] };
  /** @param {string} query @param {(facts: Form[]) => void} take */
  const follow = (query, take) =>
    connection.follow(query, (answers) => {
      take(answers.map(fact));
      changed(progress);
    });
  follow('(calibration ?state ?sentence ?width ?height ?boards ?wanted)', ([now]) => (progress.now = now));
  follow('(calibration-board ?number ?outlines)', (boards) => {
    progress.taken = boards.slice(0, mostBoards).map((board) => board[2]);
  });
  follow('(calibration-sees ?outlines ?sentence)', ([newest]) => {
    progress.newest = newest?.[1] ?? [];
    progress.sees = newest ? `the newest image: ${clipped(text(newest[2]))}` : '';
  });
  follow('(calibration-lacks ?sentence ?part)', (lacks) => (progress.lacks = lacks.slice(0, mostLacks)));
}

/** @param {Connection} connection */
export function showCalibration(connection) {
  const chip = element('span', { class: 'chip', id: 'calibration-state', role: 'status' });
  const count = element('span', { id: 'calibration-count' });
  const sentence = element('p', { id: 'calibration-sentence', hidden: true });
  const sees = element('span', { class: 'quiet', id: 'calibration-sees' });
  const missing = element('ul', { id: 'calibration-lacks', 'aria-label': 'Still missing' });
  const views = [new BoardOutlines(0), new BoardOutlines(1)];
  const panel = element(
    'section',
    { id: 'calibration', 'aria-label': 'Calibration', hidden: true },
    element('div', { class: 'row' }, element('h2', {}, 'Calibration'), chip, count, sees),
    sentence,
    element('div', { class: 'calibrating' }, ...views.map((view) => view.panel), missing),
  );
  followProgress(connection, (progress) => {
    const { now, taken, lacks } = progress;
    panel.hidden = now === undefined;
    if (now === undefined) return;
    const [, state, said, width, height, boards, wanted] = now;
    const doing = text(state);
    chip.textContent = states[doing] ?? doing;
    chip.className = `chip ${kinds[doing] ?? 'busy'}`;
    count.textContent = `${boards} of ${wanted} boards`;
    sees.textContent = progress.sees;
    sentence.textContent = clipped(text(said), 1000);
    sentence.hidden = sentence.textContent === '';
    const sentences = lacks.length ? lacks.map(([, lack]) => clipped(text(lack))) : ['nothing more'];
    missing.replaceChildren(...sentences.map((one) => element('li', {}, one)));
    const isPair = taken.some((board) => 1 in board);
    for (const view of views) view.show({ width, height, taken, newest: progress.newest, lacks, isPair });
  });
  return panel;
}
