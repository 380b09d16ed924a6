// Values over time or steps: distance bounds of GJK, energy, deepest penetration, with the present step marked.

import { digits, svg } from "./dom.ts";

export interface Series {
  name: string;
  meaning: string;
  values: number[];
}
export interface Graph {
  caption: string;
  series: Series[];
  /** The step that is shown. */
  at: number;
  /** Whether the axis begins at the least value: for values that differ by little. */
  close?: boolean;
}

export function drawGraph(graph: Graph): SVGElement {
  const width = 320, height = 120, left = 8, bottom = 18, top = 10, right = 74;
  const all = graph.series.flatMap((s) => s.values).filter(Number.isFinite);
  const lower = graph.close && all.length > 0 ? Math.min(...all) : Math.min(0, ...all), upper = Math.max(...all, lower + 1e-9);
  const count = Math.max(2, ...graph.series.map((s) => s.values.length));
  const x = (i: number): number => left + ((width - left - right) * i) / (count - 1);
  const y = (v: number): number => top + (height - top - bottom) * (1 - (v - lower) / (upper - lower));
  const last = graph.series.map((s) => ({ name: s.name, value: s.values[Math.min(graph.at, s.values.length - 1)] }));
  const picture = svg("svg", {
    class: "graph", viewBox: `0 0 ${width} ${height}`, role: "img",
    "aria-label": `${graph.caption}: ${last.map((s) => `${s.name} ${digits(s.value, 4)}`).join(", ")}`,
  });
  picture.append(
    svg("line", { class: "grid", x1: left, x2: width - right, y1: y(Math.max(0, lower)), y2: y(Math.max(0, lower)) }),
    svg("line", { class: "now", x1: x(graph.at), x2: x(graph.at), y1: top, y2: height - bottom }),
    svg("text", { x: left, y: height - 4 }, graph.caption),
  );
  const labels: number[] = [];
  for (const s of graph.series) {
    const d = s.values
      .map((v, i) => (Number.isFinite(v) ? `${x(i).toFixed(1)} ${y(v).toFixed(1)}` : ""))
      .filter(Boolean)
      .map((p, i) => `${i ? "L" : "M"}${p}`)
      .join("");
    picture.append(svg("path", { class: `of-${s.meaning}`, d }));
    s.values.length < 40 && s.values.forEach((v, i) => {
      if (Number.isFinite(v)) picture.append(svg("circle", { class: `of-${s.meaning}`, cx: x(i), cy: y(v), r: 2 }));
    });
    let at = y(s.values.findLast(Number.isFinite) ?? 0) + 4;
    const away = at < height / 2 ? 12 : -12;
    while (labels.some((other) => Math.abs(other - at) < 12)) at += away;
    labels.push(at);
    picture.append(svg("text", { class: `of-${s.meaning}`, x: width - right + 6, y: at }, s.name));
  }
  return picture;
}
