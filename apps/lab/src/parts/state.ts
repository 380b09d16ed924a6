// A page's whole state: in the address, from the address, with undo and redo.

/** The address after the `#`: a path and its values. */
export interface Place {
  path: string;
  values: Record<string, string>;
}

export function readPlace(): Place {
  const [path, rest = ""] = location.hash.replace(/^#/, "").split("?");
  return { path: path || "/", values: Object.fromEntries(new URLSearchParams(rest)) };
}
export function address(path: string, values: Record<string, string>): string {
  const rest = new URLSearchParams(values).toString();
  return `#${path}${rest ? `?${rest}` : ""}`;
}

/** Puts a text where it can be pasted from. A browser lets a page do so over https and from the machine itself alone. */
export async function copy(text: string): Promise<void> {
  if (!navigator.clipboard) throw new Error("The browser lets nothing be copied from a page that comes over http: copy the address by hand.");
  await navigator.clipboard.writeText(text);
}
/** The value of the address as JSON, or `otherwise`: an address can hold anything. */
export function parse<T>(text: string | undefined, otherwise: T, accepts: (value: unknown) => boolean): T {
  if (!text) return otherwise;
  try {
    const value = JSON.parse(text) as unknown;
    return accepts(value) ? (value as T) : otherwise;
  } catch {
    return otherwise;
  }
}

/** The numbers of a camera in an address, with all digits that they need: rounded, another address would be written as
 *  soon as this one was opened, and far from the origin another picture shown. */
export const cameraText = (camera: readonly number[]): string => camera.join(",");
export function cameraOf(text: string | undefined): number[] | null {
  const numbers = text?.split(",").map(Number) ?? [];
  return numbers.length > 0 && numbers.every(Number.isFinite) ? numbers : null;
}
/** Calls `act` once things have been still for a while: a browser refuses hundreds of addresses a minute. */
export function whenStill(act: () => void, milliseconds = 250): { call(): void; cancel(): void } {
  let timer = 0;
  const cancel = (): void => window.clearTimeout(timer);
  return { cancel, call: () => (cancel(), (timer = window.setTimeout(act, milliseconds))) };
}

/** Past and future of one value. */
export class History<T> {
  private past: string[] = [];
  private future: string[] = [];
  private now: string;

  constructor(start: T) {
    this.now = JSON.stringify(start);
  }
  /** Adds a new present; the same again changes nothing. */
  push(value: T): void {
    const text = JSON.stringify(value);
    if (text === this.now) return;
    this.past.push(this.now);
    if (this.past.length > 200) this.past.shift();
    this.future = [];
    this.now = text;
  }
  get hasPast(): boolean {
    return this.past.length > 0;
  }
  get hasFuture(): boolean {
    return this.future.length > 0;
  }
  undo(): T | null {
    return this.swap(this.past, this.future);
  }
  redo(): T | null {
    return this.swap(this.future, this.past);
  }
  private swap(from: string[], to: string[]): T | null {
    const value = from.pop();
    if (value === undefined) return null;
    to.push(this.now);
    this.now = value;
    return JSON.parse(value) as T;
  }
}
