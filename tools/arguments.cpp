#include "tools/arguments.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "io/extension.h"
#include "io/parse_number.h"
#include "io/write_mesh.h"

namespace tetsculpt::cli {
namespace {

template <class Value>
using Named = std::pair<std::string_view, Value>;

constexpr std::array<Named<Method>, 2> kMethods{
    {{"guided", Method::kGuided}, {"paper", Method::kPaper}}};
constexpr std::array<Named<Criterion>, 4> kCriteria{{{"area", Criterion::kMinimalArea},
                                                     {"gamma", Criterion::kGamma},
                                                     {"longest", Criterion::kLongestEdge},
                                                     {"constrained", Criterion::kConstrained}}};
constexpr std::array<Named<UpAxis>, 3> kAxes{
    {{"x", UpAxis::kX}, {"y", UpAxis::kY}, {"z", UpAxis::kZ}}};

template <class Value, std::size_t N>
Value value_of(std::string_view option, std::string_view word,
               const std::array<Named<Value>, N>& names) {
  std::string choices;
  for (const auto& [known, value] : names) {
    if (word == known) return value;
    choices += (choices.empty() ? "" : ", ") + std::string(known);
  }
  throw UsageError(std::string(option) + ": '" + std::string(word) + "' is none of " + choices);
}

template <class Value, std::size_t N>
std::string name_of(Value value, const std::array<Named<Value>, N>& names) {
  const auto it =
      std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.second == value; });
  return std::string(it->first);
}

int threads_of(std::string_view word) {
  int threads = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), threads);
  if (error != std::errc() || end != word.data() + word.size() || threads < 1 || threads > 1024) {
    throw UsageError("--threads: '" + std::string(word) + "' is not a number from 1 to 1024");
  }
  return threads;
}

/// Sets the two angles of `view`.
void take_angles(std::string_view word, View& view) {
  const std::size_t comma = word.find(',');
  const auto number = [](std::string_view text) {
    const ParsedNumber<double> parsed = parse_number<double>(text);
    const bool whole =
        parsed.fault == NumberFault::kNone && parsed.end == text.data() + text.size();
    return whole && std::isfinite(parsed.value) ? std::optional(parsed.value) : std::nullopt;
  };
  const auto azimuth = number(word.substr(0, comma));
  const auto elevation =
      comma == std::string_view::npos ? std::nullopt : number(word.substr(comma + 1));
  if (!azimuth || !elevation || std::abs(*elevation) > 90) {
    throw UsageError("--view: '" + std::string(word) +
                     "' is not AZIMUTH,ELEVATION in degrees, the elevation from -90 to 90");
  }
  view.azimuth = *azimuth;
  view.elevation = *elevation;
}

/// One pass over the words.
class Parser {
 public:
  explicit Parser(std::span<const char* const> words) : words_(words) {}

