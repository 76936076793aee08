#include "bench/svg_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace tetsculpt::bench {
namespace {

constexpr double kWidth = 760;
constexpr double kHeight = 520;
constexpr double kLeft = 84;
constexpr double kRight = 40;
constexpr double kTop = 48;
constexpr double kBottom = 64;

/// Told apart by those who see few colours as well. [Okabe, Ito 2008]
constexpr std::array kColors{"#000000", "#0072b2", "#d55e00", "#009e73",
                             "#cc79a7", "#e69f00", "#56b4e9"};

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

/// With thousands set apart, for labels of points.
std::string label(double value) {
  std::string text = number(value);
  if (value < 1000 || value != std::floor(value) || value >= 1e15) return text;
  text = std::to_string(static_cast<long long>(value));
  for (std::size_t i = text.size(); i > 3;) text.insert(i -= 3, 1, ',');
  return text;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string stroke(Curve::Style style, const std::string& color) {
  return "stroke=\"" + color + "\"" +
         (style == Curve::Style::kDashes ? " stroke-dasharray=\"6 5\"" : " stroke-width=\"2\"");
}

bool has_place(const PlotPoint& p) {
  return p.x > 0 && p.y > 0 && std::isfinite(p.x) && std::isfinite(p.y);
}

/// One axis: from powers of `base` to places on the paper.
struct Axis {
  double base;
  double start;  ///< on the paper
  double end;
  int low = 1;  ///< exponents; none if low > high
  int high = 0;

  void extend(double value) {
    const double exponent = std::log(value) / std::log(base);
    // 2^8 must not become 2^9 by rounding.
    const int down = static_cast<int>(std::floor(exponent + 1e-9));
    const int up = static_cast<int>(std::ceil(exponent - 1e-9));
    if (low > high) low = down, high = std::max(up, down + 1);
    low = std::min(low, down);
    high = std::max(high, up);
  }
  double place(double value) const {
    const double share = (std::log(value) / std::log(base) - low) / (high - low);
    return start + share * (end - start);
  }
};

class Drawing {
 public:
  explicit Drawing(const LogLogPlot& plot);
  std::string take() { return std::move(out_) + "</svg>\n"; }

 private:
  void line(double x1, double y1, double x2, double y2, const std::string& style);
  void text(double x, double y, const std::string& anchor, const std::string& words,
            const std::string& more = "");
  void axes(const LogLogPlot& plot);
  void polyline(const Curve& curve, const std::string& color);
  void mark(double x, double y, const std::string& color);
  void legend(const Curve& curve, std::size_t row, std::size_t rows, const std::string& color);

  Axis x_{2, kLeft, kWidth - kRight};
  Axis y_{10, kHeight - kBottom, kTop};
  std::string out_;
};

Drawing::Drawing(const LogLogPlot& plot) {
  for (const Curve& curve : plot.curves) {
    for (const PlotPoint& p : curve.points) {
      if (!has_place(p)) continue;
      x_.extend(p.x);
      y_.extend(p.y);
    }
  }
  out_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(kWidth) + "\" height=\"" +
         number(kHeight) + "\" viewBox=\"0 0 " + number(kWidth) + " " + number(kHeight) +
         "\" font-family=\"sans-serif\" font-size=\"13\">\n"
         "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  axes(plot);
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const std::string color = kColors[i % kColors.size()];
    polyline(plot.curves[i], color);
    legend(plot.curves[i], i, plot.curves.size(), color);
  }
}

void Drawing::line(double x1, double y1, double x2, double y2, const std::string& style) {
  out_ += "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) +
          "\" y2=\"" + number(y2) + "\" " + style + "/>\n";
}

void Drawing::text(double x, double y, const std::string& anchor, const std::string& words,
                   const std::string& more) {
  out_ += "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\" " +
          more + ">" + escaped(words) + "</text>\n";
}

void Drawing::axes(const LogLogPlot& plot) {
  const std::string grid = "stroke=\"#dddddd\"";
  // At most some ten labels fit side by side.
  const int step = 1 + (x_.high - x_.low) / 10;
  for (int e = x_.low; e <= x_.high; e += step) {
    const double x = x_.place(std::pow(x_.base, e));
    line(x, y_.start, x, y_.end, grid);
    text(x, y_.start + 18, "middle", label(std::pow(x_.base, e)));
  }
  for (int e = y_.low; e <= y_.high; ++e) {
    const double y = y_.place(std::pow(y_.base, e));
    line(x_.start, y, x_.end, y, grid);
    text(x_.start - 8, y + 4, "end", label(std::pow(y_.base, e)));
  }
  line(x_.start, y_.start, x_.end, y_.start, "stroke=\"#444444\"");
  line(x_.start, y_.start, x_.start, y_.end, "stroke=\"#444444\"");
  text(kWidth / 2, 26, "middle", plot.title, "font-size=\"16\" font-weight=\"bold\"");
  text((x_.start + x_.end) / 2, kHeight - 18, "middle", plot.x_label);
  const double middle = (y_.start + y_.end) / 2;
  text(20, middle, "middle", plot.y_label, "transform=\"rotate(-90 20 " + number(middle) + ")\"");
}

void Drawing::polyline(const Curve& curve, const std::string& color) {
  std::string places;
  for (const PlotPoint& p : curve.points) {
    if (!has_place(p)) continue;
    places += number(x_.place(p.x)) + "," + number(y_.place(p.y)) + " ";
    if (curve.style != Curve::Style::kDashes) mark(x_.place(p.x), y_.place(p.y), color);
  }
  if (curve.style == Curve::Style::kMarks || places.empty()) return;
  out_ +=
      "<polyline points=\"" + places + "\" fill=\"none\" " + stroke(curve.style, color) + "/>\n";
}

void Drawing::mark(double x, double y, const std::string& color) {
  out_ += "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"3.5\" fill=\"" + color +
          "\"/>\n";
}

/// Lower right, where growing curves do not go.
void Drawing::legend(const Curve& curve, std::size_t row, std::size_t rows,
                     const std::string& color) {
  const double x = kWidth - kRight - 290;
  const double y = kHeight - kBottom - 18 - 19 * static_cast<double>(rows - 1 - row);
  if (curve.style != Curve::Style::kMarks) line(x, y, x + 30, y, stroke(curve.style, color));
  if (curve.style != Curve::Style::kDashes) mark(x + 15, y, color);
  text(x + 38, y + 4, "start", curve.name);
}

}  // namespace

std::string svg(const LogLogPlot& plot) { return Drawing(plot).take(); }

}  // namespace tetsculpt::bench
