// The instant that is shown: one for the picture and all charts.

const kReadable = 150;  // ms that a figure stays while the motion plays

/** Of a listener that writes figures: as often as they can be read, and whenever the motion stops. */
export function readable(listener) {
  let told = -Infinity;
  return (at, plays) => {
    const now = performance.now();
    if (plays && now - told < kReadable) return;
    told = now;
    listener(at);
  };
}

export class Clock {
  /** @param t growing abscissa */
  constructor(t) {
    this.t = t;
    this.at = t.length ? t[0] : 0;
    this.listeners = [];
  }
  get first() { return this.t[0]; }
  get last() { return this.t[this.t.length - 1]; }
  /** @param listener called with the instant, and whether the next one follows at once */
  listen(listener) {
    this.listeners.push(listener);
    listener(this.at, false);
  }
  set(at, plays = false) {
    this.at = Math.max(this.first, Math.min(this.last, at));
    for (const listener of this.listeners) listener(this.at, plays);
  }
  /** The instant as a number of records with its fraction. */
  record() {
    const { t, at } = this;
    let low = 0, high = t.length - 1;
    while (high - low > 1) {
      const mid = (low + high) >> 1;
      if (t[mid] <= at) low = mid;
      else high = mid;
    }
    const span = t[high] - t[low];
    return span > 0 ? low + (at - t[low]) / span : low;
  }
  step(count) {
    const to = Math.max(0, Math.min(this.t.length - 1, Math.round(this.record()) + count));
    this.set(this.t[to]);
  }
}
