// Questions of the protocol's page and the answers below them, which are those of the native program.

export function pairsOfProtocol(page) {
  const lines = page.split("\n");
  return lines
    .map((line, i) => [line, lines[i + 1] ?? ""])
    .filter(([line, next]) => line.startsWith("{") && line.includes('"query"') && next.startsWith("{"));
}
