// What the checks need of an assertion library, in Node and in a browser.

const text = (value) =>
  JSON.stringify(value, (_, v) => (typeof v === "bigint" ? `${v}n` : typeof v === "number" && !Number.isFinite(v) ? `${v}` : v));

export function ok(condition, what = "condition") {
  if (!condition) throw new Error(`${what} does not hold`);
}
export function equal(got, expected, what = "value") {
  if (text(got) !== text(expected)) throw new Error(`${what}: expected ${text(expected)}, got ${text(got)}`);
}
/** Numbers, and arrays of them. */
export function close(got, expected, tolerance, what = "value") {
  const gotten = [got].flat(Infinity);
  const wanted = [expected].flat(Infinity);
  const near = gotten.length === wanted.length && gotten.every((x, i) => Math.abs(x - wanted[i]) <= tolerance);
  if (!near) throw new Error(`${what}: expected ${text(expected)} within ${tolerance}, got ${text(got)}`);
}
/** `message` is the whole message, or a regular expression. */
export function throws(body, message, type) {
  let thrown;
  try {
    body();
  } catch (error) {
    thrown = error;
  }
  ok(thrown !== undefined, `that it throws "${message}"`);
  if (message instanceof RegExp) ok(message.test(thrown.message), `that ${text(thrown.message)} has the form ${message}`);
  else equal(thrown.message, message, "message");
  if (type !== undefined) ok(thrown instanceof type, `that the error is a ${type.name}`);
}
/** Whether the engine knows `using` of its own. */
export const knowsUsing = (() => {
  try {
    new Function("{ using nothing = null; }");
    return true;
  } catch {
    return false;
  }
})();
