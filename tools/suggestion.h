#pragma once

#include <span>
#include <string>
#include <string_view>

/// What somebody may have meant by a word that is not known.
namespace tetsculpt::cli {

/// "; did you mean WORD?" with the word nearest to this one: a typo or two away, or the only one
/// that it begins. Empty if none is near.
std::string did_you_mean(std::string_view word, std::span<const std::string> known);

}  // namespace tetsculpt::cli
