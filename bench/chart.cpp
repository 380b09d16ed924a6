#include "chart.hpp"

#include <algorithm>
#include <cmath>

#include "table.hpp"

namespace graze::bench {

namespace {

constexpr double width = 860, left = 190, right = 664, top = 72, bar = 10, gap = 2, between = 8;

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return out;
}

class Drawing {
 public:
  void text(double x, double y, const std::string& what, const char* kind = "", const char* anchor = "start") {
    body_ += "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" class=\"" + kind + "\" text-anchor=\"" + anchor +
             "\">" + escaped(what) + "</text>\n";
  }
  void rectangle(double x, double y, double w, double h, const char* kind) {
    body_ += "<rect x=\"" + number(x) + "\" y=\"" + number(y) + "\" width=\"" + number(w) + "\" height=\"" + number(h) +
             "\" rx=\"1.5\" class=\"" + kind + "\"/>\n";
  }
  void line(double x, double y, double to_y) {
    body_ += "<line x1=\"" + number(x) + "\" y1=\"" + number(y) + "\" x2=\"" + number(x) + "\" y2=\"" + number(to_y) +
             "\"/>\n";
  }
  std::string svg(double height) const {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(width) + " " + number(height) +
           "\" font-family=\"system-ui, sans-serif\" font-size=\"12\">\n"
           "<style>\n"
           "text { fill: #1f2328 } .small { font-size: 10.5px; fill: #59636e } .title { font-size: 15px; font-weight: "
           "600 }\n"
           ".other { fill: #9aa4af } .one { fill: #1f6feb } .batch { fill: #1a7f37 } line { stroke: #9aa4af; "
           "stroke-opacity: 0.4 }\n"
           "@media (prefers-color-scheme: dark) {\n"
           "text { fill: #e6edf3 } .small { fill: #9198a1 } .other { fill: #656d76 } .one { fill: #4493f8 } .batch { "
           "fill: #3fb950 }\n"
           "}\n"
           "</style>\n" +
           body_ + "</svg>\n";
  }

 private:
  static std::string number(double v) { return printed("%.1f", v); }
  std::string body_;
};

/// How many times as fast.
std::string times(double other, double ours) {
  const double ratio = other / ours;
  return printed(ratio < 0.095 ? "× %.2f" : ratio < 9.95 ? "× %.1f" : "× %.0f", ratio);
}

}  // namespace

std::string chart(const std::string& title, const std::string& note, const std::vector<ChartRow>& rows) {
  const bool batches = std::any_of(rows.begin(), rows.end(), [](const ChartRow& row) { return row.batch > 0; });
  double longest = 10;
  for (const ChartRow& row : rows) longest = std::max({longest, row.nanoseconds, row.one});
  const double decades = std::ceil(std::log10(longest));
  const auto length = [&](double time) {
    return std::max(0.0, std::log10(std::max(time, 1.0)) / decades * (right - left));
  };
  const auto height = [](const ChartRow& row) { return (row.batch > 0 ? 3 : 2) * (bar + gap) + between; };
  double bottom = top;
  for (const ChartRow& row : rows) bottom += height(row);

  Drawing drawing;
  drawing.text(0, 18, title, "title");
  double x = 0;
  const auto key = [&](const char* kind, const char* what, double w) {
    drawing.rectangle(x, 30, 12, bar, kind);
    drawing.text(x + 17, 39, what, "small");
    x += w;
  };
  key("other", "fastest of the other libraries", 190);
  key("one", "Graze, a pair at a time", 160);
  if (batches) key("batch", "Graze, all pairs at once", 180);
  drawing.text(x, 39, "×: how many times as fast as the other", "small");
  for (int decade = 0; decade <= static_cast<int>(decades); ++decade) {
    const double at = left + length(std::pow(10.0, decade));
    drawing.line(at, top - 8, bottom - between + 2);
    drawing.text(at, top - 12,
                 decade < 3 ? printed("%.0f ns", std::pow(10.0, decade))
                            : printed("%.0f µs", std::pow(10.0, decade - 3)),
                 "small", "middle");
  }
  drawing.text(0, top - 12, "time for a pair, logarithmic", "small");
  double begin = top;
  for (const ChartRow& row : rows) {
    double y = begin;
    const auto draw = [&](double time, const char* kind, const std::string& label) {
      drawing.rectangle(left, y, length(time), bar, kind);
      drawing.text(right + 8, y + bar - 0.5, label, "small");
      y += bar + gap;
    };
    std::string other = nanoseconds(row.nanoseconds) + " ns " + row.other;
    if (row.wrong >= 0.0005) other += printed(", %.1f", 100 * row.wrong) + " % wrong";
    draw(row.nanoseconds, "other", other);
    const auto ours = [&](double time) { return nanoseconds(time) + " ns, " + times(row.nanoseconds, time); };
    draw(row.one, "one", ours(row.one));
    if (row.batch > 0) draw(row.batch, "batch", ours(row.batch));
    drawing.text(left - 8, (begin + y - gap) / 2 + 4, row.name, "", "end");
    begin += height(row);
  }
  drawing.text(0, bottom + 12, note, "small");
  return drawing.svg(bottom + 20);
}

}  // namespace graze::bench
