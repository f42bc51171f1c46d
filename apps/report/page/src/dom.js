// Elements by their parts. Every text goes in as text, never as HTML.

export function el(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  fill(node, attributes, children);
  return node;
}

export function svg(tag, attributes = {}, ...children) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  fill(node, attributes, children);
  return node;
}

function fill(node, attributes, children) {
  for (const [key, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (key.startsWith('on')) node.addEventListener(key.slice(2), value);
    else node.setAttribute(key, value === true ? '' : value);
  }
  for (const child of children.flat()) {
    if (child === undefined || child === null || child === false) continue;
    node.append(child instanceof Node ? child : document.createTextNode(String(child)));
  }
}

/** A name or key, with places where its line may end: behind "_", ".", "+" and the like. */
export function breakable(text) {
  return text.split(/(?<=[_/\\,=+]|\.(?=[a-z_]))(?=.)/i).flatMap((part, i) => (i ? [el('wbr'), part] : [part]));
}

export function card(title, ...children) {
  return el('section', { class: 'card' }, title ? el('h2', {}, title) : null, ...children);
}

/** A CSS variable of the page's theme. */
export function theme(name) {
  return getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
}

const listeners = [];
/** Called after a change between light and dark. */
export function onTheme(listener) {
  listeners.push(listener);
}
export function setTheme(dark) {
  document.documentElement.dataset.theme = dark ? 'dark' : 'light';
  for (const listener of listeners) listener();
}
export function isDark() {
  const chosen = document.documentElement.dataset.theme;
  return chosen ? chosen === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
}
// Paper is light, whatever the screen is: what is drawn into a canvas has to be drawn again.
let onScreen;
addEventListener('beforeprint', () => {
  onScreen ??= document.documentElement.dataset.theme ?? '';
  setTheme(false);
});
addEventListener('afterprint', () => {
  if (onScreen === undefined) return;
  document.documentElement.dataset.theme = onScreen;
  if (!onScreen) delete document.documentElement.dataset.theme;
  onScreen = undefined;
  for (const listener of listeners) listener();
});
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
  if (!document.documentElement.dataset.theme) for (const listener of listeners) listener();
});
