#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/explain_parts.hpp"

namespace graze::io {

namespace {

constexpr double widest_row = 26;

/// Names longer than their column are set smaller.
double font_for(const std::string& name) {
  constexpr double usual = 12, letter = 0.56;
  return std::clamp((name_width - 6) / (letter * static_cast<double>(name.size())), 7.0, usual);
}

std::string row_text(double y, double row, const std::string& name, const std::string& number) {
  return text(list_x, y + row / 2 + 4, font_for(name), name) +
         text(number_x, y + row / 2 + 4, 12, number, "ink", "end");
}

/// The axes of least overlap, in the order in which they were tried.
std::vector<const TraceAxis*> shown_axes(const Trace& trace) {
  std::vector<const TraceAxis*> axes;
  for (const TraceAxis& axis : trace.axes) axes.push_back(&axis);
  if (axes.size() <= most_rows) return axes;
  std::stable_sort(axes.begin(), axes.end(), [](auto* p, auto* q) { return p->overlap() < q->overlap(); });
  axes.resize(most_rows);
  std::sort(axes.begin(), axes.end());
  return axes;
}

/// The spans that matter most: those met last, in the order in which they were tried.
std::vector<const TraceSpan*> shown_spans(const Trace& trace) {
  std::vector<const TraceSpan*> spans;
  for (const TraceSpan& span : trace.spans) spans.push_back(&span);
  if (spans.size() <= most_rows) return spans;
  const auto later = [](auto* p, auto* q) { return p->enter > q->enter; };
  std::stable_sort(spans.begin(), spans.end(), later);
  spans.resize(most_rows);
  std::sort(spans.begin(), spans.end());
  return spans;
}

std::string head(double x, const std::string& words, const std::string& look = "soft", const char* anchor = "start") {
  return text(x, head_height + 4, 12, words, look, anchor);
}

}  // namespace

std::string bar(double x0, double x1, double y, const Color& color) {
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"5\" rx=\"2\" fill=\"{}\"/>\n", x0, y,
                     std::max(x1 - x0, 1.5), hex(color));
}

std::string chosen_row(double y, double height) {
  return fmt::format("<rect x=\"{}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.1f}\" rx=\"4\" class=\"chosen\"/>\n",
                     list_x - 8, y - 1, number_x - list_x + 16, height - 1);
}

std::string draw_axes(const Explanation& e, double bottom) {
  const auto axes = shown_axes(e.trace);
  double widest = 0;
  const auto ends = [](const TraceAxis& axis) {
    double low = std::min(axis.a_lower, axis.b_lower), high = std::max(axis.a_upper, axis.b_upper);
    if (!std::isfinite(low)) low = std::max(axis.a_lower, axis.b_lower);
    if (!std::isfinite(high)) high = std::min(axis.a_upper, axis.b_upper);
    return std::pair{low, high};
  };
  for (const TraceAxis* axis : axes) widest = std::max(widest, ends(*axis).second - ends(*axis).first);
  if (!(widest > 0) || !std::isfinite(widest)) return "";
  const double row = std::min(widest_row, (bottom - head_height - 34) / static_cast<double>(axes.size()));
  std::string out =
      head(bars_x, "A", hex(color_a)) + head(bars_x + 14, "B", hex(color_b)) + head(number_x, "overlap", "soft", "end");
  double y = head_height + 14;
  for (const TraceAxis* axis : axes) {
    const auto [low, high] = ends(*axis);
    const double scale = bars_width / widest, start = bars_x + (bars_width - (high - low) * scale) / 2;
    const auto x = [&, low = low, high = high](double t) { return start + (std::clamp(t, low, high) - low) * scale; };
    if (axis->name == e.trace.winner) out += chosen_row(y, row);
    out += row_text(y, row, axis->name,
                    std::isfinite(axis->overlap()) ? fmt::format("{:.4g}", axis->overlap()) : "endless");
    out += bar(x(axis->a_lower), x(axis->a_upper), y + row / 2 - 6, color_a);
    out += bar(x(axis->b_lower), x(axis->b_upper), y + row / 2 + 1, color_b);
    y += row;
  }
  if (axes.size() < e.trace.axes.size())
    out += text(list_x, picture_height - 16, 12,
                fmt::format("the {} of {} axes that overlap least", axes.size(), e.trace.axes.size()), "soft");
  return out;
}

