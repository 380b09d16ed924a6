// Elements of the page. No markup is parsed from state: texts of lessons are constants, everything else is text nodes.

type Child = Node | string | number | null | undefined | false;
type Attributes = Record<string, unknown>;

function fill(element: Element, attributes: Attributes, children: Child[]): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value as EventListener);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  for (const child of children)
    if (child !== null && child !== undefined && child !== false)
      element.append(child instanceof Node ? child : String(child));
}

export function h(tag: string, attributes: Attributes = {}, ...children: Child[]): HTMLElement {
  const element = document.createElement(tag);
  fill(element, attributes, children);
  return element;
}

export function svg(tag: string, attributes: Attributes = {}, ...children: Child[]): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  fill(element, attributes, children);
  return element;
}

export const button = (label: string, act: () => void, more: Attributes = {}): HTMLButtonElement =>
  h("button", { type: "button", onclick: act, ...more }, label) as HTMLButtonElement;

/** Sets an attribute where it differs: a browser takes one that is set again for a change. */
export function set(element: Element, name: string, value: string): void {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

/** Makes a text all that an element holds, where it differs. */
export function write(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** Makes the children of an element equal to `wanted`. Where one of the same kind stands in its place already, only its
 *  words and attributes are changed, which a browser lays out in a fraction of the time; its listeners stay, so none of
 *  `wanted` has any. */
export function update(element: Element, wanted: Node[]): void {
  const there = [...element.childNodes];
  for (const [i, node] of wanted.entries()) {
    const old = there[i];
    if (!old) element.append(node);
    else if (old.isEqualNode(node)) continue;
    else if (old instanceof Element && node instanceof Element && old.nodeName === node.nodeName) {
      for (const { name } of [...old.attributes]) if (!node.hasAttribute(name)) old.removeAttribute(name);
      for (const { name, value } of node.attributes) set(old, name, value);
      update(old, [...node.childNodes]);
    } else if (old instanceof Text && node instanceof Text) {
      if (old.data !== node.data) old.data = node.data;
    } else old.replaceWith(node);
  }
  for (const rest of there.slice(wanted.length)) rest.remove();
}

/** Words of the library, which begin small and end without a dot, as a sentence. */
export const sentence = (words: string): string => `${words.charAt(0).toUpperCase()}${words.slice(1)}.`;

/** Six significant digits, as tables show numbers; the whole number is in the title of its cell. */
export function digits(value: number | string | undefined, significant = 6): string {
  if (value === undefined) return "";
  if (typeof value === "string") return value.replace("infinity", "∞").replace("-", "−");
  if (value === 0) return "0";
  if (Math.abs(value) < 1e-12) return value.toExponential(1).replace("-", "−").replace("e-", "e−");
  const text = Math.abs(value) < 1e-4 || Math.abs(value) >= 1e7
    ? value.toExponential(significant - 3)
    : String(Number(value.toPrecision(significant)));
  return text.replaceAll("-", "−");
}
export const vector = (v: readonly number[] | undefined, significant = 4): string =>
  v ? `(${v.map((x) => digits(Math.abs(x) < 1e-15 ? 0 : x, significant)).join(", ")})` : "";
