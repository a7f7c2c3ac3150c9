// The page's elements. Text goes in as text alone: no fact is ever read as HTML.

export const find = (id) => document.getElementById(id);

// element('button', { class: 'quiet', title: 'why' }, 'Cancel', child)
export const element = (tag, attributes, ...children) => filled(document.createElement(tag), attributes, children);
// drawn('rect', { x: 3, y: 4, class: 'mark' }), within an `svg`
export const drawn = (tag, attributes, ...children) =>
  filled(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);

function filled(made, attributes = {}, children = []) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
    else if (value === true) made.setAttribute(name, '');
    else if (value !== false && value != null) made.setAttribute(name, value);
  }
  made.append(...children.filter((child) => child != null));
  return made;
}

// Makes these the children of `parent`. One that stays is not taken out meanwhile: it may be under the pointer.
export function arrange(parent, children) {
  const wanted = new Set(children);
  for (const child of [...parent.children]) if (!wanted.has(child)) child.remove();
  children.forEach((child, index) => {
    const there = parent.children[index];
    if (there !== child) parent.insertBefore(child, there ?? null);
  });
}

export const clipped = (text, most = 300) =>
  text.length > most ? `${text.slice(0, most)} … (${text.length} characters)` : text;

export const clock = (microseconds) => new Date(microseconds / 1000).toLocaleTimeString('en-GB', { hour12: false });

// What a failure says, as the prompt says it.
export const failureText = (failure) => clipped(failure.said ?? failure.sentence ?? String(failure), 1600);

// Does `draw` once before the next frame, however often it is asked for.
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
