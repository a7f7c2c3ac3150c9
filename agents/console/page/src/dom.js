// The page's elements. Text goes in as text alone: no fact is ever read as HTML.

/** Those of index.html that can do more than any element.
 * @typedef {{
 *   cancel: HTMLButtonElement, 'clear-stops': HTMLButtonElement, 'confirm-stop': HTMLButtonElement, go: HTMLButtonElement,
 *   stop: HTMLButtonElement, confirm: HTMLDialogElement, refused: HTMLDialogElement,
 *   'goal-text': HTMLInputElement, token: HTMLInputElement, scene: HTMLCanvasElement }} Special
 * @typedef {Node | string | null | undefined} Child
 * @typedef {Record<string, string | number | boolean | null | undefined | ((event: any) => void)>} Attributes
 */

/** @type {<Id extends string>(id: Id) => Id extends keyof Special ? Special[Id] : HTMLElement} */
export const find = (id) => /** @type {any} */ (document.getElementById(id));

// element('button', { class: 'quiet', title: 'why' }, 'Cancel', child)
/** @type {<Tag extends keyof HTMLElementTagNameMap>(tag: Tag, attributes: Attributes, ...children: Child[]) => HTMLElementTagNameMap[Tag]} */
export const element = (tag, attributes, ...children) => filled(document.createElement(tag), attributes, children);
// drawn('rect', { x: 3, y: 4, class: 'mark' }), within an `svg`
/** @type {<Tag extends keyof SVGElementTagNameMap>(tag: Tag, attributes: Attributes, ...children: Child[]) => SVGElementTagNameMap[Tag]} */
export const drawn = (tag, attributes, ...children) =>
  filled(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);

/** @template {Element} Made @param {Made} made @param {Attributes} attributes @param {Child[]} children */
function filled(made, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') made.addEventListener(name.slice(2), value);
    else if (value === true) made.setAttribute(name, '');
    else if (value !== false && value != null) made.setAttribute(name, String(value));
  }
  made.append(...children.filter((child) => child != null));
  return made;
}

// What is drawn with on it.
/** @param {HTMLCanvasElement} canvas */
export const penOn = (canvas) => /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));

// Makes these the children of `parent`. One that stays is not taken out meanwhile: it may be under the pointer.
/** @param {Element} parent @param {Element[]} children */
export function arrange(parent, children) {
  const wanted = new Set(children);
  for (const child of [...parent.children]) if (!wanted.has(child)) child.remove();
  children.forEach((child, index) => {
    const there = parent.children[index];
    if (there !== child) parent.insertBefore(child, there ?? null);
  });
}

// Characters that turn the direction of the text behind them, so that it reads otherwise than it is.
const turning = /[\u202a-\u202e\u2066-\u2069]/g;
const turningNothing = (/** @type {string} */ text) => text.replace(turning, '\ufffd');

// What somebody told, as it may stand beside other words.
/** @param {string} text */
export const clipped = (text, most = 300) =>
  turningNothing(text.length > most ? `${text.slice(0, most)} … (${text.length} characters)` : text);

// Never -0.
/** @param {number} value @param {number} digits */
export const fixed = (value, digits) => (Number(value.toFixed(digits)) + 0).toFixed(digits);

/** @param {number} microseconds */
export const clock = (microseconds) => new Date(microseconds / 1000).toLocaleTimeString('en-GB', { hour12: false });

// What a failure says, as the prompt says it.
/** @param {any} failure what was caught: a Failure, or an Error of the page's own */
export const failureText = (failure) => clipped(failure.said ?? failure.sentence ?? String(failure), 1600);

// Does `draw` once before the next frame, however often it is asked for.
/** @param {() => void} draw */
export function eachFrame(draw) {
  let asked = false;
  return () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      draw();
    });
  };
}
