#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "kernel/triangle_mesh.h"
#include "sculpt/reconstruct.h"
#include "tools/arguments.h"

/// What the command says about a finished run.
namespace tetsculpt::cli {

/// What a run knows beyond its Reconstruction.
struct RunFacts {
  std::size_t points = 0;   ///< read, invalid ones included
  std::size_t skipped = 0;  ///< invalid ones
  Topology topology;
  double seconds_read = 0;
  double seconds_write = 0;
  double seconds_total = 0;
};

/// What the JSON object holds, in its order, for the manual.
struct StatsMember {
  std::string_view name;
  std::string_view type;
  std::string_view meaning;
};
std::span<const StatsMember> stats_members();

/// One JSON object on one line, with these members.
std::string stats_json(const Arguments& arguments, const Reconstruction& result,
                       const RunFacts& facts);

/// What each stage did and how long it took, a line each.
std::string stage_lines(const Arguments& arguments, const Reconstruction& result,
                        const RunFacts& facts);

/// One line for people: what came out, and where it is.
std::string summary(const Arguments& arguments, const Reconstruction& result,
                    const RunFacts& facts);

}  // namespace tetsculpt::cli
