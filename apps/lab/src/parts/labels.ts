// Places of labels: beside their point, where they hide nothing and nothing hides them.

/** A rectangle of the stage in pixels, y downwards. */
export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** The height of a line of a label in pixels. */
export const labelHeight = 18;
/** The gaps between a point and its label in pixels, tried in this order: beside the point, and beyond the handle that
 *  lies on it. */
const gaps = [6, 18, 24, 40];
/** The sides of a point on which its label may lie, tried in this order. */
const sides = [[1, -1], [-1, -1], [1, 1], [-1, 1], [0, -1], [0, 1], [1, 0], [-1, 0]];

const overlap = (p: Box, q: Box): number =>
  Math.max(0, Math.min(p.right, q.right) - Math.max(p.left, q.left)) * Math.max(0, Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top));
const around = (x: number, y: number, half: number): Box => ({ left: x - half, top: y - half, right: x + half, bottom: y + half });

/** The places of one picture's labels, taken one after the other. Linear in what is there already. */
export class LabelPlaces {
  private readonly taken: Box[] = [];
  private readonly stage: Box;

  constructor([width, height]: [number, number]) {
    this.stage = { left: 0, top: 0, right: width, bottom: height };
  }
  /** Keeps labels off the square about a point: a handle, a dot. */
  keep([x, y]: [number, number], half: number): void {
    this.taken.push(around(x, y, half));
  }
  /** Keeps labels off a rectangle of the stage. */
  keepBox(box: Box): void {
    this.taken.push(box);
  }
  /** Keeps labels off a line: off squares along it that are closer to each other than a letter is wide. */
  keepLine(from: [number, number], to: [number, number], half: number): void {
    const along = [to[0] - from[0], to[1] - from[1]], count = Math.min(100, Math.ceil(Math.hypot(...along) / 8));
    for (let i = 0; i <= count; i++) this.keep([from[0] + (along[0] * i) / (count || 1), from[1] + (along[1] * i) / (count || 1)], half);
  }
  /** The box of a label at a point: the first place in the stage where nothing lies, or else that which hides least.
   *  The label of a point outside the stage stays with it, unseen. Beside the end of a line that comes `from` elsewhere
   *  those sides are tried first that are furthest from the line. */
  place([x, y]: [number, number], text: string, from: [number, number] = [x, y]): Box {
    const { stage } = this, seen = overlap(around(x, y, 0.5), stage) > 0, width = widthOf(text);
    const onwards = ([toRight, down]: number[]): number => ((x - from[0]) * toRight + (y - from[1]) * down) / Math.hypot(toRight, down);
    const tried = [...sides].sort((p, q) => onwards(q) - onwards(p));
    let best: Box | undefined, least = Infinity;
    search: for (const gap of gaps)
      for (const [toRight, down] of tried) {
        const left = toRight ? x + (toRight > 0 ? gap : -gap - width) : x - width / 2;
        const top = down ? y + (down > 0 ? gap : -gap - labelHeight) : y - labelHeight / 2;
        const box = { left, top, right: left + width, bottom: top + labelHeight };
        const cut = width * labelHeight - overlap(box, stage);
        // What is cut cannot be read at all: it weighs more than a dot or a letter below.
        const cost = this.taken.reduce((sum, other) => sum + overlap(box, other), 4 * cut);
        if (cost < least) [best, least] = [box, cost];
        if (cost < 1 || !seen) break search; // less than a pixel is what rounding leaves of a label that is free
      }
    if (seen) this.taken.push(best!);
    return best!;
  }
}

const widths = new Map<string, number>();
let pen: CanvasRenderingContext2D | null = null;
/** The width of a text in the font of the labels, in pixels. */
function widthOf(text: string): number {
  let width = widths.get(text);
  if (width === undefined) {
    if (!pen) {
      pen = document.createElement("canvas").getContext("2d")!;
      pen.font = `600 14px ${getComputedStyle(document.documentElement).fontFamily}`;
    }
    if (widths.size > 2000) widths.clear();
    width = Math.ceil(pen.measureText(text).width);
    widths.set(text, width);
  }
  return width;
}