std::string draw_spans(const Explanation& e) {
  const auto spans = shown_spans(e.trace);
  if (spans.empty()) return "";
  double low = 0, high = e.ray->hit ? e.ray->hit->t : 0;
  for (const TraceSpan* span : spans)
    for (const double t : {span->enter, span->leave})
      if (span->enter <= span->leave && std::isfinite(t)) low = std::min(low, t), high = std::max(high, t);
  // Far crossings of planes nearly along the ray would leave no room for the rest.
  const double most = e.ray->hit ? 4 * std::max(e.ray->hit->t, 1e-300) : high;
  high = std::min(high, most), low = std::max(low, -high);
  if (!(high > low)) return "";
  high += 0.08 * (high - low);  // the span that begins last is seen too
  const auto x = [&](double t) { return bars_x + (std::clamp(t, low, high) - low) / (high - low) * bars_width; };
  const double row = std::min(widest_row, (picture_height - 60 - head_height) / static_cast<double>(spans.size()));
  std::string out = head(bars_x, "where along the ray") + head(number_x, "enters", "soft", "end");
  double y = head_height + 14;
  const double top = y;
  for (const TraceSpan* span : spans) {
    const bool met = span->enter <= span->leave;
    if (span->name == e.trace.winner) out += chosen_row(y, row);
    const std::string enter = !met                         ? "never"
                              : std::isfinite(span->enter) ? fmt::format("{:.5g}", span->enter)
                                                           : "always";
    out += row_text(y, row, span->name, enter);
    if (met) out += bar(x(span->enter), x(span->leave), y + row / 2 - 2, color_a);
    y += row;
  }
  if (e.ray->hit)
    out += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" class=\"shared\" stroke-width=\"1.2\"/>\n",
                       x(e.ray->hit->t), top, y) +
           text(x(e.ray->hit->t), y + 14, 12, fmt::format("hit at {:.5g}", e.ray->hit->t), "red", "middle");
  if (spans.size() < e.trace.spans.size())
    out += text(list_x, picture_height - 16, 12,
                fmt::format("the {} of {} spans that begin last", spans.size(), e.trace.spans.size()), "soft");
  return out;
}

std::string draw_steps(const Explanation& e, double bottom) {
  const auto& steps = e.trace.steps;
  const double row = 18;
  const auto room = static_cast<std::size_t>((bottom - head_height - 44) / row);
  // The first and the last of many: between them each is a fraction of the one before.
  const std::size_t shown = std::min(steps.size(), room), first = shown < steps.size() ? shown / 2 : shown;
  double least = 1e300, most = 0;
  for (const TraceStep& step : steps)
    if (step.distance > 0) least = std::min(least, step.distance), most = std::max(most, step.distance);
  if (!(most > 0)) return "";
  const double low = std::floor(std::log10(least)) - 0.01, high = std::max(std::ceil(std::log10(most)), low + 1);
  const auto x = [&](double d) { return bars_x + (std::log10(d) - low) / (high - low) * bars_width; };
  std::string out = head(list_x, e.ray ? "step  along the ray" : "step  time") + head(bars_x, "distance, logarithmic") +
                    head(number_x, "distance", "soft", "end");
  double y = head_height + 14;
  for (std::size_t k = 0; k < shown; ++k, y += row) {
    const std::size_t i = k < first ? k : steps.size() - (shown - k);
    const TraceStep& step = steps[i];
    out += text(list_x, y + 12, 12, fmt::format("{:>2}", i + 1), "soft") +
           text(list_x + 28, y + 12, 12, fmt::format("{:.9g}", step.t)) +
           text(number_x, y + 12, 12, fmt::format("{:.3g}", step.distance), "ink", "end");
    if (step.distance > 0) out += bar(bars_x, x(step.distance), y + 5, color_a);
  }
  return out + text(bars_x, y + 10, 10, fmt::format("1e{:.0f}", std::ceil(low)), "soft") +
         text(bars_x + bars_width, y + 10, 10, fmt::format("1e{:.0f}", high), "soft", "end");
}

}  // namespace graze::io
