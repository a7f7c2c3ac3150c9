// The cells that this board names, and those that these name: how each does, with a link to its console, where it has
// one that other machines reach. They are looked at while the table is on the screen.

import { element, failureText, find } from './dom.js';
import { table } from './tables.js';

/** @import { Connection } from './connection.js' */
/** @import { Cell as TableCell, Table } from './tables.js' */
/** @import { Cell } from './messages' */

const pause = 5000; // ms between two looks

const heads = ['Cell', 'Agents', 'Goal', 'Arms', 'Stopped by', 'Last word'];

/** @param {string} text */
const warning = (text) => text && element('span', { class: 'chip bad' }, text);

// Another board tells the address, so it is a link only to where TLS is spoken.
/** @param {Cell} cell */
function nameOf({ path, console, leads }) {
  const name = path || 'this one';
  const linked = console.startsWith('https://');
  return element(
    'td',
    {},
    linked ? element('a', { href: console, target: '_blank', rel: 'noopener noreferrer' }, name) : name,
    leads && element('small', { class: 'quiet' }, `${leads} leads`),
  );
}

/** @param {Cell} cell @returns {TableCell[]} */
function rowOf(cell) {
  const name = nameOf(cell);
  if (cell.fault) return [name, element('td', { colspan: heads.length - 1 }, warning(cell.fault))];
  return [name, cell.agents, cell.goal, cell.arms, warning(cell.stops), cell.said];
}

// A link that has the focus keeps it.
/** @param {Table} cells @param {TableCell[][]} rows */
function fillKeepingFocus(cells, rows) {
  const held = document.activeElement;
  const at = held instanceof HTMLAnchorElement && cells.panel.contains(held) && held.href;
  cells.fill(rows);
  if (at) [...cells.panel.querySelectorAll('a')].find((link) => link.href === at)?.focus();
}

/** @param {Connection} connection */
export function showCells(connection) {
  const cells = table({ id: 'cells-table' }, heads);
  const note = element('p', { class: 'quiet', role: 'status' }, 'looking …');
  const panel = find('cells');
  panel.append(cells.panel, note);
  let onScreen = false;
  let looking = false;
  let timer = 0;
  const look = async () => {
    clearTimeout(timer);
    if (looking || !onScreen) return;
    looking = true;
    try {
      const seen = await connection.cells();
      fillKeepingFocus(cells, seen.cells.map(rowOf));
      note.textContent = seen.more ? `More than these ${seen.cells.length} are named: ./pizarra cells lists all` : '';
    } catch (failure) {
      note.textContent = failureText(failure);
    }
    looking = false;
    timer = setTimeout(look, pause);
  };
  new IntersectionObserver((entries) => {
    onScreen = entries[entries.length - 1].isIntersecting;
    look();
  }).observe(panel);
  connection.follow('(context-board ?name ?address)', (answers) => {
    if (answers.length > 0) find('tab-cells').hidden = false; // and stays: somebody may be looking
  });
}