  Arguments run() {
    out_.options.threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 64);
    while (next_ < words_.size() && out_.action == Action::kReconstruct) {
      const std::string_view word = words_[next_++];
      if (options_ended_ || word.size() < 2 || word[0] != '-') {
        take_file(word);
      } else {
        take_option(word);
      }
    }
    if (out_.action == Action::kReconstruct) check_files();
    return std::move(out_);
  }

 private:
  void take_file(std::string_view word) {
    if (files_ == 2) throw UsageError("unexpected word '" + std::string(word) + "'");
    (files_++ == 0 ? out_.input : out_.output) = word;
  }

  void take_option(std::string_view word) {
    const std::size_t equals = word.find('=');
    const std::string_view option = word.substr(0, equals);
    if (equals != std::string_view::npos) attached_ = word.substr(equals + 1);
    if (option == "--") {
      options_ended_ = true;
    } else if (option == "--help" || option == "-h") {
      out_.action = Action::kHelp;
    } else if (option == "--version") {
      out_.action = Action::kVersion;
    } else if (option == "--quiet" || option == "-q") {
      out_.quiet = true;
    } else if (option == "--stats") {
      out_.stats = true;
    } else if (option == "--skip-invalid") {
      out_.skip_invalid = true;
    } else if (option == "--method") {
      out_.options.method = value_of(option, value(option), kMethods);
    } else if (option == "--criterion") {
      out_.options.criterion = value_of(option, value(option), kCriteria);
    } else if (option == "--threads") {
      out_.options.threads = threads_of(value(option));
    } else if (option == "--picture") {
      out_.picture = value(option);
      if (out_.picture.empty()) throw UsageError("--picture needs a file");
    } else if (option == "--viewer") {
      out_.viewer = value(option);
      if (out_.viewer.empty()) throw UsageError("--viewer needs a file");
      out_.options.record = ReconstructOptions::Record::kStory;
    } else if (option == "--view") {
      take_angles(value(option), out_.view);
      view_option_ = option;
    } else if (option == "--up") {
      out_.view.up = value_of(option, value(option), kAxes);
      view_option_ = option;
    } else {
      throw UsageError("unknown option '" + std::string(option) + "'");
    }
    if (attached_) throw UsageError(std::string(option) + " takes no value");
  }

  std::string_view value(std::string_view option) {
    if (attached_) return *std::exchange(attached_, std::nullopt);
    if (next_ == words_.size()) throw UsageError(std::string(option) + " needs a value");
    return words_[next_++];
  }

  void check_files() const {
    if (files_ < 2) {
      throw UsageError(files_ == 0 ? "no input file given" : "no output file given");
    }
    if (!writable_mesh_extension(out_.output)) {
      throw UsageError(out_.output.string() +
                       ": unknown kind of output file; use .ply, .obj, .off, .stl or .wrl");
    }
    if (!out_.picture.empty() && lowercase_extension(out_.picture) != ".png") {
      throw UsageError(out_.picture.string() + ": unknown kind of picture; use .png");
    }
    if (!out_.viewer.empty() && lowercase_extension(out_.viewer) != ".html") {
      throw UsageError(out_.viewer.string() + ": unknown kind of viewer; use .html");
    }
    if (out_.picture.empty() && out_.viewer.empty() && !view_option_.empty()) {
      throw UsageError(std::string(view_option_) + " without --picture or --viewer");
    }
  }

  std::span<const char* const> words_;
  std::size_t next_ = 0;
  int files_ = 0;
  bool options_ended_ = false;
  std::optional<std::string_view> attached_;
  std::string_view view_option_;  // the last one that says how the picture is taken
  Arguments out_;
};

}  // namespace

Arguments parse_arguments(std::span<const char* const> words) { return Parser(words).run(); }

std::string name(Method method) { return name_of(method, kMethods); }
std::string name(Criterion criterion) { return name_of(criterion, kCriteria); }

std::string help() {
  return R"(Usage: tetsculpt [OPTIONS] POINTS SURFACE

Turns unorganised points in space into a closed manifold triangle surface
through every one of them. It needs positions only: no normals, no parameter.

  POINTS    .xyz .txt .csv .pts .asc (x y z per line, further columns ignored),
            .ply, or the vertices of an .obj or .off file
  SURFACE   .ply .obj .off .stl .wrl

Options:
  --method NAME      how to sculpt: guided by evidence for inside and outside
                     (the default), or paper (Attene, Spagnuolo 2000)
  --criterion NAME   with --method paper, which tetrahedron goes first:
                     constrained (the paper's own, the default), longest,
                     area, gamma
  --skip-invalid     drop points with a NaN or infinite coordinate and say how
                     many; without this they are an error
  --threads N        use at most N threads (default: all cores); the surface
                     does not depend on it
  --picture FILE     draw the surface, too, into a .png file; what is seen of it
                     from inside is red
  --viewer FILE      write a page, too, that shows the surface in any browser: to
                     be turned, with points, graphs and the steps that led to it
                     (.html, one file, needs no network)
  --view AZ,EL       from where, in degrees: AZ around the upright axis, EL above
                     (default: 30,20)
  --up AXIS          which axis is upright in picture and viewer: x, y, z (the
                     default)
  --stats            print what was computed as one JSON object on stdout
  -q, --quiet        no progress and no summary
  -h, --help         this text
  --version          the version

Examples:
  tetsculpt scan.xyz surface.ply
  tetsculpt --picture kitten.png --up y kitten.xyz kitten.ply
  tetsculpt --viewer kitten.html --up y kitten.xyz kitten.ply
  tetsculpt --stats slices.csv organ.stl > organ.json

Exit status:
  0  done
  1  wrong usage
  2  bad input: unreadable, broken, or with an invalid point
  3  the points span no solid: fewer than 4, all on a line, or all in a plane
  4  done, but the points named on stderr could not be brought to the surface
  5  the output could not be written
)";
}

}  // namespace tetsculpt::cli
