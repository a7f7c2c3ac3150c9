// A line that is lost on its way ends no connection: what is missing says so.
//
//   const silence = new Silence((state, why) => ...);       'silent' and for how long; 'live' when it is over
//   silence.begin(); silence.heard(); silence.end();

// Stamps come once a second at least.
const longest = 2500; // milliseconds
const often = 250;

export class Silence {
  #tell;
  /** @type {number | undefined} */
  #timer;
  #heard = 0; // by the page's own clock
  #silent = false;

  /** @param {(state: 'silent' | 'live', why?: string) => void} tell */
  constructor(tell) {
    this.#tell = tell;
  }

  begin() {
    this.end();
    this.#silent = false;
    this.#heard = performance.now();
    this.#timer = setInterval(() => this.#note(), often);
  }
  end() {
    clearInterval(this.#timer);
  }
  heard() {
    this.#heard = performance.now();
    if (this.#silent) this.#note();
  }

  #note() {
    const silence = performance.now() - this.#heard;
    const before = this.#silent;
    this.#silent = silence > longest;
    if (this.#silent) this.#tell('silent', `for ${Math.floor(silence / 1000)} s`);
    else if (before) this.#tell('live');
  }
}
