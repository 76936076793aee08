// The locale of the program, with decimal commas and grouped digits, has no influence.
#include <doctest/doctest.h>

#include <clocale>
#include <locale>
#include <string>
#include <vector>

#include "io/read_points.h"
#include "tests/support/io_point_attributes.h"

namespace tetsculpt {
namespace {

using testing::has_values;

class CommaForPoint : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

class ForeignLocale {
 public:
  ForeignLocale() : old_(std::locale::global({std::locale(), new CommaForPoint})) {
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"}) {
      if (std::setlocale(LC_ALL, name) != nullptr) break;  // as far as the system has one
    }
  }
  ~ForeignLocale() {
    std::locale::global(old_);
    std::setlocale(LC_ALL, "C");
  }
  ForeignLocale(const ForeignLocale&) = delete;
  ForeignLocale& operator=(const ForeignLocale&) = delete;

 private:
  std::locale old_;
};

void check(const std::string& path, const std::string& content) {
  CAPTURE(path);
  const PointFile file = parse_points(content, path);
  CHECK(file.points == std::vector<Point3>{{1234.5, 0.25, 4.9406564584124654e-324}});
}

TEST_CASE("texts") {
  const ForeignLocale foreign;
  const std::string row = "1234.5 .25 4e-324";
  check("a.xyz", row + "\n");
  check("a.csv", "x,y,z\n1234.5,.25,4e-324\n");
  check("a.obj", "v " + row + "\n");
  check("a.off", "OFF 1 0 0\n" + row + "\n");
  check("a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\n"
        "property double z\nend_header\n" +
            row + "\n");
  check("a.pcd", "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nPOINTS 1\nDATA ascii\n" + row + "\n");
  check("a.vtk",
        "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 1 double\n" + row + "\n");
}

TEST_CASE("attributes and messages") {
  const ForeignLocale foreign;
  const PointFile file = parse_points("x y z v\n1 2 3 1234.5\n", "a.xyz");
  CHECK(has_values<double>(file, "v", {1234.5}));
  std::string message;
  try {
    parse_points("12345\n1 2 3\n", "a.xyz");
  } catch (const std::exception& error) {
    message = error.what();
  }
  CHECK(message == "a.xyz:1: announced points: 12345, points in the file: 1");
}

}  // namespace
}  // namespace tetsculpt
