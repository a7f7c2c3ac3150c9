// Whether the page is of the version that its console serves. A page that stood in its tab while the console was replaced
// is not: it loads anew, once, and says so afterwards. Where it comes back as it was, it says that.

import { find } from './dom.js';

const loadedFor = 'pizarra-loaded-for'; // the version for which this tab loaded the page anew

/** @param {string} sentence */
function say(sentence) {
  find('version-said').textContent = sentence;
  find('version-note').hidden = false;
  find('version-read').onclick = () => (find('version-note').hidden = true);
}

// The console serves that version. Answers whether this page is of another one.
/** @param {string} served */
export function isOutdated(served) {
  const outdated = served !== PAGE_VERSION;
  const before = sessionStorage.getItem(loadedFor);
  if (!outdated) {
    if (before === served) say('The console is of another version than before: this page was loaded anew.');
    sessionStorage.removeItem(loadedFor);
  } else if (before === served) {
    say('This page is of another version than the console, and loading it anew did not help. STOP works; nothing else does.');
  } else {
    sessionStorage.setItem(loadedFor, served);
    location.reload();
  }
  return outdated;
}
