// Formulas. A lesson writes them as text, `d = |c_B - c_A| <= r_A + r_B`, and the page shows MathML.
//
//   x_A       a subscript           frac(a, b)   a fraction         a*b  a·b   products
//   x^2       a superscript         sqrt(a)      a root             <=  >=  !=  ->  in  sum  theta ...
//   |a|       bars                  [x, y]       a vector           "words"

import { digits } from "./dom.ts";

const namespace = "http://www.w3.org/1998/Math/MathML";

function element(tag: string, ...children: (Node | string)[]): Element {
  const made = document.createElementNS(namespace, tag);
  made.append(...children);
  return made;
}

/** A narrow space. */
const thin = "\u2009";
const operators: Record<string, string> = {
  "<=": "≤", ">=": "≥", "!=": "≠", "->": "→", "-": "−", "*": "·", "·": "·", "×": "×", "⊕": "⊕", "⊖": "⊖", "&": `${thin}&${thin}`,
};
const names: Record<string, string> = {
  theta: "θ", mu: "μ", omega: "ω", sum: "∑", in: "∈", pi: "π", infinity: "∞",
};
const functions = /^(max|min|conv)$/;
const token = /\s*("[^"]*"|[0-9]+(?:\.[0-9]+)?(?:e[−-]?[0-9]+)?|<=|>=|!=|->|[A-Za-z]+|[^\s])/y;

/** Brackets grow with fractions alone: beside an index they would be twice as high as what they hold. */
function bracketed(open: string, inside: Element, close: string): Element {
  const signs = [open, close].map((sign) => element("mo", sign));
  if (!inside.querySelector("mfrac")) for (const sign of signs) sign.setAttribute("stretchy", "false");
  return element("mrow", signs[0], inside, signs[1]);
}

export function formula(text: string): Element {
  const tokens: string[] = [];
  token.lastIndex = 0;
  for (let m = token.exec(text); m; m = token.exec(text)) tokens.push(m[1]);
  let at = 0;

  function group(close: string): Element {
    const row = element("mrow");
    while (at < tokens.length && tokens[at] !== close) row.append(scripted());
    at++;
    return row;
  }
  function argument(): Element {
    const row = element("mrow");
    while (at < tokens.length && tokens[at] !== "," && tokens[at] !== ")") row.append(scripted());
    at++;
    return row;
  }
  function atom(): Element {
    const word = tokens[at++];
    if (word === undefined) return element("mrow");
    if (word[0] === '"') return element("mtext", word.slice(1, -1));
    if (/^[0-9]/.test(word)) return element("mn", word);
    if (word === "frac" && tokens[at] === "(") {
      at++;
      return element("mfrac", argument(), argument());
    }
    if (word === "sqrt" && tokens[at] === "(") {
      at++;
      return element("msqrt", argument());
    }
    if (word === "(") return bracketed("(", group(")"), ")");
    if (word === "[") return bracketed("(", group("]"), ")");
    if (word === "{") return group("}");
    if (word === "|") return bracketed("|", group("|"), "|");
    if (/^(and|or)$/.test(word)) return element("mtext", `\u00a0${word}\u00a0`);
    if (functions.test(word)) return element("mtext", word);
    if (names[word]) return element("mi", names[word]);
    if (/^[A-Za-zα-ω]/.test(word)) return element("mi", word);
    return element("mo", operators[word] ?? word);
  }
  function scripted(): Element {
    const named = functions.test(tokens[at]), base = atom();
    let below: Element | undefined, above: Element | undefined;
    while (tokens[at] === "_" || tokens[at] === "^") {
      const kind = tokens[at++];
      const script = atom();
      if (kind === "_") below = script;
      else above = script;
    }
    const made = below && above ? element("msubsup", base, below, above)
      : below ? element("msub", base, below) : above ? element("msup", base, above) : base;
    return named && tokens[at] !== "(" ? element("mrow", made, element("mtext", thin)) : made;
  }

  const math = element("math");
  math.setAttribute("display", "block");
  const row = element("mrow");
  while (at < tokens.length) row.append(scripted());
  math.append(row);
  return math;
}

/** Shrinks formulas that are wider than their place, down to what can still be read; the rest can be scrolled to. All
 *  are measured before the first is changed, so that they are laid out once. */
export function fit(shown: HTMLElement[]): void {
  const smallest = 0.6;
  for (const one of shown) one.style.fontSize = "";
  const widths = shown.map(({ clientWidth, scrollWidth }) => [clientWidth, scrollWidth]);
  shown.forEach((one, i) => {
    const [place, wanted] = widths[i];
    if (wanted > place) one.style.fontSize = `${Math.max(smallest, (0.98 * place) / wanted)}em`;
  });
}

/** A vector as text of a formula; the rounding of zero is shown as zero. */
export const row = (v: readonly number[], significant = 3): string =>
  `[${v.map((x) => digits(Math.abs(x) < 1e-15 ? 0 : x, significant)).join(", ")}]`;
/** A number as a factor or a term behind a minus: in brackets where it is negative. */
export const term = (x: number | string, significant = 4): string =>
  Number(x) < 0 ? `(${digits(x, significant)})` : digits(x, significant);
