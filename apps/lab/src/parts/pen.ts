// A layer of an SVG picture that is drawn anew for each frame, while its elements stay: of what stands there already
// only the attributes and words that differ are changed. A browser then makes, styles and lays out nothing that looks
// as before.

import { svg } from "./dom.ts";

type Attributes = Record<string, string | number | undefined>;
/** An element that was drawn, and what it was drawn with, which the page could tell only more slowly. */
interface Drawn {
  tag: string;
  element: SVGElement;
  attributes: Attributes;
  text: string;
}

export class Pen {
  readonly element = svg("g");
  private readonly drawn: Drawn[] = [];
  /** How many elements this picture has so far. */
  private count = 0;

  /** Begins a picture. */
  begin(): void {
    this.count = 0;
  }
  /** Draws an element above those before it. */
  put(tag: string, attributes: Attributes, text = ""): void {
    const before = this.drawn[this.count], at = this.count++;
    if (before?.tag === tag) return change(before, attributes, text);
    const element = svg(tag, attributes, text);
    if (before) before.element.replaceWith(element);
    else this.element.append(element);
    this.drawn[at] = { tag, element, attributes, text };
  }
  /** Ends a picture: what only the one before it had is taken away. */
  end(): void {
    for (const { element } of this.drawn.splice(this.count)) element.remove();
  }
}

function change(drawn: Drawn, attributes: Attributes, text: string): void {
  const { element, attributes: before } = drawn;
  for (const name in attributes)
    if (attributes[name] !== before[name] && attributes[name] !== undefined) element.setAttribute(name, String(attributes[name]));
  for (const name in before)
    if (before[name] !== undefined && attributes[name] === undefined) element.removeAttribute(name);
  if (text !== drawn.text) element.textContent = text;
  drawn.attributes = attributes;
  drawn.text = text;
}
