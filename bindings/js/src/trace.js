// The trace of a query as plain objects.

export function traceReader(core, layout) {
  const all = (type, pointer, count, read = (x) => x) => layout.readAll(type, pointer, count).map(read);
  const points = (pointer, count) => all(layout.support, pointer, count);
  const corners = (pointer, count) => all(layout.realVector, pointer, count);
  return (trace) => {
    const p = core.room(layout.traceView.size);
    core.check(core.exports.graze_trace_view(trace, p));
    const view = layout.traceView.read(p);
    return {
      method: core.string(view.method),
      winner: core.string(view.winner),
      reason: core.string(view.reason),
      axes: all(layout.traceAxis, view.axes, view.axisCount, (axis) => ({
        name: core.string(axis.name),
        direction: axis.direction,
        a: [axis.aLower, axis.aUpper],
        b: [axis.bLower, axis.bUpper],
        overlap: axis.aUpper - axis.bLower,
      })),
      gjk: all(layout.traceGjk, view.gjk, view.gjkCount, ({ simplexCount, polygonCount, ...step }) => ({
        ...step,
        simplex: points(step.simplex, simplexCount),
        polygon: points(step.polygon, polygonCount),
      })),
      epa: all(layout.traceEpa, view.epa, view.epaCount, ({ polygonCount, ...step }) => ({
        ...step,
        polygon: points(step.polygon, polygonCount),
      })),
      difference: points(view.difference, view.differenceCount),
      rounding: view.rounding,
      polytope: points(view.polytope, view.polytopeCount),
      triangles: all(layout.traceTriangle, view.triangles, view.triangleCount),
      spans: all(layout.traceSpan, view.spans, view.spanCount, (span) => ({ ...span, name: core.string(span.name) })),
      steps: all(layout.traceStep, view.steps, view.stepCount),
      faceA: corners(view.faceA, view.faceACount),
      faceB: corners(view.faceB, view.faceBCount),
      cuts: all(layout.traceCut, view.cuts, view.cutCount, ({ leftCount, ...cut }) => ({
        ...cut,
        left: corners(cut.left, leftCount),
      })),
      nodes: view.nodes,
      pieces: view.pieces,
    };
  };
}
