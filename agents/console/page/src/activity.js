// What goes on on the board, once a second, as `top` has it: taken while one of the parts that show it is on the screen.
//
//   const activity = new Activity(connection);
//   activity.shownIn(panel, (sample, why) => ...);        // null and why, where it cannot be had

export class Activity {
  #connection;
  #parts = new Map(); // whether each is on the screen
  #listeners = [];
  #on = false;

  constructor(connection) {
    this.#connection = connection;
  }

  shownIn(panel, listener) {
    this.#listeners.push(listener);
    this.#parts.set(panel, false);
    new IntersectionObserver((entries) => {
      this.#parts.set(panel, entries.at(-1).isIntersecting);
      this.#choose();
    }).observe(panel);
  }

  #choose() {
    const on = [...this.#parts.values()].includes(true);
    if (on === this.#on) return;
    this.#on = on;
    const tell = (sample, why) => this.#listeners.forEach((listener) => listener(sample, why));
    this.#connection.sampleActivity(on ? tell : null);
  }
}
