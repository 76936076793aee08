#pragma once

#include <string>
#include <vector>

/// Plots for the documents: a writer of SVG that needs nothing else.
namespace tetsculpt::bench {

struct PlotPoint {
  double x;
  double y;
};

struct Curve {
  enum class Style { kMarks, kLine, kDashes };  ///< kLine has marks, too

  std::string name;
  std::vector<PlotPoint> points;
  Style style = Style::kLine;
};

/// Both axes logarithmic: a power law is a straight line, its slope the exponent.
struct LogLogPlot {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Curve> curves;  ///< named in the legend in this order
};

/// The plot as a whole SVG document on a white ground, with lines at the powers of ten and of two
/// for y and x. Points with a coordinate that isn't positive and finite have no place on such axes
/// and are left out. Any text is fit for a name: what SVG would take for markup is escaped.
std::string svg(const LogLogPlot& plot);

}  // namespace tetsculpt::bench
