// The instant that is shown: one for the picture and all charts.

export class Clock {
  /** @param t growing abscissa */
  constructor(t) {
    this.t = t;
    this.at = t.length ? t[0] : 0;
    this.listeners = [];
  }
  get first() { return this.t[0]; }
  get last() { return this.t[this.t.length - 1]; }
  listen(listener) {
    this.listeners.push(listener);
    listener(this.at);
  }
  set(at) {
    this.at = Math.max(this.first, Math.min(this.last, at));
    for (const listener of this.listeners) listener(this.at);
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
