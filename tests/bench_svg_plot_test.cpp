// The plots' SVG: every mark where the logarithms put it, nothing that is not markup among it.
#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "bench/svg_plot.h"

namespace tetsculpt::bench {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

/// The numbers after each occurrence of `key`, as in cx="12.5".
std::vector<double> numbers_after(const std::string& text, const std::string& key) {
  std::vector<double> numbers;
  for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
    numbers.push_back(std::stod(text.substr(at + key.size())));
  }
  return numbers;
}

LogLogPlot plot_of(std::vector<Curve> curves) { return {"title", "x", "y", std::move(curves)}; }

TEST_CASE("a power law lies on a straight line, higher values higher up") {
  Curve curve{"square", {}, Curve::Style::kLine};
  for (double x = 1; x <= 64; x *= 2) curve.points.push_back({x, x * x});
  const std::string text = svg(plot_of({curve}));
  const std::vector<double> x = numbers_after(text, "cx=\"");
  const std::vector<double> y = numbers_after(text, "cy=\"");
  REQUIRE(x.size() == curve.points.size() + 1);  // and one in the legend
  REQUIRE(y.size() == x.size());
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    CHECK(x[i] - x[i - 1] == doctest::Approx(x[1] - x[0]).epsilon(1e-3));
    CHECK(y[i] - y[i - 1] == doctest::Approx(y[1] - y[0]).epsilon(1e-3));
  }
  CHECK(x[1] > x[0]);
  CHECK(y[1] < y[0]);
}

TEST_CASE("points without a place on logarithmic axes are left out") {
  const double infinity = std::numeric_limits<double>::infinity();
  const Curve curve{"some",
                    {{1, 0}, {0, 1}, {-1, 1}, {1, infinity}, {std::nan(""), 1}, {2, 3}, {4, 5}},
                    Curve::Style::kMarks};
  const std::string text = svg(plot_of({curve}));
  CHECK(count(text, "<circle") == 2 + 1);
  CHECK(count(text, "nan") == 0);
  CHECK(count(text, "inf") == 0);
}

TEST_CASE("no curves, empty ones, and a single point: still a document") {
  const std::vector<std::vector<Curve>> cases{
      {}, {{"empty", {}, Curve::Style::kLine}}, {{"one", {{256, 1}}, Curve::Style::kLine}}};
  for (const std::vector<Curve>& curves : cases) {
    const std::string text = svg(plot_of(curves));
    CHECK(count(text, "<svg ") == 1);
    CHECK(text.ends_with("</svg>\n"));
    CHECK(count(text, "nan") == 0);
    CHECK(count(text, "inf") == 0);
  }
}

TEST_CASE("styles: marks alone, a line with marks, dashes alone") {
  const std::vector<PlotPoint> two{{1, 1}, {2, 2}};
  const std::string marks = svg(plot_of({{"a", two, Curve::Style::kMarks}}));
  CHECK(count(marks, "<circle") == 3);
  CHECK(count(marks, "<polyline") == 0);
  const std::string line = svg(plot_of({{"a", two, Curve::Style::kLine}}));
  CHECK(count(line, "<circle") == 3);
  CHECK(count(line, "<polyline") == 1);
  const std::string dashes = svg(plot_of({{"a", two, Curve::Style::kDashes}}));
  CHECK(count(dashes, "<circle") == 0);
  CHECK(count(dashes, "<polyline") == 1);
  CHECK(count(dashes, "stroke-dasharray") == 2);  // and in the legend
}

TEST_CASE("markup in a name is text") {
  const std::string text = svg(plot_of({{"a < b & \"c\" > d", {{1, 1}}, Curve::Style::kMarks}}));
  CHECK(count(text, "a &lt; b &amp; \"c\" &gt; d") == 1);
  CHECK(count(text, "<text") == count(text, "</text>"));
}

}  // namespace
}  // namespace tetsculpt::bench
