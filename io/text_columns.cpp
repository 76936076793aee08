#include "io/text_columns.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "io/column_names.h"
#include "io/point_rows.h"

namespace tetsculpt {
namespace {

constexpr std::size_t kMostColumns = 1000;

std::string_view trimmed(std::string_view text, std::string_view off) {
  const std::size_t begin = text.find_first_not_of(off);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(off) + 1 - begin);
}

// The first three are x, y and z; the others keep their names, or get one.
std::vector<std::string> coordinates_first(std::vector<std::string> names) {
  constexpr std::array kCoordinates = {"x", "y", "z"};
  if (names.size() < kCoordinates.size()) names.resize(kCoordinates.size());
  std::ranges::copy(kCoordinates, names.begin());
  return canonical_names(std::move(names));
}

std::vector<std::string> usual_names(TextColumns usual, std::size_t count) {
  if (usual == TextColumns::kPts) {
    if (count == 4) return {"x", "y", "z", "intensity"};
    if (count == 6) return {"x", "y", "z", "red", "green", "blue"};
    if (count == 7) return {"x", "y", "z", "intensity", "red", "green", "blue"};
  }
  return coordinates_first(std::vector<std::string>(count));
}

}  // namespace

TextColumnNames::Titles TextColumnNames::split(std::string_view line) {
  std::string_view delimiters = " \t";
  for (const std::string_view stronger : {"\t", ",;"}) {
    if (line.find_first_of(stronger) != std::string_view::npos) delimiters = stronger;
  }
  Titles titles{{}, delimiters != " \t"};
  while (!line.empty() && titles.names.size() <= kMostColumns) {
    const std::size_t end = std::min(line.find_first_of(delimiters), line.size());
    const std::string_view name = trimmed(line.substr(0, end), " \t\"'");
    if (titles.delimited || !name.empty()) titles.names.emplace_back(name);
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  while (!titles.names.empty() && titles.names.back().empty()) titles.names.pop_back();
  titles.names = canonical_names(std::move(titles.names));
  return titles;
}

void TextColumnNames::take_comment(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of("#/ \t"), line.size()));
  Titles words = split(line);
  if (name_coordinates(words.names)) comment_ = std::move(words);
}

void TextColumnNames::take_titles(std::string_view line) { titles_ = split(line); }

std::vector<std::string> TextColumnNames::of_row(const TextScanner& in) const {
  const std::size_t count = count_cells(in, kMostColumns + 1);
  if (count > kMostColumns) {
    in.fail("more than " + std::to_string(kMostColumns) + " columns; expected a point per line");
  }
  const bool titles_fit = titles_.names.size() == count;
  if (name_coordinates(titles_.names) && (titles_fit || titles_.delimited)) {
    std::vector<std::string> names = titles_.names;
    if (names.size() < count) names.resize(count);
    return canonical_names(std::move(names));
  }
  if (comment_.names.size() == count) return comment_.names;
  if (titles_fit) {
    std::vector<std::string> names = coordinates_first(titles_.names);
    if (!name_coordinates(names)) in.fail("the titles do not name x, y and z once each");
    return names;
  }
  if (name_coordinates(titles_.names) &&
      !std::ranges::equal(std::span(titles_.names).first(3), std::array{"x", "y", "z"})) {
    in.fail("the header names " + std::to_string(titles_.names.size()) + " columns, the row has " +
            std::to_string(count));
  }
  return usual_names(usual_, count);
}

}  // namespace tetsculpt
